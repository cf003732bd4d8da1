"""The numbers are those of the command line, to the last bit: ellipses of 413 people's prescriptions, lenses, wavefronts, point spreads."""
import csv
import json
import math
import os
import unittest

import numpy as np

import sturm
from sturm_process import SOURCE, FolderTest, strict_json

TABLE = SOURCE / "configs/data/papila_prescriptions.csv"
DISTANCES_M = [0.25, 0.4, 1.0, 1 / 3, 6.0, math.inf]
GAZES_DEG = [(0, 0), (20, -10), (-35, 5)]


def prescriptions():
    with TABLE.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [{"sphere_D": float(r["sph_D"]), "cylinder_D": float(r["cyl_D"]), "axis_deg": float(r["axis_deg"]), "vertex_distance_mm": 12} for r in rows]


def query(eye, spectacles=None, distances_m=DISTANCES_M, gazes_deg=((0, 0),)):
    targets = [{"distance_m": "inf" if math.isinf(d) else d, "gaze_deg": list(gaze)} for gaze in gazes_deg for d in distances_m]
    document = {"format": "sturm.ellipse/1", "eye": eye, "targets": targets, "methods": ["conoid"]}
    return {**document, "spectacles": spectacles} if spectacles else document


class EllipsesTest(FolderTest):
    def from_command_line(self, document):
        return strict_json(self.succeed("ellipse", self.write("query.json", document)).stdout)["results"]

    def assert_same_bits(self, rows, results):
        self.assertEqual(rows.shape, (len(results),))
        for row, result in zip(rows, results):
            self.assertEqual(sturm.STATUS[row["status"]], result["status"])
            if result["status"] != "ok":
                self.assertTrue(all(math.isnan(row[name]) for name in row.dtype.names if name != "status"))
                continue
            self.assertEqual(row["accommodation_D"], result["accommodation_D"])
            self.assertEqual([row["semi_major_rad"], row["semi_minor_rad"]], result["semi_axes_rad"])
            self.assertEqual(row["orientation_deg"] if not math.isnan(row["orientation_deg"]) else None, result["orientation_deg"])
            if result["semi_axes_m"] is None:
                self.assertTrue(math.isnan(row["semi_major_m"]) and math.isnan(row["semi_minor_m"]))
                angular = [[row["angular_xx"], row["angular_xy"]], [row["angular_yx"], row["angular_yy"]]]
                self.assertEqual(angular, result["footprint"])
            else:
                self.assertEqual([row["semi_major_m"], row["semi_minor_m"]], result["semi_axes_m"])


class RealPrescriptions(EllipsesTest):
    def test_the_naked_eyes_of_413_prescriptions(self):
        known = prescriptions()
        self.assertEqual(len(known), 413)
        for number, rx in enumerate(known):
            accommodation = {"mode": "best", "amplitude_D": number % 5} if number % 2 else {"mode": "relaxed"}
            eye = {"prescription": rx, "pupil_diameter_mm": 2 + number % 6, "accommodation": accommodation}
            with self.subTest(number=number, **rx):
                self.assert_same_bits(sturm.ellipses(sturm.Eye(eye), DISTANCES_M), self.from_command_line(query(eye)))

    def test_the_table_is_read_as_it_is_written(self):
        rows = sturm.read_prescription_table(TABLE)
        self.assertEqual([[r["sphere_D"], r["cylinder_D"], r["axis_deg"]] for r in rows],
                         [[r["sphere_D"], r["cylinder_D"], r["axis_deg"]] for r in prescriptions()])


class Lenses(EllipsesTest):
    def test_shipped_lenses_for_oblique_gazes(self):
        eye = {"prescription": {"sphere_D": -1, "cylinder_D": -0.75, "axis_deg": 25, "vertex_distance_mm": 12}, "pupil_diameter_mm": 4,
               "accommodation": {"mode": "best", "amplitude_D": 1.5}}
        wearer = sturm.Eye(eye)
        for name in ("progressive_regular", "aspheric_plus", "oblique_astigmat", "high_minus_p069"):
            with self.subTest(name):
                lens = sturm.Spectacles(name, wearer)
                azimuths, elevations = np.transpose(GAZES_DEG + [(80, 0)])  # the last one looks past the lens
                rows = sturm.ellipses(wearer, DISTANCES_M, azimuths[:, None], elevations[:, None], lens)
                self.assertEqual(rows.shape, (4, len(DISTANCES_M)))
                results = self.from_command_line(query(eye, str(sturm.shipped(f"lenses/{name}.json")), gazes_deg=GAZES_DEG + [(80, 0)]))
                self.assert_same_bits(rows.reshape(-1), results)
                self.assertEqual(sturm.STATUS[rows[-1, 0]["status"]], "missed_lens")

    def test_the_report_of_a_lens(self):
        path = sturm.shipped("lenses/progressive_regular.json")
        reported = strict_json(self.succeed("lens", path, "--azimuth-deg", "-10:10:10", "--elevation-deg", "0").stdout)
        self.assertEqual(sturm.Spectacles(path).report([-10, 0, 10], [0]), reported)


class Documents(FolderTest):
    def test_a_query_by_rays(self):
        document = query({"prescription": "-2.00 -1.50 x 30", "pupil_diameter_mm": 4}, distances_m=[0.5, math.inf])
        document["methods"] = ["conoid", "previous", "rays:power_matrix"]
        document["rays"] = {"count": 256, "replicates": 4}
        printed = strict_json(self.succeed("ellipse", self.write("query.json", document)).stdout)
        self.assertEqual(sturm.ellipse(document), printed)
        self.assertEqual(sturm.ellipse(self.folder / "query.json"), printed)

    def test_point_spreads(self):
        document = {"format": "sturm.psf/1", "eye": {"prescription": {"sphere_D": -1, "cylinder_D": -0.5, "axis_deg": 30}, "pupil_diameter_mm": 3},
                    "defocus_D": [0, 1], "lights": [{"id": "green", "wavelength_nm": 555}], "rays": {"count": 4096}, "waves": {"grid": 256},
                    "picture": {"pixel_arcmin": 0.5, "size_px": 33}}
        printed = strict_json(self.succeed("psf", self.write("query.json", document)).stdout)
        spreads = sturm.point_spreads(document)
        self.assertEqual([spread.measures for spread in spreads], printed["results"])
        for spread in spreads:
            self.assertEqual(spread.picture.shape, (33, 33))
            self.assertEqual(spread.pixel_arcmin, 0.5)
            # The centroid of the picture: x to the right, y up from the middle. Pixels of half an arcminute that hold all of the light.
            if spread.measures["model"] == "rays" and spread.picture.sum() > 1 - 1e-9:
                places = 0.5 * (np.arange(33) - 16)
                centroid = [(spread.picture.sum(0) * places).sum(), (spread.picture.sum(1) * -places).sum()]
                np.testing.assert_allclose(centroid, spread.measures["centroid_arcmin"], atol=0.05)  # a tenth of a pixel

    def test_each_point_spread_has_its_own_picture(self):
        """In another order pictures would have the same sums and centroids; their second moments tell them apart."""
        spreads = sturm.point_spreads({"format": "sturm.psf/1", "eye": {"prescription": "-1.00 -0.50 x 30", "pupil_diameter_mm": 3}, "defocus_D": [0, 0.25, 0.5], "models": ["rays"],
                                       "rays": {"count": 65536}, "picture": {"pixel_arcmin": 0.25, "size_px": 129}})
        places = 0.25 * (np.arange(129) - 64)
        for spread in spreads:
            self.assertAlmostEqual(spread.picture.sum(), 1, delta=1e-9)
            x, y = np.meshgrid(places, -places)
            [xx, xy, yy] = [(spread.picture * product).sum() for product in (x * x, x * y, y * y)]
            # A pixel of 0.25' adds 0.25²/12 = 0.0052 to a variance; its edges cut a spread at random, by some hundredths of that.
            np.testing.assert_allclose([xx, xy, yy], spread.measures["covariance_arcmin2"], atol=0.02)
        self.assertEqual(len({round(spread.measures["covariance_arcmin2"][0]) for spread in spreads}), 3)


class NamedEyes(FolderTest):
    def test_a_file_of_a_shipped_eye_s_name_is_the_one_that_is_meant(self):
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        self.assertEqual(sturm.Eye("hofer_5").pupil_diameter_mm, json.loads(sturm.shipped("eyes/hofer_5.json").read_text())["pupil_diameter_mm"])
        self.write("hofer_5", {"prescription": "-1.00 DS", "pupil_diameter_mm": 2.5})
        self.assertEqual(sturm.Eye("hofer_5").pupil_diameter_mm, 2.5)


class Optics(unittest.TestCase):
    def test_an_eye_by_hand(self):
        # -4 D at 12 mm is -4/(1 + 0.048) D at the cornea. The axis at 180 degrees: no cylinder across the horizontal.
        eye = sturm.Eye(prescription="-4.00 DS VD 12", pupil_diameter_mm=5)
        self.assertAlmostEqual(eye.power_vector["M_D"], -4 / 1.048, delta=1e-12)
        np.testing.assert_allclose(eye.correction_D, -4 / 1.048 * np.eye(2), atol=1e-12)
        # 1/0.5 m - 3.8168 D = -1.8168 D over a radius of 2.5 mm.
        self.assertAlmostEqual(float(sturm.ellipses(eye, 0.5)["semi_major_rad"]), 2.5e-3 * (4 / 1.048 - 2), delta=1e-15)
        self.assertEqual(eye.pupil_diameter_mm, 5)

    def test_members_stand_in_place_of_a_document_s(self):
        eye = sturm.Eye("oblique_astigmat", pupil_diameter_mm=6.5)
        self.assertEqual((eye.pupil_diameter_mm, eye.prescription["axis_deg"]), (6.5, 30))

    def test_glasses_are_made_for_their_wearer(self):
        eye = sturm.Eye(prescription="-4.00 -1.50 x 20", pupil_diameter_mm=4)
        far = sturm.ellipses(eye, np.inf, spectacles=sturm.Spectacles("glasses", eye))
        self.assertLess(float(far["semi_major_rad"]), 1e-12)
        self.assertGreater(float(sturm.ellipses(eye, np.inf)["semi_major_rad"]), 5e-3)

    def test_shapes_broadcast(self):
        eye = sturm.Eye("oblique_astigmat")
        self.assertEqual(sturm.ellipses(eye, 1.0).shape, ())
        self.assertEqual(sturm.ellipses(eye, []).shape, (0,))
        self.assertEqual(sturm.ellipses(eye, np.ones((3, 1)), np.zeros(4)).shape, (3, 4))
        flat = sturm.ellipses(eye, np.linspace(0.2, 5, 5000))
        for i in (0, 1023, 1024, 4999):  # both sides of a block that a thread gets
            self.assertEqual(flat[i], sturm.ellipses(eye, np.linspace(0.2, 5, 5000)[i]))

    def test_notation(self):
        right, left = sturm.parse_prescription("OD -2.00 -1.50 x 30 OS +1.25 DS ADD +2.00")
        self.assertEqual((right["eye"], right["sphere_D"], right["cylinder_D"], right["axis_deg"]), ("right", -2.0, -1.5, 30.0))
        self.assertEqual((left["eye"], left["sphere_D"], left["cylinder_D"], left["axis_deg"]), ("left", 1.25, 0.0, None))

    def test_wavefronts(self):
        # Defocus Z(2, 0) = c sqrt(3) (2 r^2 - 1): the eye needs M = -4 sqrt(3) c / a^2 (Thibos, Hong, Bradley & Applegate 2004).
        wave = sturm.Wavefront([0, 0, 0, 0, 0.5], 6)
        self.assertAlmostEqual(wave.power()["M_D"], -4 * math.sqrt(3) * 0.5e-6 / 3e-3 ** 2, delta=1e-12)
        self.assertAlmostEqual(float(wave.height_um(0, 0)), -0.5 * math.sqrt(3), delta=1e-12)
        np.testing.assert_allclose(wave.height_um([3.0, 0.0], [0.0, -3.0]), 0.5 * math.sqrt(3), atol=1e-12)
        np.testing.assert_allclose(wave.coefficients_um, [0, 0, 0, 0, 0.5], atol=1e-15)
        # Half the pupil has a quarter of the defocus.
        self.assertAlmostEqual(wave.rescaled(3).coefficients_um[4], 0.125, delta=1e-15)
        # Horizontal coma leans to the examiner's right, which is the wearer's left.
        coma = sturm.Wavefront([0] * 8 + [1], 6)
        self.assertLess(coma.height_um(2.9, 0), 0)
        self.assertIsNone(sturm.Eye(prescription="-1.00 DS", pupil_diameter_mm=3).wavefront)
        written = json.loads(sturm.shipped("eyes/hofer_5.json").read_text())["wavefront"]
        measured = sturm.Eye("hofer_5").wavefront
        self.assertAlmostEqual(measured.pupil_diameter_mm, written["pupil_diameter_mm"], delta=1e-12)
        for j, coefficient in written["coefficients_um"].items():
            self.assertAlmostEqual(measured.coefficients_um[int(j)], coefficient, delta=1e-14)


if __name__ == "__main__":
    unittest.main()
