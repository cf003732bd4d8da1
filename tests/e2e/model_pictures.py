"""Pictures of small models in front of a camera at the origin that looks along -z, 90 degrees wide: at z = -2 a pixel of 32 is 1/8 m."""
import json

import png_pixels
from exr_header import float_pixels
from sturm_process import FolderTest, WRONG_INPUT, sturm

RED, GREEN, BLUE, YELLOW = (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0)
QUARTERS = png_pixels.encode([[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 0)]])  # upper row red, green
SQUARE = "v -1 -1 -2\nv 1 -1 -2\nv 1 1 -2\nv -1 1 -2\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"  # pixels 8 to 23
FACE = "f 1/1 2/2 3/3 4/4\n"


class ModelTest(FolderTest):
    def view(self, scene, **changes):
        document = {"format": "sturm.render/1", "scene": scene,
                    "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 90, "resolution": [32, 32]},
                    "eye": {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 0},
                    "method": {"type": "path_trace", "ray_model": "pinhole", "samples_per_pixel": 1, "max_bounces": 1}}
        for key, value in changes.items():
            document[key].update(value)
        return self.write("view.json", document)

    def picture(self, scene, **changes):
        """Channels of the picture of a scene; self.notes are its notes."""
        self.succeed("render", self.view(scene, **changes), "-o", self.folder / "out.exr", "--quiet")
        self.notes = json.loads((self.folder / "out.manifest.json").read_text())["notes"]
        return float_pixels((self.folder / "out.exr").read_bytes())

    @staticmethod
    def with_model(file, **model):
        return {"models": [{"file": file, **model}], "lights": [{"type": "point", "position_m": [0, 0, 0], "intensity": [1, 1, 1]}]}

    def model(self, file, **model):
        return self.picture(self.with_model(file, **{"texture_filter": "nearest", **model}))

    def obj(self, obj, mtl=None, name="m.obj", **model):
        """The picture of an OBJ text, with an MTL text in m.mtl."""
        if mtl is not None:
            self.write("m.mtl", mtl)
        self.write(name, obj)
        return self.model(name, **model)

    def refused(self, scene, *named):
        process = sturm("render", self.view(scene), "-o", self.folder / "none.exr", "--quiet")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertFalse((self.folder / "none.exr").exists())
        for text in named:
            self.assertIn(text, process.stderr)
        return process.stderr

    def assert_albedo(self, picture, x, y, right):
        seen = [picture["albedo." + c][y][x] for c in "RGB"]
        for a, b in zip(seen, right):
            self.assertAlmostEqual(a, b, delta=2e-3, msg=f"pixel {x} {y}: {seen}, right: {right}; {self.notes}")  # textures have 8 bits

    def assert_quarters(self, picture, *right):
        """Upper left, upper right, lower left, lower right of the square."""
        for (x, y), colour in zip(((12, 12), (20, 12), (12, 20), (20, 20)), right):
            self.assert_albedo(picture, x, y, colour)

    def assert_noted(self, *words):
        self.assertTrue(any(all(w in note for w in words) for note in self.notes), f"{words}: {self.notes}")
