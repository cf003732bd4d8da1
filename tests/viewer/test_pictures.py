"""Pictures of the page against those of the program, pixel by pixel: the same passes through the same points of the pupil."""
import json

from page_in_browser import PageTest, emissive_view, main
from picture_measures import differences, rmse, same_passes

SIZE, PASSES = 128, 64
WORN = "s.modes = ['gather']; s.eyes.right = {...s.eyes.right, sphere_D: -3, cylinder_D: -1.5, axis_deg: 70, vertex_mm: 12};"
EYES = {
    "naked": "",
    "toric": WORN + "s.glasses.right = {...s.glasses.right, kind: 'single', fitted: false, sphere_D: -1, cylinder_D: -2, axis_deg: 25};",
    "progressive": WORN + "s.glasses.right.kind = 'progressive';",
}
HEAD = {"camera": "s.camera.gaze = 'camera'; s.camera.tilt_deg = 0; s.camera.turn_deg = 0;", "foveal": "s.camera.gaze = 'foveal'; s.camera.tilt_deg = -4; s.camera.turn_deg = 3;"}


class Pictures(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.pages = {size: cls.write_page(cls(), emissive_view(size), f"page{size}") for size in (SIZE, SIZE // 2)}

    def open(self, size):
        self.browser.open(self.pages[size])
        self.wait("window.sturmViewer")

    def saved(self):
        """What the program makes of the view that the page would save."""
        return self.rendered(json.loads(self.browser.run("return window.sturmViewer.measured.document()")))

    def test_traced_passes_are_the_programs(self):
        self.open(SIZE)
        for eye, worn in EYES.items():
            for gaze, head in HEAD.items():
                with self.subTest(eye=eye, gaze=gaze):
                    self.change(f"s.modes = ['gather']; {worn} {head}")
                    page, program = self.measured("picture('gather', 0)"), self.saved()
                    apart = differences(page, program)
                    print(f"{eye}, {gaze}: {100 * sum(d > 1e-6 for d in apart) / len(apart):.3f} % of pixels, at most {max(apart) * PASSES * 16 / 15:.2f} passes, RMSE {rmse(page, program):.1e}", flush=True)
                    self.assertTrue(same_passes(page, program, PASSES))

    def test_displaced_vertices_make_nearly_the_same_picture(self):
        self.open(SIZE // 2)
        self.change("s.modes = ['gather'];")
        # What users see at first has one set of points for all pixels: grain, not an error.
        self.assertLess(rmse(self.measured("picture('raster', 0)"), self.saved()), 8e-3)
        program, page = self.saved(), self.measured("interleaved()")
        print(f"rasterised: RMSE {rmse(page, program):.1e}")
        # SwiftShader rasterises on 1/16 of a pixel, so edges move by up to 1/32.
        self.assertLess(rmse(page, program), 3e-3)


if __name__ == "__main__":
    main()
