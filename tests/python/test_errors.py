"""What is wrong is said as the command line says it: with the place, the value and what was expected."""
import math
import pickle
import unittest

import numpy as np

import sturm
from sturm_process import FolderTest, sturm as program

EYE = {"prescription": {"sphere_D": -1}, "pupil_diameter_mm": 4}


class Errors(FolderTest):
    def error(self, function, *arguments, **options):
        with self.assertRaises(sturm.InputError) as caught:
            function(*arguments, **options)
        return caught.exception

    def test_a_document_names_the_place(self):
        error = self.error(sturm.ellipse, {"format": "sturm.ellipse/1", "eye": {**EYE, "pupil_diameter_mm": -1}, "targets": [{"distance_m": 1}], "methods": ["conoid"]})
        self.assertEqual((error.file, error.pointer, error.value), ("<python>", "/eye/pupil_diameter_mm", "-1"))
        self.assertIn("diameter of the pupil [mm]", error.expected)
        self.assertIsInstance(error, ValueError)
        self.assertIn(error.expected, str(error))

    def test_a_file_has_the_command_line_s_message(self):
        path = self.write("query.json", {"format": "sturm.ellipse/1", "eye": EYE, "targets": [{"distance_m": 1}], "methods": ["conoids"]})
        error = self.error(sturm.ellipse, path)
        process = program("ellipse", path)
        self.assertEqual(process.stderr, f"error: {error}\n")
        self.assertEqual((error.file, error.pointer), (str(path), "/methods/0"))

    def test_a_missing_file(self):
        self.assertEqual(self.error(sturm.render, self.folder / "nowhere.json").file, str(self.folder / "nowhere.json"))

    def test_members_and_notation(self):
        self.assertEqual(self.error(sturm.Eye, pupil_diameter=4).pointer, "/pupil_diameter")
        self.assertEqual(self.error(sturm.Eye, prescription="-2.00 -1.50", pupil_diameter_mm=4).pointer, "/prescription")
        self.assertIn("axis", self.error(sturm.parse_prescription, "-2.00 -1.50").expected.lower())
        self.assertEqual(self.error(sturm.Eye, prescription={"sphere_D": math.nan}, pupil_diameter_mm=4).pointer, "/prescription/sphere_D")
        self.assertEqual(self.error(sturm.Eye, prescription={"sphere_D": object()}, pupil_diameter_mm=4).pointer, "/prescription/sphere_D")

    def test_arrays(self):
        eye = sturm.Eye(EYE)
        for bad in (0.0, -1.0, math.nan, [1.0, -1.0]):
            self.assertEqual(self.error(sturm.ellipses, eye, bad).pointer, "distance_m")
        self.assertEqual(self.error(sturm.ellipses, eye, 1.0, 90.0).pointer, "azimuth_deg")
        with self.assertRaises(ValueError):
            sturm.ellipses(eye, np.ones(3), np.zeros(2))
        picture = np.ones((16, 16, 3))
        self.assertEqual(self.error(sturm.compare, picture, np.ones(5)).pointer, "reference")
        self.assertEqual(self.error(sturm.see, picture, np.ones((4, 4)), eye, vfov_deg=20).pointer, "depth_m")
        self.assertEqual(self.error(sturm.see, picture, 1.0, eye, vfov_deg=200).pointer, "vfov_deg")
        self.error(sturm.see, np.full((16, 16, 3), math.nan), 1.0, eye, vfov_deg=20)
        self.error(sturm.write_picture, self.folder / "a.bmp", picture)

    def test_a_lens_needs_a_prescription_or_a_wearer(self):
        document = {"single_vision": {"refractive_index": 1.6, "center_thickness_mm": 2, "diameter_mm": 60}}
        self.error(sturm.Spectacles, document)
        sturm.Spectacles(document, sturm.Eye(EYE))

    def test_errors_can_be_handed_to_other_processes(self):
        error = self.error(sturm.Eye, pupil_diameter=4)
        copy = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(copy), copy.pointer, copy.expected), (str(error), error.pointer, error.expected))


if __name__ == "__main__":
    unittest.main()
