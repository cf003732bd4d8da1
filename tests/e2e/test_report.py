"""`sturm report`: the page of a stored run is drawn again from its folder alone."""
import shutil
import unittest

from documents import changed
from study_test import StudyTest
from sturm_process import SOURCE, WRONG_INPUT, snapshot, strict_json, sturm
from test_lens_study import EXPERIMENT, GATES, ROUND, SVG

STORED = SOURCE / "tests/reference/reports"


class Report(StudyTest):
    section = "lens_study"
    document = EXPERIMENT
    gates = GATES
    files = {"round.json": ROUND, "map.svg": SVG}

    def test_the_page_is_the_same_to_the_byte(self):
        self.run_study("out", "--quiet")
        page = self.folder / "out/report.html"
        first = page.read_bytes()
        page.unlink()
        before = snapshot(self.folder / "out")
        self.assertEqual(self.succeed("report", self.folder / "out").stdout, f"Report: {page}\n")
        self.assertEqual(page.read_bytes(), first)
        page.unlink()
        self.assertEqual(snapshot(self.folder / "out"), before)  # nothing else was touched
        # The report itself stands for its folder, which may lie anywhere; the page may go elsewhere.
        (self.folder / "out").rename(self.folder / "moved")
        self.succeed("report", self.folder / "moved/report.json", "-o", self.folder / "page.html")
        self.assertEqual((self.folder / "page.html").read_bytes(), first)
        self.assertFalse((self.folder / "moved/report.html").exists())
        self.succeed("report", "report.json", cwd=self.folder / "moved")
        self.assertEqual((self.folder / "moved/report.html").read_bytes(), first)

    def test_stored_reports_of_an_earlier_version_are_drawn(self):
        for name, shown in [("lens_study", "Conoid tracing through spectacles"), ("sampling_study", "Spread of rays over the pupil"),
                            ("sin2_study", "What sin² does"), ("bench_section", "Run time against error")]:
            with self.subTest(report=name):
                folder = self.folder / name
                folder.mkdir()
                shutil.copy(STORED / (name + ".json"), folder / "report.json")
                self.succeed("report", folder)
                html = (folder / "report.html").read_text()
                self.assertIn(shown, html)
                self.assertIn("is not there", html)  # the figures' files were not stored
                self.assertNotIn("NaN", html.partition("<script")[0])

    def test_a_benchmark_has_a_page_of_its_own(self):
        shutil.copy(STORED / "bench.json", self.folder / "bench.json")
        self.succeed("report", self.folder)
        self.assertIn("Sturm: run time against error", (self.folder / "bench.html").read_text())

    def test_what_is_no_report_is_refused_and_nothing_is_written(self):
        report = strict_json((STORED / "sampling_study.json").read_text())
        spoilt = [(None, "report.json"), ({**report, "format": "sturm.gates/1"}, "/format"), ({**report, "format": "sturm.report/9"}, "/format"),
                  (changed(report, "/sampling_study/entries", "none"), "/sampling_study/entries"),
                  ({key: value for key, value in report.items() if key != "gates"}, "gates"), ('{"format": "sturm.report/1", ', "report.json")]
        for number, (content, named) in enumerate(spoilt):
            with self.subTest(number=number):
                folder = self.folder / f"spoilt_{number}"
                folder.mkdir()
                if content is not None:
                    self.write(f"spoilt_{number}/report.json", content)
                before = snapshot(folder)
                process = sturm("report", folder)
                self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
                self.assertIn(named, process.stderr)
                self.assertEqual(snapshot(folder), before)
        self.assertEqual(sturm("report", self.folder / "nowhere").returncode, WRONG_INPUT)


if __name__ == "__main__":
    unittest.main()
