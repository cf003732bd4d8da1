"""`sturm wearers`: tables of prescriptions with ages and additions; each row is what the line for one wearer says."""
import csv
import pathlib
import unittest

from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, sturm

THIN = {"format": "sturm.spectacles/1", "single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5}}
REGULAR = "progressive_regular"
FEW_GAZES = ("--reach-deg", 20, "--step-deg", 20)


class Wearers(FolderTest):
    def rows(self, table, *arguments):
        file = self.write("wearers.csv", table)
        return list(csv.DictReader(self.succeed("wearers", file, *arguments).stdout.splitlines()))

    def table(self, *arguments):
        return list(csv.DictReader(self.succeed("wearers", *arguments).stdout.splitlines()))

    def lens(self):
        return self.write("thin.json", THIN)

    def test_ages_of_the_table(self):
        table = "id,eye,age,sph_D,cyl_D,axis_deg\nA,OD,30,0,0,\nB,OD,,0,0,\nC,OD,70,0,0,\n"
        young, unknown, old = self.rows(table, self.lens(), "--distance", "0.5", *FEW_GAZES)
        # Hofstetter's mean: 18.5 - 0.3 * 30; nothing is left at 70.
        self.assertEqual([(r["age_years"], r["amplitude_D"]) for r in (young, unknown, old)], [("30", "9.5"), ("", "0"), ("70", "0")])
        self.assertLess(float(young["median_D"]), 0.02)  # what is left is astigmatism of oblique rays
        # 2 D at 0.5 m less the 12 mm that lie before the eye, and a little more in oblique gazes.
        for row in (unknown, old):
            self.assertAlmostEqual(float(row["median_D"]), 1.95, delta=0.05)

    def test_an_option_stands_in_place_of_the_ages(self):
        table = "id,eye,age,sph_D,cyl_D,axis_deg\nA,OD,30,0,0,\nB,OD,,0,0,\n"
        for options, amplitude in ((("--amplitude", 1), 1), (("--age", 58), 1.1), (("--amplitude", 0), 0)):
            rows = self.rows(table, self.lens(), "--distance", "0.5", *FEW_GAZES, *options)
            for row in rows:
                self.assertAlmostEqual(float(row["amplitude_D"]), amplitude, delta=1e-12)
            self.assertAlmostEqual(float(rows[0]["median_D"]), 1.95 - amplitude, delta=0.05)

    def test_additions_of_the_table(self):
        table = "id,eye,sph_D,cyl_D,axis_deg,Add\nA,OD,0,0,,+1.00\nB,OD,0,0,,\n"
        rows = self.rows(table, REGULAR, self.lens(), *FEW_GAZES)
        self.assertEqual([(r["wearer"], r["lens"], r["addition_D"]) for r in rows],
                         [("A-OD", REGULAR, "1"), ("A-OD", "thin", ""), ("B-OD", REGULAR, "3"), ("B-OD", "thin", "")])
        # An addition of a third has less cylinder beside its corridor.
        self.assertLess(float(rows[0]["largest_D"]), 0.6 * float(rows[2]["largest_D"]))

    def test_a_table_in_windows_1252(self):
        """Its 96 is an en dash, as word processors write for a minus; a quoted name on two lines, lines that end in separators, and empty ones."""
        table = b'# of J\xe9r\xf4me\n\nAxis;CYL;sph;Eye;Name;\n30\xb0;\x960,5;\x961,25;OD;"J\xe9r\xf4me\nM";\n;;;;;\n'
        row, = self.rows(table, self.lens(), *FEW_GAZES)[:1] or [None]
        self.assertEqual((row["sphere_D"], row["cylinder_D"], row["axis_deg"]), ("-1.25", "-0.5", "30"))

    def test_an_addition_in_the_notation(self):
        rows = self.rows('id,rx\nA,"OD -1.00 DS ADD +2.00 OS -1.50 -0.50 x 20 ADD +2.25"\n', REGULAR, *FEW_GAZES)
        self.assertEqual([(r["wearer"], r["addition_D"]) for r in rows], [("A-OD", "2"), ("A-OS", "2.25")])

    def test_an_addition_is_that_of_the_design(self):
        made = self.write("made.json", {"format": "sturm.spectacles/1", "progressive": {
            "addition_D": 1.5, "corridor_start_mm": 0, "corridor_length_mm": 18, "zone_width_mm": 10, "eye": "right", "center_thickness_mm": 2.2,
            "refractive_index": 1.6, "diameter_mm": 60}})
        other = self.write("other.json", made.read_text().replace("1.5,", "2.5,"))
        of_table, = self.rows("id,eye,sph_D,cyl_D,axis_deg,add\nA,OD,-2,0,,1.5\n", other, *FEW_GAZES)
        of_design, = self.rows("id,eye,sph_D,cyl_D,axis_deg\nA,OD,-2,0,\n", made, *FEW_GAZES)
        self.assertEqual({**of_table, "lens": ""}, {**of_design, "lens": ""})

    def test_what_is_wrong(self):
        before = None
        for cells, named in (("160,0,0,,", "0 to 150"), ("-1,0,0,,", "0 to 150"), ("old,0,0,,", "column age"), ("50,0,0,,-1", "0 to 10"), ("50,0,0,,12", "0 to 10")):
            file = self.write("wearers.csv", "id,eye,age,sph_D,cyl_D,axis_deg,add\nA,OD," + cells + "\n")
            lens = self.lens()
            before = snapshot(self.folder)
            process = sturm("wearers", file, lens, "-o", self.folder / "seen.csv")
            self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""))
            self.assertIn(named, process.stderr)
            self.assertIn("line 2", process.stderr)
            self.assertEqual(snapshot(self.folder), before)

    def test_two_hundred_prescriptions(self):
        table = (SOURCE / "configs/data/papila_prescriptions.csv").read_text().splitlines()
        rows = self.rows("\n".join(table[:202]) + "\n", self.lens(), "--distance", "inf,0.4", "--reach-deg", 10, "--step-deg", 10)
        self.assertEqual(len(rows), 400)
        self.assertEqual({r["status"] for r in rows}, {"ok"})
        columns = (SOURCE / "docs/commands/wearers.md").read_text()
        for column in rows[0]:
            self.assertIn(f"`{column}`", columns, "documented")
        self.assertEqual(pathlib.Path(self.folder / "wearers.csv").read_text().splitlines()[2].split(",")[2], rows[0]["age_years"])

    def test_a_row_for_each_wearer_lens_and_distance(self):
        prescriptions = self.write("rx.csv", "id,eye,sph_D,cyl_D,axis_deg\nA,OD,0,0,\nB,OS,-6,-2,30\n")
        lens = self.write("lens.json", {"format": "sturm.spectacles/1", "single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5}})
        rows = self.table(prescriptions, lens, "--distance", "inf,0.5")
        self.assertEqual([(r["wearer"], r["lens"], r["distance_m"]) for r in rows],
                         [(w, "lens", d) for w in ("A-OD", "B-OS") for d in ("inf", "0.5")])
        plano_far, plano_near = rows[:2]
        # A lens without power leaves a far target sharp in every direction, and 2 D (less what lies before the eye) at 0.5 m.
        self.assertEqual(float(plano_far["share_above_0.25_D"]), 0)
        self.assertEqual(float(plano_near["share_above_0.25_D"]), 1)
        self.assertAlmostEqual(float(plano_near["median_D"]), 1.95, delta=0.05)
        self.assertGreater(float(rows[2]["largest_D"]), 0.05)  # oblique astigmatism
        accommodated, = self.table(prescriptions, lens, "--distance", "0.5", "--age", 30)[:1]
        self.assertLess(float(accommodated["median_D"]), 0.02)  # what is left is astigmatism of oblique rays, which no accommodation takes away

    def test_the_largest_blur_is_that_of_its_gaze(self):
        """`sturm ellipse` finds that blur in that direction, and less in the mirrored one."""
        row, = self.rows("id,eye,sph_D,cyl_D,axis_deg\nB,OS,-4,-4,45\n", self.lens(), "--reach-deg", 22, "--step-deg", 15)
        azimuth, elevation = float(row["largest_azimuth_deg"]), float(row["largest_elevation_deg"])
        self.assertNotIn(0, (azimuth, elevation))
        lines = self.succeed("ellipse", "--rx", "-4.00 -4.00 x 45", "--lens", self.lens(), "--distance", "inf", "--csv", "--gaze", f"{azimuth},{elevation}",
                             "--gaze", f"{-azimuth},{elevation}").stdout.splitlines()
        there, mirrored = (float(line["semi_major_D"]) for line in csv.DictReader(lines))
        # The ellipse counts angles before the lens, which makes them smaller by a few per cent.
        self.assertAlmostEqual(float(row["largest_D"]), there, delta=0.06 * there)
        self.assertLess(mirrored, 0.75 * there)

    def test_a_lens_that_cannot_be_made_for_one_of_them(self):
        # A front of +15 D and the addition is steeper than a surface that reaches a rim of 60 mm.
        prescriptions = self.write("rx.csv", "id,eye,sph_D,cyl_D,axis_deg\nA,OD,0,0,\nB,OD,15,0,\n")
        made, not_made = self.table(prescriptions, REGULAR)
        self.assertEqual((made["wearer"], made["status"]), ("A-OD", "ok"))
        self.assertEqual((not_made["wearer"], not_made["gazes"], not_made["median_D"]), ("B-OD", "0", ""))
        self.assertIn("before the rim", not_made["status"])
        alone = sturm("wearers", self.write("b.csv", "id,eye,sph_D,cyl_D,axis_deg\nB,OD,15,0,\n"), REGULAR)
        self.assertEqual(alone.returncode, WRONG_INPUT)
        self.assertIn("before the rim", alone.stderr)

    def test_a_lens_that_cannot_be_made(self):
        prescriptions = self.write("rx.csv", "id,eye,sph_D,cyl_D,axis_deg\nA,OD,0,0,\n")
        lens = self.write("lens.json", {"format": "sturm.spectacles/1", "front": {"type": "sphere", "radius_mm": 100}, "back": {"type": "sphere", "radius_mm": 100},
                                        "center_thickness_mm": 2, "refractive_index": 1.5})
        self.assertEqual(sturm("wearers", prescriptions, lens).returncode, WRONG_INPUT)


if __name__ == "__main__":
    unittest.main()
