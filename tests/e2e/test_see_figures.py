"""scripts/see_figures.py: the eyes that it lets see, and what it makes of the Middlebury motorcycle's files."""
import io
import json
import math
import struct
import sys
import unittest
import zipfile

import png_pixels
from sturm_process import SOURCE, FolderTest

sys.path.insert(0, str(SOURCE / "scripts"))
sys.dont_write_bytecode = True
import see_figures  # noqa: E402


class SeeFigures(FolderTest):
    def test_all_eyes_are_valid_and_say_what_they_are(self):
        for name, (label, eye) in see_figures.EYES.items():
            with self.subTest(name):
                self.succeed("validate", self.write(f"{name}.json", eye))
                if "myope" in name or name == "keratoconus":
                    self.assertIn("constructed", label)
                    self.assertIn("constructed", eye["source"])

    def test_myopes_have_the_defocus_of_their_rows(self):
        """M = −4 c/a² of the coefficient of 2ρ² − 1, which is not normalised: P2 OS has 7.294 µm over 6 mm, at first."""
        for name, micrometres in (("myope_before", 7.294), ("myope_after", 2.794)):
            query = {"format": "sturm.ellipse/1", "eye": dict(see_figures.EYES[name][1], pupil_diameter_mm=6),
                     "targets": [{"distance_m": "inf"}], "methods": ["conoid"]}
            xx, _, yy = self.curvature(query)
            self.assertAlmostEqual(-0.5 * (xx + yy), -4 * micrometres / 9, delta=1e-9)

    def curvature(self, query):
        [result] = json.loads(self.succeed("ellipse", self.write("query.json", query)).stdout)["results"]
        return result["wavefront_curvature_D"]

    def test_depth_of_the_motorcycle(self):
        """f b = 192.0317 px m: 60 px are (60 + 31.086)/192.0317 = 0.474328 D, 7 px are 0.198332 D. Four times as far apart they are
        0.198332 + 4 · 0.275996 = 1.302316 D."""
        near, far, hole = see_figures.stretched([60.0, 7.0, math.inf], 4)
        self.assertAlmostEqual(1 / far, 0.198332, delta=1e-6)
        self.assertAlmostEqual(1 / near, 1.302316, delta=1e-6)
        self.assertEqual(hole, 0.0)

    def test_arrays_of_numpy_are_read(self):
        header = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }".ljust(117) + "\n"
        array = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + struct.pack("<6f", 1, 2, 3, 4, 5, math.inf)
        memory = io.BytesIO()
        with zipfile.ZipFile(memory, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("arr_0.npy", array)
        self.assertEqual(see_figures.disparity_map(self.write("a.npz", memory.getvalue())), ((1, 2, 3, 4, 5, math.inf), 3))
        self.assertEqual(see_figures.pfm((1, 2, 3, 4), 2), b"Pf\n2 2\n-1.0\n" + struct.pack("<4f", 3, 4, 1, 2))

    def test_small_pictures_keep_the_light(self):
        """Of two white pixels and two black ones half of the light is left, which sRGB writes as 188."""
        rows = [[(255, 255, 255), (0, 0, 0)], [(0, 0, 0), (255, 255, 255)]]
        self.assertEqual(see_figures.shrunk(png_pixels.decode(png_pixels.encode(rows)), 2), [[(188, 188, 188)]])


if __name__ == "__main__":
    unittest.main()
