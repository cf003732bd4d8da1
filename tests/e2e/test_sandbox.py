"""--sandbox: files of someone who is not trusted may name only files in their own folder and below it, links followed."""
import json
import os
import unittest

import documents
import gltf_models
import picture_files
from sturm_process import SOURCE, WRONG_INPUT, FolderTest, sturm

EYE = {"format": "sturm.eye/1", "prescription": {"sphere_D": -2, "cylinder_D": -1, "axis_deg": 30}, "pupil_diameter_mm": 4}


class Sandbox(FolderTest):
    def setUp(self):
        super().setUp()
        self.write("outside/eye.json", EYE)
        self.write("inside/eyes/eye.json", EYE)
        os.symlink(self.folder / "outside/eye.json", self.folder / "inside/link.json")
        os.symlink(self.folder / "outside", self.folder / "inside/folder")
        os.symlink("eyes/eye.json", self.folder / "inside/own_link.json")

    def ellipse(self, eye, *options):
        query = self.write("inside/query.json", {**documents.query(), "eye": eye})
        return sturm("ellipse", query, *options)

    def test_files_below_are_read(self):
        for eye in ("eyes/eye.json", "./eyes/../eyes/eye.json", "own_link.json", str(self.folder / "inside/eyes/eye.json")):
            process = self.ellipse(eye, "--sandbox")
            self.assertEqual(process.returncode, 0, process.stderr)

    def test_ways_out_are_refused(self):
        ways = ("../outside/eye.json", str(self.folder / "outside/eye.json"), "link.json", "folder/eye.json", "eyes/../../outside/eye.json")
        for eye in ways:
            process = self.ellipse(eye, "--sandbox")
            self.assertEqual(process.returncode, WRONG_INPUT, eye)
            self.assertIn("--sandbox", process.stderr)
            self.assertIn("query.json", process.stderr)
            self.assertEqual(process.stdout, "")
            # Whether the file is there is not told either.
            self.assertEqual(self.ellipse(eye.replace("eye.json", "none.json"), "--sandbox").returncode, WRONG_INPUT)
            self.assertEqual(self.ellipse(eye).returncode, 0, eye)  # trusted files may name any

    def test_the_option_stands_before_or_behind_the_command(self):
        self.ellipse("../outside/eye.json")
        self.assertEqual(sturm("--sandbox", "ellipse", self.folder / "inside/query.json").returncode, WRONG_INPUT)

    def test_what_the_command_line_names_is_trusted(self):
        line = ("--rx", "-2.00 -1.50 x 30", "--distance", "1", "--sandbox")
        self.write("outside/lens.json", json.loads((SOURCE / "configs/lenses/aspheric_plus.json").read_text()))
        self.write("outside/grey.png", picture_files.png([[128] * 8] * 8, 8))
        (self.folder / "work").mkdir()
        for arguments in (("ellipse", *line, "--lens", self.folder / "outside/lens.json"), ("ellipse", *line[2:], "--eye", self.folder / "outside/eye.json"),
                          ("see", self.folder / "outside/grey.png", "--rx", "-2", "--distance-m", 1, "--vfov-deg", 1, "-o", "seen.png", "--sandbox")):
            process = sturm(*arguments, cwd=self.folder / "work")
            self.assertEqual(process.returncode, 0, process.stderr)
        # A document names what is below it alone, on standard input too.
        query = json.dumps({**documents.query(), "eye": str(self.folder / "outside/eye.json")})
        self.assertEqual(sturm("ellipse", "-", "--sandbox", stdin=query, cwd=self.folder / "work").returncode, WRONG_INPUT)

    def render(self, model, *options):
        scene = {"models": [{"file": model}]}
        view = self.write("inside/view.json", {**documents.view(), "scene": scene})
        return sturm("render", view, "-o", self.folder / "seen.exr", "--set", "/camera/resolution=[4,4]", "--quiet", *options)

    def test_models_name_files_below_alone(self):
        faces = "v -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n"
        texture = (SOURCE / "tests/reference/images/reference.exr").read_bytes()
        for folder in ("inside", "outside", "inside/below"):
            self.write(f"{folder}/t.exr", texture)
            self.write(f"{folder}/a.mtl", "newmtl a\nKd 1 1 1\nmap_Kd t.exr\n")
        self.write("inside/way_out.mtl", "newmtl a\nKd 1 1 1\nmap_Kd ../outside/t.exr\n")
        os.symlink(self.folder / "outside/t.exr", self.folder / "inside/linked.exr")
        self.write("inside/linked.mtl", "newmtl a\nKd 1 1 1\nmap_Kd linked.exr\n")
        for library, refused in (("a.mtl", False), ("below/a.mtl", False), ("../outside/a.mtl", True), ("way_out.mtl", True), ("linked.mtl", True),
                                 (f"{self.folder}/outside/a.mtl", True)):
            self.write("inside/m.obj", f"mtllib {library}\n{faces}")
            process = self.render("m.obj", "--sandbox")
            self.assertEqual(process.returncode, WRONG_INPUT if refused else 0, f"{library}: {process.stderr}")
            self.assertEqual(self.render("m.obj").returncode, 0, library)
        for uri, refused in (("t.exr", False), ("below/t.exr", False), ("../outside/t.exr", True), ("linked.exr", True), ("%2e%2e/outside/t.exr", True)):
            model = gltf_models.Model()
            model.square(model.material(texture={"index": model.add("textures", source=model.add("images", uri=uri))}))
            model.write(self.folder / "inside/m.gltf")
            process = self.render("m.gltf", "--sandbox")
            self.assertEqual(process.returncode, WRONG_INPUT if refused else 0, f"{uri}: {process.stderr}")
            self.assertEqual(self.render("m.gltf").returncode, 0, uri)


if __name__ == "__main__":
    unittest.main()
