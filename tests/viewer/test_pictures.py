"""Pictures of the page against those of the program, pixel by pixel: the same passes through the same points of the pupil."""
import json

from page_in_browser import PageTest, emissive_view, main

SIZE, PASSES = 128, 64
STEP = 15 / 16 / PASSES  # the most that one pass of one pixel can change


def differences(first, second):
    """Of each pixel, the largest of its channels'."""
    return [max(abs(first[3 * i + c] - second[3 * i + c]) for c in range(3)) for i in range(len(first) // 3)]


def rmse(first, second):
    return (sum((a - b) ** 2 for a, b in zip(first, second)) / len(first)) ** 0.5


class Pictures(PageTest):
    RASTER_RMSE = 3e-3  # SwiftShader rasterises on 1/16 of a pixel, so edges move by up to 1/32

    def gathered(self, view, name):
        self.page_of(view, name)
        return self.measured("picture('gather', 0)"), self.rendered(view, name)

    def same(self, page, program):
        apart = differences(page, program)
        # A ray that passes within rounding of an edge may fall on either side of it: 0.16 % of pixels when this was first measured.
        self.assertLess(sum(d > 1e-6 for d in apart), 0.005 * len(apart))
        self.assertLessEqual(max(apart), 2 * STEP)

    def test_traced_passes_are_the_programs(self):
        view = emissive_view(SIZE)
        page, program = self.gathered(view, "naked")
        self.same(page, program)
        # What would be seen of a mirrored AXIS, and of half a pixel: the bounds above can fail.
        for mutant in ("s.eyes.right.axis_deg = 150", "s.camera.field_deg = 36.3"):
            self.change(mutant)
            apart = differences(self.measured("picture('gather', 0)"), program)
            self.assertGreater(sum(d > 1e-6 for d in apart), 0.02 * len(apart), mutant)

    def test_a_turned_head_sees_what_the_program_sees(self):
        view = emissive_view(SIZE)
        view["camera"].update({"position_m": [0.1, 0.05, 0.2], "look_at_m": [-0.05, 0.2, -1], "gaze": "foveal"})
        self.same(*self.gathered(view, "foveal"))

    def test_a_saved_view_is_the_same_picture(self):
        self.page_of(emissive_view(SIZE), "saved")
        worn = "s.modes = ['gather']; s.eyes.right = {...s.eyes.right, sphere_D: -3, cylinder_D: -1.5, axis_deg: 70, vertex_mm: 12}; s.glasses.right.kind = "
        for edit in (worn + "'single'; s.glasses.right.fitted = false; s.glasses.right.sphere_D = -1;", worn + "'progressive'; s.camera.gaze = 'foveal'; s.camera.tilt_deg = -4;"):
            with self.subTest(edit=edit):
                self.change(edit)
                view = json.loads(self.browser.run("return window.sturmViewer.measured.document()"))
                self.same(self.measured("picture('gather', 0)"), self.rendered(view, "saved"))

    def test_displaced_vertices_make_nearly_the_same_picture(self):
        view = emissive_view(SIZE // 2)
        self.page_of(view, "raster")
        program = self.rendered(view, "raster")
        self.assertLess(rmse(self.measured("interleaved()"), program), self.RASTER_RMSE)
        # What users see has one set of points for all pixels: grain, not an error.
        self.assertLess(rmse(self.measured("picture('raster', 0)"), program), 8e-3)


if __name__ == "__main__":
    main()
