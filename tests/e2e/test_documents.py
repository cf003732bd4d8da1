"""Every command that stands in the documents works: those of their own lines are run in a clean folder, those within sentences have the
options that there are.

Pictures, tables and spectra are made small, since it is the commands that are tested here.
"""
import functools
import json
import os
import re
import shutil
import subprocess
import unittest

import documents
import picture_files
from sturm_process import PASSED, SOURCE, STURM, WRONG_INPUT, FolderTest, sturm

PAGES = [SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md"))]
PROGRAMS = r"sturm|scripts/[\w.]+|build/\w+/bin/\w+|cmake|python3|STURM_BUILD=\S+|PYTHONPATH=\S+"
LINE = re.compile(rf"^    (?:\$ )?(…your renderer.*|(?:{PROGRAMS})(?: .*)?)$")
PLACEHOLDER = re.compile(r"…|\[[^\"]|\b[A-Z]{3,}\b(?![\"'=])|X\.exr|\w\|\w")
SMALL = "--size 48x32 --samples 2"

# Commands that are not run here, by how they begin, and why.
ELSEWHERE = {
    "scripts/run": "builds the program; it is how this test came to run",
    "scripts/test": "runs this test",
    "scripts/bench": "minutes, and other people's programs",
    "scripts/cycles_check.py": "needs Blender",
    "scripts/gate_seeds.py": "minutes: 20 runs of an experiment",
    "scripts/convert_usd": "needs Node; tests/viewer/test_convert_usd.py",
    "scripts/viewer": "builds the page with Node; tests/viewer",
    "cmake": "tests/e2e/test_install.py builds, installs and uses the library",
    "PYTHONPATH=": "tests/e2e/test_deb.py runs the example",
    "STURM_BUILD=": "tests/python/test_package.py makes the wheel and installs it",
    "build/release/bin/bench_work_plan": "minutes; tests/bench",
    "sturm view": "needs the page that scripts/viewer builds with Node; tests/viewer",
    "sturm serve": "runs until it is stopped; tests/e2e/test_serve.py",
    "sturm bench configs/benchmarks/rendering.json": "minutes",
    "sturm bench two_samplers.json": "minutes: a street at night by two samplers",
    "sturm run configs/experiments/": "minutes; tests/e2e/test_run.py, test_sin2_study.py and their neighbours run small ones",
}
ELSEWHERE_PAGES = {"docs/first_steps.md": "tests/e2e/test_first_steps.py runs its lines and takes their time"}


def page_name(page):
    return page.relative_to(SOURCE).as_posix()


def lines_of(page):
    """The commands and synopses on lines of their own, without remarks."""
    for line in page.read_text(encoding="utf-8").splitlines():
        if found := LINE.match(line):
            yield re.sub(r"\s{2,}# .*$", "", found[1])


def commands(page):
    """Those that can be run as they stand."""
    return [line for line in lines_of(page) if line.startswith("…your renderer") or not PLACEHOLDER.search(line)]


def is_elsewhere(command):
    return any(command.startswith(start) for start in ELSEWHERE)


def json_block(page, number=0):
    return json.loads(re.findall(r"(?s)```json\n(.*?)```", (SOURCE / page).read_text(encoding="utf-8"))[number])


def even_png(value, depth=8):
    return picture_files.png([[value] * 48] * 32, depth)


class DocumentedCommands(FolderTest):
    def rendered(self, name, *options):
        self.succeed("render", *options, "-o", name, "--quiet", *SMALL.split(), cwd=self.folder)

    def prepare(self, page):
        """What a page takes for granted."""
        name = page.split("/")[-1].removesuffix(".md")
        if name in ("common", "validate"):
            self.write("query.json", documents.changed(documents.query(), "/eye/pupil_diameter_mm", -4) if name == "validate" else documents.query())
            self.write("view.json", documents.view())
        if name == "ellipse":
            self.write("query.json", json_block(page))
        if name == "psf":
            spreads = json_block(page)
            spreads["lights"][1]["step_nm"] = 50
            self.write("psf.json", spreads)
        if name == "wearers":
            table = "configs/data/papila_prescriptions.csv"
            self.write(table, "".join((SOURCE / table).read_text(encoding="utf-8").splitlines(keepends=True)[:40]))
        if name in ("run", "compare-runs", "gate", "report", "junit"):
            self.write("my.json", json_block("docs/formats/experiment.md"))
            self.write("gates.json", json_block("docs/formats/gates.md"))
        if name in ("gate", "report", "junit"):
            self.succeed("run", "my.json", "--quiet", cwd=self.folder)
            shutil.copy(self.folder / "reports/runs/my/report.json", self.folder)
        if name in ("see", "teacher"):
            self.write("chart.png", even_png((180, 180, 180)))
            self.write("photo.png", even_png((90, 90, 90)))
            self.write("depth.png", even_png(2000, 16))
            for layer in ("sharp", "hidden1", "hidden2"):
                self.rendered(f"{layer}.exr", "desk", "--pupil", 0)
        if name in ("compare", "ci"):
            for picture, seed in (("traced2", 2), ("predicted2", 3)):
                self.rendered(f"{picture}.exr", "chart", "--seed", seed)
            self.write("photo.png", (self.folder / "traced2.png").read_bytes())
            for place in ("test", "reference", "test_seed"):
                (self.folder / "suite/chart").mkdir(parents=True, exist_ok=True)
                shutil.copy(self.folder / "traced2.exr", self.folder / f"suite/chart/{place}.exr")

    def run_line(self, command):
        command = command.replace("build/release/bin/sturm", "sturm")
        command = re.sub(r"^…your renderer.*", "sturm render check/view.json -o check/picture.exr --quiet", command)
        if re.match(r"sturm render (?!--help|--explain|check)", command):
            command += "".join(f" {option} {value}" for option, value in re.findall(r"(--\w+) (\S+)", SMALL) if option not in command)
        environment = {**os.environ, "PATH": f"{STURM.resolve().parent}:{os.environ['PATH']}"}
        return subprocess.run(["bash", "-c", command], cwd=self.folder, env=environment, capture_output=True, text=True, check=False, timeout=300)

    def test_lines(self):
        count = 0
        for page in PAGES:
            lines = [command for command in commands(page) if not is_elsewhere(command)]
            if not lines or page_name(page) in ELSEWHERE_PAGES:
                continue
            self.setUp()  # a folder of its own
            self.prepare(page_name(page))
            for command in lines:
                if command.startswith("sturm plot") and not shutil.which("gnuplot"):
                    continue
                count += 1
                with self.subTest(page=page_name(page), command=command):
                    process = self.run_line(command)
                    wanted = WRONG_INPUT if page.name == "validate.md" and "query" in command else PASSED
                    self.assertEqual(process.returncode, wanted, process.stderr)
        self.assertGreater(count, 60)

    def test_nothing_is_kept_out_in_vain(self):
        every = [command for page in PAGES for command in commands(page)]
        for start in ELSEWHERE:
            self.assertTrue(any(command.startswith(start) for command in every), start)


@functools.lru_cache
def options_of(command):
    return set(re.findall(r"(--[\w-]+)", sturm(command, "--help").stdout)) | {"--help", "--sandbox", "--version"}


class NamedCommands(unittest.TestCase):
    def test_options(self):
        """`sturm COMMAND --option` in a sentence or a synopsis names a command and options that there are."""
        names = set(re.findall(r"(?m)^  ([a-z-]+) {2,}", sturm("--help").stdout.split("Subcommands:")[1]))
        count = 0
        for page in PAGES:
            synopses = [line.removeprefix("sturm ") for line in lines_of(page) if line.startswith("sturm ")]
            for text in [*re.findall(r"`sturm ([^`]+)`", page.read_text(encoding="utf-8")), *synopses]:
                words = [word for word in text.split() if word != "--sandbox"]
                if not re.fullmatch(r"[a-z][a-z-]*", words[0]):
                    continue
                count += 1
                with self.subTest(page=page_name(page), command=text):
                    self.assertIn(words[0], names)
                    for option in re.findall(r"(?<![^\s\[(])(--[\w-]+)", text):
                        self.assertIn(option, options_of(words[0]))
        self.assertGreater(count, 200)


if __name__ == "__main__":
    unittest.main()
