"""What people got stuck on in their first minutes: names mistyped, documents given to the wrong command, shipped things by name, silence."""
import csv
import json
import shutil
import unittest

import documents
from sturm_process import FAILED, SOURCE, WRONG_INPUT, FolderTest, strict_json, sturm


class Mistyped(unittest.TestCase):
    def refused(self, *arguments):
        process = sturm(*arguments)
        self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""))
        return process.stderr

    def test_commands(self):
        for typed, meant in (("elipse", "ellipse"), ("rendr", "render"), ("Ellipse", "ellipse"), ("blur-field", "blurfield"), ("comp-runs", None)):
            message = self.refused(typed, "x.json")
            self.assertIn(f'"{typed}"', message)
            if meant:
                self.assertIn(f'did you mean "{meant}"', message)

    def test_options(self):
        for arguments, typed, meant in ((["ellipse", "--rx", "-1", "--pupill", "4"], "--pupill", "--pupil"), (["render", "desk", "--outptu", "x.exr"], "--outptu", "--output"),
                                        (["ellipse", "--dist=1", "--rx", "-1"], "--dist", "--distance"), (["lens", "--pupil-mm", "3"], "--pupil-mm", None)):
            message = self.refused(*arguments)
            self.assertIn(f'"{typed}" is no option of sturm {arguments[0]}', message)
            if meant:
                self.assertIn(f'did you mean "{meant}"', message)

    def test_no_command_says_what_can_be_done(self):
        message = self.refused()
        for command in ("ellipse", "render", "lens", "see", "compare", "init", "doctor"):
            self.assertRegex(message, rf"(?m)^  {command} ")
        self.assertIn("--rx", message)

    def test_help_is_a_word_too(self):
        self.assertEqual(sturm("help").stdout, sturm("--help").stdout)
        self.assertEqual(sturm("help", "lens").stdout, sturm("lens", "--help").stdout)
        self.assertIn('did you mean "--version"', self.refused("version"))

    def test_names_of_shipped_documents(self):
        message = self.refused("render", "cornel", "-o", "x.png")
        for text in ("cornel", 'did you mean "cornell"', '"desk"'):
            self.assertIn(text, message)


    def test_values(self):
        for arguments, texts in (
            (["ellipse", "--rx", "-1", "--pupil", "-3"], ("--pupil: got -3, expected a number from 0 to 100", "sturm ellipse --help")),
            (["ellipse", "--rx", "-1", "--pupil", "wide"], ('--pupil: got "wide", expected a number',)),
            (["ellipse", "--rx", "-1", "--age", "200"], ("--age: got 200, expected a number from 0 to 150",)),
            (["plot", "blurr", "--rx", "-1", "-o", "x.svg"], ('"blurr" (did you mean "blur"?)', '"corridor"')),
            (["init", "vew"], ('did you mean "view"',)),
            (["plot", "blur", "--rx", "-1"], ("--output is missing",)),
            (["render", "desk"], ("--output is missing", "sturm render --help")),
            (["lens", "--rx", "-3", "--index", "0.5"], ("--index: got 0.5, expected a number from 1 to 4",)),
            (["lens", "--rx", "-3", "--index", "1,67"], ('got "1,67"', "with a decimal point")),
            (["ellipse", "--rx", "-1", "--pupil", "5mm"], ('got "5mm"', "[mm], without a unit")),
            (["ellipse", "--rx", "-1", "--distance", "40cm"], ('got "40cm"', "in metres, like 0.4")),
            (["ellipse", "--rx", "-1", "--rx", "-2"], ("--rx: got 2 of them, expected one",)),
            (["compare", "a.png", "b.png", "--json"], ("--json: got nothing behind it",)),
            (["plot"], ("kind is missing", '"blur"', '"corridor"')),
            (["init"], ("kind is missing", '"view"')),
            (["render"], ("files is missing", '"cornell"')),
        ):
            with self.subTest(arguments=arguments):
                message = self.refused(*arguments)
                self.assertTrue(message.startswith("error: "), message)
                self.assertEqual(message.count("\n"), 1)
                for text in texts:
                    self.assertIn(text, message)

    def test_what_was_taken_for_a_file(self):
        for arguments, texts in (
            (["ellipse", "--rx", "-2.00", "--distance", "0.4", "1"], ("1: got a number", "--distance 0.4,1,inf")),
            (["ellipse", "cornell"], ("a name of the shipped views", "sturm.ellipse/1")),
            (["wearers", SOURCE / "configs/eyes/polans_5.json", "glasses"], ("a JSON document", "CSV")),
            (["validate-camera", "nowhere"], ("sturm validate-camera nowhere --write",)),
            (["ellipse", "-3.25", "-1.75", "160"], ("-3.25: got a number", '--rx "-2.00 -1.50 x 30"')),
            (["render", "cornell", "--rx", "-3.25", "-1.75", "x", "160", "-o", "a.png"], ("-1.75: got a number", "between quotes")),
            (["ellipse", "-3.25 -1.75 x 160"], ("got a prescription", '--rx "-3.25 -1.75 x 160"')),
            (["render", "cornell_box", "-o", "a.png"], ("a name of the shipped scenes", '"cornell"')),
            (["render", "nowhere/desk.json", "-o", "a.png"], ('did you mean the shipped "desk"',)),
            (["plot", "blur", "hofer5", "-o", "a.svg"], ('did you mean "hofer_5"', '"glasses"')),
            (["ellipse", "--rx", "-1", "--lens", "cornell"], ("/spectacles", '"progressive_regular"')),
            (["wearers", "glasses", SOURCE / "configs/data/papila_prescriptions.csv"], ("a table (CSV)",)),
            (["render", SOURCE / "docs/images/desk.png", "-o", "a.png"], ("got a PNG picture, expected a JSON document",)),
            (["lens", "progressive_regular", "--rx", "-1.00 -2.00"], ("--rx", "axis behind the cylinder")),
            (["ellipse", "--rx", "OD -1.00 OS -2.00"], ("OD -1.00 DS", "OS -2.00 DS")),
        ):
            with self.subTest(arguments=arguments):
                message = self.refused(*arguments)
                for text in texts:
                    self.assertIn(text, message)


class NamesOfOutputs(FolderTest):
    def test_the_ending_says_what_is_written(self):
        for line in (["ellipse", "--rx", "-3.00 -1.00 x 20"], ["lens", "--rx", "-3.00 -1.00 x 20"], ["lens", "progressive_regular", "reading"]):
            self.assertEqual(self.succeed(*line, "-o", "a.csv", cwd=self.folder).stdout, "")
            self.assertEqual((self.folder / "a.csv").read_text(), self.succeed(*line, "--csv").stdout)
            self.succeed(*line, "-o", "a.txt", cwd=self.folder)
            self.assertEqual((self.folder / "a.txt").read_text(), self.succeed(*line).stdout)
            self.assertLess(len((self.folder / "a.txt").read_text().splitlines()), 24)
        self.succeed("lens", "progressive_regular", "-o", "a.txt", cwd=self.folder)
        self.assertEqual((self.folder / "a.txt").read_text(), self.succeed("lens", "progressive_regular", "--table").stdout)
        for command in ("ellipse", "lens"):
            self.succeed(command, "--rx", "-3.00 -1.00 x 20", "-o", "a.json", cwd=self.folder)
            self.assertEqual(strict_json((self.folder / "a.json").read_text()), strict_json(self.succeed(command, "--rx", "-3.00 -1.00 x 20", "--json").stdout))

    def test_other_endings_are_refused(self):
        view, table = ["render", "desk"], ["wearers", SOURCE / "configs/data/papila_prescriptions.csv", "glasses"]
        for line, output, expected in ((["ellipse", "--rx", "-1"], "a.png", "sturm plot"), (["ellipse", "--rx", "-1"], "a.xlsx", ".csv"),
                                       (["ellipse", "--rx", "-1", "--csv"], "a.json", ".csv"), (["ellipse", "--rx", "-1", "--table"], "a.csv", ".txt"),
                                       (["lens", "--rx", "-1"], "a.svg", "sturm plot"), (["psf", "--rx", "-1"], "a.png", ".json"),
                                       (["ellipse", "--rx", "-1", "--print-config"], "a.csv", ".json"), (view, "a.gif", ".exr or .png"), (table, "a.json", ".csv")):
            with self.subTest(line=line, output=output):
                process = sturm(*line, "-o", output, cwd=self.folder)
                self.assertEqual((process.returncode, process.stdout, list(self.folder.iterdir())), (WRONG_INPUT, "", []))
                self.assertIn(f'--output: got "{output}"', process.stderr)
                self.assertIn(expected, process.stderr)


class OtherKinds(FolderTest):
    def test_each_kind_is_told_its_command(self):
        view = self.write("view.json", documents.view())
        query = self.write("query.json", documents.query())
        eye = SOURCE / "configs/eyes/oblique_astigmat.json"
        for command, file, kind, use in ((["ellipse"], view, "sturm.render/1", "sturm render"), (["render", "-o", "x.exr"], query, "sturm.ellipse/1", "sturm ellipse"),
                                         (["run"], view, "sturm.render/1", "sturm render"), (["lens"], query, "sturm.ellipse/1", "sturm ellipse"),
                                         (["ellipse"], eye, "sturm.eye/1", "sturm see --eye"), (["gate"], query, "sturm.ellipse/1", "sturm ellipse"),
                                         (["render", "-o", "x.exr"], SOURCE / "configs/scenes/cornell_box.json", "sturm.scene/1", "sturm render, with a view"),
                                         (["psf"], SOURCE / "configs/gates/validation.json", "sturm.gates/1", "sturm gate")):
            with self.subTest(command=command, kind=kind):
                process = sturm(command[0], file, *command[1:], cwd=self.folder)
                self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""))
                for text in (str(file), "/format", kind, use):
                    self.assertIn(text, process.stderr)


class ShippedThings(FolderTest):
    SMALL = ["--size", "24x16", "--samples", "4", "--quiet"]

    def test_a_view_by_name(self):
        self.succeed("render", "cornell", "--rx", "-3 -1 x 20", *self.SMALL, "-o", "seen.png", cwd=self.folder)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"seen.png", "seen.manifest.json"})
        manifest = strict_json((self.folder / "seen.manifest.json").read_text())
        self.assertEqual(manifest["spec"]["camera"]["resolution"], [24, 16])
        self.assertEqual(manifest["spec"]["eye"]["prescription"], "-3 -1 x 20")

    def test_a_view_that_was_copied_elsewhere(self):
        shutil.copy(SOURCE / "configs/views/street.json", self.folder / "mine.json")
        self.succeed("render", "mine.json", *self.SMALL, "-o", "a.exr", cwd=self.folder)
        self.succeed("render", SOURCE / "configs/views/street.json", *self.SMALL, "-o", "b.exr", cwd=self.folder)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_a_file_beside_the_document_comes_before_a_shipped_one(self):
        self.write("scenes/cornell_box.json", documents.two_triangles())
        self.write("views/v.json", documents.changed(documents.view(), "/scene", "../scenes/cornell_box.json"))
        self.succeed("render", "views/v.json", *self.SMALL, "-o", "a.exr", cwd=self.folder)
        inputs = strict_json((self.folder / "a.manifest.json").read_text())["provenance"]["inputs"]
        self.assertIn(str(self.folder.resolve() / "scenes/cornell_box.json"), [entry["file"] for entry in inputs])

    def test_names_within_documents(self):
        document = {**documents.query(), "eye": "oblique_astigmat", "spectacles": "glasses"}
        self.succeed("ellipse", self.write("query.json", document))
        process = sturm("ellipse", self.write("query.json", {**document, "eye": "oblique_astigmta"}))
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn('did you mean "oblique_astigmat"', process.stderr)

    def test_a_lens_on_one_line(self):
        report = strict_json(self.succeed("lens", "--rx", "-3.25 -1.75 x 160", "--index", 1.6, "--azimuth-deg", 0, "--elevation-deg", 0, "--json").stdout)
        self.assertEqual(report["refractive_index"], 1.6)
        self.assertAlmostEqual(report["back_vertex"]["sphere_D"], -3.25, delta=1e-9)
        self.assertAlmostEqual(report["back_vertex"]["axis_deg"], 160, delta=1e-6)
        self.assertEqual(strict_json(self.succeed("lens", "--rx", "-1.00 DS", "--json").stdout)["refractive_index"], 1.5)

    def test_where_a_lens_sits(self):
        lens = strict_json(self.succeed("lens", "--rx", "-4.00", "--vertex", 15, "--diameter", 60, "--thickness", 1.8, "--json").stdout)
        self.assertEqual([lens["vertex_distance_mm"], lens["diameter_mm"], lens["thickness"]["center_mm"]], [15, 60, 1.8])

    def test_a_lens_as_a_table(self):
        """Each gaze with the numbers of the report; straight ahead the lens has its own power."""
        line = ["lens", "--rx", "-3.25 -1.75 x 160", "--azimuth-deg", "-20:20:20", "--elevation-deg", "0"]
        gazes = strict_json(self.succeed(*line, "--json").stdout)["gazes"]
        rows = list(csv.DictReader(self.succeed(*line, "--csv").stdout.splitlines()))
        self.assertEqual([(row["gaze_azimuth_deg"], row["gaze_elevation_deg"], row["status"]) for row in rows],
                         [(str(azimuth), "0", "ok") for azimuth in (-20, 0, 20)])
        for row, gaze in zip(rows, gazes):
            for column, part, key in (("sphere_D", "power", "sphere_D"), ("cylinder_D", "power", "cylinder_D"), ("axis_deg", "power", "axis_deg"),
                                      ("error_M_D", "error", "M_D"), ("error_J0_D", "error", "J0_D"), ("error_J45_D", "error", "J45_D"),
                                      ("error_astigmatism_D", "error", "astigmatism_D"), ("prism_cm_per_m", "prism", "prism_cm_per_m")):
                self.assertEqual(float(row[column]), gaze[part][key], column)
        self.assertEqual([rows[1][column] for column in ("prism_cm_per_m", "prism_base_deg")], ["0", ""])
        self.assertAlmostEqual(float(rows[1]["sphere_D"]), -3.25, delta=1e-9)
        self.assertAlmostEqual(float(rows[1]["axis_deg"]), 160, delta=1e-6)

    def test_an_eye_by_name(self):
        """--eye is the eye of a document that names it, and other options change it."""
        by_name = self.succeed("ellipse", "--eye", "polans_5", "--pupil", 3, "--distance", "0.4,inf", "--json").stdout
        eye = strict_json((SOURCE / "configs/eyes/polans_5.json").read_text())
        document = {**documents.query(), "eye": {**eye, "pupil_diameter_mm": 3}, "targets": [{"distance_m": 0.4}, {"distance_m": "inf"}]}
        self.assertEqual(by_name, self.succeed("ellipse", self.write("query.json", document)).stdout)
        shutil.copy(SOURCE / "configs/eyes/polans_5.json", self.folder / "mine.json")
        self.write("elsewhere/query.json", document)
        self.assertEqual(self.succeed("ellipse", "elsewhere/query.json", "--eye", "mine.json", "--pupil", 3, cwd=self.folder).stdout, by_name)
        spreads = strict_json(self.succeed("psf", "--eye", "polans_5", "--distance", "0.5,inf", "--set", '/models=["rays"]', "--set", "/rays/count=1024", "--json").stdout)
        self.assertEqual([result["distance_m"] for result in spreads["results"]], [0.5, "inf"])
        self.succeed("render", "cornell", "--eye", "oblique_astigmat", *self.SMALL, "-o", "a.png", cwd=self.folder)
        self.assertEqual(strict_json((self.folder / "a.manifest.json").read_text())["spec"]["eye"]["prescription"]["axis_deg"], 30)

    def test_a_map_of_the_lens_of_a_prescription(self):
        self.succeed("plot", "power", "--rx", "-3.25 -1.75 x 160", "-o", "a.svg", cwd=self.folder)
        self.succeed("lens", "--rx", "-3.25 -1.75 x 160", "--print-config", "-o", "lens.json", cwd=self.folder)
        self.succeed("plot", "power", "lens.json", "-o", "b.svg", cwd=self.folder)
        self.assertEqual((self.folder / "a.csv").read_text().replace("-3.25 -1.75 x 160", "lens"), (self.folder / "b.csv").read_text())

    def test_paths_of_the_source_tree_mean_shipped_files(self):
        self.assertEqual(self.succeed("lens", "configs/lenses/reading.json", cwd=self.folder).stdout, self.succeed("lens", "reading", cwd=self.folder).stdout)
        self.succeed("validate", "configs/experiments/night.json", cwd=self.folder)
        self.write("configs/lenses/reading.json", {"format": "sturm.spectacles/1"})
        self.assertEqual(sturm("lens", "configs/lenses/reading.json", cwd=self.folder).returncode, WRONG_INPUT)

    def test_what_a_line_stands_for(self):
        """--print-config gives a document that does the same, for every command that has it."""
        for command in (["lens", "--rx", "-2.00 -1.00 x 20", "--index", "1.67"], ["psf", "--rx", "-2.00 DS"], ["lens", "--rx", "+4.00 DS"],
                        ["render", "cornell", "--rx", "-3 -1 x 20", *self.SMALL[:4]], ["blurfield", "kakimoto_fig12", "--rx", "-1 DS"], ["run", "night", "--seed", "5"],
                        ["see", SOURCE / "docs/images/see_desk.png", "--rx", "-3 -1 x 20", "--distance-m", 2, "--vfov-deg", 30]):
            with self.subTest(command):
                config = self.succeed(*command, "--print-config").stdout
                self.write("config.json", config)
                self.assertIn("a valid sturm.", self.succeed("validate", "config.json", cwd=self.folder).stdout)
                self.assertEqual(self.succeed(command[0], "config.json", "--print-config", cwd=self.folder).stdout, config)

    def test_several_documents_are_validated_at_once(self):
        views = sorted((SOURCE / "configs/views").glob("*.json"))
        self.assertEqual(len(self.succeed("validate", *views).stdout.splitlines()), len(views))
        process = sturm("validate", views[0], self.write("broken.json", "{"), views[1])
        self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""))
        self.assertIn("broken.json", process.stderr)


class Silence(FolderTest):
    def picture(self, scene, **camera):
        self.write("view.json", {**documents.view(), "scene": scene, "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [16, 12], **camera}})
        process = self.succeed("render", "view.json", "-o", "a.exr", "--quiet", cwd=self.folder)
        return process.stderr, strict_json((self.folder / "a.manifest.json").read_text())["notes"]

    def test_a_scene_without_light(self):
        scene = documents.without(documents.two_triangles(), "/lights")
        stderr, notes = self.picture(scene)
        self.assertIn("warning: the picture is black: the scene has no light", stderr)
        self.assertTrue(any("no light" in note for note in notes))

    def test_a_black_picture_of_a_lit_scene(self):
        stderr, notes = self.picture(documents.two_triangles(), look_at_m=[0, 0, 1])
        self.assertIn("warning: the picture is black: the camera sees no surface", stderr)
        self.assertTrue(any("black" in note for note in notes))

    def test_a_picture_with_light_says_nothing(self):
        self.assertEqual(self.picture(documents.two_triangles()), ("", []))


class Gates(FolderTest):
    def small(self):
        experiment = documents.without(documents.experiment(), "/images")
        return documents.changed(experiment, "/ellipses/rays", {"count": 64, "replicates": 4})

    def test_a_study_needs_none(self):
        self.write("experiment.json", documents.without(self.small(), "/gates"))
        process = self.succeed("run", "experiment.json", "--out", "report", "--quiet", cwd=self.folder)
        self.assertIn("No gates: nothing was judged.", process.stdout)
        report = strict_json((self.folder / "report/report.json").read_text())
        self.assertEqual(report["verdict"]["passed"], None)
        page = (self.folder / "report/report.html").read_text()
        self.assertIn("No verdict", page)
        self.assertNotIn("0 of 0", page)
        self.assertNotIn('class="verdict fail"', page)
        self.succeed("report", "report", cwd=self.folder)
        process = sturm("gate", self.folder / "report/report.json")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("--gates", process.stderr)

    def test_a_gate_without_cases_says_so(self):
        gates = documents.gates()
        gates["gates"] = [{**gates["gates"][0], "statistic": "images/*/ssim"}]
        self.write("gates.json", gates)
        self.write("experiment.json", self.small())
        process = sturm("run", "experiment.json", "--out", "report", "--quiet", cwd=self.folder)
        self.assertEqual(process.returncode, FAILED, process.stderr)
        self.assertIn("(no case)", process.stdout)
        self.assertNotIn("0 of 0 cases", (self.folder / "report/report.html").read_text())
        self.assertIn("no case", sturm("gate", self.folder / "report/report.json").stdout)

    def test_mutations_need_gates(self):
        self.write("experiment.json", {**documents.without(self.small(), "/gates"), "mutations": ["turned_axis"]})
        process = sturm("run", "experiment.json", cwd=self.folder)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/mutations", process.stderr)


if __name__ == "__main__":
    unittest.main()
