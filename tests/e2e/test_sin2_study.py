"""`sturm run` with a section "sin2_study": a small grid from end to end, resumed and spoilt, and the shipped study's inputs."""
import csv
import io
import math
import unittest

from study_test import StudyTest

TABLE = "# source: made up\neye,id,sph_D,cyl_D,axis_deg\nOD,A,-2.5,-3.25,35\nOS,A,0.5,-0.5,100\n"
FOCUS = {"mode": "fixed", "focus_distance_m": 1}
EXPERIMENT = {
    "format": "sturm.experiment/1",
    "title": "A few eyes",
    "sin2_study": {
        "grid": {"spheres_D": [-2, -1, 0, 1], "cylinders_D": [0, -2], "axes_deg": [30, 90]},
        "real_eyes": {"file": "eyes.csv"},
        "distances_m": ["inf", 1], "pupil_diameters_mm": [2, 4], "accommodations": [{"mode": "relaxed"}, FOCUS],
        "reference": {"pupil_diameter_mm": 4, "distance_m": 1}, "gallery_rays": 4096,
        "gallery": [{"id": "circle", "title": "A rose", "prescription": {"sphere_D": 1, "cylinder_D": -2, "axis_deg": 30, "vertex_distance_mm": 0},
                     "pupil_diameter_mm": 4, "distance_m": 1, "accommodation": FOCUS}],
    },
    "gates": "gates.json",
}
GATES = {
    "format": "sturm.gates/1",
    "gates": [{"id": "closed_form", "title": "sin² has its closed form", "statistic": "sin2_study/sin2_vs_closed_form_max",
               "comparison": "at_most", "bound": 1e-9, "reason": "as in the shipped gates"},
              {"id": "theory", "title": "Matrix rays are wavefront theory", "statistic": "sin2_study/matrix_vs_theory_max",
               "comparison": "at_most", "bound": 1e-9, "reason": "as in the shipped gates"},
              {"id": "mutations", "title": "Each deliberate error is noticed", "statistic": "mutation_min_gates", "comparison": "at_least",
               "bound": 1, "reason": "as in the shipped gates"}],
}


class Sin2Study(StudyTest):
    section = "sin2_study"
    document = EXPERIMENT
    gates = GATES
    files = {"eyes.csv": TABLE}

    def rows(self, folder):
        return list(csv.DictReader(io.StringIO((self.folder / folder / "sin2_study.csv").read_text())))

    def test_a_small_grid(self):
        process = self.run_study("out", "--threads", 2)
        self.assertIn("3 of 3 gates passed", process.stdout)
        noticed = {mutation: set(gates) for mutation, gates in self.noticed_by("out").items()}
        self.assertEqual(noticed, {"repaired_as_sin2": {"closed_form"}, "wrong_coefficient": {"closed_form"}, "mirrored_axis": {"theory"},
                                   "sin2_as_matrix": {"theory"}})
        self.succeed("validate", self.folder / "out/report.json")
        rows = self.rows("out")
        eyes = 4 * (1 + 2) + 2  # a sphere needs no second axis
        self.assertEqual(len(rows), eyes * 2 * 2 * 2 * 3)
        by_key = {tuple(row[key] for key in ("eye", "distance_m", "pupil_mm", "accommodation", "ray_model")): row for row in rows}

        def case(eye, model, distance="1", state="focus 1 m"):
            return by_key[eye, distance, "4", state, model]

        # Numbers of the table have nine digits: 1e-7 of at most 14. Half-widths worked by hand: a = 2 mm; 1 mrad is 3.4377 arcmin.
        mrad = 3.4377467707849
        line = case("+0.00 -2.00 × 30", "sin2_radial")  # principal values 0 and −2 D at the focus
        self.assertAlmostEqual(float(line["true_semi_major_arcmin"]), 4 * mrad, delta=1e-7)
        self.assertAlmostEqual(float(line["semi_major_arcmin"]), 0.7905694150420949 * 4 * mrad, delta=1e-7)
        self.assertAlmostEqual(float(line["semi_minor_arcmin"]), 0.35355339059327373 * 4 * mrad, delta=1e-7)
        # The width of the true line is the root of a rounding error of its variance, 1e-8 D.
        self.assertAlmostEqual(float(line["error_D"]), 0.35355339059327373 * 2, delta=1e-7)
        circle = case("+1.00 -2.00 × 30", "sin2_radial")
        self.assertAlmostEqual(float(circle["semi_major_arcmin"]), 0.7071067811865476 * 2 * mrad, delta=1e-6)
        self.assertEqual(circle["difference_ratio"], "")
        # As printed: at zero power the eye is focused at infinity; at P = −1/d_f all rays are dropped; relaxed it is undefined.
        self.assertAlmostEqual(float(case("+0.00", "metalstigmatism")["error_D"]), 1.0, delta=1e-7)
        pole = case("-1.00", "metalstigmatism")
        self.assertEqual((pole["status"], pole["rays_dropped"], pole["error_D"]), ("pole", pole["rays"], ""))
        self.assertEqual(case("+0.00", "metalstigmatism", state="relaxed")["status"], "undefined")
        # Powers 0 … −2 D, −1 D on a meridian between them: no second moments exist although hardly a ray meets the pole.
        between = case("+0.00 -2.00 × 30", "metalstigmatism")
        self.assertEqual((between["status"], between["error_D"]), ("pole", ""))
        self.assertLess(float(between["rays_dropped"]), float(between["rays"]))
        # +1.00 at its focus: slope −1/(1 + 1) D in place of +1 D, seen from 1 m.
        self.assertAlmostEqual(float(case("+1.00", "metalstigmatism")["semi_major_arcmin"]), 0.5 * 2 * mrad, delta=1e-7)
        for row in rows:
            if row["ray_model"] == "power_matrix":
                self.assertLess(float(row["error_D"]), 1e-6)
            if row["ray_model"] == "sin2_radial":
                self.assertLess(float(row["repaired_deviation"]), 1e-12)

        study = self.study("out")
        self.assertEqual({row["ray_model"]: row["cases"] for row in study["models"]},
                         {model: eyes * 8 for model in ("metalstigmatism", "sin2_radial", "power_matrix")})
        poles = [row for row in rows if row["status"] == "pole"]
        self.assertEqual({row["ray_model"]: row["pole"] for row in study["models"]}, {"metalstigmatism": len(poles), "sin2_radial": 0, "power_matrix": 0})
        worst = [row for row in study["population"] if row["ray_model"] == "sin2_radial" and row["accommodation"] is None]
        self.assertEqual([row["eyes"] for row in worst], [2])
        self.assertGreater(worst[0]["error_D"]["max"], 0.25)
        psfs = {psf["model"]: psf for psf in study["gallery"][0]["models"]}
        self.assertGreater(psfs["sin2_radial"]["total_variation_over_noise"], 3)
        self.assertLess(psfs["repaired"]["total_variation_over_noise"], 1.5)
        # Half of a disc's light lies within √½ of its radius; a is 2 mm, V is ±1 D.
        self.assertAlmostEqual(psfs["wavefront"]["radius_50_arcmin"], math.sqrt(0.5) * 2 * mrad, delta=0.02)
        self.assertEqual({path.name for path in (self.folder / "out/figures").iterdir()},
                         {"sin2_study_map.svg", "sin2_study_gallery.svg", "sin2_study_population.svg", "sin2_study_sphere.svg"})
        html = (self.folder / "out/report.html").read_text()
        self.assertIn("sturm run experiment.json", html)
        self.assertNotRegex(html, r'(src|href)\s*=\s*["\']?https?:')

    def test_the_same_numbers_for_any_number_of_threads_and_after_a_resume(self):
        self.run_study("one", "--threads", 1, "--quiet")
        self.run_study("two", "--threads", 2, "--quiet")
        self.assertEqual(self.study("one"), self.study("two"))
        csv_of = {folder: (self.folder / folder / "sin2_study.csv").read_bytes() for folder in ("one", "two")}
        self.assertEqual(csv_of["one"], csv_of["two"])
        reused = "taken from the interrupted run"
        next((self.folder / "two/parts").glob("*/sin2_real_eyes.json")).unlink()  # as if it had died there
        self.assertEqual(self.run_study("two", "--resume").stderr.count(reused), 4 + 1)  # spheres and the gallery
        self.assertEqual(self.study("two"), self.study("one"))
        self.assertEqual((self.folder / "two/sin2_study.csv").read_bytes(), csv_of["one"])
        self.write("eyes.csv", TABLE.replace("-3.25", "-3.00"))
        self.assertNotIn(reused, self.run_study("two", "--resume").stderr)

    def test_a_wrong_bound_fails(self):
        self.expect_a_wrong_bound_to_fail(1e-30)

    def test_wrong_input_is_named_and_nothing_is_written(self):
        section = "/sin2_study"
        cases = [(section + "/reference/pupil_diameter_mm", 3, section + "/reference/pupil_diameter_mm"),
                 (section + "/reference/distance_m", 2, section + "/reference/distance_m"),
                 (section + "/accommodations", [{"mode": "relaxed"}], section + "/reference/distance_m"),
                 (section + "/real_eyes/file", "none.csv", section + "/real_eyes/file"),
                 (section + "/real_eyes/file", "gates.json", "gates.json"),
                 (section + "/grid/spheres_D", [99], section + "/grid/spheres_D/0"),
                 (section + "/gallery/0/prescription/axis_deg", 200, section + "/gallery/0/prescription/axis_deg")]
        self.expect_rejections(cases)
        for table, named in [(TABLE.replace("-3.25", "minus"), "cyl_D"), (TABLE.replace("sph_D", "ball_D"), "sph_D"),
                             (TABLE.replace("-2.5,", ","), "line 3"), ("eye,id,sph_D,cyl_D,axis_deg\n", "at least one")]:
            with self.subTest(table=table):
                self.write("eyes.csv", table)
                self.expect_rejection(named)


if __name__ == "__main__":
    unittest.main()
