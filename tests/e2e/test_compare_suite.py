"""`sturm compare --suite` on pairs of the stored reference images."""
import re
import shutil
import unittest
import xml.etree.ElementTree

from sturm_process import FAILED, SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

IMAGES = SOURCE / "tests/reference/images"


class Suite(FolderTest):
    def pair(self, name, test, reference="reference", bounds=None, **seeds):
        folder = self.folder / "suite" / name
        folder.mkdir(parents=True)
        for stem, image in {"test": test, "reference": reference, **seeds}.items():
            if image:
                shutil.copy(IMAGES / f"{image}.exr", folder / f"{stem}.exr")
        if bounds is not None:
            self.write(f"suite/{name}/bounds.json", bounds)

    def judge(self, *options):
        return sturm("compare", "--suite", self.folder / "suite", *options)

    def test_every_pair_is_judged_by_the_numbers_of_a_single_comparison(self):
        self.pair("a", "noise")
        self.pair("b", "blur")
        rmse = {name: strict_json(self.succeed("compare", IMAGES / f"{name}.exr", IMAGES / "reference.exr", "--json", "-").stdout)["metrics"]["rmse_linear"]
                for name in ("noise", "blur")}
        between = sum(rmse.values()) / 2
        process = self.judge("--max-rmse", repr(between), "--junit", self.folder / "j.xml", "--markdown", self.folder / "s.md")
        self.assertEqual(process.returncode, FAILED)
        worse = "a" if rmse["noise"] > rmse["blur"] else "b"
        root = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot()
        failed = [case.get("name") for case in root.iter("testcase") if case.find("failure") is not None]
        self.assertEqual((failed, root.get("tests")), ([f"{worse}/rmse_linear"], "2"))
        self.assertIn(repr(rmse["noise"]), process.stdout)
        self.assertIn("1 of 2 gates passed", (self.folder / "s.md").read_text())
        self.assertEqual(self.judge("--max-rmse", repr(max(rmse.values()))).returncode, 0)

    def test_a_preview_beside_a_picture_is_passed_over(self):
        self.pair("a", "noise")
        (self.folder / "suite/a/test.png").write_bytes(b"no picture")
        self.assertEqual(self.judge("--max-rmse", "1000").returncode, 0)
        shutil.copy(IMAGES / "noise.exr", self.folder / "suite/a/test.pfm")  # no preview: which is meant?
        self.assertEqual(self.judge("--max-rmse", "1000").returncode, WRONG_INPUT)

    def test_a_pair_has_bounds_of_its_own(self):
        self.pair("strict", "noise", bounds={"rmse_linear": 0})
        self.pair("loose", "noise")
        process = self.judge("--bound", "rmse_linear=1")
        self.assertEqual(process.returncode, FAILED)
        self.assertIn("FAIL  strict/rmse_linear", process.stdout)
        self.assertIn("pass  loose/rmse_linear", process.stdout)

    def test_beyond_noise(self):
        self.pair("same", "reference", test_seed="reference")
        self.assertEqual(self.judge("--beyond-noise", "--max-rmse", 0).returncode, 0)
        self.pair("blurred", "blur", test_seed="blur", reference_seed="noise")
        process = self.judge("--beyond-noise", "--max-rmse", 10)
        single = strict_json(self.succeed("compare", IMAGES / "blur.exr", IMAGES / "reference.exr", "--noise", IMAGES / "blur.exr", IMAGES / "noise.exr", "--json", "-").stdout)
        largest = max(z for z in single["noise"]["z"].values() if z is not None)
        self.assertIn(f"blurred/beyond_noise {largest!r}", re.sub(" +", " ", process.stdout))
        # Two seeds of the test alone that do not differ at all: the other picture lies beyond their noise.
        self.pair("other", "blur", test_seed="blur")
        process = self.judge("--beyond-noise", "--max-rmse", 10)
        self.assertEqual(process.returncode, FAILED)
        self.assertEqual(re.findall(r"(?m)^(pass|FAIL) +(\w+)/beyond_noise", process.stdout), [("pass", "blurred"), ("FAIL", "other"), ("pass", "same")])

    def test_what_is_wrong_with_a_suite_is_said_and_nothing_is_written(self):
        self.write("suite/readme.txt", "no pairs")
        for build, options, words in (
            (lambda: None, ["--max-rmse", 1], "no pairs"),
            (lambda: self.pair("half", "noise", reference=None), ["--max-rmse", 1], "a test alone"),
            (lambda: None, ["--json", self.folder / "x.json"], "an option for two pictures"),
        ):
            build()
            before = snapshot(self.folder)
            process = self.judge(*options, "--junit", self.folder / "j.xml")
            self.assertEqual(process.returncode, WRONG_INPUT, process.stdout)
            self.assertIn(words, process.stderr)
            self.assertEqual(snapshot(self.folder), before)

    def test_a_pair_that_nothing_judges_is_no_pass(self):
        self.pair("a", "noise")
        process = self.judge()
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("nothing judges", process.stderr)

    def test_a_suite_stands_alone(self):
        self.pair("a", "noise")
        self.assertEqual(self.judge(IMAGES / "noise.exr", "--max-rmse", 1).returncode, WRONG_INPUT)
        self.assertEqual(sturm("compare", IMAGES / "noise.exr").returncode, WRONG_INPUT)


if __name__ == "__main__":
    unittest.main()
