"""The five lines of docs/first_steps.md, and the lines that the starters of `sturm init` recommend, as a user would type them.

`python3 tests/e2e/test_first_steps.py --times` prints how long the five take.
"""
import os
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import time
import unittest

import png_pixels
from sturm_process import SOURCE, STURM, FolderTest

LINES = re.findall(r"(?m)^\| \d \| `(sturm [^`]*)`", (SOURCE / "docs/first_steps.md").read_text(encoding="utf-8"))
PICTURE_SECONDS, SECONDS = 15, 2


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(line, folder):
    """A line in a shell, `sturm` being on the path; returns the process and the seconds that it took.

    On a machine that has more to do than it has processors these are the seconds of the processors, if they are fewer.
    """
    environment = {**os.environ, "PATH": f"{STURM.resolve().parent}:{os.environ['PATH']}"}
    start, used = time.monotonic(), children_seconds()
    process = subprocess.run(["bash", "-c", line], cwd=folder, env=environment, capture_output=True, text=True, check=False, timeout=120)
    seconds = time.monotonic() - start
    return process, min(seconds, children_seconds() - used) if os.getloadavg()[0] > os.cpu_count() else seconds


class FirstSteps(FolderTest):
    def test_five_lines_in_time(self):
        self.assertEqual(len(LINES), 5)
        for line in LINES:
            with self.subTest(line):
                process, seconds = run(line, self.folder)
                self.assertEqual((process.returncode, process.stderr if "render" not in line else ""), (0, ""), process.stderr)
                self.assertLessEqual(seconds, PICTURE_SECONDS if "render" in line else SECONDS)
        rows, columns = len((self.folder / "blur.csv").read_text().splitlines()), png_pixels.size((self.folder / "seen.png").read_bytes())
        self.assertEqual((rows, columns), (1 + 2, (320, 320)))
        self.assertTrue((self.folder / "map.svg").read_text().startswith("<"))
        self.assertTrue((self.folder / "view/view.json").exists())

    def test_the_other_lines_of_the_page(self):
        text = (SOURCE / "docs/first_steps.md").read_text(encoding="utf-8")
        lines = re.findall(r"(?m)^    (sturm .*)$", text)
        self.assertEqual(len(lines), 3)
        for line in lines:
            process, _ = run(line, self.folder)
            self.assertEqual((process.returncode, process.stderr), (0, ""), line)

    def test_what_starters_recommend(self):
        for kind in ("experiment", "lens", "sweep", "view"):
            process, _ = run(f"sturm init {kind}", self.folder)
            self.assertEqual(process.returncode, 0, process.stderr)
            lines = re.findall(r"(?m)^    (sturm .*)$", (self.folder / kind / f"{kind}.md").read_text(encoding="utf-8"))
            self.assertGreater(len(lines), 0)
            for line in lines:
                with self.subTest(line):
                    process, _ = run(line, self.folder / kind)
                    self.assertEqual(process.returncode, 0, process.stderr)
            keys = re.findall(r"(?m)^\| `([\w.]+)", (self.folder / kind / f"{kind}.md").read_text(encoding="utf-8"))
            self.assertGreaterEqual(len(keys), 4)


if __name__ == "__main__":
    if sys.argv[1:] == ["--times"]:
        with tempfile.TemporaryDirectory() as place:
            for first in LINES:
                print(f"{run(first, place)[1]:6.2f} s  {shlex.join(shlex.split(first)[:3])}")
    else:
        unittest.main()
