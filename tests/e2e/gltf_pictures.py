"""A glTF model before the eye, for the tests of glTF files, and what its picture shows."""
import json

from exr_header import float_pixels
from gltf_models import Model
from sturm_process import WRONG_INPUT, FolderTest, sturm

RED, GREEN, BLUE, YELLOW, BLACK, WHITE = (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 0, 0), (1, 1, 1)
QUARTERS = [[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 0)]]  # as a picture: rows from the top
IN_PLACE = [RED, GREEN, BLUE, YELLOW]                                    # how the square then looks: upper row, lower row
PLACES = [(12, 12), (20, 12), (12, 20), (20, 20)]                        # pixels of the square's quarters
LIGHT = {"type": "point", "position_m": [0, 0, 0], "intensity": [1, 1, 1]}
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


class Gltf(FolderTest):
    def view(self, file, lights=(LIGHT,), samples=1, bounces=1, camera=None, **model):
        model.setdefault("texture_filter", "nearest")
        view = {"format": "sturm.render/1",
                "scene": {"models": [{"file": file, **{k: v for k, v in model.items() if v is not None}}], "lights": list(lights)},
                "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 90, "resolution": [32, 32], **(camera or {})},
                "eye": {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 0},
                "method": {"type": "path_trace", "ray_model": "pinhole", "samples_per_pixel": samples, "max_bounces": bounces}}
        return self.write("view.json", view)

    def shown(self, model, name="model.glb", **options):
        """Channels of the picture of a model (a file's name, or a Model that is written first); self.notes are its notes."""
        if isinstance(model, Model):
            model.write(self.folder / name)
        else:
            name = model
        self.succeed("render", self.view(name, **options), "-o", self.folder / "out.exr", "--quiet")
        self.notes = json.loads((self.folder / "out.manifest.json").read_text())["notes"]
        return float_pixels((self.folder / "out.exr").read_bytes())

    def refused(self, model, *named, name="model.glb"):
        if isinstance(model, Model):
            model.write(self.folder / name)
        process = sturm("render", self.view(name), "-o", self.folder / "out.exr", "--quiet")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        for word in (name, *named):
            self.assertIn(word, process.stderr)

    def assert_noted(self, *words):
        self.assertTrue(any(all(w in note for w in words) for note in self.notes), f"{words}: {self.notes}")

    def assert_not_noted(self, word):
        self.assertFalse(any(word in note for note in self.notes), self.notes)

    def assert_near(self, seen, right, tolerance=2e-3, what=""):
        """The tolerance is 16-bit halves' of the layers, unless stated."""
        for a, b in zip(seen, right):
            self.assertAlmostEqual(a, b, delta=tolerance * max(1, abs(b)), msg=f"{what}: {seen}, right: {right}")

    @staticmethod
    def albedo(picture, x, y):
        return [picture["albedo." + c][y][x] for c in "RGB"]

    @staticmethod
    def radiance(picture, x, y):
        return [picture[c][y][x] for c in "RGB"]

    @staticmethod
    def mean(picture, layer="", low=9, high=23):
        return [sum(picture[layer + c][y][x] for y in range(low, high) for x in range(low, high)) / (high - low) ** 2 for c in "RGB"]

    def assert_quarters(self, picture, right, what=""):
        for (x, y), colour in zip(PLACES, right):
            self.assert_near(self.albedo(picture, x, y), colour, what=f"{what} at {x}, {y}")
