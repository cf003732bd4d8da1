"""`sturm stress`: the suite is quick, repeats itself, and its cases can be replayed with `sturm ellipse`."""
import json
import unittest

from sturm_process import FAILED, PASSED, WRONG_INPUT, FolderTest, strict_json, sturm


def replay(index, seed=1):
    process = sturm("stress", "--case", index, "--seed", seed)
    if process.returncode != PASSED:
        raise AssertionError(process.stderr + process.stdout)
    return strict_json(process.stdout)


class Suite(FolderTest):
    def report(self, name, *options):
        path = self.folder / name
        process = sturm("stress", "--cases", 20000, "--quiet", "-o", path, *options)
        self.assertEqual(process.returncode, PASSED, process.stdout)
        self.assertEqual(process.stderr, "")
        return process.stdout, path.read_bytes()

    def test_same_bits_for_any_number_of_threads(self):
        one, two = self.report("one.json", "--threads", 1), self.report("two.json", "--threads", 2)
        self.assertEqual(one, two)
        self.assertNotEqual(one, self.report("other.json", "--seed", 2))

    def test_report(self):
        table, text = self.report("report.json")
        report = strict_json(text)
        self.assertEqual(sturm("validate", self.folder / "report.json").returncode, PASSED)
        self.assertIn("PASSED: 0 of 20000 cases failed (seed 1)", table)
        self.assertTrue(report["passed"])
        for check in report["checks"]:
            self.assertEqual(check["cases"] + sum(check["skipped"].values()), 20000, check["check"])
            self.assertEqual(check["over_bound"], 0)
            self.assertLessEqual(check["worst_of_bound"]["value"], 1, check["check"])
        by_name = {family["family"]: family for family in report["families"]}
        self.assertEqual(sum(f["cases"] for f in report["families"]), 20000)
        # Every family draws, and those that are after a status get it.
        for family in report["families"]:
            self.assertGreater(family["cases"], 100, family["family"])
        self.assertGreater(by_name["total_reflection"]["total_internal_reflection"], 100)
        self.assertGreater(by_name["missed_rim"]["missed_lens"], 100)
        self.assertGreater(by_name["vertex_at_focus"]["refused"], 100)
        self.assertGreater(by_name["focus_on_target"]["ok"], 100)
        self.assertGreater(by_name["mounted"]["ok"], 100)
        self.assertGreater(by_name["free_form"]["ok"], 100)


class Replay(unittest.TestCase):
    def test_ellipse_repeats_the_footprint(self):
        through = refused = lost = 0
        for index in range(60):
            case = replay(index)
            process = sturm("ellipse", "-", stdin=json.dumps(case["query"]))
            if case["refused"]:
                self.assertEqual(process.returncode, WRONG_INPUT)
                refused += 1
                continue
            self.assertEqual(process.returncode, PASSED, process.stderr)
            result = strict_json(process.stdout)["results"][0]
            self.assertEqual(result["status"], case["double"]["status"])
            if result["status"] != "ok":
                lost += 1
                continue
            through += 1
            d = case["query"]["targets"][0]["distance_m"]
            scale = 1.0 if d == "inf" else d
            for i in range(2):
                for j in range(2):  # the same bits, but for the multiplication here
                    expected = scale * case["double"]["angular_footprint"][i][j]
                    self.assertLessEqual(abs(result["footprint"][i][j] - expected), 1e-15 * abs(expected), (index, i, j))
            self.assertEqual(result["wavefront_curvature_D"], case["double"]["wavefront_curvature_D"])
        self.assertGreater(through, 20)
        self.assertGreater(lost, 0)
        self.assertGreater(refused, 0)

    def test_both_precisions_are_shown(self):
        case = next(c for c in map(replay, range(20)) if c["extended"] and c["extended"]["status"] == "ok")
        self.assertEqual({"query", "double", "extended", "checks", "family", "seed", "case", "passed", "refused"}, set(case))
        for i in range(2):
            for j in range(2):
                extended = case["extended"]["angular_footprint"][i][j]
                self.assertIsInstance(extended, str)
                self.assertAlmostEqual(float(extended), case["double"]["angular_footprint"][i][j], delta=1e-9 * (1 + abs(float(extended))))
        self.assertEqual(len(case["checks"]), 17)


class ReplayWithTables(FolderTest):
    def test_ellipse_repeats_a_lens_that_is_a_table(self):
        found = 0
        for index in range(1000):
            if found == 2:
                break
            case = replay(index)
            if "tables" not in case or case["refused"] or case["double"]["status"] != "ok":
                continue
            found += 1
            for name, text in case["tables"].items():
                (self.folder / name).write_text(text)
            query = self.folder / "query.json"
            query.write_text(json.dumps(case["query"]))
            process = sturm("ellipse", query)
            self.assertEqual(process.returncode, PASSED, process.stderr)
            result = strict_json(process.stdout)["results"][0]
            self.assertEqual(result["chief_ray"], case["double"]["chief_ray"])
            self.assertEqual(result["wavefront_curvature_D"], case["double"]["wavefront_curvature_D"])
        self.assertEqual(found, 2)


class Errors(unittest.TestCase):
    def test_wrong_options(self):
        for options in (["--cases", "0"], ["--cases", "x"], ["--case", "-1"], ["--threads", "-2"], ["extra"]):
            self.assertEqual(sturm("stress", *options).returncode, WRONG_INPUT, options)


if __name__ == "__main__":
    unittest.main()
