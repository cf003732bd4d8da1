"""`sturm bench`: a small benchmark from end to end, resumed, judged, and refused where it is wrong."""
import copy
import json
import math
import re
import unittest
import xml.etree.ElementTree

import documents
from documents import changed, without
from sturm_process import FAILED, SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

ERRORS = ("rmse", "relative_mse", "relative_mse_trimmed", "one_minus_ssim")

_BENCH = {
    "format": "sturm.bench/1",
    "title": "A small benchmark <of nothing much>",
    "rounds": 2,
    "reference": {"samples_per_pixel": 64},
    "views": [{"id": "box", "view": "view.json", "patch": {"camera": {"resolution": [24, 20]}}, "max_neighbourhood_radiance": 1},
              {"id": "pinhole", "view": {}, "reference": {"samples_per_pixel": 32}}],
    "methods": [
        {"id": "independent", "patch": {"method": {"sampler": "independent"}}, "samples_per_pixel": [1, 4]},
        {"id": "sobol", "title": "Sobol' points", "sweep": [{"method": {"samples_per_pixel": 1}}, {"method": {"samples_per_pixel": 4}}]},
        {"id": "predict", "patch": {"method": {"type": "predict", "ray_model": None, "samples_per_pixel": 4}}, "views": ["box"]},
    ],
    "levels": [{"error": "rmse", "level": 0.3}, {"error": "relative_mse", "level": 1e-9}],
    "require": [{"id": "steep", "title": "Errors fall", "statistic": "slope", "error": "rmse", "method": "independent", "at_most": 0, "reason": "more samples, less noise"}],
}

# Of each view: RMSE against samples; RMSE and trimmed relative MSE against time, and relative MSE, which one of the levels asks for.
FIGURES = 2 * 4


def bench():
    document = copy.deepcopy(_BENCH)
    view = documents.view()
    view["camera"]["resolution"] = [16, 16]
    view["method"]["ray_model"] = "pinhole"
    document["views"][1]["view"] = view
    return document


def without_times(value):
    """A report without what may change from run to run."""
    if isinstance(value, dict):
        unstable = ("provenance", "machine", "seconds", "samples_per_second", "error_seconds", "times", "pareto", "crossovers", "time_ratio", "cost_ratio",
                    "command", "started_utc")
        return {key: without_times(member) for key, member in value.items() if key not in unstable}
    return [without_times(member) for member in value] if isinstance(value, list) else value


class BenchTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.write("view.json", documents.view())
        self.write("bench.json", bench())

    def bench(self, folder, *options, status=0):
        process = sturm("bench", "bench.json", "--out", folder, *options, cwd=self.folder)
        self.assertEqual(process.returncode, status, process.stderr)
        return process

    def report(self, folder):
        return strict_json((self.folder / folder / "bench.json").read_text())


class Report(BenchTest):
    def test_everything_is_there(self):
        process = self.bench("out", "--threads", 1)
        self.assertIn("slope of RMSE", process.stdout)
        self.assertIn("All 2 requirements hold.", process.stdout)
        self.assertIn("100 %", process.stderr)
        out = self.folder / "out"
        self.succeed("validate", out / "bench.json")
        report = self.report("out")
        self.assertEqual(report["machine"]["threads"], 1)
        self.assertGreater(report["provenance"]["peak_memory_bytes"], 1 << 20)
        self.assertIn("view.json", " ".join(entry["file"] for entry in report["provenance"]["inputs"]))
        box, pinhole = report["views"]
        self.assertEqual([method["id"] for method in box["methods"]], ["independent", "sobol", "predict"])
        self.assertEqual([method["id"] for method in pinhole["methods"]], ["independent", "sobol"])
        self.assertEqual(box["resolution"], [24, 20])
        self.assertGreater(box["reference"]["pixels_left_out"], 0)  # the lamp and around it
        for view in report["views"]:
            for method in view["methods"]:
                for point in method["points"]:
                    self.assertEqual(point["samples"], math.prod(view["resolution"]) * point["samples_per_pixel"] if method["id"] != "predict" else point["samples"])
                    self.assertLessEqual(point["seconds"]["shortest"], point["seconds"]["median"])
                    for error in ERRORS:
                        self.assertGreater(point["errors"][error]["raw"], 0)
                self.assertEqual([time["status"] == "never" for time in method["times"]][1], True)
                self.assertIsNone(method["times"][1]["seconds"])
            self.assertEqual(box["methods"][2]["slopes"]["rmse"], None)
            self.assertTrue((out / view["reference"]["file"]).exists())
            self.assertTrue((out / view["reference"]["picture"]).exists())
        files = {figure["file"] for figure in report["figures"]}
        self.assertEqual(len(files), FIGURES)
        for figure in report["figures"]:
            self.assertEqual(figure["command"], "sturm bench bench.json")
            xml.etree.ElementTree.fromstring((out / figure["file"]).read_text())

    def test_the_page_is_well_formed_and_complete(self):
        self.bench("out", "--quiet")
        text = (self.folder / "out/bench.html").read_text()
        page = xml.etree.ElementTree.fromstring(text.replace("<!DOCTYPE html>", ""))
        self.assertEqual(page.find("head/title").text, bench()["title"])
        self.assertEqual(len([image for image in page.iter("img") if image.get("src").startswith("data:image/svg+xml")]), FIGURES)
        self.assertEqual(len([image for image in page.iter("img") if image.get("src").startswith("data:image/png")]), 2)
        self.assertIn("sturm bench bench.json", text)
        self.assertNotRegex(re.sub(r'"data:[^"]*"', "", text), r"(?i)\b(nan|inf)\b")

    def test_errors_do_not_depend_on_threads_and_do_on_the_seed(self):
        self.bench("one", "--threads", 1, "--quiet")
        self.bench("two", "--threads", 2, "--quiet")
        self.assertEqual(without_times(self.report("one")), without_times(self.report("two")))
        self.bench("three", "--seed", 2, "--quiet")
        self.assertNotEqual(without_times(self.report("one"))["views"], without_times(self.report("three"))["views"])

    def test_rounds_have_seeds_of_their_own(self):
        self.bench("out", "--quiet")
        rounds = [strict_json(path.read_text()) for path in sorted((self.folder / "out/parts").rglob("round_*_box.json"))]
        self.assertEqual(len(rounds), 2)
        errors = [setting["errors"]["mse"] for part in rounds for setting in part]
        self.assertEqual(len(set(errors)), len(errors))


class Resume(BenchTest):
    def test_finished_rounds_and_references_are_taken_over(self):
        self.bench("out", "--quiet")
        first = self.report("out")
        out = self.folder / "out"
        for name in ("bench.json", "bench.html"):
            (out / name).unlink()
        next(out.rglob("round_1_pinhole.json")).unlink()
        process = self.bench("out", "--resume")
        self.assertEqual(process.stderr.count("taken from the interrupted run"), 3)
        self.assertEqual(process.stderr.count(".exr"), 2)
        second = self.report("out")
        self.assertEqual(without_times(second), without_times(first))
        # Kept rounds keep their times; those of the round that was made again are new.
        self.assertEqual(second["views"][0]["methods"][0]["points"], first["views"][0]["methods"][0]["points"])

    def test_without_resume_rounds_are_made_again_and_references_stay(self):
        self.bench("out", "--quiet")
        before = {path: path.stat().st_mtime_ns for path in (self.folder / "out/references").iterdir()}
        process = self.bench("out")
        self.assertNotIn("taken from the interrupted run", process.stderr)
        self.assertEqual({path: path.stat().st_mtime_ns for path in (self.folder / "out/references").iterdir()}, before)

    def test_another_reference_does_not_replace_the_first(self):
        self.bench("out", "--quiet")
        before = snapshot(self.folder / "out/references")
        self.bench("out", "--quiet", "--set", "/reference/samples_per_pixel=16")
        after = snapshot(self.folder / "out/references")
        self.assertEqual({name: after.get(name) for name in before}, before)
        self.assertEqual(len(after), len(before) + 3)  # the second view has samples of its own


class Requirements(BenchTest):
    def test_a_broken_one_fails_the_command(self):
        self.write("bench.json", changed(bench(), "/require/0/at_most", -10))
        process = self.bench("out", "--quiet", status=FAILED)
        self.assertIn("FAIL  steep", process.stdout)
        self.assertIn("2 of 2 requirements do not hold.", process.stdout)
        self.assertFalse(self.report("out")["verdict"]["passed"])
        self.assertIn("does not hold", (self.folder / "out/bench.html").read_text())

    def test_what_cannot_be_computed_fails(self):
        document = changed(bench(), "/require/0/statistic", "time_ratio")
        document["require"][0].update(method="independent", baseline="sobol", at_most=1e9, views=["box"])
        document["methods"][1]["sweep"] = [{"method": {"samples_per_pixel": 64}}]  # an error that 4 independent samples do not reach
        self.write("bench.json", document)
        self.assertIn("the error is never reached", self.bench("out", "--quiet", status=FAILED).stdout)
        self.assertIsNone(self.report("out")["requirements"][0]["value"])


class Wrong(BenchTest):
    def reject(self, document, *named):
        self.write("bench.json", document)
        before = snapshot(self.folder)
        for command in (["bench", "bench.json", "--out", "out", "--quiet"], ["validate", "bench.json"]):
            process = sturm(*command, cwd=self.folder)
            self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
            self.assertEqual(process.stdout, "")
            for text in ("bench.json", *named):
                self.assertIn(text, process.stderr)
            self.assertEqual(snapshot(self.folder), before)

    def test_places_are_named(self):
        self.reject(changed(bench(), "/views/0/view", "nowhere.json"), "/views/0/view", "nowhere.json")
        self.reject(changed(bench(), "/views/1/id", "box"), "/views/1/id", "box")
        self.reject(changed(bench(), "/views/1/view/camera/vfov_deg", 400), "/views/1", "400")
        self.reject(changed(bench(), "/views/0/patch/camera", {"resolution": [8, 8]}), "/views/0", "at least 11")
        self.reject(changed(bench(), "/methods/0/patch/method/sampler", "sobl"), "/methods/0", "sobol")
        self.reject(changed(bench(), "/methods/0/patch", {"camera": {"resolution": [30, 30]}}), "/methods/0", "same resolution")
        self.reject(changed(bench(), "/methods/1/samples_per_pixel", [1]), "/methods/1/sweep")
        self.reject(changed(bench(), "/methods/2/views", ["bix"]), "/methods/2/views/0", "did you mean \"box\"")
        self.reject(changed(bench(), "/reference/samples_per_pixel", 63), "even")
        self.reject(without(bench(), "/reference"), "/views/0/reference", "samples_per_pixel")
        self.reject(changed(bench(), "/rounds", 1), "/rounds")
        self.reject(changed(bench(), "/metods", []), "/metods", "did you mean \"methods\"")

    def test_requirements_that_could_not_be_judged(self):
        self.reject(changed(bench(), "/require/0/method", "sobel"), "/require/0/method", "did you mean \"sobol\"")
        self.reject(changed(bench(), "/require/0/method", "predict"), "/require/0", "pinhole")
        self.reject(without(bench(), "/require/0/at_most"), "/require/0", "at_least")
        self.reject(changed(bench(), "/require/0/statistic", "error_ratio"), "/require/0", "baseline")
        self.reject(changed(bench(), "/require/0/baseline", "sobol"), "/require/0", "baseline")


class Shipped(FolderTest):
    def test_benchmarks_are_valid(self):
        files = sorted((SOURCE / "configs/benchmarks").glob("*.json"))
        self.assertGreaterEqual(len(files), 2)
        for path in files:
            with self.subTest(path.name):
                self.succeed("validate", path)

    def test_convergence_covers_every_scene(self):
        """A scene that is shipped is a scene whose convergence is measured."""
        benchmark = json.loads((SOURCE / "configs/benchmarks/convergence.json").read_text())
        scenes = set()
        for view in benchmark["views"]:
            document = view["view"] if isinstance(view["view"], dict) else json.loads((SOURCE / "configs/benchmarks" / view["view"]).read_text())
            scenes.add(document["scene"].rsplit("/", 1)[-1])
        self.assertEqual(scenes, {path.name for path in (SOURCE / "configs/scenes").glob("*.json")})


if __name__ == "__main__":
    unittest.main()
