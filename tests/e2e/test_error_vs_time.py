"""`sturm run` with a section bench: run time against error of a tiny picture, inline and from a file, and refused where it is wrong."""
import unittest
import xml.etree.ElementTree

import documents
from documents import changed
from study_test import StudyTest
from sturm_process import FAILED, SOURCE, strict_json, sturm

PREDICT = {"method": {"type": "predict", "ray_model": None, "prediction": "multipass", "samples_per_pixel": 2}}
BENCH = {
    "format": "sturm.bench/1",
    "title": "A race <of few>",
    "rounds": 2,
    "reference": {"samples_per_pixel": 64},
    "views": [{"id": "box", "view": "view.json", "patch": {"camera": {"resolution": [24, 20]}}}],
    "methods": [
        {"id": "filtered", "patch": {"method": {"denoise": {}}}, "picture": "denoised", "samples_per_pixel": [2]},
        {"id": "independent", "patch": {"method": {"sampler": "independent"}}, "samples_per_pixel": [1, 16]},
        {"id": "raw", "patch": {"method": {"denoise": {}}}, "samples_per_pixel": [2]},
        {"id": "passes", "patch": PREDICT, "sweep": [{"method": {"passes": 2}}, {"method": {"passes": 4, "smooth": False}}]},
    ],
    "levels": [{"error": "rmse", "level": 0.9}, {"error": "one_minus_ssim", "level": 1e-6}],
    "require": [{"id": "steep", "title": "Errors fall", "statistic": "slope", "error": "rmse", "method": "independent", "at_most": 0, "reason": "more samples, less noise"}],
}
GATES = {"format": "sturm.gates/1", "gates": [
    {"id": "falls", "title": "Errors fall", "statistic": "bench/box/independent/slope/rmse", "comparison": "at_most", "bound": 0, "reason": "more samples, less noise"}]}
EXPERIMENT = {"format": "sturm.experiment/1", "title": "Race", "seed": 3, "gates": "gates.json", "bench": BENCH}


class ErrorVersusTime(StudyTest):
    section = "bench"
    document = EXPERIMENT
    gates = GATES
    files = {"view.json": documents.view()}

    def test_a_tiny_race(self):
        process = self.run_study("out", "--quiet", "--threads", 2)
        self.assertIn("2 of 2 gates passed", process.stdout)  # its own, and the benchmark's requirement
        self.assertIn("box: RMSE 0.9: ", process.stdout)
        out = self.folder / "out"
        self.succeed("validate", out / "report.json")
        report = strict_json((out / "report.json").read_text())
        self.assertEqual(report["spec"]["bench"]["seed"], 3)
        self.assertGreater(report["provenance"]["seconds"]["bench"], 0)
        self.assertEqual(report["bench"]["machine"]["threads"], 2)
        (box,) = report["bench"]["views"]
        methods = {method["id"]: method for method in box["methods"]}
        self.assertEqual({name: method["biased"] for name, method in methods.items()}, {"filtered": True, "independent": False, "raw": False, "passes": False})
        self.assertEqual([point["setting"] for point in methods["passes"]["points"]], ["passes 2", "passes 4, smooth false"])
        self.assertEqual([point["setting"] for point in methods["independent"]["points"]], ["", ""])
        # The same samples with other seeds, raw and filtered: two samples per pixel are mostly noise, and the filter takes most of it away.
        errors = {name: methods[name]["points"][0]["errors"]["relative_mse"]["value"] for name in ("filtered", "raw")}
        self.assertLess(errors["filtered"], 0.7 * errors["raw"])
        # A filtered picture is not the baseline although it comes first, and in nothing that compares methods.
        self.assertEqual({(ratio["method"], ratio["baseline"]) for ratio in box["ratios"]}, {("raw", "independent"), ("passes", "independent")})
        self.assertNotIn("filtered", str([box["pareto"], box["crossovers"], box["ratios"]]))
        self.assertEqual([time["status"] for time in methods["passes"]["times"]][1], "never")
        self.assertIsNone(methods["passes"]["slopes"]["rmse"])  # its samples hardly differ
        for ratio in box["ratios"]:
            best = ratio["at_its_best"]
            if best["times_faster"] is not None:
                self.assertAlmostEqual(best["times_faster"], best["baseline_seconds"] / best["seconds"], delta=1e-9 * best["times_faster"])
        gate = {gate["id"]: gate for gate in report["gates"]}["falls"]
        self.assertEqual(gate["value"], methods["independent"]["slopes"]["rmse"]["slope"])
        self.assertTrue((out / box["reference"]["file"]).is_file())
        figures = [figure for figure in report["figures"] if figure["section"] == "bench/box"]
        self.assertEqual({figure["id"] for figure in figures},
                         {"bench_convergence_box", "bench_pareto_box_rmse", "bench_pareto_box_relative_mse_trimmed", "bench_pareto_box_one_minus_ssim"})

        text = (out / "report.html").read_text()
        page = xml.etree.ElementTree.fromstring(text.replace("<!DOCTYPE html>", ""))
        (section,) = [element for element in page.iter("section") if element.get("id") == "bench"]
        words = " ".join(section.itertext())
        for shown in ("A race <of few>", "filtered: biased", "passes 4, smooth false", "not reached", "Errors fall", "Processor"):
            self.assertIn(shown, words)
        self.assertEqual(len([image for image in section.iter("img") if image.get("src").startswith("data:image/svg+xml")]), 4)

        # Judged again later: the same gates from the report alone.
        self.assertIn("2 of 2 gates passed", self.succeed("gate", out / "report.json").stdout)
        resumed = self.run_study("out", "--resume", "--threads", 2)
        self.assertEqual(resumed.stderr.count("taken from the interrupted run"), 2)
        self.assertEqual(strict_json((out / "report.json").read_text())["bench"]["views"], report["bench"]["views"])

    def test_from_a_file_with_a_broken_requirement(self):
        self.write("race.json", changed(BENCH, "/require/0/at_most", -10))
        self.write("experiment.json", changed(EXPERIMENT, "/bench", "race.json"))
        process = sturm("run", self.experiment, "--out", self.folder / "out", "--quiet")
        self.assertEqual(process.returncode, FAILED, process.stderr)
        report = strict_json((self.folder / "out/report.json").read_text())
        self.assertEqual({gate["id"]: gate["passed"] for gate in report["gates"]}, {"falls": True, "bench_requirements": False})
        self.assertIn("race.json", " ".join(entry["file"] for entry in report["provenance"]["inputs"]))

    def test_places_are_named(self):
        self.expect_rejections([
            ("/bench/rounds", 1, "/bench/rounds"),
            ("/bench/metods", [], "/bench/metods"),
            ("/bench/views/0/view", "nowhere.json", "/bench/views/0/view"),
            ("/bench/methods/0/picture", "smooth", "/bench/methods/0/picture"),
            ("/bench/methods/0/patch", {}, "/bench/methods/0/picture"),
            ("/bench/require/0/method", "filtered", "/bench/require/0/method"),
            ("/bench", "nowhere.json", "/bench"),
            ("/bench", 1, "/bench"),
            ("/figures", [{"id": "bench_x", "title": "x", "file": "x.svg"}], "/figures/0/id"),
        ])


class Shipped(unittest.TestCase):
    def test_every_method_is_in_the_race(self):
        bench = strict_json((SOURCE / "configs/benchmarks/error_vs_time.json").read_text())
        methods = {method["id"]: method.get("patch", {}).get("method", {}) for method in bench["methods"]}
        self.assertEqual({method.get("sampler", "sobol") for method in methods.values()}, {"sobol", "independent", "halton"})
        self.assertEqual({method["prediction"] for method in methods.values() if "prediction" in method}, {"ellipses", "layered", "multipass", "depth_psf"})
        self.assertEqual({method.get("psf", "rays") for method in methods.values() if method.get("prediction") == "depth_psf"}, {"rays", "waves"})
        self.assertTrue(any("adaptive" in method for method in methods.values()))
        self.assertTrue(any(method.get("oversampling", 1) > 1 for method in methods.values()))
        self.assertEqual({(level["error"], level["level"]) for level in bench["levels"]},
                         {("one_minus_ssim", 0.05), ("one_minus_ssim", 0.02), ("relative_mse", 0.01), ("relative_mse", 0.001)})


if __name__ == "__main__":
    unittest.main()
