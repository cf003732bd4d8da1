"""`sturm compare-runs`: what has changed between two runs beyond its uncertainty."""
import copy
import unittest

import documents
from sturm_process import FAILED, WRONG_INPUT, FolderTest, strict_json, sturm


class CompareRuns(FolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.reports = {}

    def setUp(self):
        super().setUp()
        self.write("gates.json", documents.gates())
        experiment = documents.experiment()
        experiment["images"][0]["replicates"] = 4
        self.experiment = self.write("experiment.json", experiment)
        for name, seed in (("first", 1), ("again", 1), ("other", 2)):  # each is run once for all tests
            if name not in self.reports:
                self.succeed("run", self.experiment, "--out", self.folder / name, "--seed", seed, "--quiet")
                self.reports[name] = strict_json((self.folder / name / "report.json").read_text())
            self.write(name + "/report.json", self.reports[name])

    def compare(self, before, after, *options):
        """The comparison and the exit status with --gate."""
        process = sturm("compare-runs", self.folder / before, self.folder / after, "--json", "-", "--gate", *options)
        return strict_json(process.stdout), process.returncode

    def mutated(self, change):
        report = copy.deepcopy(self.reports["first"])
        change(report)
        return self.write("mutated/report.json", report).parent.name

    def test_the_same_seed_changes_nothing(self):
        comparison, status = self.compare("first", "again")
        self.assertEqual((comparison["changes"], status), ([], 0))
        # 4 ellipses x 2 models with a spread (metalstigmatism is undefined, thin_lens and the myope's have one, too), 2 PSFs, 2 SSIMs
        self.assertGreater(comparison["tests"], 4 * 2 * 3)
        self.assertGreater(comparison["numbers"], comparison["tests"])
        path = self.write("comparison.json", comparison)
        self.succeed("validate", path)

    def test_another_seed_changes_nothing_beyond_uncertainty(self):
        comparison, status = self.compare("first", "other")
        self.assertEqual({change["kind"] for change in comparison["changes"]}, {"without_uncertainty"})
        self.assertEqual(status, 0)
        # Numbers that depend on no seed are the same to the last bit.
        self.assertFalse([change for change in comparison["changes"] if "conoid" in change["name"] or "reference" in change["name"]])

    def test_a_worse_number_is_found(self):
        def worse(report):
            metric = report["images"][0]["metrics"]["ssim_display"]
            metric["value"] -= 1000.0 * metric["uncertainty"] + 0.01

        comparison, status = self.compare("first", self.mutated(worse))
        change, = comparison["changes"]
        self.assertEqual((change["name"], change["kind"], change["direction"], status),
                         ("image box, power_matrix: ssim_display", "beyond_uncertainty", "worse", FAILED))
        self.assertLess(change["z"], -comparison["threshold_z"])
        # The other way round it is an improvement, which no gate rejects.
        back, status = self.compare("mutated", "first")
        self.assertEqual((back["changes"][0]["direction"], status), ("better", 0))

    def test_a_covariance_away_from_its_prediction_is_worse(self):
        def away(report):
            rays = report["ellipses"]["cases"][0]["rays"][3]
            self.assertEqual(rays["ray_model"], "power_matrix")
            rays["covariance_rad2"][0] += 20.0 * rays["covariance_standard_error_rad2"][0]

        comparison, status = self.compare("first", self.mutated(away))
        change, = comparison["changes"]
        self.assertEqual((change["name"], change["direction"], status),
                         ("ellipse oblique|1 m|4 mm, power_matrix: covariance xx [rad²]", "worse", FAILED))

    def test_few_replicates_prove_little(self):
        """Four replicates have a t distribution with heavy tails: 5 standard errors of one side are within it."""
        def moved(report):
            metric = report["images"][0]["metrics"]["ssim_display"]
            metric["value"] -= 5.0 * metric["uncertainty"]

        comparison, status = self.compare("first", self.mutated(moved))
        self.assertEqual((comparison["changes"], status), ([], 0))

    def test_a_missing_case_and_a_failing_gate_are_worse(self):
        def poorer(report):
            del report["psfs"][0]
            report["gates"][0]["passed"] = False

        comparison, status = self.compare("first", self.mutated(poorer))
        self.assertEqual(sorted((change["kind"], change["direction"]) for change in comparison["changes"]),
                         [("missing", "worse"), ("missing", "worse"), ("verdict", "worse")])
        self.assertEqual(status, FAILED)
        back, status = self.compare("mutated", "first")
        self.assertEqual(({change["kind"] for change in back["changes"]}, status), ({"new", "verdict"}, 0))

    def test_without_gate_the_table_only_reports(self):
        def worse(report):
            report["gates"][0]["passed"] = False

        process = self.succeed("compare-runs", self.folder / "first", self.folder / self.mutated(worse))
        self.assertIn("WORSE", process.stdout)
        self.assertIn("gate matrix_equals_conoid", process.stdout)
        self.assertIn("1 worse.", process.stdout)

    def test_wrong_input(self):
        self.assertEqual(sturm("compare-runs", self.folder / "first", self.folder / "nowhere").returncode, WRONG_INPUT)
        self.assertEqual(sturm("compare-runs", self.folder / "first", self.folder / "gates.json").returncode, WRONG_INPUT)
        self.assertEqual(sturm("compare-runs", self.folder / "first", self.folder / "other", "--level", 2).returncode, WRONG_INPUT)


if __name__ == "__main__":
    unittest.main()
