"""`sturm run`: a small experiment from end to end, killed, resumed and judged again."""
import csv
import io
import re
import shutil
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree

import documents
from documents import changed
from sturm_process import FAILED, STURM, FolderTest, snapshot, strict_json, sturm

REPORT_FILES = {"report.json", "report.html", "ellipses.csv", "junit.xml"}
REUSED = "taken from the interrupted run"


def without_times(value):
    """A report without what may change from run to run: provenance and every duration."""
    if isinstance(value, dict):
        return {key: without_times(member) for key, member in value.items() if key not in ("provenance", "seconds")}
    return [without_times(member) for member in value] if isinstance(value, list) else value


class RunTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.write("gates.json", documents.gates())
        self.experiment = self.write("experiment.json", documents.experiment())

    def command(self, folder, *options):
        return ["run", self.experiment, "--out", self.folder / folder, *options]

    def run_experiment(self, folder, *options):
        return self.succeed(*self.command(folder, *options))

    def report(self, folder):
        return strict_json((self.folder / folder / "report.json").read_text())

    def pictures(self, folder):
        return {path.relative_to(self.folder / folder): path.read_bytes() for path in (self.folder / folder).rglob("*.exr")}

    def assert_same_run(self, folder, other):
        self.assertEqual(without_times(self.report(folder)), without_times(self.report(other)))
        self.assertEqual(self.pictures(folder), self.pictures(other))
        csv_file = "ellipses.csv"
        self.assertEqual((self.folder / folder / csv_file).read_bytes(), (self.folder / other / csv_file).read_bytes())


class Report(RunTest):
    def test_everything_is_there_and_finite(self):
        process = self.run_experiment("out", "--threads", 2)
        out = self.folder / "out"
        self.assertIn("2 of 2 gates passed", process.stdout)
        self.assertIn(str(out / "report.html"), process.stdout)
        self.assertLessEqual(REPORT_FILES, {path.name for path in out.iterdir()})
        for path in out.rglob("*.json"):
            strict_json(path.read_text())
        self.succeed("validate", out / "report.json")

        report = self.report("out")
        self.assertTrue(report["verdict"]["passed"])
        self.assertEqual(report["provenance"]["threads"], 2)
        self.assertEqual([case["id"] for case in report["ellipses"]["cases"]],
                         ["oblique|1 m|4 mm", "oblique|inf|4 mm", "myope|1 m|4 mm", "myope|inf|4 mm"])
        self.assertEqual([psf["ray_model"] for psf in report["psfs"]], ["power_matrix", "sin2_radial"])
        self.assertEqual([image["id"] for image in report["images"]], ["box"])
        named = [psf["file"] for psf in report["psfs"]] + [file for image in report["images"] for file in image["files"].values()]
        for file in named:
            self.assertTrue((out / file).is_file(), file)
        for picture in out.rglob("*.exr"):
            self.succeed("compare", picture, picture)  # which refuses pixels that are not finite

        for name in ("ellipses.csv", "junit.xml", "report.html"):
            text = re.sub(r'data:[^"\')]*', "", (out / name).read_text())
            self.assertNotRegex(text, r"(?i)(?<![\w.])-?(nan|infinity)(?![\w(])", name)
        rows = list(csv.reader(io.StringIO((out / "ellipses.csv").read_text())))
        self.assertEqual(len(rows), 1 + 4 * 4)  # cases x ray models
        self.assertEqual({len(row) for row in rows}, {len(rows[0])})
        html = (out / "report.html").read_text()
        self.assertIn("matrix_equals_conoid", html)
        self.assertNotRegex(html, r'(src|href)\s*=\s*["\']?https?:')

        suite = xml.etree.ElementTree.parse(out / "junit.xml").getroot()
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("2", "0"))
        self.assertEqual([case.get("name") for case in suite.iter("testcase")], ["matrix_equals_conoid", "sin2_differs"])

    def test_numbers_of_the_report(self):
        self.run_experiment("out", "--quiet")
        report = self.report("out")
        for case in report["ellipses"]["cases"]:
            rays = {entry["ray_model"]: entry for entry in case["rays"]}
            self.assertEqual(rays["metalstigmatism"]["status"], "undefined")  # a relaxed eye states no focus distance
            self.assertIsNone(rays["metalstigmatism"]["semi_axes_rad"])
            self.assertLess(rays["power_matrix"]["against_conoid"]["relative_frobenius"], 0.005)
        # -2.50 -3.25 x 35 at 12 mm vertex distance, relaxed, target at infinity: principal powers F/(1 - dF), 2 mm pupil radius. The
        # stronger meridian (5.75 D) stands across AXIS 35, i.e. along the wearer's 145 + 90 = 55 degrees.
        conoid = report["ellipses"]["cases"][1]["conoid"]
        for got, power in zip(conoid["semi_axes_rad"], (5.75, 2.5)):
            self.assertAlmostEqual(got, 2e-3 * power / (1.0 + 0.012 * power), delta=1e-15)
        self.assertAlmostEqual(conoid["orientation_deg"], 55.0, delta=1e-9)
        psf = report["psfs"][0]
        self.assertAlmostEqual(psf["measured"]["orientation_deg"], 55.0, delta=5.0)  # 24 px across: a mirror would be 70 degrees off

    def test_the_same_numbers_for_any_number_of_threads(self):
        self.run_experiment("one", "--threads", 1, "--quiet")
        self.run_experiment("two", "--threads", 2, "--quiet")
        self.assert_same_run("one", "two")

    def test_set_and_seed(self):
        options = ["--set", "/psfs=[]", "--set", "/images=[]"]
        self.run_experiment("a", *options, "--set", "/seed=5", "--quiet")
        self.run_experiment("b", *options, "--seed", 5, "--quiet")
        self.run_experiment("c", *options, "--quiet")
        self.assert_same_run("a", "b")
        self.assertNotEqual(self.report("a")["ellipses"], self.report("c")["ellipses"])


class Gates(RunTest):
    IMPOSSIBLE = changed(documents.gates(), "/gates/0/bound", -1.0)

    def assert_one_failure(self, junit):
        suite = xml.etree.ElementTree.parse(junit).getroot()
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("2", "1"))
        failed = [case.get("name") for case in suite.iter("testcase") if case.find("failure") is not None]
        self.assertEqual(failed, ["matrix_equals_conoid"])

    def test_an_impossible_bound_fails_the_run(self):
        self.write("gates.json", self.IMPOSSIBLE)
        process = sturm(*self.command("out", "--quiet"))
        self.assertEqual(process.returncode, FAILED, process.stderr)
        self.assertIn("1 of 2", process.stdout)
        out = self.folder / "out"
        self.assertLessEqual(REPORT_FILES, {path.name for path in out.iterdir()})
        self.assertFalse(self.report("out")["verdict"]["passed"])
        self.assert_one_failure(out / "junit.xml")
        self.assertEqual(sturm("gate", out / "report.json").returncode, FAILED)

    def test_a_stored_report_is_judged_again(self):
        self.run_experiment("out", "--quiet")
        report = self.folder / "out/report.json"
        before = snapshot(self.folder / "out")
        self.assertIn("2 of 2 gates passed", self.succeed("gate", report).stdout)
        self.succeed("gate", report, "--gates", self.folder / "gates.json")
        stricter = self.write("stricter.json", self.IMPOSSIBLE)
        process = sturm("gate", report, "--gates", stricter, "--junit", self.folder / "judged.xml")
        self.assertEqual(process.returncode, FAILED, process.stderr)
        self.assertIn("FAIL", process.stdout)
        self.assert_one_failure(self.folder / "judged.xml")
        self.assertEqual(snapshot(self.folder / "out"), before)

    def test_a_statistic_that_does_not_exist_fails(self):
        self.run_experiment("out", "--quiet", "--set", "/psfs=[]", "--set", "/images=[]")
        for name in ("no_such_statistic", "psf_matrix_axis_max_z"):
            gates = self.write("other.json", changed(documents.gates(), "/gates/0/statistic", name))
            self.assertEqual(sturm("gate", self.folder / "out/report.json", "--gates", gates).returncode, FAILED, name)

    def test_baseline(self):
        self.run_experiment("out", "--quiet")
        report, baseline = self.folder / "out/report.json", self.folder / "baseline.json"
        self.succeed("gate", report, "--write-baseline", baseline, cwd=self.folder)
        inputs = [entry["file"] for entry in strict_json(baseline.read_text())["provenance"]["inputs"]]
        self.assertTrue(inputs)
        for name in inputs:  # where a folder stands on this machine means nothing on another one
            self.assertFalse(name.startswith(str(self.folder)), name)
        gates = documents.gates()
        gates["gates"][0].update({"id": "as_before", "statistic": "image_ssim_display/box", "comparison": "baseline", "bound": 0.001})
        path = self.write("with_baseline.json", gates)
        self.succeed("gate", report, "--gates", path, "--baseline", baseline)
        self.assertEqual(sturm("gate", report, "--gates", path).returncode, FAILED, "no baseline must not pass")
        # Nor may the stored result of another gate with the same id stand for it.
        namesake = self.write("namesake.json", changed(gates, "/gates/0/id", "matrix_equals_conoid"))
        self.assertEqual(sturm("gate", report, "--gates", namesake).returncode, FAILED, "no baseline must not pass")
        moved = strict_json(baseline.read_text())
        moved["images"][0]["metrics"]["ssim_display"]["value"] += 0.5  # the run is worse than this
        self.assertEqual(sturm("gate", report, "--gates", path, "--baseline", self.write("moved.json", moved)).returncode, FAILED)


class Interrupted(RunTest):
    MOMENTS = (0.05, 0.1, 0.2, 0.4, 0.7, 1.1, 1.6)  # seconds after the start

    def kill(self, folder, seconds):
        """Starts a run and kills it. True if it was still running."""
        process = subprocess.Popen([STURM, *map(str, self.command(folder, "--quiet"))], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(seconds)
        process.kill()
        return process.wait() == -signal.SIGKILL

    def assert_nothing_half_written(self, folder):
        """Every file that has its final name is whole, and report.json comes last."""
        final = [path for path in folder.rglob("*") if path.is_file() and not path.name.startswith(".")]
        names = {path.name for path in final}
        for path in final:
            self.assertNotIn("tmp", path.name)
            if path.suffix == ".json":
                strict_json(path.read_text())
            elif path.suffix == ".exr":
                self.succeed("compare", path, path)
            elif path.suffix == ".html":
                self.assertTrue(path.read_text().rstrip().endswith("</html>"))
        if "report.json" in names:
            self.assertLessEqual(REPORT_FILES, names)
        if "report.html" in names:
            self.assertLessEqual(REPORT_FILES - {"report.json"}, names)

    def test_a_killed_run_leaves_no_report_and_can_be_resumed(self):
        # Long enough to be caught in the middle.
        self.write("experiment.json", changed(documents.experiment(), "/images/0/samples_per_pixel", 512))
        self.run_experiment("whole", "--quiet")
        killed = 0
        for moment in self.MOMENTS:
            folder = self.folder / f"after_{moment}"
            if not self.kill(folder.name, moment):
                continue
            killed += 1
            with self.subTest(moment=moment):
                self.assert_nothing_half_written(folder)
                self.run_experiment(folder.name, "--quiet", "--resume")
                self.assert_same_run(folder.name, "whole")
                left = [path.name for path in folder.rglob("*") if "tmp" in path.name]
                self.assertEqual(left, [], "what the killed run left half written is cleared away")
        self.assertGreaterEqual(killed, 2, "no run was caught in the middle")

    def test_resume_takes_over_finished_parts(self):
        self.run_experiment("out")
        whole = self.report("out")
        # Once in a while a killed run is caught between making a file and giving it its name.
        parts = next((self.folder / "out" / "parts").iterdir())
        left = [folder / ".ellipses.json.tmp-5161-0" for folder in (parts, self.folder / "out", self.folder / "out/images")]
        for path in left:
            path.write_text("half")
        process = self.run_experiment("out", "--resume")
        self.assertEqual(process.stderr.count(REUSED), 3)  # ellipses, one PSF, one image
        self.assertEqual(without_times(self.report("out")), without_times(whole))
        self.assertEqual([path for path in left if path.exists()], [])

    def test_without_resume_nothing_is_taken_over(self):
        self.run_experiment("out")
        self.assertNotIn(REUSED, self.run_experiment("out").stderr)

    def test_another_experiment_takes_nothing_over(self):
        self.run_experiment("out")
        self.assertNotIn(REUSED, self.run_experiment("out", "--resume", "--seed", 2).stderr)
        self.run_experiment("fresh", "--quiet", "--seed", 2)
        self.assert_same_run("out", "fresh")

    def test_a_changed_input_file_takes_nothing_over(self):
        scene = self.write("scene.json", documents.two_triangles())
        self.write("experiment.json", changed(documents.experiment(), "/images/0/scene", "scene.json"))
        self.run_experiment("out", "--quiet")
        scene.write_text(scene.read_text().replace("0.5", "0.25"))
        self.assertNotIn(REUSED, self.run_experiment("out", "--resume").stderr)
        self.run_experiment("fresh", "--quiet")
        self.assert_same_run("out", "fresh")

    def test_a_lost_picture_is_made_again(self):
        self.run_experiment("out", "--quiet")
        self.run_experiment("whole", "--quiet")
        shutil.rmtree(self.folder / "out/images")
        self.run_experiment("out", "--quiet", "--resume")
        self.assert_same_run("out", "whole")


if __name__ == "__main__":
    unittest.main()
