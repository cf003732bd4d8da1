"""`sturm compare-runs` on the studies: predictions against path tracing, pupil samplings, sin². What another seed moves is within its
uncertainty; what is beyond it is found."""
import copy
import unittest

import documents
from sturm_process import CORNELL_BOX, FAILED, FolderTest, strict_json, sturm
from test_sampling_study import STUDY as SAMPLINGS
from test_sin2_study import EXPERIMENT as SIN2
from test_sin2_study import TABLE

CASE = {"id": "box", "scene": str(CORNELL_BOX), "camera": {**documents.view()["camera"], "resolution": [32, 32]},
        "eye": documents.view()["eye"], "predictions": ["ellipses", "layered"], "samples_per_pixel": 16, "sharp_samples_per_pixel": 16, "replicates": 6}


class CompareStudies(FolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.reports, cls.pages = {}, {}

    def setUp(self):
        super().setUp()
        self.write("eyes.csv", TABLE)
        self.write("gates.json", documents.changed(documents.gates(), "/gates", [
            {"id": "similar", "title": "Similar", "statistic": "agreement_ssim_display_min/layered", "comparison": "at_least", "bound": 0.5,
             "reason": "a picture of something else is below it"}]))
        experiment = self.write("experiment.json", {
            "format": "sturm.experiment/1", "title": "Studies", "agreement": [CASE], "sampling_study": {**SAMPLINGS, "samples_per_pixel": 16},
            "sin2_study": SIN2["sin2_study"], "gates": "gates.json"})
        for name, seed in (("first", 1), ("other", 2)):  # each is run once for all tests
            if name not in self.reports:
                self.succeed("run", experiment, "--out", self.folder / name, "--seed", seed, "--quiet")
                self.reports[name] = strict_json((self.folder / name / "report.json").read_text())
                self.pages[name] = (self.folder / name / "report.html").read_text()
            self.write(name + "/report.json", self.reports[name])

    def compare(self, before, after):
        """The comparison and the exit status with --gate."""
        process = sturm("compare-runs", self.folder / before, self.folder / after, "--json", "-", "--gate")
        return strict_json(process.stdout), process.returncode

    def changed(self, change):
        report = copy.deepcopy(self.reports["first"])
        change(report)
        self.write("mutated/report.json", report)
        return self.compare("first", "mutated")

    def test_another_seed_changes_nothing_beyond_uncertainty(self):
        comparison, status = self.compare("first", "other")
        self.assertEqual(status, 0)
        # Times are of one machine in one hour: they differ, and nothing says what that means.
        self.assertEqual({(change["name"], change["kind"]) for change in comparison["changes"]},
                         {(f"prediction box, {kind}: times faster", "without_uncertainty") for kind in ("ellipses", "layered")})
        table = sturm("compare-runs", self.folder / "first", self.folder / "other").stdout
        self.assertTrue(table.startswith("No uncertainty is known"), table)
        self.assertNotIn("Changed beyond", table)
        parts = sum(len(p["parts"]) for p in self.reports["first"]["agreement"][0]["predictions"])
        # Two numbers of each part of a prediction (an SSIM may be missing in small ones), two noise floors, bias and noise of 8 samplings.
        self.assertGreater(comparison["tests"], parts + 2 + 2 * 8)
        # 17 checks, 5 numbers of 3 models, 6 of some rows of the population, 3 point spreads with theirs and theory's two radii.
        self.assertGreater(comparison["bounded"], 17 + 5 * 3 + 3 + 2 * 4)
        self.succeed("validate", self.write("comparison.json", comparison))
        # They did move: it is the uncertainty that explains it.
        first, other = (self.reports[name]["agreement"][0]["predictions"][1]["parts"][0]["mean_square_display"]["value"] for name in ("first", "other"))
        self.assertNotEqual(first, other)

    def test_a_worse_prediction_is_found(self):
        def worse(report):
            error = report["agreement"][0]["predictions"][1]["parts"][0]["mean_square_display"]
            error["value"] += 100.0 * error["uncertainty"] + 1e-4

        comparison, status = self.changed(worse)
        change, = comparison["changes"]
        self.assertEqual((change["name"], change["kind"], change["direction"], status),
                         ("prediction box, layered, whole: mean square error", "beyond_uncertainty", "worse", FAILED))

    def test_a_change_within_its_uncertainty_is_not_listed(self):
        def moved(report):
            error = report["agreement"][0]["predictions"][1]["parts"][0]["mean_square_display"]
            error["value"] += error["uncertainty"]
            entry = report["sampling_study"]["entries"][0]
            entry["noise"] += entry["noise_standard_error"]
            entry["mean_square_bias"] += entry["mean_square_bias_standard_error"]
            view = report["sin2_study"]["gallery"][0]
            view["models"][1]["total_variation"] += view["noise_total_variation"]
            report["sin2_study"]["checks"]["sin2_vs_closed_form_max"]["value"] += 1e-9

        comparison, status = self.changed(moved)
        self.assertEqual((comparison["changes"], status), ([], 0))

    def test_a_noisier_reference_is_found(self):
        def noisier(report):
            entry = report["agreement"][0]
            entry["noise_floor"]["rmse_display"] += 100.0 * entry["noise_floor_uncertainty"]["rmse_display"]

        comparison, status = self.changed(noisier)
        change, = comparison["changes"]
        self.assertEqual((change["name"], change["kind"], change["direction"], status),
                         ("prediction box: noise floor of rmse_display", "beyond_uncertainty", "worse", FAILED))

    def test_a_wider_point_spread_is_found(self):
        def wider(report):
            spread = report["sin2_study"]["gallery"][0]["models"][1]
            spread["radius_80_arcmin"] += 9.0 * spread["radius_80_error_of_independent_rays_arcmin"]  # beyond 4 of either run

        comparison, status = self.changed(wider)
        change, = comparison["changes"]
        self.assertEqual((change["kind"], change["direction"], status), ("beyond_uncertainty", "neither", 0))
        self.assertTrue(change["name"].endswith(": radius_80 [arcmin]"), change["name"])

    def test_a_bias_that_comes_up_is_found(self):
        def biased(report):
            entry = next(e for e in report["sampling_study"]["entries"] if e["sampling"] == "uniform_polar_weighted")
            entry["mean_square_bias"] = 100.0 * entry["mean_square_bias_standard_error"]

        comparison, status = self.changed(biased)
        change, = comparison["changes"]
        self.assertIn("uniform_polar_weighted", change["name"])
        self.assertEqual((change["direction"], status), ("worse", FAILED))

    def test_sin2_away_from_its_closed_form_is_found(self):
        def away(report):
            report["sin2_study"]["checks"]["sin2_vs_closed_form_max"]["value"] = 1e-3

        comparison, status = self.changed(away)
        change, = comparison["changes"]
        self.assertEqual((change["name"], change["standard_error"], change["z"], status),
                         ("sin² study, sin2_vs_closed_form_max", None, None, FAILED))

    def test_the_page_has_a_row_for_each_case(self):
        page = self.pages["first"]
        table = page[page.index('id="cases"'):page.index("</table>", page.index('id="cases"'))]
        for section, rows in (("agreement", 2), ("sampling_study", 8), ("sin2_study", 17 + 3)):
            self.assertEqual(table.count(f'<a href="#{section}">'), rows, section)


if __name__ == "__main__":
    unittest.main()
