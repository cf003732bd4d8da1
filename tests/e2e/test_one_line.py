"""`sturm ellipse --rx …`: a line stands for a document, and both give the same numbers; tables, words, orientation."""
import csv
import io
import json
import random
import unittest

from sturm_process import WRONG_INPUT, FolderTest, strict_json, sturm

RX = "-3.25 -1.75 x 160"


def answer(*options):
    process = sturm("ellipse", *options)
    if process.returncode:
        raise AssertionError(process.stderr)
    return process.stdout


def rows(*options):
    return list(csv.DictReader(io.StringIO(answer(*options, "--csv"))))


def signed(value):
    return f"{value:+.2f}"


class Notation:
    """A random prescription, written in one of the ways of the trade, and as numbers."""

    def __init__(self, draw):
        self.sphere = draw.randrange(-48, 33) / 4
        self.cylinder = draw.choice([0, *[c / 4 for c in range(-16, 0)], *[c / 4 for c in range(1, 17)]])
        self.axis = draw.randrange(1, 181)
        self.text = self.with_cylinder(draw) if self.cylinder else draw.choice(["{s} DS", "sph {s}", "{s}"]).format(s=signed(self.sphere))

    def with_cylinder(self, draw):
        if draw.random() < 0.2:  # two powers at right angles: the power at a meridian lies across the axis of its cylinder
            across = (self.axis + 90 - 1) % 180 + 1
            return f"{signed(self.sphere)} @ {self.axis} / {signed(self.sphere + self.cylinder)} @ {across}"
        form = draw.choice(["{s} {c} x {a}", "{s}/{c}x{a}", "OD {s} {c} {a}", "S {s} C {c} A {a}", "{s} DS {c} DC axis {a}°"])
        return form.format(s=signed(self.sphere), c=signed(self.cylinder), a=self.axis)

    def object(self, vertex_mm):
        return {"sphere_D": self.sphere, "cylinder_D": self.cylinder, "axis_deg": self.axis, "vertex_distance_mm": vertex_mm}


class LineAndDocument(FolderTest):
    def test_random_prescriptions_and_notations(self):
        draw = random.Random(16)
        for case in range(60):
            rx, vertex, pupil = Notation(draw), draw.choice([0, 10.5, 12, 14]), draw.choice([2, 3.5, 5])
            distances = draw.sample([0.25, 0.4, 1, 6, "inf"], 3)
            gaze = [draw.randrange(-40, 41), draw.randrange(-30, 31)]
            eye = {"prescription": rx.object(vertex), "pupil_diameter_mm": pupil}
            options = ["--rx", rx.text, "--vertex", vertex, "--pupil", pupil, "--distance", ",".join(map(str, distances)), "--gaze", f"{gaze[0]},{gaze[1]}"]
            if case % 3 == 1:
                eye["accommodation"] = {"mode": "best", "age_years": 52}
                options += ["--age", 52]
            elif case % 3 == 2:
                eye["accommodation"] = {"mode": "fixed", "focus_distance_m": 0.7}
                options += ["--focus", 0.7]
            document = {"format": "sturm.ellipse/1", "eye": eye, "methods": ["conoid"],
                        "targets": [{"gaze_deg": gaze, "distance_m": d} for d in distances]}
            if case % 4 == 3:
                document["spectacles"] = "oblique_astigmat"
                options += ["--lens", "oblique_astigmat"]
            with self.subTest(rx=rx.text, options=options):
                by_document = sturm("ellipse", "-", stdin=json.dumps(document)).stdout
                self.assertIn('"results"', by_document)
                self.assertEqual(answer(*options, "--json"), by_document)
                config = answer(*options, "--print-config")
                self.assertEqual(sturm("ellipse", "-", stdin=config).stdout, by_document)

    def same(self, command, line, *options, output=None):
        """The line's answer is that of the document which it says it stands for."""
        config = self.succeed(command, *line, *options, "--print-config").stdout
        file = self.write("line.json", config)
        if output is None:
            self.assertEqual(self.succeed(command, *line, *options).stdout, self.succeed(command, file).stdout)
        else:
            by_line, by_document = self.folder / ("line_" + output), self.folder / ("document_" + output)
            self.succeed(command, *line, *options, "-o", by_line)
            self.succeed(command, file, "-o", by_document)
            self.assertEqual(by_line.read_bytes(), by_document.read_bytes())

    def test_lines_of_other_commands(self):
        draw = random.Random(61)
        for case in range(6):
            rx = Notation(draw).text
            with self.subTest(rx=rx):
                self.same("lens", ["--rx", rx, "--json"], "--index", draw.choice([1.5, 1.67]), "--thickness", 2.5)
                self.same("psf", ["--rx", rx, "--json"], "--pupil", 3, "--set", '/models=["rays"]', "--set", "/distances_m=[1]")
                if case % 3 == 0:
                    self.same("render", ["cornell", "--rx", rx], "--pupil", 5, "--lens", "glasses", "--size", "12x8", "--samples", 2, "--seed", 3, output="seen.png")

    def test_options_change_a_document(self):
        document = {"format": "sturm.ellipse/1", "eye": {"prescription": "-1.00 DS", "pupil_diameter_mm": 3}, "methods": ["conoid"],
                    "targets": [{"distance_m": 1}]}
        self.write("query.json", document)
        changed = {**document, "eye": {**document["eye"], "pupil_diameter_mm": 6}, "targets": [{"distance_m": 2}]}
        self.write("changed.json", changed)
        self.assertEqual(answer(self.folder / "query.json", "--pupil", 6, "--distance", 2), answer(self.folder / "changed.json"))

    def test_a_line_without_a_question(self):
        process = sturm("ellipse")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("--rx", process.stderr)

    def test_two_vertex_distances_are_refused_with_both(self):
        process = sturm("ellipse", "--rx", "-4.00 DS VD 14", "--vertex", 12)
        self.assertEqual(process.returncode, WRONG_INPUT)
        for number in ("--vertex", "12", "14"):
            self.assertIn(number, process.stderr)
        self.assertEqual(answer("--rx", "-4.00 DS VD 14", "--vertex", 14, "--json"), answer("--rx", "-4.00 DS VD 14", "--json"))

    def test_what_excludes_each_other(self):
        for options in (["--age", "50", "--focus", "1"], ["--csv", "--json"], ["--age", "50", "--amplitude", "1"]):
            process = sturm("ellipse", "--rx", RX, *options)
            self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""))
        for options, named in ((["--distance", "far"], "--distance"), (["--gaze", "20"], "--gaze"), (["--focus", "-1"], "--focus"),
                               (["--lens", "oblique_astigmatt"], "oblique_astigmat")):
            process = sturm("ellipse", "--rx", RX, *options)
            self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""), process.stderr)
            self.assertIn(named, process.stderr)

    def test_json_fits_a_screen(self):
        """Three targets by three methods, which would be 900 lines with a number on each."""
        text = answer("--rx", RX, "--distance", "0.4,1,inf", "--method", "conoid,rays:power_matrix,rays:sin2_radial", "--json")
        self.assertEqual(len(strict_json(text)["results"]), 9)
        self.assertLess(len(text.splitlines()), 200)
        self.assertLessEqual(max(map(len, text.splitlines())), 120)


class Numbers(unittest.TestCase):
    def test_distances_as_people_write_them(self):
        self.assertEqual(answer("--rx", RX, "--distance", " 0.4, 1 ,Infinity"), answer("--rx", RX, "--distance", "0.4,1,inf"))
        self.assertEqual(answer("--rx", RX, "--distance", "∞"), answer("--rx", RX, "--distance", "inf"))
        self.assertEqual(answer("--rx", RX, "--gaze", "20, -10"), answer("--rx", RX, "--gaze", "20,-10"))


    def test_an_age_leaves_an_amplitude(self):
        """Hofstetter's mean, 18.5 D - 0.3 D for each year: 3.5 D at 50. At 0.25 m a hyperope of 2 D at the cornea needs 6 D."""
        line = ["--rx", "+2.00 DS", "--vertex", 0, "--pupil", 4, "--distance", 0.25]
        for options, accommodation_D in ((["--age", 50], 3.5), (["--amplitude", 5], 5), (["--age", 10], 6), (["--focus", 1], 1), (["--focus", "inf"], 0), ([], 0)):
            row, = rows(*line, *options)
            self.assertAlmostEqual(float(row["accommodation_D"]), accommodation_D, delta=1e-12)
            self.assertAlmostEqual(float(row["semi_major_D"]), 6 - accommodation_D, delta=1e-12)


class Orientation(unittest.TestCase):
    """PL -2.00 x 30 stated at the cornea: -2 D across TABO 30, which is the wearer's 150 degrees, so along the wearer's 60."""

    LINE = ["--rx", "PL -2.00 x 30", "--vertex", 0, "--pupil", 4]

    def test_far_and_near(self):
        near, far = rows(*self.LINE, "--distance", "0.5,inf")
        self.assertAlmostEqual(float(far["orientation_deg"]), 60, delta=1e-9)
        self.assertAlmostEqual(float(far["orientation_tabo_deg"]), 120, delta=1e-9)
        self.assertAlmostEqual(float(near["orientation_deg"]), -30, delta=1e-9)
        self.assertAlmostEqual(float(near["orientation_tabo_deg"]), 30, delta=1e-9)
        # At infinity the error is -2 D along 60 degrees and none across: 2 mm x 2 D = 4 mrad = 13.7510 arcmin.
        self.assertAlmostEqual(float(far["semi_major_D"]), 2, delta=1e-12)
        self.assertAlmostEqual(float(far["semi_minor_D"]), 0, delta=1e-12)
        self.assertAlmostEqual(float(far["semi_major_arcmin"]), 13.7509870831, delta=1e-9)
        self.assertEqual((far["semi_major_m"], far["distance_m"]), ("", "inf"))
        # At half a metre 2 - 2 = 0 along 60 degrees and 2 - 0 across: 2 mm at the target.
        self.assertAlmostEqual(float(near["semi_major_m"]), 0.002, delta=1e-15)

    def test_focal_lines_as_an_examiner_writes_them(self):
        """The 2 D along the wearer's 60 degrees make a line across, 150 (TABO 30), at half a metre; the other one lies far away."""
        lines = strict_json(answer(*self.LINE, "--distance", "inf", "--json"))["results"][0]["focal_lines"]
        for line, (vergence_D, wearer_deg, tabo_deg) in zip(lines, ((2, 150, 30), (0, 60, 120))):
            self.assertAlmostEqual(line["vergence_D"], vergence_D, delta=1e-12)
            self.assertAlmostEqual(line["orientation_deg"] % 180, wearer_deg, delta=1e-9)
            self.assertAlmostEqual(line["orientation_tabo_deg"], tabo_deg, delta=1e-9)

    def test_in_words(self):
        near, far = rows(*self.LINE, "--distance", "0.5,inf")
        self.assertEqual(far["in_words"], "blurred along 60°; lines along 150° clear at 0.5 m, along 60° far away")
        self.assertEqual(near["in_words"], "blurred along 150°; lines along 150° clear at 0.5 m, along 60° far away")
        self.assertEqual(rows("--rx", "-2.00 DS", "--vertex", 0, "--distance", "0.5")[0]["in_words"], "clear; clear at 0.5 m")
        self.assertEqual(rows("--rx", "-2.00 DS", "--vertex", 0, "--distance", "inf")[0]["in_words"], "blurred evenly; clear at 0.5 m")
        self.assertEqual(rows("--rx", "+2.00 DS", "--vertex", 0, "--distance", "inf")[0]["in_words"], "blurred evenly; clear nowhere")

    def test_mirrored_axis(self):
        self.assertAlmostEqual(float(rows("--rx", "PL -2.00 x 150", "--vertex", 0, "--distance", "inf")[0]["orientation_deg"]), -60, delta=1e-9)

    def test_a_pinhole_has_no_defocus(self):
        row = rows("--rx", RX, "--pupil", 0, "--distance", 1)[0]
        self.assertEqual((row["semi_major_D"], row["semi_major_arcmin"], row["orientation_deg"]), ("", "0", ""))


class Table(unittest.TestCase):
    def test_the_line_of_the_documents(self):
        text = answer("--rx", RX, "--vertex", 12, "--pupil", 5, "--age", 52, "--distance", "0.4,1,6,inf").splitlines()
        self.assertEqual(len(text), 5)
        for title in ("[arcmin]", "[D]", "[mm]", "wearer", "TABO", "in words"):
            self.assertIn(title, text[0])
        answers = strict_json(answer("--rx", RX, "--pupil", 5, "--age", 52, "--distance", "0.4,1,6,inf", "--json"))["results"]
        for line, result in zip(text[1:], answers):
            self.assertIn(" x ".join(f"{v:.4g}" for v in result["semi_axes_arcmin"]), line)
            self.assertIn(" x ".join(f"{v:.4g}" for v in result["semi_axes_D"]), line)
            self.assertIn(f"{result['orientation_tabo_deg']:.4g}"[:3], line)
        self.assertEqual(text[4].split()[0], "inf")

    def test_what_is_sharp(self):
        line = answer("--rx", "-2.00 DS", "--lens", "glasses", "--distance", "inf").splitlines()[1]
        self.assertIn("0 x 0", line)
        self.assertIn("clear", line)

    def test_gazes_and_methods_have_columns_when_there_are_several(self):
        text = answer("--rx", RX, "--distance", 1, "--gaze", "0,0", "--gaze", "20,-10", "--method", "conoid,previous", "--lens", "glasses").splitlines()
        self.assertEqual(len(text), 1 + 4)
        self.assertIn("20,-10", text[4])
        self.assertIn("previous", text[4])


if __name__ == "__main__":
    unittest.main()
