"""Rasterised passes against traced ones of the same state, which test_pictures.py holds to the program: after every kind of change, since vertices are displaced,
and triangles out of sight left out, once for all passes; through lenses, whose field bends; and where triangles are near, or at the picture's edge."""
import test_pictures
from page_in_browser import QUADS_ASIDE, PageTest, emissive_view, main, rectangle
from picture_measures import rmse

SIZE, PASSES = 64, 8
START = f"""s.passes = {PASSES}; s.modes = ['raster']; s.camera.gaze = 'foveal';
  Object.assign(s.eyes.right, {{sphere_D: -3, cylinder_D: -4, axis_deg: 70, vertex_mm: 12, accommodation: 'fixed', focus_D: 0.5}}); Object.assign(s.eyes.left, s.eyes.right, {{sphere_D: 1}});
  Object.assign(s.glasses.right, {{kind: 'single', fitted: false, sphere_D: -1, cylinder_D: -2, axis_deg: 25}}); Object.assign(s.glasses.left, s.glasses.right);"""
# One after the other, each on top of those before.
CHANGES = {
    "the eye's power": "s.eyes.right.sphere_D = -8;",
    "its axis": "s.eyes.right.axis_deg = 150;",
    "its pupil": "s.eyes.right.pupil_mm = 4;",
    "what it is focused at": "s.eyes.right.focus_D = 8;",
    "the lens's power": "s.glasses.right.sphere_D = -5;",
    "where the lens stands": "s.glasses.right.vertex_mm = 25;",
    "a progressive lens": "s.glasses.right.kind = 'progressive'; s.glasses.right.sphere_D = 0;",
    "an eye that looks ahead": "s.camera.gaze = 'camera';",
    "the head's turn": "s.camera.turn_deg = 11;",
    "the head's tilt": "s.camera.tilt_deg = -7;",
    "the head's place": "s.camera.position_m = [0.05, -0.04, -0.03];",
    "the field": "s.camera.field_deg = 70;",
    "no lens": "s.glasses.right.kind = 'none';",
    "an eye that turns": "s.camera.gaze = 'foveal';",
    "the other eye": "s.side = 'left';",
    "a naked eye that looks ahead": "s.glasses.left.kind = 'none'; s.camera.gaze = 'camera';",
    "its power, ahead": "s.eyes.left.sphere_D = -6;",
    "its head, ahead": "s.camera.turn_deg = -20;",
}
# For each vertex the eye seeks focus at its distance, and for a traced ray at what the middle of its pixel looks at. That is the same where nothing stands before
# anything else: strips of a floor.
EDGES_M = (0.05, 0.25, 0.35, 0.5, 0.7, 1, 1.5, 3)
FLOOR = [(f"strip{k}", [[x, -0.25, -z * (1 + 0.2 * x)] for x, z in ((-2, near), (2, near), (2, far), (-2, far))], 9 + 3 * (k % 2)) for k, (near, far) in enumerate(zip(EDGES_M, EDGES_M[1:]))]
FLOOR_CHANGES = {
    "an eye that seeks focus": "Object.assign(s.eyes.right, {accommodation: 'best', sphere_D: 3, amplitude_D: 1});",
    "how far it can": "s.eyes.right.amplitude_D = 5;",
    "no lens": "s.glasses.right.kind = 'none';",
    "an eye that looks ahead": "s.camera.gaze = 'camera';",
    "a progressive lens": "s.glasses.right.kind = 'progressive';",
}
# A narrow field, which blur reaches into from far aside, and in which a lens whose power changes over the pupil shows: small tiles, most of them out of sight.
TILES = [("wall", rectangle(0, 0, -6, 12, 12), 8)] + [(f"tile {i} {j}", rectangle(0.04 * i, 0.04 * j, -1.2 if (i + j) % 2 else -0.8, 0.012, 0.012, 0.3), 9 + (i + 2 * j) % 4)
                                                    for i in range(-4, 5) for j in range(-4, 5)]
NARROW = "s.eyes.right.pupil_mm = 8; s.camera.field_deg = 5;"
NARROW_CHANGES = {
    "a progressive lens": "Object.assign(s.glasses.right, {kind: 'progressive', fitted: false, sphere_D: 1, addition_D: 3});",
    "an eye that looks ahead": "s.camera.gaze = 'camera'; s.glasses.right.cylinder_D = -4;",
    "no lens": "s.glasses.right.kind = 'none';",
}


class Displacement(PageTest):
    RASTER_RMSE = test_pictures.Pictures.RASTER_RMSE

    def begin(self, view):
        self.page_of(view)
        self.change(START)

    def both(self):
        return self.measured("interleaved()"), self.measured("picture('gather', 0)")

    def hold(self, changes):
        drawn, before = self.both()
        self.assertLess(rmse(drawn, before), self.RASTER_RMSE)
        for name, edit in changes.items():
            with self.subTest(change=name):
                self.change(edit)
                drawn, traced = self.both()
                print(f"{name}: RMSE {rmse(drawn, traced):.1e}, of what was before {rmse(before, traced):.1e}", flush=True)
                self.assertLess(rmse(drawn, traced), self.RASTER_RMSE)
                self.assertGreater(rmse(before, traced), 2 * self.RASTER_RMSE)  # so that what is kept too long is seen
                before = traced

    def test_pictures_are_new_after_every_change(self):
        self.begin(emissive_view(SIZE, QUADS_ASIDE, 40))
        self.hold(CHANGES)

    def test_every_vertex_has_its_own_focus(self):
        self.begin(emissive_view(SIZE, FLOOR, 40))
        self.change("s.camera.tilt_deg = -40;")
        self.hold(FLOOR_CHANGES)

    def test_what_is_far_aside_is_blurred_into_a_narrow_field(self):
        self.begin(emissive_view(SIZE, TILES, 40))
        self.change(NARROW)
        self.hold(NARROW_CHANGES)


if __name__ == "__main__":
    main()
