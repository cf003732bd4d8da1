"""A blur field as arrays: views into its own memory that say what the ellipses say."""
import unittest

import numpy as np

import sturm

DOCUMENT = {"format": "sturm.blurfield/1", "eye": {"prescription": {"sphere_D": -1, "cylinder_D": -0.5, "axis_deg": 30}, "pupil_diameter_mm": 4,
                                                   "accommodation": {"mode": "relaxed"}},
            "spectacles": str(sturm.shipped("lenses/progressive_regular.json")),
            "field": {"hfov_deg": 60, "vfov_deg": 40, "directions": [9, 7], "depths": 12, "near_m": 0.25, "far_m": "inf"}}


def address(array):
    return array.__array_interface__["data"][0]


class BlurFields(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.field = sturm.BlurField(DOCUMENT)

    def test_shapes(self):
        self.assertEqual(self.field.voxels.shape, (7, 9, 12, 2, 2))
        self.assertEqual(self.field.nodes.shape, (7, 9, 4, 2, 2))
        self.assertEqual(self.field.usable.shape, (7, 9))
        np.testing.assert_allclose(self.field.vergences_D, np.linspace(4, 0, 12), atol=1e-15)
        self.assertEqual(self.field.summary["directions"]["usable"], int(self.field.usable.sum()))

    def test_nothing_is_copied(self):
        for name in ("voxels", "nodes", "usable"):
            with self.subTest(name):
                first, second = getattr(self.field, name), getattr(self.field, name)
                self.assertEqual(address(first), address(second))
                self.assertIs(first.base, self.field)
                self.assertFalse(first.flags.writeable)

    def test_arrays_outlive_the_name_of_their_field(self):
        voxels = sturm.BlurField(DOCUMENT).voxels
        np.testing.assert_array_equal(voxels, self.field.voxels)

    def test_a_voxel_is_the_ellipse_of_its_line_of_sight(self):
        eye = sturm.Eye(DOCUMENT["eye"])
        lens = sturm.Spectacles("progressive_regular", eye)
        x, y = np.tan(np.radians(30)) * (2 / 8 - 1), np.tan(np.radians(20)) * (1 - 2 * 4 / 6)  # column 1, row 4
        azimuth, elevation = np.degrees(np.arctan(x)), np.degrees(np.arctan(y / np.hypot(1, x)))
        with np.errstate(divide="ignore"):
            rows = sturm.ellipses(eye, 1 / self.field.vergences_D, azimuth, elevation, lens)
        angular = np.stack([rows["angular_xx"], rows["angular_xy"], rows["angular_yx"], rows["angular_yy"]], -1).reshape(-1, 2, 2)
        # Single precision, and the direction from tangents of angles: 1e-6 of some rad/m.
        np.testing.assert_allclose(self.field.voxels[4, 1], angular, atol=1e-5)
        a, b, q0, q1 = self.field.nodes[4, 1].astype(float)
        np.testing.assert_allclose(self.field.vergences_D[:, None, None] * a + b, angular, atol=1e-5)
        np.testing.assert_allclose(self.field.footprint(2 / 8 - 1, 1 - 8 / 6, 2.0), 2 * a + b, atol=1e-5)
        self.assertIsNone(self.field.footprint(1.5, 0, 1))


if __name__ == "__main__":
    unittest.main()
