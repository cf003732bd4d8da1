"""`sturm plot`: the numbers beside each picture are those of `sturm ellipse`, `psf` and `lens`; signs by hand; three kinds of files."""
import csv
import json
import math
import unittest
import xml.etree.ElementTree

from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

EYE = SOURCE / "configs/eyes/oblique_astigmat.json"  # -2 -1.5 x 30, 4 mm
LENS = SOURCE / "configs/lenses/oblique_astigmat.json"
REGULAR, WIDE = (SOURCE / f"configs/lenses/progressive_{name}.json" for name in ("regular", "wide_near"))
ARCMIN = 60 * 180 / math.pi
SVG = "{http://www.w3.org/2000/svg}"


class Plot(FolderTest):
    def rows(self, kind, *arguments, name="plot.svg"):
        picture = self.folder / name
        self.assertEqual(self.succeed("plot", kind, *arguments, "-o", picture).stdout, "")
        with open(picture.with_suffix(".csv"), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def texts(self, name="plot.svg"):
        root = xml.etree.ElementTree.parse(self.folder / name).getroot()
        return root, ["".join(text.itertext()) for text in root.iter(SVG + "text")]

    def ellipses(self, document):
        return strict_json(self.succeed("ellipse", self.write("query.json", document)).stdout)["results"]


class Eyes(Plot):
    def test_blur_is_that_of_ellipse(self):
        rows = self.rows("blur", EYE)
        self.assertEqual(rows[0]["distance_m"], "inf")
        chosen = [row for row in rows if row["distance_m"] == "inf" or row is rows[-1] or row is rows[60]]
        query = {"format": "sturm.ellipse/1", "eye": json.loads(EYE.read_text()), "methods": ["conoid"],
                 "targets": [{"distance_m": "inf" if row["distance_m"] == "inf" else float(row["distance_m"])} for row in chosen]}
        for row, result in zip(chosen, self.ellipses(query)):
            for column, expected in zip(("semi_major_arcmin", "semi_minor_arcmin"), result["semi_axes_rad"]):
                self.assertAlmostEqual(float(row[column]), ARCMIN * expected, delta=1e-9)
            self.assertEqual(float(row["orientation_deg"]), result["orientation_deg"])
        # A far point spreads across the AXIS: 60 degrees up from the wearer's right, 120 as the examiner sees it.
        self.assertAlmostEqual(float(rows[0]["orientation_deg"]), 60.0, delta=1e-9)
        self.assertAlmostEqual(float(rows[0]["orientation_tabo_deg"]), 120.0, delta=1e-9)

    def test_the_interval_of_clear_vision(self):
        # Stated at the cornea, -2 D and no cylinder: clear to 0.25 D from 1/2.25 m to 1/1.75 m.
        eye = self.write("eye.json", {"format": "sturm.eye/1", "pupil_diameter_mm": 4,
                                      "prescription": {"sphere_D": -2, "vertex_distance_mm": 0}})
        rows = self.rows("blur", eye)
        clear = [float(row["distance_m"]) for row in rows if row["clear"] == "yes"]
        self.assertGreaterEqual(min(clear), 1 / 2.25 - 1e-9)
        self.assertLessEqual(max(clear), 1 / 1.75 + 1e-9)
        self.assertIn("clear from 44.4 cm to 57.1 cm", " ".join(self.texts()[1]))
        # Two dioptres of accommodation bring the near end to 1/4.25 m.
        self.rows("blur", eye, "--amplitude", 2)
        self.assertIn("clear from 23.5 cm to 57.1 cm", " ".join(self.texts()[1]))

    def test_the_ends_of_clear_vision_lie_between_the_distances_of_the_table(self):
        # 1/2.3 m to 1/1.7 m; the nearest rows within are at 2.2917 D and 1.7083 D.
        self.rows("blur", "--rx", "-2.00 DS VD 0", "--clear-D", 0.3)
        self.assertIn("clear from 43.5 cm to 58.8 cm", " ".join(self.texts()[1]))

    def test_clear_vision_goes_on_beyond_the_plot(self):
        # At the cornea -2 D and 6 D of accommodation: clear to 0.25 D from 1/8.25 m, nearer than the plot's 0.2 m.
        eye = self.write("eye.json", {"format": "sturm.eye/1", "pupil_diameter_mm": 4,
                                      "prescription": {"sphere_D": -2, "vertex_distance_mm": 0}})
        self.rows("blur", eye, "--amplitude", 6)
        self.assertIn("clear from 12.1 cm to 57.1 cm", " ".join(self.texts()[1]))
        # 10 D count as clear: from infinity to 1/(1.953 + 10) m, where 1.953 D is what the lens of -2 D at 12 mm is at the cornea.
        self.rows("blur", "--rx", "-2.00 DS", "--clear-D", 10)
        self.assertIn("clear from 8.37 cm on", " ".join(self.texts()[1]))

    def test_options_stand_for_a_document(self):
        one_line = self.rows("blur", "--rx", "-2.00 -1.50 x 30", "--pupil", 4)
        document = self.rows("blur", EYE)
        for a, b in zip(one_line, document):
            self.assertEqual({**a, "eye": ""}, {**b, "eye": ""})

    def test_spots_are_those_of_psf(self):
        rows = self.rows("spots", EYE, "--distance", "inf,0.5")
        spec = {"format": "sturm.psf/1", "eye": json.loads(EYE.read_text()), "models": ["rays"], "distances_m": ["inf", 0.5]}
        spreads = strict_json(self.succeed("psf", self.write("psf.json", spec)).stdout)["results"]
        for distance, spread in zip(("inf", "0.5"), spreads):
            points = [(float(r["x_arcmin"]), float(r["y_arcmin"])) for r in rows if r["distance_m"] == distance]
            n = len(points)
            mean = [sum(p[i] for p in points) / n for i in (0, 1)]
            xx, xy, yy = (sum((p[i] - mean[i]) * (p[j] - mean[j]) for p in points) / n for i, j in ((0, 0), (0, 1), (1, 1)))
            expected = spread["covariance_arcmin2"]
            for got, want in zip((xx, xy, yy), expected):
                self.assertAlmostEqual(got, want, delta=0.005 * (expected[0] + expected[2]))  # 3000 low-discrepancy rays
        self.assertGreater(spreads[0]["covariance_arcmin2"][1], 0)  # up to the right

    def test_wavefront_of_an_axis_of_30(self):
        # F has the entry xy = -1.5 cos 60 sin 60 D; W(1, 1) - W(1, -1) = -2 xy (1 mm)^2 = 1.299 um.
        eye = self.write("eye.json", {"format": "sturm.eye/1", "pupil_diameter_mm": 4,
                                      "prescription": {"sphere_D": -2, "cylinder_D": -1.5, "axis_deg": 30, "vertex_distance_mm": 0}})
        heights = {(float(r["x_mm"]), float(r["y_mm"])): float(r["value"]) for r in self.rows("wavefront", eye)}
        self.assertAlmostEqual(heights[1, 1] - heights[1, -1], 1.299038, delta=1e-6)
        self.assertEqual(min(heights, key=lambda place: math.hypot(*place)), (0.0, 0.0))

    def test_mtf_is_that_of_psf(self):
        rows = self.rows("mtf", EYE, "--distance", "0.5", "--psf", "rays")
        spec = {"format": "sturm.psf/1", "eye": json.loads(EYE.read_text()), "models": ["rays"], "distances_m": [0.5],
                "mtf": {"frequencies_cpd": [10], "directions_deg": [0, 90]}}
        mtf = strict_json(self.succeed("psf", self.write("psf.json", spec)).stdout)["results"][0]["mtf"]
        for direction, expected in ((0, mtf[0][0]), (90, mtf[1][0])):
            got, = [float(r["mtf"]) for r in rows if float(r["direction_deg"]) == direction and float(r["frequency_cpd"]) == 10]
            self.assertAlmostEqual(got, expected, delta=1e-12)

    def test_mtf_of_waves_in_the_light_that_the_eye_is_in_focus_at(self):
        rows = self.rows("mtf", EYE, "--distance", "0.5", "--psf", "both")
        spec = {"format": "sturm.psf/1", "eye": json.loads(EYE.read_text()), "lights": [{"wavelength_nm": 555}], "distances_m": [0.5],
                "models": ["waves"], "mtf": {"frequencies_cpd": [10], "directions_deg": [0]}}
        (expected,), = strict_json(self.succeed("psf", self.write("psf.json", spec)).stdout)["results"][0]["mtf"]
        got, = [float(r["mtf"]) for r in rows if r["model"] == "waves" and float(r["direction_deg"]) == 0 and float(r["frequency_cpd"]) == 10]
        self.assertAlmostEqual(got, expected, delta=1e-12)
        self.assertEqual({r["model"] for r in rows}, {"waves", "rays"})

    def test_an_eye_and_a_lens_of_one_name(self):
        rows = self.rows("blur", EYE, LENS)
        self.assertEqual({row["eye"] for row in rows}, {"eyes/oblique_astigmat", "lenses/oblique_astigmat"})
        self.assertIn("eyes/oblique_astigmat, shortest", [text.strip() for text in self.texts()[1]])


class Lenses(Plot):
    def test_ellipses_through_a_lens(self):
        rows = self.rows("ellipses", EYE, "--lens", LENS)
        self.assertEqual(len(rows), 49)
        row, = [r for r in rows if (float(r["azimuth_deg"]), float(r["elevation_deg"])) == (30, -20)]
        result, = self.ellipses({"format": "sturm.ellipse/1", "eye": json.loads(EYE.read_text()), "spectacles": json.loads(LENS.read_text()),
                                 "targets": [{"gaze_deg": [30, -20], "distance_m": "inf"}], "methods": ["conoid"]})
        self.assertAlmostEqual(float(row["semi_major_arcmin"]), ARCMIN * result["semi_axes_rad"][0], delta=1e-9)
        self.assertAlmostEqual(float(row["orientation_deg"]), result["orientation_deg"], delta=1e-9)
        self.assertAlmostEqual(float(row["orientation_tabo_deg"]), result["orientation_tabo_deg"], delta=1e-9)
        self.assertGreater(abs(result["orientation_tabo_deg"] - result["orientation_deg"] % 180), 5)  # so that the two are told apart

    def test_red_is_too_much_power_in_all_maps(self):
        # The near zone of a progressive lens has too much power for what is far, in both kinds of maps.
        power = self.rows("power", REGULAR)
        defocus = self.rows("defocus", REGULAR, "--distance", "inf")
        for rows, title in ((power, "mean power error"), (defocus, "defocus")):
            near = [float(r["value"]) for r in rows if title in r["map"] and abs(float(r["x_mm"]) + 2.5) < 0.5 and abs(float(r["y_mm"]) + 22) < 0.5]
            self.assertGreater(min(near), 1.5, title)

    def test_the_middle_of_a_power_map_is_the_error_of_lens(self):
        rows = self.rows("power", LENS)
        report = strict_json(self.succeed("lens", LENS, "--azimuth-deg", 0, "--elevation-deg", 0).stdout)
        at_the_middle = [r for r in rows if float(r["x_mm"]) == 0 and float(r["y_mm"]) == 0]
        error = report["gazes"][0]["error"]
        for row, expected in zip(at_the_middle, (error["M_D"], error["astigmatism_D"])):
            self.assertAlmostEqual(float(row["value"]), expected, delta=1e-9)

    def test_two_lenses_and_their_difference(self):
        rows = self.rows("power", REGULAR, WIDE, "--difference", "--range", 2)
        maps = {}
        for row in rows:
            maps.setdefault(row["map"], {})[row["x_mm"], row["y_mm"]] = float(row["value"])
        self.assertEqual(len(maps), 6)
        means = [values for name, values in maps.items() if "mean power" in name]
        place = ("0", "0")
        self.assertAlmostEqual(means[2][place], means[1][place] - means[0][place], delta=1e-6)
        root, texts = self.texts()
        self.assertIn("progressive_regular", " ".join(texts))
        self.assertEqual(root.get("role"), "img")
        self.assertIn("difference of mean power", root.get("aria-label"))

    def test_a_corridor_gains_the_addition(self):
        rows = {float(r["elevation_deg"]): r for r in self.rows("corridor", REGULAR)}
        self.assertLess(abs(float(rows[10]["addition_D"])), 0.25)
        self.assertGreater(float(rows[-36]["addition_D"]), 2.3)  # of 3 D
        self.assertLess(float(rows[-36]["azimuth_deg"]), 0)       # towards the nose of a right eye: the wearer's left


class Files(Plot):
    def test_three_kinds(self):
        for name, start in (("a.svg", b"<?xml"), ("a.png", b"\x89PNG"), ("a.PDF", b"%PDF")):
            self.rows("blur", EYE, name=name)
            self.assertTrue((self.folder / name).read_bytes().startswith(start))
        self.assertEqual(self.succeed("plot", "blur", EYE, "-o", self.folder / "b.svg", "--csv", self.folder / "numbers.txt").stderr, "")
        self.assertTrue((self.folder / "numbers.txt").exists())

    def test_the_parts_of_a_picture(self):
        self.rows("blur", EYE)
        root, texts = self.texts()
        self.assertEqual(root.tag, SVG + "svg")
        for words in ("distance of the target", "vergence of the target [D]", "semi-axis of the blur [arcmin]", "∞", "50 cm"):
            self.assertIn(words, [text.strip() for text in texts])

    def test_what_is_wrong_is_said_and_nothing_is_written(self):
        before = snapshot(self.folder)
        for arguments, words in (
            (["blur", EYE, "-o", self.folder / "a.bmp"], ".svg, .png or .pdf"),
            (["blur", "-o", self.folder / "a.svg"], "--rx"),
            (["power", EYE, "-o", self.folder / "a.svg"], "sturm.spectacles/1"),
            (["mtf", EYE, "--lens", LENS, "-o", self.folder / "a.svg"], "without spectacles"),
            (["power", LENS, "--difference", "-o", self.folder / "a.svg"], "two lenses"),
            (["blur", EYE, "-o", self.folder / "a.svg", "--rx", "nonsense"], "--rx"),
            (["blot", EYE, "-o", self.folder / "a.svg"], "blot"),
        ):
            process = sturm("plot", *arguments)
            self.assertEqual(process.returncode, WRONG_INPUT, process.stdout)
            self.assertIn(words, process.stderr)
        self.assertEqual(snapshot(self.folder), before)


if __name__ == "__main__":
    unittest.main()
