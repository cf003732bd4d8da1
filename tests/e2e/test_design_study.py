"""`sturm run` with a section design_study: maps, corridors and wearers are those of the commands that ask for one of them."""
import csv
import json
import math
import unittest

from study_test import StudyTest
from sturm_process import SOURCE, strict_json

EXPERIMENT = json.loads((SOURCE / "configs/experiments/compare_designs.json").read_text())
TABLE = "id,eye,age,sph_D,cyl_D,axis_deg,add\nA,OD,40,-1,0,,\nB,OD,60,-3,-1,30,1.5\nC,OS,,1,0,,\nD,OS,70,0,0,,2\n"
REGULAR, WIDE = ({"id": name, "lens": f"progressive_{name}"} for name in ("regular", "wide_far"))
STUDY = {"designs": [REGULAR, {**WIDE, "note": "a lower corridor"}], "distances_m": ["inf", 0.4], "reach_deg": 20, "step_deg": 10, "range_D": 3,
         "wearers": {"file": "wearers.csv", "at_most": 2}}


class DesignStudy(StudyTest):
    section = "design_study"
    document = {"format": "sturm.experiment/1", "title": "Two designs", "design_study": STUDY}
    files = {"wearers.csv": TABLE}

    def rows(self, *arguments):
        return list(csv.DictReader(self.succeed(*arguments).stdout.splitlines()))

    def test_two_designs(self):
        self.run_study("out", "--quiet")
        self.succeed("validate", self.folder / "out/report.json")
        self.wearers()
        self.facts()
        report = strict_json((self.folder / "out/report.json").read_text())
        self.assertEqual([figure["id"] for figure in report["figures"]], ["design_study_" + name for name in (
            "maps", "difference", "corridor", "ellipses_1", "ellipses_2", "wearers")])
        self.assertRegex(report["verdict"]["design_sentence"], r"median wearer, \d+ % \(.*\) to \d+ % \(.*\) are blurred by more than 0.25 D")
        self.assertIn("wide_far less regular", (self.folder / "out/figures/design_study_difference.svg").read_text())
        page = (self.folder / "out/report.html").read_text()
        for words in ("Lens designs", "a lower corridor", "Every wearer", "design_study.csv"):
            self.assertIn(words, page)
        before = self.study("out")
        self.run_study("out", "--quiet", "--resume")
        self.assertEqual(self.study("out"), before)

    def wearers(self):
        """Two of four, evenly spread: the first and the third."""
        some = self.write("some.csv", "\n".join(TABLE.splitlines()[i] for i in (0, 1, 3)) + "\n")
        alone = self.rows("wearers", some, "progressive_regular", "progressive_wide_far", "--distance", "inf,0.4", "--reach-deg", 20, "--step-deg", 10)
        with open(self.folder / "out/design_study.csv", newline="", encoding="utf-8") as file:
            table = list(csv.DictReader(file))
        found = self.study("out")["wearers"]
        self.assertEqual((len(table), len(found)), (8, 8))
        by_case = {(r["wearer"], r["lens"].removeprefix("progressive_"), r["distance_m"]): r for r in alone}
        for row, stored in zip(table, found):
            expected = by_case[row["wearer"], row["design"], row["distance_m"]]
            self.assertAlmostEqual(float(row["share_blurred"]), float(expected["share_above_0.25_D"]), delta=1e-6)  # written with six digits there
            self.assertAlmostEqual(float(row["largest_D"]), float(expected["largest_D"]), delta=1e-5)
            self.assertEqual((row["addition_D"], row["age_years"]), (expected["addition_D"], expected["age_years"]))
            self.assertEqual(float(row["median_D"]), stored["median_D"])

    def facts(self):
        """The numbers of a design are those of its maps."""
        self.succeed("plot", "power", "progressive_regular", "-o", self.folder / "power.svg")
        mean, cylinder = {}, {}
        with open(self.folder / "power.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                (mean if "mean power" in row["map"] else cylinder)[row["x_mm"], row["y_mm"]] = float(row["value"])
        facts = self.study("out")["designs"][0]
        self.assertEqual(facts["sphere_D"], -1)
        self.assertAlmostEqual(facts["largest_cylinder_D"], max(cylinder.values()), delta=1e-9)
        self.assertAlmostEqual(facts["largest_mean_D"], max(mean.values(), key=abs), delta=1e-9)
        clear = [abs(mean[place]) + 0.5 * cylinder[place] <= 0.25 for place in mean]
        self.assertAlmostEqual(facts["clear_area_percent"], 100 * sum(clear) / len(clear), delta=1e-9)
        self.succeed("plot", "corridor", "progressive_regular", "-o", self.folder / "corridor.svg")
        with open(self.folder / "corridor.csv", newline="", encoding="utf-8") as file:
            widths = {float(row["elevation_deg"]): float(row["width_deg"]) for row in csv.DictReader(file) if row["azimuth_deg"] and float(row["elevation_deg"]) <= 0}
        self.assertEqual(facts["narrowest_deg"], min(widths.values()))
        self.assertEqual(widths[facts["narrowest_elevation_deg"]], facts["narrowest_deg"])
        self.assertTrue(math.isfinite(facts["narrowest_deg"]))

    def test_wrong_input(self):
        self.expect_rejections((
            ("/design_study/designs/1/id", "regular", "/design_study/designs/1/id"),
            ("/design_study/designs/0/lens", "progressive_regulr", "progressive_regulr"),
            ("/design_study/designs/0/lens", "aspheric_plus", "/design_study/designs/0/lens"),  # given surfaces can be made for nobody else
            ("/design_study/wearers/file", "nowhere.csv", "nowhere.csv"),
            ("/design_study/wearers/at_most", 0, "at_most"),
            ("/design_study/clear_D", -1, "clear_D"),
            ("/design_study/distances_m", [], "distances_m")))

    def test_the_shipped_experiment_is_valid(self):
        self.succeed("validate", SOURCE / "configs/experiments/compare_designs.json")
        self.assertEqual(len(EXPERIMENT["design_study"]["designs"]), 4)


if __name__ == "__main__":
    unittest.main()
