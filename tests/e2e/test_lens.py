"""`sturm lens`: powers, thickness and as-worn power map, against tests/reference/thick_lens.json and sagittas worked by hand.

The file is in the examiner's frame (x flipped), its z runs from the eye to the object.
"""
import json
import math
import unittest
import xml.etree.ElementTree

import documents
from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm
from thick_lens_cases import EveryCase, gaze_deg, lens_of
from wearer_frame import correction, from_examiner

LENS = SOURCE / "configs/lenses/oblique_astigmat.json"
REGULAR = SOURCE / "configs/lenses/progressive_regular.json"


def report(lens, *options):
    process = sturm("lens", "-", *options, stdin=json.dumps(lens))
    if process.returncode:
        raise AssertionError(process.stderr)
    return strict_json(process.stdout)


class Reference(EveryCase, unittest.TestCase):
    def check(self, case):
        out, rx = case["outputs"], case["inputs"]["Rx"]
        azimuth, elevation = gaze_deg(out)
        document = report({"format": "sturm.spectacles/1", **lens_of(case)}, "--rotation-center-mm", "13", f"--azimuth-deg={azimuth!r}", f"--elevation-deg={elevation!r}")
        self.assertEqual(len(document["gazes"]), 1)
        gaze = document["gazes"][0]
        self.assertEqual(gaze["status"], "ok")
        # Everything here within 1e-8 D; the file's own two ways agree to 7e-12 D.
        for got, expected in zip(gaze["power"]["matrix_D"], from_examiner(out["as_worn_power_D_xx_xy_yy"])):
            self.assertAlmostEqual(got, expected, delta=1e-8)
        for key, expected in zip(("M_D", "J0_D", "J45_D"), out["as_worn_error_M_J0_J45_D"]):
            self.assertAlmostEqual(gaze["error"][key], expected, delta=1e-8)
        self.assertAlmostEqual(gaze["error"]["astigmatism_D"], out["as_worn_astigmatism_magnitude_D"], delta=1e-8)
        power = gaze["power"]
        for got, expected in zip(correction(power["sphere_D"], power["cylinder_D"], power["axis_deg"] or 180), power["matrix_D"]):
            self.assertAlmostEqual(got, expected, delta=1e-12)
        for got, expected in zip(document["back_vertex"]["matrix_D"], correction(rx["S"], rx["C"], rx["A"])):
            self.assertAlmostEqual(got, expected, delta=1e-12)
        self.check_prism(gaze["prism"], out)

    def check_prism(self, prism, out):
        # The exit direction on the eye's axes as the examiner sees them.
        forward, right, up = [sum(a * b for a, b in zip(out["chief"]["exit_dir"], axis)) for axis in (out["gaze_dir"], out["eye_x"], out["eye_y"])]
        self.assertAlmostEqual(prism["prism_cm_per_m"], 100 * math.hypot(right, up) / forward, delta=1e-10)
        if math.hypot(right, up) < 1e-12:
            return
        turn = (prism["base_deg"] - math.degrees(math.atan2(up, right))) % 360.0
        self.assertAlmostEqual(min(turn, 360.0 - turn), 0.0, delta=1e-8)


class Report(FolderTest):
    def test_the_example_lens(self):
        output = self.folder / "report.json"
        self.assertEqual(self.succeed("lens", LENS, "-o", output).stdout, "")
        self.succeed("validate", output)
        document = strict_json(output.read_text())
        self.assertEqual(document["format"], "sturm.lens_report/1")
        # Front 0.5/0.25 m; back -0.5/0.124833 m and -0.5/0.090821 m; the radii are those of -2.00 -1.50 x 30 to 6 digits.
        self.assertEqual(document["front"]["principal_powers_D"], [2.0, 2.0])
        self.assertIsNone(document["front"]["axis_deg"])
        for got, expected in zip(document["back"]["principal_powers_D"], (-0.5 / 0.124833, -0.5 / 0.090821)):
            self.assertAlmostEqual(got, expected, delta=1e-12)
        for key, expected in (("sphere_D", -2.0), ("cylinder_D", -1.5), ("axis_deg", 30.0)):
            self.assertAlmostEqual(document["back_vertex"][key], expected, delta=1e-4)
        # Sagittas at 35 mm: of the front 250 - sqrt(250^2 - 35^2), of the back along either meridian alone.
        front, flat, steep = (r - math.sqrt(r * r - 35.0 * 35.0) for r in (250.0, 124.833, 90.821))
        thickness = document["thickness"]
        self.assertEqual((thickness["center_mm"], thickness["edge_status"], thickness["usable_diameter_mm"]), (2.0, "ok", 70.0))
        self.assertAlmostEqual(thickness["edge_min_mm"], 2.0 + flat - front, delta=1e-12)
        self.assertAlmostEqual(thickness["edge_max_mm"], 2.0 + steep - front, delta=1e-12)
        self.assertEqual([g["gaze_deg"] for g in document["gazes"]], [[a, e] for e in range(-40, 50, 10) for a in range(-40, 50, 10)])
        middle = document["gazes"][40]
        self.assertEqual(middle["prism"], {"deviation_deg": 0.0, "prism_cm_per_m": 0.0, "chromatic_cm_per_m": None, "base_deg": None})
        self.assertIsNone(document["material"])
        self.assertEqual(document["free_form"], [])
        for got, expected in zip(middle["power"]["matrix_D"], document["back_vertex"]["matrix_D"]):
            self.assertAlmostEqual(got, expected, delta=1e-12)
        # Where the corners of the map miss the lens there are no numbers.
        for gaze in document["gazes"]:
            self.assertEqual(gaze["status"] == "ok", gaze["power"] is not None)

    def test_a_lens_that_cannot_be_cut(self):
        lens = {"format": "sturm.spectacles/1", "single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5, "base_curve_D": 10, "prescription": {"sphere_D": 8}}}
        document = report(lens, "--set", "/single_vision/diameter_mm=60", "--azimuth-deg", "60", "--elevation-deg", "0:50:50")
        self.assertEqual(document["thickness"]["edge_status"], "surfaces_cross")
        self.assertIsNone(document["thickness"]["edge_min_mm"])
        self.assertTrue(10.0 < document["thickness"]["usable_diameter_mm"] < 60.0)
        self.assertEqual([(g["status"], g["prism"], g["power"], g["error"]) for g in document["gazes"]], [("missed_lens", None, None, None)] * 2)
        self.succeed("validate", self.write("report.json", document))

    def test_grids(self):
        lens = json.loads(LENS.read_text())
        gazes = report(lens, "--azimuth-deg", "-1:1:0.1", "--elevation-deg=-5")["gazes"]
        self.assertEqual(len(gazes), 21)
        self.assertEqual((gazes[0]["gaze_deg"], gazes[-1]["gaze_deg"]), ([-1.0, -5.0], [1.0, -5.0]))
        self.assertEqual([g["gaze_deg"][0] for g in report(lens, "--azimuth-deg", "0:10:4", "--elevation-deg", "0")["gazes"]], [0.0, 4.0, 8.0])

    def test_wrong_input(self):
        lens = self.write("lens.json", {"format": "sturm.spectacles/1", "single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5}})
        query = self.write("query.json", documents.query())
        before = snapshot(self.folder)
        for arguments, *named in [
            ([lens], "lens.json", "/single_vision", "prescription"),
            ([query], "query.json", "/format", "sturm.spectacles/1"),
            ([LENS, "--set", "/refractive_index=0.5"], "/refractive_index", "0.5"),
            ([LENS, "--azimuth-deg", "0:10"], "--azimuth-deg", "0:10"),
            ([LENS, "--azimuth-deg", "10:0:1"], "--azimuth-deg", "10:0:1"),
            ([LENS, "--elevation-deg", "0:90:10"], "--elevation-deg", "0:90:10"),
            ([LENS, "--elevation-deg", "0:10:0"], "--elevation-deg", "0:10:0"),
            ([LENS, "--elevation-deg", "0:80:1e-9"], "--elevation-deg", "721"),
            ([LENS, "--elevation-deg", "nan"], "--elevation-deg", "nan"),
            ([LENS, "--elevation-deg", "1:2:3x"], "--elevation-deg", "3x"),
            ([LENS, "--rotation-center-mm", "-1"], "--rotation-center-mm"),
            ([LENS, "--map", self.folder / "map.gif"], "--map", "map.gif", ".svg, .png or .pdf"),
            ([LENS, "--defocus-map", self.folder / "map.svg", "--distance", "0"], "--distance", "0.001"),
            ([REGULAR, "--set", "/progressive/prescription=null"], "/progressive/prescription"),
            ([REGULAR, "--set", "/progressive/eye=\"both\""], "/progressive/eye", "both"),
            ([REGULAR, "--set", "/progressive/inset_mm=9.5"], "/progressive/inset_mm", "half"),
            ([REGULAR, "--set", "/progressive/refractive_index=1.5"], "/progressive/refractive_index", "material"),
            ([REGULAR, "--set", "/progressive/material=\"CR39\""], "/progressive/material", "CR-39"),
            ([REGULAR, "--set", "/progressive/base_curve_D=30"], "/progressive", "a lens that can be made"),
        ]:
            with self.subTest(arguments):
                process = sturm("lens", *arguments, "-o", self.folder / "report.json")
                self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""), process.stderr)
                for text in named:
                    self.assertIn(text, process.stderr)
        self.assertEqual(snapshot(self.folder), before)

    def test_every_lens_file(self):
        """The files of configs/lenses can be cut, and have the power on their axis that they state."""
        files = sorted((SOURCE / "configs/lenses").glob("*.json"))
        self.assertGreaterEqual(len(files), 10)
        for file in files:
            with self.subTest(file.name):
                self.succeed("validate", file)
                output = self.folder / "report.json"
                lens = json.loads(file.read_text())
                made = lens.get("single_vision", lens.get("progressive"))
                if made and "prescription" not in made:  # it is made for the eye that wears it
                    made["prescription"] = {"sphere_D": -2, "cylinder_D": -1.5, "axis_deg": 30}
                    file = self.write("lens.json", lens)
                self.succeed("lens", file, "--azimuth-deg", "0", "--elevation-deg", "20", "-o", output)
                self.succeed("validate", output)
                document = strict_json(output.read_text())
                self.assertEqual(document["thickness"]["edge_status"], "ok")
                self.assertEqual(document["gazes"][0]["status"], "ok")
                if made and made.get("corridor_start_mm", 0) <= 0:
                    rx = made["prescription"]
                    for got, expected in zip(document["back_vertex"]["matrix_D"], correction(rx["sphere_D"], rx.get("cylinder_D", 0), rx.get("axis_deg", 180))):
                        self.assertAlmostEqual(got, expected, delta=1e-3 if "progressive" in lens else 1e-12)
                for fit in document["free_form"]:  # the spline's curvature within the rim
                    self.assertLess(fit["power_residual_D"]["mean"], 1e-3)
                    self.assertLess(fit["power_residual_D"]["cylinder"], 1e-3)

    def test_the_real_prescriptions(self):
        """Three lens files are made for rows of the PAPILA table."""
        rows = {f"{r[1]}-{r[0]}": [float(x) for x in r[4:7]] for r in
                (line.split(",") for line in (SOURCE / "configs/data/papila_prescriptions.csv").read_text().splitlines()) if r[0] in ("OD", "OS")}
        for name, eye in (("high_minus_p069", "P069-OS"), ("high_plus_p128", "P128-OS"), ("oblique_toric_p195", "P195-OD")):
            rx = json.loads((SOURCE / f"configs/lenses/{name}.json").read_text())["single_vision"]["prescription"]
            self.assertEqual([rx["sphere_D"], rx["cylinder_D"], rx["axis_deg"]], rows[eye])

    def test_a_progressive_lens(self):
        lens = json.loads(REGULAR.read_text())
        lens["progressive"]["inset_mm"] = 0  # the umbilic lies straight below
        document = report(lens, "--azimuth-deg", "0", "--elevation-deg=-38:20:58")
        down, up = document["gazes"]
        self.assertAlmostEqual(up["error"]["M_D"], 0.0, delta=0.05)  # a weak lens's oblique error at 20 deg
        # Through the near zone the light is oblique by 38 deg: its power comes out higher than the addition of 3 D, by less than a third.
        self.assertTrue(2.7 < down["error"]["M_D"] < 4.0, down)
        # The umbilic of a right lens turns to the wearer's left, of a left lens to the right.
        for eye, sign in (("right", -1), ("left", 1)):
            lens["progressive"]["eye"] = eye
            lens["progressive"]["inset_mm"] = 4
            left, right = report(lens, "--azimuth-deg=-8:8:16", "--elevation-deg=-34")["gazes"]
            self.assertGreater(sign * (right["error"]["M_D"] - left["error"]["M_D"]), 0.3)
        self.assertEqual(document["material"], {"name": "MR-8", "abbe_number": 41.0})
        for gaze in document["gazes"]:
            self.assertAlmostEqual(gaze["prism"]["chromatic_cm_per_m"], gaze["prism"]["prism_cm_per_m"] / 41.0, delta=1e-15)

    def test_a_sag_grid(self):
        """A sphere of 100 mm as a table of heights is that sphere."""
        table = "x_mm,y_mm,z_mm\n" + "".join(f"{x},{y},{100 - math.sqrt(100 ** 2 - x * x - y * y)!r}\n" for x in range(-32, 33) for y in range(-32, 33))
        (self.folder / "front.csv").write_text(table)
        lens = {"format": "sturm.spectacles/1", "center_thickness_mm": 3, "refractive_index": 1.5, "diameter_mm": 60,
                "front": {"type": "sag_grid", "file": "front.csv"}, "back": {"type": "sphere", "radius_mm": 125}}
        document = strict_json(self.succeed("lens", self.write("lens.json", lens)).stdout)
        lens["front"] = {"type": "sphere", "radius_mm": 100}
        expected = report(lens)
        fit, = document["free_form"]
        self.assertEqual((fit["side"], fit["knot_spacing_mm"], fit["power_residual_D"]), ("front", [1.0, 1.0], None))
        self.assertLess(fit["height_residual_um"]["max"], 1e-9)
        self.assertAlmostEqual(document["thickness"]["edge_min_mm"], expected["thickness"]["edge_min_mm"], delta=1e-6)
        for got, wanted in zip(document["gazes"], expected["gazes"]):
            self.assertEqual(got["status"], wanted["status"])
            for a, b in zip((got["power"] or {}).get("matrix_D", []), (wanted["power"] or {}).get("matrix_D", [])):
                self.assertAlmostEqual(a, b, delta=1e-3)  # h^2/12 of fourth derivatives of 3e3 to 1e4 /m^3, 1 mm apart, twice as oblique
        lens["front"] = {"type": "sag_grid", "file": "nowhere.csv"}
        self.assertIn("nowhere.csv", self.refuse("lens", self.write("lens.json", lens)))
        (self.folder / "front.csv").write_text(table.replace("\n5,7,", "\n5,8,"))
        lens["front"] = {"type": "sag_grid", "file": "front.csv"}
        self.assertIn("(5, 8) mm again", self.refuse("lens", self.write("lens.json", lens)))

    def refuse(self, *arguments):
        process = sturm(*arguments)
        self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""), process.stderr)
        return process.stderr

    def test_maps(self):
        svg, png = self.folder / "map.svg", self.folder / "defocus.png"
        self.succeed("lens", REGULAR, "--map", svg, "--defocus-map", png, "--distance", "0.4,inf", "--amplitude", "0.5", "-o", self.folder / "r.json")
        root = xml.etree.ElementTree.parse(svg).getroot()
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        text = svg.read_text()
        for words in ("mean power error, as worn", "cylinder of the error, as worn", "data:image/png"):
            self.assertIn(words, text)
        self.assertEqual(png.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        pdf = self.folder / "map.pdf"
        self.succeed("lens", REGULAR, "--map", pdf, "-o", self.folder / "r.json")
        self.assertTrue(pdf.read_bytes().startswith(b"%PDF"))


if __name__ == "__main__":
    unittest.main()
