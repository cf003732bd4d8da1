"""Failures at run time: status 3, one line on stderr, and nothing left behind."""
import unittest

import documents
from sturm_process import RUNTIME_FAILURE, FolderTest, snapshot, sturm


class RunTimeFailures(FolderTest):
    """Permissions do not stop root: a file in a folder's place and /proc do."""

    def fail(self, *arguments):
        before = snapshot(self.folder)
        process = sturm(*arguments, cwd=self.folder)
        self.assertEqual(process.returncode, RUNTIME_FAILURE, f"{arguments}: {process.stderr}")
        self.assertEqual(process.stdout, "")
        self.assertTrue(process.stderr.startswith("error: "), process.stderr)
        self.assertEqual(snapshot(self.folder), before)
        return process.stderr

    def test_ellipse(self):
        self.write("query.json", documents.query())
        self.write("file", "in the way")
        for output in ("file/answer.json", "nowhere/answer.json", "/proc/answer.json"):
            with self.subTest(output):
                self.assertIn(output, self.fail("ellipse", "query.json", "-o", output))

    def test_render(self):
        self.write("view.json", documents.view())
        self.write("file", "in the way")
        for output in ("file/picture.exr", "nowhere/picture.exr", "/proc/picture.exr"):
            with self.subTest(output):
                self.assertIn(output, self.fail("render", "view.json", "-o", output, "--quiet"))

    def test_run(self):
        self.write("gates.json", documents.gates())
        self.write("experiment.json", documents.experiment())
        self.write("file", "in the way")
        for folder in ("file", "file/report", "/proc/report"):
            with self.subTest(folder):
                self.fail("run", "experiment.json", "--out", folder, "--quiet")


if __name__ == "__main__":
    unittest.main()
