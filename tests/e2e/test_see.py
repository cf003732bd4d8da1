"""`sturm see`: pictures with a depth map in all the forms that it may come in, and what is wrong with them."""
import json
import math
import os
import unittest

import png_pixels
from picture_files import pfm, png
from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

WIDTH, HEIGHT = 48, 40
MYOPE = {"format": "sturm.eye/1", "prescription": {"sphere_D": -2, "vertex_distance_mm": 0}, "pupil_diameter_mm": 5}


def to_linear(encoded):
    return encoded / 12.92 if encoded <= 0.04045 else ((encoded + 0.055) / 1.055) ** 2.4


def board():
    """Squares of 8 px in two greys."""
    return [[(200,) * 3 if (x // 8 + y // 8) % 2 else (60,) * 3 for x in range(WIDTH)] for y in range(HEIGHT)]


def two_distances(near, far):
    return [[near if x < WIDTH // 2 else far for x in range(WIDTH)] for _ in range(HEIGHT)]


class See(FolderTest):
    def setUp(self):
        super().setUp()
        self.photo = self.write("photo.png", png_pixels.encode(board()))
        self.eye = self.write("eye.json", MYOPE)

    def see(self, *arguments, output="seen.png"):
        self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "-o", self.folder / output, *arguments)
        return png_pixels.decode((self.folder / output).read_bytes())

    def refuse(self, *arguments):
        before = snapshot(self.folder)
        process = sturm("see", *arguments, "-o", self.folder / "seen.png")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertEqual(snapshot(self.folder), before)
        return process.stderr

    def test_depth_means_the_same_in_every_form(self):
        metres = two_distances(0.5, 4.0)
        forms = {
            "mm.png": (png([[round(1000 * d) for d in row] for row in metres], 16), []),
            "scaled.png": (png([[round(5000 * d) for d in row] for row in metres], 16), ["--depth-scale", "0.0002"]),
            "m.pfm": (pfm(metres), []),
            "dioptres.pfm": (pfm([[1 / d for d in row] for row in metres]), ["--depth-unit", "D"]),
            # f b = 100 px m, so that 0.5 m are 200 px and 4 m are 25 px; 5 px are added to the stored ones.
            "disparity.pfm": (pfm([[100 / d - 5 for d in row] for row in metres]),
                              ["--disparity", "--focal-px", "1000", "--baseline-m", "0.1", "--doffs-px", "5"]),
            "disparity8.png": (png([[round(100 / d) for d in row] for row in metres], 8),
                               ["--disparity", "--focal-px", "1000", "--baseline-m", "0.1"]),
        }
        expected = None
        for name, (content, options) in forms.items():
            with self.subTest(form=name):
                seen = self.see("--depth", self.write(name, content), *options)
                expected = expected or seen
                difference = max(abs(a - b) for r, s in zip(seen, expected) for p, q in zip(r, s) for a, b in zip(p, q))
                self.assertLessEqual(difference, 1)

    def test_a_myope_sees_near_things_sharply(self):
        seen, sharp = self.see("--depth", self.write("d.pfm", pfm(two_distances(0.5, 10.0)))), board()
        self.assertEqual([row[: WIDTH // 2 - 12] for row in seen], [row[: WIDTH // 2 - 12] for row in sharp])
        far = [row[-10:] for row in seen]
        self.assertLess(max(p[0] for row in far for p in row) - min(p[0] for row in far for p in row), 139)

    def test_holes_are_filled_and_reported(self):
        rows = two_distances(0.5, 10.0)
        rows[5][30] = rows[6][30] = 0.0
        self.see("--depth", self.write("d.pfm", pfm(rows)))
        manifest = json.loads((self.folder / "seen.manifest.json").read_text())
        self.assertEqual(manifest["counters"]["filled_holes"], 2)
        self.assertTrue(any("without depth" in note for note in manifest["notes"]))

    def test_light_is_added_in_linear_space(self):
        """Far out of focus the squares become the mean of their light, not of their numbers."""
        seen = self.see("--distance-m", "inf", "--pupil-mm", "9", "--focus-D", "8")
        middle = to_linear(seen[HEIGHT // 2][WIDTH // 2][0] / 255)
        self.assertAlmostEqual(middle, 0.5 * (to_linear(200 / 255) + to_linear(60 / 255)), delta=0.02)

    def test_sequences_and_explanations(self):
        depth = self.write("d.pfm", pfm(two_distances(0.5, 10.0)))
        self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "--depth", depth, "--rack-focus-D", "0", "2",
                     "--frames", "3", "-o", self.folder / "rack.png")
        for name in ("rack_0001.png", "rack_0002.png", "rack_0003.png", "rack.manifest.json"):
            self.assertTrue((self.folder / name).is_file(), name)
        before = snapshot(self.folder)
        text = self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "--depth", depth, "--explain").stdout
        self.assertIn("2 planes", text)
        self.assertEqual(snapshot(self.folder), before)

    def test_names_need_not_be_utf8(self):
        """A file's name in Latin-1 stands in the manifest, with a replacement character."""
        picture = os.fsencode(self.folder) + b"/gr\xfcn.png"
        with open(picture, "wb") as file:
            file.write(png(board()))
        process = sturm("see", os.fsdecode(picture), "--distance-m", 1, "--eye", self.folder / "eye.json", "--vfov-deg", 2,
                        "-o", self.folder / "named.png")
        self.assertEqual(process.returncode, 0, process.stderr)
        manifest = strict_json((self.folder / "named.manifest.json").read_text())
        self.assertTrue(manifest["spec"]["picture"].endswith("gr\ufffdn.png"))

    def test_wrong_input_is_refused_and_nothing_is_written(self):
        usual = [self.photo, "--eye", self.eye, "--vfov-deg", "2"]
        good = self.write("good.pfm", pfm(two_distances(0.5, 10.0)))
        for expected, arguments in [
            ("40 x 20 pixels", ["--depth", self.write("small.pfm", pfm([[1.0] * 40] * 20))]),
            ("-1", ["--depth", self.write("negative.pfm", pfm(two_distances(-1.0, 1.0)))]),
            ("nan", ["--depth", self.write("nan.pfm", pfm(two_distances(math.nan, 1.0)))]),
            ("8 bits", ["--depth", self.write("eight.png", png([[9] * WIDTH] * HEIGHT, 8))]),
            ("in colour", ["--depth", self.write("colour.png", png_pixels.encode([[(1, 2, 3)] * WIDTH] * HEIGHT))]),
            ("no depth", []),
            ("calibration", ["--depth", good, "--disparity"]),
            ("no pixel with a depth", ["--depth", self.write("empty.pfm", pfm(two_distances(0.0, 0.0)))]),
            ("no such file", ["--depth", self.folder / "none.pfm"]),
            ("break off", ["--depth", self.write("broken.pfm", b"Pf\n48 40\n-1.0\nshort")]),
            ("distance", ["--distance-m", "-3"]),
        ]:
            with self.subTest(expected=expected):
                self.assertIn(expected, self.refuse(*usual, *arguments))
        self.assertIn("field of view", self.refuse(self.photo, "--eye", self.eye, "--depth", good))
        hofer = SOURCE / "configs/eyes/hofer_5.json"
        self.assertIn("pupil_diameter_mm", self.refuse(self.photo, "--eye", hofer, "--vfov-deg", "2", "--depth", good, "--pupil-mm", "7"))
        best = self.write("best.json", dict(MYOPE, accommodation={"mode": "best", "amplitude_D": 3}))
        self.assertIn("accommodation", self.refuse(self.photo, "--eye", best, "--vfov-deg", "2", "--depth", good))


if __name__ == "__main__":
    unittest.main()
