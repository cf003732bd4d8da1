"""`sturm run` with a section "lens_study": a tiny grid from end to end, resumed and spoilt."""
import csv
import io
import unittest

from documents import changed, without
from sturm_process import WRONG_INPUT, sturm
from study_test import StudyTest

LENSES = [
    {"id": "toric", "prescription": {"sphere_D": -1.5, "cylinder_D": -4, "axis_deg": 55},
     "lens": {"single_vision": {"base_curve_D": 4, "center_thickness_mm": 1.8, "refractive_index": 1.5}}},
    {"id": "round", "note": "from a file", "prescription": {"sphere_D": -3}, "lens": "round.json"},
    {"id": "small", "prescription": {"sphere_D": -3},
     "lens": {"single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5, "diameter_mm": 20}}},
]
ROUND = {"format": "sturm.spectacles/1",
         "single_vision": {"prescription": {"sphere_D": -3}, "base_curve_D": 4, "center_thickness_mm": 2, "refractive_index": 1.5}}
EXPERIMENT = {
    "format": "sturm.experiment/1",
    "title": "A few lenses",
    "lens_study": {
        "lenses": LENSES, "eccentricities_deg": [0, 25, 40], "directions_deg": [0, 60], "distances_m": [0.5, "inf"],
        "pupil_diameters_mm": [0.5, 1, 4], "quadrature": {"radial": 6, "azimuthal": 24},
        "field": {"lens": "toric", "azimuths_deg": [0, 25, 50], "distance_m": 0.5, "pupil_diameter_mm": 4},
    },
    "figures": [{"id": "map", "title": "A map", "caption": "Drawn elsewhere.", "file": "map.svg", "command": "sturm map"}],
    "gates": "gates.json",
}
GATES = {
    "format": "sturm.gates/1",
    "gates": [{"id": "order", "title": "Order 4", "statistic": "lens_order_max_deviation", "comparison": "at_most", "bound": 0.05,
               "reason": "as in the shipped gates"},
              {"id": "mutations", "title": "Each deliberate error is noticed", "statistic": "mutation_min_gates", "comparison": "at_least",
               "bound": 1, "reason": "as in the shipped gates"}],
}
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><rect width="1" height="1"/></svg>'


class LensStudy(StudyTest):
    section = "lens_study"
    document = EXPERIMENT
    gates = GATES
    files = {"round.json": ROUND, "map.svg": SVG}

    def test_a_tiny_grid(self):
        process = self.run_study("out", "--threads", 2)
        out = self.folder / "out"
        self.assertIn("2 of 2 gates passed", process.stdout)
        self.assertIn("Through 3 lenses", process.stdout)
        noticed = self.noticed_by("out")
        # An error of first order makes the error of order 2, which is 2 less than that of the exact first order.
        self.assertEqual(set(noticed), {"published_as_exact", "mirrored_gaze"})
        for gates in noticed.values():
            self.assertGreater(gates["order"]["value"], 1)
            self.assertLess(gates["order"]["honest_value"], 0.05)
        self.succeed("validate", out / "report.json")
        study = self.study("out")
        self.assertEqual(len(study["gazes"]), 3 * (1 + 2 * 2))
        lost = [gaze for gaze in study["gazes"] if gaze["status"] != "ok"]
        # The rim of a 20 mm lens stands 10 mm from the axis, 25.5 mm from the centre of rotation: 21.4 degrees.
        self.assertEqual([(gaze["lens"], gaze["eccentricity_deg"], gaze["status"]) for gaze in lost],
                         [("small", e, "missed_lens") for e in (25, 25, 40, 40)])
        self.assertEqual(len(study["views"]), (len(study["gazes"]) - len(lost)) * 2)
        for view in study["views"]:
            if view["eccentricity_deg"] > 0:
                self.assertAlmostEqual(view["order"], 4.0, delta=0.05)
            for pupil in view["pupils"]:
                self.assertEqual(pupil["rays_lost"], 0)
                self.assertIsNotNone(pupil["ray_transfer"])
        # straight ahead the corrected astigmat's wave is plane behind the lens and leaves the section its axes; a circle needs none
        self.assertEqual([gaze["eq11"]["principal"] for gaze in study["gazes"] if gaze["eccentricity_deg"] == 0], ["free_axes", "ok", "ok"])
        by_key = {(view["lens"], view["eccentricity_deg"], view["distance_m"]): view for view in study["views"]}
        self.assertLess(by_key["toric", 0, 0.5]["first_order"]["published"]["defocus_D"], 1e-10)
        self.assertLess(by_key["round", 40, 0.5]["first_order"]["published"]["defocus_D"], 1e-10)
        self.assertGreater(by_key["toric", 40, 0.5]["first_order"]["published"]["defocus_D"], 0.01)
        self.assertEqual([point["azimuth_deg"] for point in study["field"]["points"]], [0, 25, 50])
        rows = list(csv.reader(io.StringIO((out / "lens_study.csv").read_text())))
        self.assertEqual(len(rows), 1 + len(study["views"]) * 3 * 3 + len(lost))
        self.assertEqual({len(row) for row in rows}, {len(rows[0])})
        self.assertEqual({path.name for path in (out / "figures").iterdir()},
                         {"map.svg", "lens_study_convergence.svg", "lens_study_field.svg", "lens_study_field_ellipses.svg",
                          "lens_study_heat_toric.svg", "lens_study_heat_round.svg", "lens_study_heat_small.svg"})
        self.assertEqual((out / "figures/map.svg").read_text(), SVG)
        html = (out / "report.html").read_text()
        self.assertIn("A map", html)
        self.assertNotRegex(html, r'(src|href)\s*=\s*["\']?https?:')

    def test_a_finer_quadrature_changes_nothing(self):
        self.run_study("coarse", "--quiet", "--set", '/lens_study/quadrature={"radial": 10, "azimuthal": 40}')
        self.run_study("fine", "--quiet", "--set", '/lens_study/quadrature={"radial": 20, "azimuthal": 80}')
        for coarse, fine in zip(self.study("coarse")["views"], self.study("fine")["views"]):
            for a, b in zip(coarse["pupils"], fine["pupils"]):
                for x, y in zip(a["real_semi_axes_arcmin"], b["real_semi_axes_arcmin"]):
                    self.assertAlmostEqual(x, y, delta=1e-11 * max(1.0, y))  # rounding: smooth surfaces converge exponentially

    def test_the_same_numbers_for_any_number_of_threads(self):
        self.run_study("one", "--threads", 1, "--quiet")
        self.run_study("two", "--threads", 2, "--quiet")
        self.assertEqual(self.study("one"), self.study("two"))
        self.assertEqual((self.folder / "one/lens_study.csv").read_bytes(), (self.folder / "two/lens_study.csv").read_bytes())

    def test_resume_takes_lenses_over_unless_their_file_has_changed(self):
        reused = "taken from the interrupted run"
        self.run_study("out")
        whole = self.study("out")
        self.assertEqual(self.run_study("out", "--resume").stderr.count(reused), 3 + 1)  # lenses and the field
        self.assertEqual(self.study("out"), whole)
        (self.folder / "out/parts").glob("*/lens_toric.json").__next__().unlink()  # as if it had died there
        self.assertEqual(self.run_study("out", "--resume").stderr.count(reused), 2 + 1)
        self.assertEqual(self.study("out"), whole)
        self.write("round.json", changed(ROUND, "/single_vision/center_thickness_mm", 3))
        self.assertNotIn(reused, self.run_study("out", "--resume").stderr)

    def test_a_wrong_bound_fails(self):
        self.expect_a_wrong_bound_to_fail(1e-9)

    def test_wrong_input_is_named_and_nothing_is_written(self):
        cases = [("/lens_study/field/lens", "torik", "/lens_study/field/lens"),
                 ("/lens_study/eccentricities_deg", [10, 5], "/lens_study/eccentricities_deg/1"),
                 ("/lens_study/order_pupil_diameters_mm", [0.5, 2], "/lens_study/order_pupil_diameters_mm/1"),
                 ("/lens_study/accommodation", {"mode": "best", "amplitude_D": 2}, "/lens_study/accommodation"),
                 ("/lens_study/lenses/1/id", "toric", "/lens_study/lenses/1/id"),
                 ("/lens_study/lenses/1/lens", "none.json", "/lens_study/lenses/1/lens"),
                 ("/lens_study/lenses/1/lens", None, "/lens_study/lenses/1/lens"),
                 ("/figures/0/file", "gates.json", "gates.json"),
                 ("/figures/0/id", "lens_study_map", "/figures/0/id")]
        self.expect_rejections(cases)
        self.write("experiment.json", without(EXPERIMENT, "/lens_study/lenses/0/prescription"))
        self.assertEqual(sturm("run", self.experiment, "--out", self.folder / "out").returncode, WRONG_INPUT)


if __name__ == "__main__":
    unittest.main()
