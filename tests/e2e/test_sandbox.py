"""--sandbox: files of someone who is not trusted may name only files in their own folder and below it, links followed."""
import os
import unittest

import documents
from sturm_process import WRONG_INPUT, FolderTest, sturm

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


if __name__ == "__main__":
    unittest.main()
