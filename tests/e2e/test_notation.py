"""Prescriptions in optical notation and in people's tables, through the command line, against the same numbers as an object."""
import json
import math
import unittest

import documents
from sturm_process import PASSED, WRONG_INPUT, FolderTest, strict_json, sturm


def query(prescription, **eye):
    document = documents.query()
    document["eye"] = {"prescription": prescription, "pupil_diameter_mm": 4, **eye}
    return document


def ask(document, *options):
    process = sturm("ellipse", "-", *options, stdin=json.dumps(document))
    if process.returncode != PASSED:
        raise AssertionError(process.stderr)
    return strict_json(process.stdout)["results"]


def power(sphere, cylinder, axis_deg, vertex_mm):
    """Power at the cornea [D] as (xx, xy, yy) in the wearer frame, by Euler's theorem along two meridians."""
    along, across = (p / (1 - vertex_mm * 1e-3 * p) for p in (sphere, sphere + cylinder))
    c, s = math.cos(math.radians(axis_deg)), math.sin(math.radians(axis_deg))
    return along * c * c + across * s * s, -(along - across) * c * s, along * s * s + across * c * c


class Notation(FolderTest):
    def test_texts_mean_what_they_say(self):
        for text, numbers in (("-2.00 -1.50 x 30", (-2, -1.5, 30, 12)), ("+1.25 DS", (1.25, 0, 180, 12)), ("PL -0.75 x 180", (0, -0.75, 180, 12)),
                              ("OD -1.00/-0.50x90", (-1, -0.5, 90, 12)), ("-1.00/-0.50×90", (-1, -0.5, 90, 12)), ("-2,00 -1,50 x 30", (-2, -1.5, 30, 12)),
                              ("-2.00 -1.50 axis 30°", (-2, -1.5, 30, 12)), ("-2.00 DS -1.50 DC x 30", (-2, -1.5, 30, 12)),
                              ("sph -2.00 cyl -1.50 ax 30", (-2, -1.5, 30, 12)), ("\u22122.00 \u22121.50 x 30 VD 14", (-2, -1.5, 30, 14)),
                              ("OD : -1,75 (-0,50 à 90°)", (-1.75, -0.5, 90, 12)), ("-2 ½ -1 ¼ x 30", (-2.5, -1.25, 30, 12)),
                              ("\uff0d2·00 ⌢ \uff0d1·50 ╳ 030", (-2, -1.5, 30, 12)),
                              ("+1.00 +2.00 x 120 BVD 0mm", (1, 2, 120, 0)), ("OS -6.00 -2.25 x 7", (-6, -2.25, 7, 12))):
            for results in (ask(query(text)), ask(query({"sphere_D": 9}), "--rx", text), ask(query({"sphere_D": 9}), "--set", f"/eye/prescription={text}")):
                for got, expected in zip(results[0]["wavefront_curvature_D"], power(*numbers)):
                    self.assertAlmostEqual(got, -expected, delta=1e-12, msg=text)

    def test_the_option_replaces_the_prescription_of_an_eye_in_a_file(self):
        self.write("eye.json", {"format": "sturm.eye/1", "prescription": {"sphere_D": 5}, "pupil_diameter_mm": 4})
        document = query("PL")
        document["eye"] = "eye.json"
        path = self.write("query.json", document)
        got = strict_json(self.succeed("ellipse", path, "--rx", "-2.00 -1.50 x 30").stdout)["results"]
        self.assertEqual(got, ask(query("-2.00 -1.50 x 30")))

    def test_what_is_ambiguous_is_refused_with_its_readings(self):
        for text, words in (("-2.00 / -1.50 @ 30", ("x 30", "x 120")), ("-200 -150 x 30", ("-2.00", "-200")), ("-2.00 x 30", ("-2.00 DS", "PL -2.00 x 30")),
                            ("-2.00 -1.50", ("an axis",)), ("-2.00 -1.50 x 190", ("from 0 to 180",)), ("piano", ("plano",)), ("-2.00 DS 2^ BI", ("OD or OS",)),
                            ("-2 1/4", ("fraction", "axis")), ("OD 1.00 BI 2", ("sphere", "prism")), ("90° -0,50 -1,75", ("behind the cylinder",)),
                            ("-2.00 DS PD 63", ("distance of the pupils",)),
                            ("OD -1.00 DS OS -2.00 DS", ("OS -2.00 DS",))):
            for process in (sturm("ellipse", "-", stdin=json.dumps(query(text))),
                            sturm("ellipse", "-", "--rx", text, stdin=json.dumps(query("PL")))):
                self.assertEqual(process.returncode, WRONG_INPUT, text)
                self.assertIn(text, process.stderr)
                for word in words:
                    self.assertIn(word, process.stderr)
        self.assertIn("/eye/prescription", sturm("ellipse", "-", stdin=json.dumps(query("hello"))).stderr)
        process = sturm("lens", "-", "--rx", "PL", stdin=json.dumps({"format": "sturm.spectacles/1", "front": {"type": "sphere"}}))
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("--rx", process.stderr)

    def test_lenses_are_made_for_texts(self):
        def lens(maker, **members):
            return {"format": "sturm.spectacles/1", maker: {"center_thickness_mm": 2, "refractive_index": 1.5, **members}}

        def report(document, *options):
            process = sturm("lens", "-", "--azimuth-deg", "0", "--elevation-deg", "0", *options, stdin=json.dumps(document))
            self.assertEqual(process.returncode, PASSED, process.stderr)
            return strict_json(process.stdout), process.stderr

        text, notes = report(lens("single_vision", prescription="OD -2.00/-1.50x30 2^ base in add 2.00 VD 14"))
        self.assertEqual(text["vertex_distance_mm"], 14)
        self.assertAlmostEqual(text["back_vertex"]["sphere_D"], -2, delta=1e-9)
        self.assertAlmostEqual(text["back_vertex"]["axis_deg"], 30, delta=1e-9)
        prism = text["gazes"][0]["prism"]
        self.assertAlmostEqual(prism["prism_cm_per_m"], 2, delta=1e-9)
        self.assertAlmostEqual(math.cos(math.radians(prism["base_deg"])), 1, delta=1e-9)  # towards the examiner's right: the nose of a right eye
        self.assertIn("no addition", notes)
        for way in ("2^ base in", "BI 2", "2 cm/m nasal"):
            option, _ = report(lens("single_vision", vertex_distance_mm=14), "--rx", "OD -2.00/-1.50x30 " + way)
            self.assertEqual((option["back_vertex"], option["gazes"][0]["prism"]), (text["back_vertex"], prism), way)

        progressive = dict(knot_spacing_mm=0.5, diameter_mm=50)
        text, _ = report(lens("progressive", prescription="OS -1.00 DS ADD +2.00", **progressive))
        numbers, _ = report(lens("progressive", prescription={"sphere_D": -1}, addition_D=2, eye="left", **progressive))
        self.assertEqual(text, numbers)
        process = sturm("lens", "-", stdin=json.dumps(lens("progressive", prescription="-1.00 DS")))
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("addition_D", process.stderr)

    def test_an_experiment_takes_texts(self):
        self.write("gates.json", documents.gates())
        experiment = documents.experiment()
        experiment.pop("images", None)  # their scene is not beside it
        experiment["ellipses"]["prescriptions"][0] = {"id": "oblique", "prescription": "-2.50 -3.25 x 35"}
        self.succeed("validate", self.write("experiment.json", experiment))
        experiment["ellipses"]["prescriptions"][0]["sphere_D"] = -2
        process = sturm("validate", self.write("experiment.json", experiment))
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/ellipses/prescriptions/0/sphere_D", process.stderr)


class Messages(FolderTest):
    def test_typographic_signs_and_wrong_keys_are_named(self):
        text = json.dumps(query({"sphere_D": 0})).replace('"sphere_D": 0', '"sphere_D": \u22121')
        process = sturm("ellipse", "-", stdin=text)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn('got "\u2212"', process.stderr)
        self.assertNotIn("\uFFFD", process.stderr)
        document = query("PL")
        document["eye"] = {"wavefront": {"coefficients_um": {"Z4": 1}, "pupil_diameter_mm": 6}, "pupil_diameter_mm": 6}
        process = sturm("ellipse", "-", stdin=json.dumps(document))
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/eye/wavefront/coefficients_um/Z4", process.stderr)
        self.assertIn("OSA", process.stderr)

    def test_usd_scenes_are_sent_to_the_converter(self):
        for name in ("room.usdz", "room.USDA", "room.usdc", "room.usd"):
            self.write(name, "#usda 1.0\n")
            for scene in (name, {"models": [{"file": name}]}):
                view = documents.view()
                view["scene"] = scene
                process = sturm("render", self.write("view.json", view), "-o", self.folder / "a.exr")
                self.assertEqual(process.returncode, WRONG_INPUT, name)
                self.assertIn("scripts/convert_usd SCENE", process.stderr)
                self.assertFalse((self.folder / "a.exr").exists())


if __name__ == "__main__":
    unittest.main()
