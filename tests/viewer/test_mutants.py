"""Mistakes that are easily made between the core and a shader, made on purpose: each must change a picture by more than the bounds of test_pictures.py
allow, or what is called right would not be known to be right. A lens is looked through away from its middle, where its maps are not symmetric."""
import json

from page_in_browser import PageTest, QUADS_ASIDE, emissive_view, main
from picture_measures import differences, same_passes

SIZE, PASSES = 64, 64

# What the drivers get in place of the shaders' own text.
SHADERS = {
    "rows for columns in the maps of a lens": ("mat2x3(grid_texel(at, k).xyz, grid_texel(at, k + 1).xyz)",
                                              "mat2x3(grid_texel(at, k).x, grid_texel(at, k + 1).x, grid_texel(at, k).z, grid_texel(at, k).y, grid_texel(at, k + 1).yz)"),
    "rows for columns of the head": ("if (!u_sphere) return u_head;", "if (!u_sphere) return transpose(u_head);"),
    "y down": ("u_center.y - place.y", "place.y - u_center.y"),
    "half a pixel": ("vec2 place = vec2(pixel) + film;", "vec2 place = vec2(pixel) + film + 0.5;"),
    "no tangential term": ("return vec2(dot(u_correction.xy, p), dot(u_correction.yz, p)) - accommodation * p;", "return (meridional_power(p) - accommodation) * p;"),
    "no moved origin": ("origin = sight.origin + sight.offset_p * p + sight.offset_s * s;", "origin = sight.origin;"),
}
STATES = {
    "AXIS mirrored": "s.eyes.right.axis_deg = 180 - s.eyes.right.axis_deg",
    "the other eye": "s.side = 'left'",
}
EYE = "s.eyes.right = {...s.eyes.right, sphere_D: -3, cylinder_D: -4.5, axis_deg: 65, vertex_mm: 12}; s.camera.turn_deg = 4; s.camera.tilt_deg = -3;"
# For an eye that turns to each point, the off-diagonal numbers of this lens's maps are up to 0.3 D apart at 30°. For one that looks ahead they are
# nearly equal whatever the lens is (0.02 D here, a quarter of a minute of arc through this pupil), so that no picture would show them swapped.
LENS = EYE + "s.glasses.right = {...s.glasses.right, kind: 'single', fitted: false, sphere_D: -1, cylinder_D: -5, axis_deg: 25}; s.camera.gaze = 'foveal';"
ON_A_LENS = ("rows for columns in the maps of a lens",)


class Mutants(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = cls.write_page(cls(), emissive_view(SIZE, QUADS_ASIDE, 60))

    def open(self, edit):
        self.browser.open(self.page)
        self.wait("window.sturmViewer")
        self.change(f"s.passes = {PASSES}; s.modes = ['gather']; s.eyes.left = {{...s.eyes.left, sphere_D: -1, cylinder_D: 0}}; {edit}")
        self.program = self.rendered(json.loads(self.browser.run("return window.sturmViewer.measured.document()")))

    def picture(self):
        return self.measured("picture('gather', 0)")

    def with_shader(self, right, wrong):
        """The picture by shaders in which one piece of text is another."""
        changed = self.browser.run("""
          const [right, wrong] = arguments, {gpu: {gl}, pictures: {programs}} = window.sturmViewer.app, own = gl.shaderSource.bind(gl);
          let found = 0;
          gl.shaderSource = (shader, text) => { found += text.includes(right); own(shader, text.replaceAll(right, wrong)); };
          programs.compiled.clear();
          programs.use('eye');
          delete gl.shaderSource;
          return found;""", right, wrong)
        self.assertGreater(changed, 0, f"no shader has {right}")
        picture = self.picture()
        self.browser.run("window.sturmViewer.app.pictures.programs.compiled.clear()")
        return picture

    def caught(self, picture):
        self.assertFalse(same_passes(picture, self.program, PASSES), f"{sum(d > 1e-6 for d in differences(picture, self.program))} pixels")

    def test_naked(self):
        self.open(EYE)
        self.assertTrue(same_passes(self.picture(), self.program, PASSES))
        for name, (right, wrong) in SHADERS.items():
            if name not in ON_A_LENS:
                with self.subTest(mutant=name):
                    self.caught(self.with_shader(right, wrong))
        for name, edit in STATES.items():
            with self.subTest(mutant=name):
                self.change(edit)
                self.caught(self.picture())
                self.change(f"s.side = 'right'; {EYE}")

    def test_through_an_oblique_lens_away_from_its_middle(self):
        self.open(LENS)
        picture = self.picture()
        self.assertTrue(same_passes(picture, self.program, PASSES), f"{sum(d > 1e-6 for d in differences(picture, self.program))} pixels")
        self.caught(self.with_shader(*SHADERS[ON_A_LENS[0]]))


if __name__ == "__main__":
    main()
