"""`sturm blurfield`: fields of the shipped documents and of small ones, what is skipped, and what is refused."""
import json
import unittest
import xml.etree.ElementTree

from sturm_process import CORNELL_BOX, SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

FIELD = {"format": "sturm.blurfield/1",
         "eye": {"prescription": {"sphere_D": -4, "cylinder_D": -2, "axis_deg": 30, "vertex_distance_mm": 12}, "pupil_diameter_mm": 4},
         "spectacles": {"single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5, "base_curve_D": 4}},
         "field": {"hfov_deg": 40, "directions": [8, 6], "depths": 16, "near_m": 0.4}}
SYMMETRIC = ["--set", "/eye/prescription/axis_deg=90"]


class Field(FolderTest):
    def summary(self, *options, document=FIELD, name="f.exr"):
        path = self.write("field.json", document)
        return strict_json(self.succeed("blurfield", path, "-o", self.folder / name, *options).stdout)

    def test_files_and_summary(self):
        summary = self.summary("--layers", self.folder / "layers.svg")
        self.assertEqual(summary["format"], "sturm.blurfield_result/1")
        self.assertEqual(summary["directions"]["usable"], 48)
        self.assertEqual(summary["directions"]["traced"], 48)  # an oblique cylinder has no mirror
        self.assertEqual(summary["voxels"]["stored"], 8 * 6 * 16)
        self.assertEqual(summary["voxels"]["memory_bytes"], 8 * 6 * 16 * 16)
        self.assertLess(summary["interpolation_error"]["largest_D"], 0.05)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["f.exr", "f.manifest.json", "field.json", "layers.svg"])
        manifest = strict_json((self.folder / "f.manifest.json").read_text())
        self.assertEqual(manifest["counters"]["directions"], summary["directions"])
        ellipses = xml.etree.ElementTree.parse(self.folder / "layers.svg").iter("{http://www.w3.org/2000/svg}ellipse")
        self.assertEqual(len(list(ellipses)), 3 * 48)
        schema = strict_json(self.succeed("schema", "blurfield_result").stdout)
        self.assertEqual(set(schema["required"]), set(summary))

    def test_the_same_bytes_for_any_number_of_threads(self):
        self.summary("--threads", "1", name="a.exr")
        self.summary("--threads", "3", name="b.exr")
        files = snapshot(self.folder)
        self.assertEqual(files["a.exr"], files["b.exr"])

    def test_what_is_skipped_is_counted(self):
        quarter = self.summary(*SYMMETRIC)["directions"]
        self.assertEqual((quarter["traced"], quarter["mirrored"]), (12, 36))
        whole = self.summary(*SYMMETRIC, "--set", "/skip/symmetry=false")["directions"]
        self.assertEqual((whole["traced"], whole["mirrored"]), (48, 0))
        narrow = ["--set", "/spectacles/single_vision/diameter_mm=10"]
        rim = self.summary(*narrow)["directions"]
        traced = self.summary(*narrow, "--set", "/skip/rim=false")["directions"]
        self.assertGreater(rim["skipped_beyond_rim"], 0)
        self.assertEqual(traced["skipped_beyond_rim"], 0)
        for key in ("usable", "missed_lens"):
            self.assertEqual(rim[key], traced[key])
        self.assertGreater(rim["missed_lens"], 0)

    def test_voxels_that_see_nothing_of_a_room(self):
        visible = {"scene": str(CORNELL_BOX), "position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0.0]}
        document = {**FIELD, "visible": visible, "field": {**FIELD["field"], "depths": 256}}
        some = self.summary(document=document)["voxels"]
        # The room fills the field at 0.8 to 1.4 m, which is a fifth of the dioptres from 0.4 m to infinity; each column needs less.
        self.assertLess(some["stored"], 0.2 * some["total"])
        self.assertGreater(some["stored"], 0.01 * some["total"])
        self.assertEqual(some["stored"] + some["skipped_empty"], some["total"])
        every = self.summary("--set", "/skip/empty_voxels=false", document=document)["voxels"]
        self.assertEqual(every["stored"], every["total"])

    def test_methods(self):
        for method in ("published", "previous"):
            summary = self.summary("--set", f"/method={method}")
            self.assertIsNone(summary["depth_analytic"])
            self.assertEqual(summary["voxels"]["undefined"], 0)

    def test_shipped_documents(self):
        for path in sorted((SOURCE / "configs/blurfields").glob("*.json")):
            with self.subTest(path.name):
                self.succeed("validate", path)
                summary = strict_json(self.succeed("blurfield", path, "-o", self.folder / "shipped.exr").stdout)
                self.assertGreater(summary["directions"]["usable"], 900)


class OneLine(FolderTest):
    WORN = ("--rx", "+1.00 -0.75 x 90", "--pupil", 3, "--age", 50, "--lens", "progressive_regular")

    def test_a_line_is_its_document(self):
        line = self.succeed("blurfield", *self.WORN, "-o", "line.exr", cwd=self.folder).stdout
        self.succeed("blurfield", *self.WORN, "--print-config", "-o", "field.json", cwd=self.folder)
        document = self.succeed("blurfield", "field.json", "-o", "document.exr", cwd=self.folder).stdout
        fields = [(self.folder / f"{name}.exr").read_bytes() for name in ("line", "document")]
        self.assertEqual(fields[0], fields[1])
        results = [{**strict_json(text), "seconds": None} for text in (line, document)]
        self.assertEqual(results[0], results[1])
        inputs = [[entry["file"] for entry in strict_json((self.folder / f"{name}.manifest.json").read_text())["provenance"]["inputs"]]
                  for name in ("line", "document")]
        self.assertEqual(inputs[1], ["field.json", *inputs[0]])

    def test_what_a_line_asks_for(self):
        """As docs/commands/blurfield.md has it."""
        document = strict_json(self.succeed("blurfield", "--rx", "-1.00 DS", "--print-config").stdout)
        self.assertEqual(document, {"format": "sturm.blurfield/1", "eye": {"prescription": "-1.00 DS", "pupil_diameter_mm": 4},
                                    "field": {"hfov_deg": 60, "directions": [32, 32]}})

    def test_no_question(self):
        process = sturm("blurfield", "-o", "field.exr", cwd=self.folder)
        self.assertEqual((process.returncode, list(self.folder.iterdir())), (WRONG_INPUT, []))
        self.assertIn("--rx", process.stderr)


class Refusals(FolderTest):
    CASES = [
        ("/field/hfov_deg", 0), ("/field/hfov_deg", 160), ("/field/directions", [1, 8]), ("/field/directions", [8]), ("/field/depths", 1),
        ("/field/near_m", 0), ("/field/far_m", 0.3), ("/field/far_m", "far"), ("/forms", []), ("/forms", ["voxel"]), ("/method", "wave"),
        ("/visible", {"scene": "none.obj", "position_m": [0, 0, 0], "look_at_m": [0, 0, -1]}), ("/skip/rims", True), ("/layers_m", [0]),
        ("/field/directions", [1024, 1024])]

    def test_wrong_values(self):
        for pointer, value in self.CASES:
            with self.subTest(f"{pointer} = {value}"):
                path = self.write("field.json", FIELD)
                extra = ["--set", "/field/depths=4096"] if value == [1024, 1024] else []
                before = snapshot(self.folder)
                process = sturm("blurfield", path, "-o", self.folder / "f.exr", "--set", f"{pointer}={json.dumps(value)}", *extra)
                self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
                self.assertIn(pointer.split("/")[1], process.stderr)
                self.assertEqual(snapshot(self.folder), before)

    def test_analytic_form_of_another_method(self):
        path = self.write("field.json", {**FIELD, "method": "previous", "forms": ["depth_analytic"]})
        process = sturm("blurfield", path, "-o", self.folder / "f.exr")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/forms", process.stderr)

    def test_names(self):
        path = self.write("field.json", FIELD)
        self.assertEqual(sturm("blurfield", path, "-o", self.folder / "f.png").returncode, WRONG_INPUT)
        self.assertEqual(sturm("blurfield", path, "-o", self.folder / "none" / "f.exr").returncode, 3)


if __name__ == "__main__":
    unittest.main()
