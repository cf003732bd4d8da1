"""`sturm ellipse` through thick spectacle lenses, against tests/reference/thick_lens.json: exact rays by other people's programs.

The file is in the examiner's frame (x flipped), its origin is the eye's centre of rotation, its z runs from the eye to the object.
"""
import json
import math
import unittest

import documents
from sturm_process import SOURCE, WRONG_INPUT, FolderTest, strict_json, sturm
from thick_lens_cases import CASES, EveryCase, direction, gaze_deg, lens_of
from wearer_frame import difference, folded_deg, frobenius, from_examiner

CENTER_MM = 13.0
QUADRATURE = {"quadrature": {"radial": 14, "azimuthal": 56}}


def ask(query):
    process = sturm("ellipse", "-", stdin=json.dumps(query))
    if process.returncode:
        raise AssertionError(process.stderr)
    return strict_json(process.stdout)["results"]


def point_m(mm):
    return [-1e-3 * mm[0], 1e-3 * mm[1], 1e-3 * (CENTER_MM - mm[2])]


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)))


def query_of(case, accommodation, distances, methods, rays=None):
    given = case["inputs"]
    rx = given["Rx"]
    return {
        "format": "sturm.ellipse/1",
        "eye": {
            "prescription": {"sphere_D": rx["S"], "cylinder_D": rx["C"], "axis_deg": rx["A"], "vertex_distance_mm": 12},
            "pupil_diameter_mm": given["pupil_mm"], "rotation_center_mm": CENTER_MM, "accommodation": accommodation,
        },
        "spectacles": lens_of(case),
        "targets": [{"gaze_deg": gaze_deg(case["outputs"]), "distance_m": d} for d in distances],
        "methods": methods,
        "rays": rays or {},
    }


class Reference(EveryCase, unittest.TestCase):
    def check(self, case):
        out, distances = case["outputs"], [0.4, 1, 6]
        results = ask(query_of(case, {"mode": "relaxed"}, distances, ["conoid", "rays:power_matrix"], QUADRATURE))
        self.assertEqual(len(results), 6)
        for result in results:
            self.assertEqual(result["status"], "ok")
            # 1e-9 mm; the file's programs agree to 8e-14 mm.
            self.assertLess(distance(result["chief_ray"]["origin_m"], point_m(out["chief"]["exit_point_mm"])), 1e-12)
            self.assertLess(distance(result["chief_ray"]["direction"], direction(out["chief"]["exit_dir"])), 1e-12)
            spot = out["spots_4mm"][f"{distances[result['target']]}m_relaxed"]
            self.check_spot(result, spot)
        curvature = from_examiner(out["exit_wavefront_curvature_D_11_12_22"]["coddington"])
        for got, diverging in zip(results[0]["wavefront_curvature_D"], curvature):
            self.assertAlmostEqual(got, -diverging, delta=1e-8)

    def check_spot(self, result, spot):
        conoid = result["method"] == "conoid"
        expected = [1e-6 * v for v in from_examiner(spot["linear_cov_mm2_xx_xy_yy" if conoid else "cov_mm2_xx_xy_yy"])]
        self.assertLess(frobenius(difference(result["covariance_m2"], expected)), 1e-8 * frobenius(expected), result["method"])
        if conoid:
            self.assertEqual(result["centroid_m"], [0.0, 0.0])
        else:
            self.assertEqual(result["rays"]["launched"], 14 * 56)
            self.assertEqual([result["rays"][key] for key in ("lost_rim", "lost_tir", "lost_no_convergence", "undefined")], [0] * 4)
            # The file prints its centroids with 13 digits of numbers up to 1 mm.
            for got, examiner in zip(result["centroid_m"], [-1e-3 * spot["centroid_mm"][0], 1e-3 * spot["centroid_mm"][1]]):
                self.assertAlmostEqual(got, examiner, delta=1e-12)

    def test_accommodated(self):
        for case in CASES[::6]:
            for d in (0.4, 1, 6):
                with self.subTest(case["id"], distance_m=d):
                    accommodation = {"mode": "fixed", "focus_distance_m": d}
                    for result in ask(query_of(case, accommodation, [d], ["conoid", "rays:power_matrix"], QUADRATURE)):
                        self.assertAlmostEqual(result["accommodation_D"], 1.0 / d, delta=1e-15)
                        self.check_spot(result, case["outputs"]["spots_4mm"][f"{d}m_accommodated"])

    def test_sample_rays(self):
        for case in CASES[::3]:
            rays = case["outputs"]["sample_rays"]
            points = [[-ray["pupil_xy_mm"][0], ray["pupil_xy_mm"][1]] for ray in rays]
            result = ask(query_of(case, {"mode": "relaxed"}, ["inf"], ["rays:power_matrix"], {"pupil_points_mm": points}))[0]
            for got, expected in zip(result["exit_rays"], rays):
                self.assertLess(distance(got["exit_point_m"], point_m(expected["exit_point_mm"])), 1e-12, case["id"])
                self.assertLess(distance(got["exit_direction"], direction(expected["exit_dir"])), 1e-12, case["id"])


def spectacled():
    query = documents.query()
    query["eye"]["prescription"]["vertex_distance_mm"] = 12
    query["spectacles"] = {"single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5}}
    return query


class Wearing(FolderTest):
    def test_the_prescription_corrects_the_far_point_on_the_axis(self):
        query = spectacled()
        query["targets"] = [{"distance_m": "inf"}]
        result = ask(query)[0]
        # Without the lens the blur would be 2 mm times 3.5 D: 7e-3 rad.
        self.assertLess(result["semi_axes_rad"][0], 1e-14)
        for value in result["wavefront_curvature_D"]:
            self.assertAlmostEqual(value, 0.0, delta=1e-12)
        self.assertIsNone(result["semi_axes_m"])

    def test_sampled_rays_agree_with_the_quadrature(self):
        query = spectacled()
        query["targets"] = [{"gaze_deg": [25, -15], "distance_m": 0.5}]
        query["methods"] = ["rays:power_matrix"]
        exact = ask({**query, "rays": QUADRATURE})[0]
        sampled = ask({**query, "rays": {"count": 4096, "replicates": 16}})[0]
        # 5 standard errors from 16 replicates (Student's t, 15 degrees of freedom: p = 2e-4 for one number); the seed is fixed.
        for got, expected, error in zip(sampled["covariance_m2"], exact["covariance_m2"], sampled["standard_error"]["covariance_m2"]):
            self.assertLess(abs(got - expected), 5.0 * error)
        self.assertLess(sampled["standard_error"]["covariance_rel"], 1e-3)
        self.assertEqual(sampled["rays"]["launched"], 16 * 4096)

    def test_small_pupils_agree_with_the_conoid(self):
        query = spectacled()
        query["targets"] = [{"gaze_deg": [25, -15], "distance_m": 0.5}]
        query["methods"] = ["conoid", "rays:power_matrix"]
        query["rays"] = QUADRATURE
        differences = []
        for pupil in (2.0, 1.0):
            query["eye"]["pupil_diameter_mm"] = pupil
            conoid, rays = ask(query)
            differences.append(frobenius(difference(conoid["covariance_m2"], rays["covariance_m2"])) / frobenius(conoid["covariance_m2"]))
        # Third-order aberrations: the relative error of second moments falls with the square of the pupil.
        self.assertAlmostEqual(differences[0] / differences[1], 4.0, delta=0.1)
        self.assertLess(differences[1], 1e-2)

    def test_sin2_rays_go_through_the_lens_too(self):
        query = spectacled()
        query["eye"]["accommodation"] = {"mode": "fixed", "power_D": 0.5}
        query["methods"] = ["rays:sin2_radial", "rays:power_matrix", "rays:pinhole"]
        query["rays"] = QUADRATURE
        sin2, matrix, pinhole = ask(query)
        self.assertEqual(pinhole["semi_axes_m"], [0.0, 0.0])
        self.assertGreater(frobenius(difference(sin2["covariance_m2"], matrix["covariance_m2"])), 0.01 * frobenius(matrix["covariance_m2"]))

    def test_published_and_previous_methods(self):
        query = spectacled()
        query["methods"] = ["conoid", "conoid_published", "previous"]
        query["spectacles"]["single_vision"]["prescription"] = {"sphere_D": -4}
        query["eye"]["accommodation"] = {"mode": "fixed", "power_D": 0.5}
        exact, published, previous = ask(query)
        # On the axis of a lens of revolution the printed equations are exact.
        for got, expected in zip(published["covariance_m2"], exact["covariance_m2"]):
            self.assertAlmostEqual(got, expected, delta=1e-13 * exact["covariance_m2"][2])
        # The older one measures from the eye's side and differs by the lens's magnification.
        self.assertEqual(previous["status"], "ok")
        error = frobenius(difference(previous["covariance_m2"], exact["covariance_m2"])) / frobenius(exact["covariance_m2"])
        self.assertTrue(1e-3 < error < 0.5, error)
        query["targets"] = [{"gaze_deg": [25, 15], "distance_m": 0.5}]
        query["spectacles"]["single_vision"]["prescription"] = {"sphere_D": -4, "cylinder_D": -3, "axis_deg": 75}
        exact, published, previous = ask(query)
        error = frobenius(difference(published["covariance_m2"], exact["covariance_m2"])) / frobenius(exact["covariance_m2"])
        self.assertTrue(1e-4 < error < 0.3, error)

    def test_published_accommodation_is_equation_12(self):
        query = documents.changed(documents.query(), "/eye/accommodation", {"mode": "best", "amplitude_D": 6})
        query["methods"] = ["conoid", "conoid_published", "previous"]
        query["targets"] = [{"distance_m": d} for d in (0.1, 0.2, "inf")]
        results = ask(query)
        for exact, published, previous in zip(results[::3], results[1::3], results[2::3]):
            for result in (published, previous):
                self.assertAlmostEqual(result["accommodation_D"], exact["accommodation_D"], delta=1e-12)
                for got, expected in zip(result["covariance_rad2"], exact["covariance_rad2"]):
                    self.assertAlmostEqual(got, expected, delta=1e-17)

    def test_a_pinhole_has_no_blur_by_any_method(self):
        query = documents.changed(spectacled(), "/eye/pupil_diameter_mm", 0)
        query["methods"] = ["conoid", "conoid_published", "previous", "rays:power_matrix"]
        query["rays"] = {"count": 16, "replicates": 2}
        query["targets"] = [{"gaze_deg": [20, 10], "distance_m": 0.5}]
        for result in ask(query):
            self.assertEqual((result["status"], result["semi_axes_m"]), ("ok", [0.0, 0.0]), result["method"])

    def test_best_accommodation_minimises_the_larger_semi_axis(self):
        query = spectacled()
        query["targets"] = [{"gaze_deg": [30, 20], "distance_m": 0.4}]
        query["eye"]["accommodation"] = {"mode": "best", "amplitude_D": 4}
        best = ask(query)[0]
        self.assertTrue(2.0 < best["accommodation_D"] < 3.0, best["accommodation_D"])
        for change in (-1e-3, 1e-3):
            query["eye"]["accommodation"] = {"mode": "fixed", "power_D": best["accommodation_D"] + change}
            self.assertGreater(ask(query)[0]["semi_axes_m"][0], best["semi_axes_m"][0])
        query["eye"]["accommodation"] = {"mode": "best", "amplitude_D": 1}
        self.assertEqual(ask(query)[0]["accommodation_D"], 1.0)

    def test_mirrored_eye_and_lens_mirror_the_ellipse(self):
        query = spectacled()
        query["targets"] = [{"gaze_deg": [25, 10], "distance_m": 0.5}]
        right = ask(query)[0]
        query["eye"]["prescription"]["axis_deg"] = 150
        query["targets"] = [{"gaze_deg": [-25, 10], "distance_m": 0.5}]
        left = ask(query)[0]
        self.assertAlmostEqual(folded_deg(left["orientation_deg"] + right["orientation_deg"]), 0.0, delta=1e-9)
        self.assertGreater(abs(right["orientation_deg"]), 5.0)
        self.assertAlmostEqual(left["semi_axes_m"][0], right["semi_axes_m"][0], delta=1e-15)
        self.assertAlmostEqual(left["chief_ray"]["origin_m"][0], -right["chief_ray"]["origin_m"][0], delta=1e-16)

    def test_no_lens_power_is_the_naked_eye_from_the_exit_point(self):
        query = documents.query()
        query["spectacles"] = {"center_thickness_mm": 2, "refractive_index": 1.0, "front": {"type": "sphere", "radius_mm": None}, "back": {"type": "sphere", "radius_mm": None}}
        query["targets"] = [{"distance_m": 0.5}]
        seen = ask(query)[0]
        naked = documents.changed(documents.query(), "/targets", [{"distance_m": 0.514}])
        for got, expected in zip(seen["covariance_m2"], ask(naked)[0]["covariance_m2"]):
            self.assertAlmostEqual(got, expected, delta=1e-18)

    def test_rays_that_are_lost_have_a_status_and_no_numbers(self):
        steep = {"center_thickness_mm": 2, "refractive_index": 1.5, "front": {"type": "sphere", "radius_mm": -20}, "back": {"type": "sphere", "radius_mm": None}}
        small = {**steep, "front": {"type": "sphere", "radius_mm": 200}, "diameter_mm": 10}
        for lens, gaze, status in [(steep, [25, 0], "total_internal_reflection"), (small, [30, 0], "missed_lens")]:
            query = documents.changed(documents.query(), "/spectacles", lens)
            query["eye"]["accommodation"] = {"mode": "best", "amplitude_D": 3}
            query["targets"] = [{"gaze_deg": gaze, "distance_m": 1}]
            query["methods"] = ["conoid", "rays:power_matrix"]
            for result in ask(query):
                self.assertEqual(result["status"], status)
                for key in ("semi_axes_m", "semi_axes_rad", "orientation_deg", "covariance_m2", "chief_ray", "accommodation_D"):
                    self.assertIsNone(result[key], key)
            query["targets"] = [{"gaze_deg": [0, 0], "distance_m": 1}]
            self.assertEqual({result["status"] for result in ask(query)}, {"ok"})

    def test_rays_beyond_the_rim_are_counted(self):
        query = documents.changed(documents.query(), "/spectacles", {
            "center_thickness_mm": 2, "refractive_index": 1.5, "diameter_mm": 2, "front": {"type": "sphere", "radius_mm": None}, "back": {"type": "sphere", "radius_mm": None}})
        query["eye"]["prescription"] = {"sphere_D": 0}
        query["methods"] = ["rays:power_matrix"]
        query["rays"] = {"pupil_points_mm": [[0.5, 0], [-0.999, 0], [0, 1.5], [1.2, 1.2]]}
        result = ask(query)[0]
        self.assertEqual((result["rays"]["launched"], result["rays"]["lost_rim"]), (4, 2))
        self.assertEqual([ray is None for ray in result["exit_rays"]], [False, False, True, True])

    def test_a_lens_file(self):
        query = spectacled()
        lens = strict_json((SOURCE / "configs/lenses/oblique_astigmat.json").read_text())
        del lens["$schema"]
        self.write("lenses/l.json", lens)
        self.succeed("validate", self.folder / "lenses/l.json")
        by_name = self.succeed("ellipse", self.write("a.json", {**query, "spectacles": "lenses/l.json"})).stdout
        self.assertEqual(self.succeed("ellipse", self.write("b.json", {**query, "spectacles": lens})).stdout, by_name)

    def test_answers_follow_their_schema(self):
        query = spectacled()
        query["methods"] = ["conoid", "rays:sin2_radial"]
        query["targets"] = [{"gaze_deg": [20, 5], "distance_m": 1}, {"gaze_deg": [85, 0], "distance_m": 1}]
        query["rays"] = {"count": 64, "replicates": 4}
        answer = self.folder / "answer.json"
        self.succeed("ellipse", self.write("query.json", query), "-o", answer)
        self.succeed("validate", answer)

    def test_predictions_and_experiments_refuse_spectacles(self):
        view = documents.changed(documents.view(), "/spectacles", spectacled()["spectacles"])
        view["method"] = {"type": "predict"}
        process = sturm("render", self.write("view.json", view), "-o", self.folder / "a.exr")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/spectacles", process.stderr)
        self.write("gates.json", documents.gates())
        experiment = documents.changed(documents.experiment(), "/spectacles", None)
        process = sturm("run", self.write("experiment.json", experiment), "--out", self.folder / "out")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/spectacles", process.stderr)


if __name__ == "__main__":
    unittest.main()
