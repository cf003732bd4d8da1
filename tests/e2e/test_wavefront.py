"""Eyes with measured wavefronts in `sturm ellipse`: other programs' moments, real eyes, smaller pupils, frames."""
import csv
import json
import math
import unittest

from sturm_process import SOURCE, FolderTest, strict_json

REFERENCE = SOURCE / "tests/reference/wave_psf.json"
ARCMIN = 60 * 180 / math.pi


def query(eye, *methods, distance="inf", **rays):
    return {"format": "sturm.ellipse/1", "eye": eye, "targets": [{"distance_m": distance}], "methods": list(methods),
            "rays": rays or {"quadrature": {"radial": 20, "azimuthal": 64}}}


def eye(coefficients, pupil_mm, used_mm=None):
    return {"wavefront": {"coefficients_um": coefficients, "pupil_diameter_mm": pupil_mm}, "pupil_diameter_mm": used_mm or pupil_mm}


class Wavefront(FolderTest):
    def results(self, document):
        return strict_json(self.succeed("ellipse", self.write("query.json", document)).stdout)["results"]

    def test_geometric_moments_are_the_references(self):
        cases = json.loads(REFERENCE.read_text())["cases"]
        aberrated = [case for case in cases if case["inputs"]["zernike_osa_um"]]
        self.assertEqual(len(aberrated), 11)
        for case in aberrated:
            with self.subTest(case["id"]):
                [result] = self.results(query(eye(case["inputs"]["zernike_osa_um"], case["inputs"]["pupil_mm"]), "rays:zernike"))
                expected = case["outputs"]["geometric"]
                # The reference is +grad W in the examiner's frame; rays are -grad W, x flipped: of the centroid y changes its sign, of the
                # covariance xy does.
                x, y = expected["centroid_arcmin"]
                xx, xy, yy = expected["cov_arcmin2_xx_xy_yy"]
                for got, wanted in zip(result["centroid_rad"], (x, -y)):
                    self.assertAlmostEqual(got * ARCMIN, wanted, delta=1e-12)
                for got, wanted in zip(result["covariance_rad2"], (xx, -xy, yy)):
                    self.assertAlmostEqual(got * ARCMIN**2, wanted, delta=1e-12 * (xx + yy))

    def test_real_eyes_have_the_power_of_their_rows(self):
        """M, J0 and J45 of the table were derived from the coefficients by its maker, with four digits."""
        with open(SOURCE / "configs/data/jaeken_artal2012_fovea.csv", encoding="utf-8") as lines:
            rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        for name, subject, side in (("jaeken_36_right", "36", "OD"), ("jaeken_4_left", "4", "OS")):
            row = next(r for r in rows if r["subject"] == subject and r["eye"] == side)
            [result] = self.results(query(str(SOURCE / f"configs/eyes/{name}.json"), "conoid"))
            xx, xy, yy = (-value for value in result["wavefront_curvature_D"])  # of the relaxed eye: -F
            for got, key in ((0.5 * (xx + yy), "M_D"), (0.5 * (xx - yy), "J0_D"), (-xy, "J45_D")):
                self.assertAlmostEqual(got, float(row[key]), delta=6e-5, msg=f"{name} {key}")

    def test_eye_files_are_their_rows(self):
        import importlib.util
        spec = importlib.util.spec_from_file_location("make_wavefront_eyes", SOURCE / "scripts/make_wavefront_eyes.py")
        maker = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(maker)
        for name, arguments in maker.EYES.items():
            self.assertEqual(json.loads((SOURCE / f"configs/eyes/{name}.json").read_text()), maker.eye(*arguments), name)
            self.succeed("validate", SOURCE / f"configs/eyes/{name}.json")

    def test_a_prescription_is_a_second_order_wavefront(self):
        # -1 D x 30 at the cornea over 3 mm; literals of case E05.
        wave = eye({"3": -0.19887378220871652, "4": 0.16237976320958225, "5": -0.11481983169296153}, 3.0)
        written = {"prescription": {"sphere_D": 0, "cylinder_D": -1, "axis_deg": 30, "vertex_distance_mm": 0}, "pupil_diameter_mm": 3}
        for axis_eye in (wave, written):
            for result in self.results(query(axis_eye, "rays:zernike", "rays:power_matrix", "conoid")):
                self.assertAlmostEqual(result["semi_axes_rad"][0], 1.5e-3, delta=1e-14)
                self.assertAlmostEqual(result["semi_axes_rad"][1], 0.0, delta=1e-11)  # the root of a covariance that has rounding of 1e-22
                # The power of AXIS 30 acts along the examiner's 120, the wearer's 60.
                self.assertAlmostEqual(result["orientation_deg"], 60.0, delta=1e-6)
        mirrored = eye({"3": 0.19887378220871652, "4": 0.16237976320958225, "5": -0.11481983169296153}, 3.0)
        self.assertAlmostEqual(self.results(query(mirrored, "conoid"))[0]["orientation_deg"], -60.0, delta=1e-6)

    def test_a_smaller_pupil_sees_the_middle_of_the_wave(self):
        # Spherical aberration c sqrt5 (6 r^4 - 6 r^2 + 1) at a tenth of the pupil is the defocus 12 sqrt5 c/a^2 of its centre, up to r^2.
        [rays, conoid] = self.results(query(eye({"12": 0.2}, 6, 0.06), "rays:zernike", "conoid"))
        expected = 26.832815729997478 * 0.2e-6 / 9e-6 * 3e-5
        self.assertAlmostEqual(rays["semi_axes_rad"][0] / expected, 1.0, delta=2e-4)  # 2 (r/a)^2
        self.assertAlmostEqual(conoid["semi_axes_rad"][0] / expected, 1.0, delta=2e-4)

    def test_sampling_and_apodization(self):
        defocus = {"prescription": {"sphere_D": -1, "vertex_distance_mm": 0}, "pupil_diameter_mm": 6}
        for sampling, apodized, square in (("uniform_disk", 0, 1 / 2), ("uniform_polar", 0, 1 / 3), ("uniform_polar_weighted", 0, 1 / 2),
                                           ("rings", 0, 9 / 16), ("uniform_disk", 0.05, None), ("uniform_polar_weighted", 0.05, None)):
            with self.subTest(sampling=sampling, apodized=apodized):
                if square is None:
                    q = apodized * 9 * math.log(10)
                    square = 1 / q - math.exp(-q) / (1 - math.exp(-q))
                document = query(dict(defocus, stiles_crawford_per_mm2=apodized), "rays:power_matrix", count=4096, sampling=sampling)
                [result] = self.results(document)
                xx, _, yy = result["covariance_rad2"]
                error = math.hypot(result["standard_error"]["covariance_rad2"][0], result["standard_error"]["covariance_rad2"][2])
                self.assertAlmostEqual((xx + yy) / 9e-6, square, delta=5 * error / 9e-6 + 1e-9)  # 5 sigma of 16 scramblings


if __name__ == "__main__":
    unittest.main()
