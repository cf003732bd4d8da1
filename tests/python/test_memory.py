"""Nothing leaks: the same call again and again does not make the process grow."""
import gc
import unittest

import documents
import numpy as np
import sturm

VIEW = documents.changed(documents.changed(documents.view(), "/method/samples_per_pixel", 1), "/camera/resolution", [64, 64])
FIELD = {"format": "sturm.blurfield/1", "eye": {"prescription": {"sphere_D": -1}, "pupil_diameter_mm": 4},
         "field": {"hfov_deg": 60, "vfov_deg": 40, "directions": [16, 16], "depths": 64, "near_m": 0.25, "far_m": "inf"}}


def resident_kB():
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmRSS"))


class Memory(unittest.TestCase):
    def assert_steady(self, call, times, most_kB=2048):
        """After as many calls again the process has grown by at most `most_kB`: pools and caches, not a picture for each call."""
        for _ in range(times):
            call()
        gc.collect()
        before = resident_kB()
        for _ in range(times):
            call()
        gc.collect()
        self.assertLess(resident_kB() - before, most_kB)

    def test_rows(self):
        eye, distances_m = sturm.Eye("oblique_astigmat"), np.linspace(0.2, 5, 10000)  # 880 kB a call
        self.assert_steady(lambda: sturm.ellipses(eye, distances_m), 100)

    def test_objects_and_documents(self):
        eye = {"prescription": "-2.00 -1.50 x 30", "pupil_diameter_mm": 4}
        self.assert_steady(lambda: sturm.Spectacles("progressive_regular", sturm.Eye(eye)), 20)
        self.assert_steady(lambda: sturm.parse_prescription("OD -2.00 -1.50 x 30 OS PL"), 2000)

    def test_errors(self):
        def refused():
            try:
                sturm.Eye(pupil_diameter=3)
            except sturm.InputError:
                pass

        self.assert_steady(refused, 300)

    def test_pictures(self):
        self.assert_steady(lambda: sturm.render(VIEW), 30, 4096)  # some 250 kB of layers a call, threads and a scene
        picture = sturm.render(VIEW).radiance
        self.assert_steady(lambda: sturm.compare(picture, picture), 30, 4096)

    def test_fields(self):
        self.assert_steady(lambda: sturm.BlurField(FIELD).voxels, 30)  # 262 kB of voxels a call


if __name__ == "__main__":
    unittest.main()
