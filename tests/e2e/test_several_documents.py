"""Several documents on one line: each has the answer that it has alone; names of outputs; nothing half-written."""
import csv
import io
import json
import unittest
import xml.etree.ElementTree

import documents
from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

LENSES = ("progressive_regular", "progressive_wide_far")
SVG = "{http://www.w3.org/2000/svg}"


def query(sphere, **keys):
    return {"format": "sturm.ellipse/1", "eye": {"prescription": {"sphere_D": sphere}, "pupil_diameter_mm": 4},
            "targets": [{"distance_m": 1}, {"distance_m": "inf"}], "methods": ["conoid"], **keys}


class Several(FolderTest):
    def refused(self, named, *arguments):
        before = snapshot(self.folder)
        process = sturm(*arguments)
        self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""), process.stderr)
        self.assertIn(named, process.stderr)
        self.assertEqual(snapshot(self.folder), before)


class Lenses(Several):
    GAZES = ("--azimuth-deg=-20:20:20", "--elevation-deg=-20")

    def texts(self, name):
        root = xml.etree.ElementTree.parse(self.folder / name).getroot()
        return ["".join(text.itertext()).strip() for text in root.iter(SVG + "text")]

    def test_a_line_for_each(self):
        lines = self.succeed("lens", *LENSES, *self.GAZES).stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines[1:]], list(LENSES))
        for line, name in zip(lines[1:], LENSES):
            report = strict_json(self.succeed("lens", name, *self.GAZES).stdout)
            for key in ("M_D", "astigmatism_D"):
                gaze = max(report["gazes"], key=lambda g: abs(g["error"][key]))
                azimuth, elevation = gaze["gaze_deg"]
                self.assertIn(f"{gaze['error'][key]:+.2f} at {azimuth:g},{elevation:g}", line)
            self.assertIn(f"{report['back_vertex']['sphere_D']:+.2f}", line)

    def test_reports_in_a_folder_are_those_of_each(self):
        self.assertEqual(self.succeed("lens", *LENSES, *self.GAZES, "-o", f"{self.folder}/reports/").stdout, "")
        for name in LENSES:
            self.assertEqual((self.folder / f"reports/{name}.json").read_text(), self.succeed("lens", name, *self.GAZES).stdout)

    def test_pictures(self):
        pictures = {option: self.folder / f"{option}.svg" for option in ("map", "defocus-map", "corridor", "ellipses")}
        arguments = [word for option, file in pictures.items() for word in ("--" + option, file)]
        self.succeed("lens", *LENSES, *self.GAZES, *arguments, "--range", 3, "--distance", "0.5", "--age", 60)
        maps = self.texts("map.svg")
        for words in (*LENSES, "progressive_wide_far less progressive_regular", "difference of mean power, as worn", "cylinder of the difference"):
            self.assertIn(words, maps)
        self.assertEqual(maps.count("-3"), 3)  # the one scale of three maps that have a sign
        self.assertIn("defocus for targets at 0.5 m", self.texts("defocus-map.svg"))
        self.assertIn("width with less than 0.5 D [°]", self.texts("corridor.svg"))
        self.assertIn("progressive_regular, target 50 cm", self.texts("ellipses.svg"))

    def test_one_lens_has_no_difference(self):
        for ending, start in (("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")):
            self.succeed("lens", LENSES[0], *self.GAZES, "--map", self.folder / f"map.{ending}", "-o", self.folder / "r.json")
            self.assertTrue((self.folder / f"map.{ending}").read_bytes().startswith(start))
        self.assertNotIn("less", " ".join(self.texts("map.svg")).replace("useless", ""))

    def test_refused(self):
        self.refused("{name}", "lens", *LENSES, "-o", self.folder / "one.json")
        self.refused(".svg, .png or .pdf", "lens", *LENSES, "--map", self.folder / "map.gif")
        self.refused("one document", "lens", *LENSES, "--print-config")
        self.refused("panels", "lens", *LENSES, LENSES[0], LENSES[1], "--map", self.folder / "map.svg")
        self.refused("progressive_wide_far", "lens", LENSES[0], "progressive_wide_farr", "--map", self.folder / "map.svg")


class Queries(Several):
    def setUp(self):
        super().setUp()
        self.files = [self.write("first.json", query(-1)), self.write("second.json", query(-2.5))]

    def test_one_table(self):
        rows = list(csv.DictReader(io.StringIO(self.succeed("ellipse", *self.files, "--csv").stdout)))
        self.assertEqual([row.pop("query") for row in rows], ["first", "first", "second", "second"])
        alone = [row for file in self.files for row in csv.DictReader(io.StringIO(self.succeed("ellipse", file, "--csv").stdout))]
        self.assertEqual(rows, alone)
        lines = self.succeed("ellipse", *self.files).stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["query", "first", "first", "second", "second"])

    def test_json_by_name(self):
        for output in (f"{self.folder}/answers/", f"{self.folder}/answers/{{name}}.json"):
            self.succeed("ellipse", *self.files, "-o", output)
            for file in self.files:
                self.assertEqual((self.folder / "answers" / file.name).read_text(), self.succeed("ellipse", file).stdout)

    def test_options_change_all(self):
        wide = [self.write(f"wide/{file.name}", query(rx, eye={"prescription": {"sphere_D": rx}, "pupil_diameter_mm": 6}))
                for file, rx in zip(self.files, (-1, -2.5))]
        self.assertEqual(self.succeed("ellipse", *self.files, "--pupil", 6, "--csv").stdout, self.succeed("ellipse", *wide, "--csv").stdout)

    def test_refused(self):
        self.refused("a folder", "ellipse", *self.files, "--json")
        self.write("other/first.json", query(0))
        self.refused('two documents of the name "first"', "ellipse", self.files[0], self.folder / "other/first.json", "-o", f"{self.folder}/answers/")
        names = self.succeed("ellipse", self.files[0], self.folder / "other/first.json", "--csv").stdout
        self.assertIn("other/first", names)
        wrong = self.write("wrong.json", query(-1, methods=["conoidd"]))
        self.refused("wrong.json", "ellipse", self.files[0], wrong, "-o", f"{self.folder}/answers/")


class Pictures(Several):
    def test_views(self):
        for name in ("left", "right"):
            self.write(f"{name}.json", documents.view())
        views = [self.folder / "left.json", self.folder / "right.json"]
        options = ("--size", "16x12", "--samples", 1, "--quiet")
        self.succeed("render", *views, *options, "-o", f"{self.folder}/seen_{{name}}.png")
        self.succeed("render", *views, *options, "-o", f"{self.folder}/seen/")
        alone = self.folder / "alone.png"
        self.succeed("render", views[0], *options, "-o", alone)
        for name in ("seen_left.png", "seen_right.png", "seen/left.png", "seen/right.png"):
            self.assertEqual((self.folder / name).read_bytes(), alone.read_bytes(), name)
        self.assertTrue((self.folder / "seen/left.exr").exists())
        self.refused("one document", "render", *views, "--preview", self.folder / "p.png", "-o", f"{self.folder}/seen/")
        wrong = self.write("wrong.json", {**documents.view(), "scene": "nowhere.json"})
        self.refused("wrong.json", "render", views[0], wrong, *options, "-o", f"{self.folder}/new/")

    def test_point_spreads(self):
        spec = {"format": "sturm.psf/1", "eye": {"prescription": {"sphere_D": -1}, "pupil_diameter_mm": 3}, "models": ["rays"], "distances_m": [1]}
        files = [self.write("near.json", spec), self.write("far.json", {**spec, "distances_m": [5]})]
        self.succeed("psf", *files, "-o", f"{self.folder}/spreads/", "--images", f"{self.folder}/{{name}}_picture.exr")
        for file in files:
            self.assertEqual((self.folder / "spreads" / file.name).read_text(), self.succeed("psf", file).stdout)
            self.assertTrue((self.folder / f"{file.stem}_picture.exr").exists())
        self.refused("{name}", "psf", *files, "--json")
        wrong = self.write("wrong.json", {**spec, "distances_m": [-1]})
        self.refused("wrong.json", "psf", files[0], wrong, "--images", f"{self.folder}/{{name}}_refused.exr")
        table = self.succeed("psf", *files).stdout.splitlines()
        self.assertEqual([line.split()[:2] for line in table], [["document", "distance"], ["near", "1"], ["far", "5"]])


class ShownNames(Several):
    def test_an_eye_and_a_lens_of_one_name(self):
        pair = [SOURCE / f"configs/{kind}/oblique_astigmat.json" for kind in ("eyes", "lenses")]
        self.succeed("plot", "blur", *pair, "-o", self.folder / "blur.svg")
        with open(self.folder / "blur.csv", newline="", encoding="utf-8") as file:
            self.assertEqual({row["eye"] for row in csv.DictReader(file)}, {"eyes/oblique_astigmat", "lenses/oblique_astigmat"})

    def test_json_of_one_line(self):
        config = json.loads(self.succeed("lens", LENSES[0], "--index", 1.6, "--print-config").stdout)
        self.assertEqual(config["progressive"]["refractive_index"], 1.6)


if __name__ == "__main__":
    unittest.main()
