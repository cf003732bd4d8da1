"""The composite action and the pre-commit hooks: their steps are taken from their files and run."""
import os
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

from sturm_process import FAILED, PASSED, SOURCE, STURM, WRONG_INPUT, FolderTest

IMAGES = SOURCE / "tests/reference/images"
ACTION = (SOURCE / "ci/action/action.yml").read_text(encoding="utf-8")


def step_of_the_action():
    """The script of the only step, and its environment with `inputs.NAME` as values."""
    block = re.search(r"^      run: \|\n((?:        .*\n|\n)+)", ACTION, re.MULTILINE).group(1)
    environment = dict(re.findall(r"^        (\w+): \$\{\{ inputs\.(\w+) \}\}$", ACTION, re.MULTILINE))
    return "".join(line[8:] or "\n" for line in block.splitlines(keepends=True)), environment


def default_of(name):
    found = re.search(rf"^  {name}:\n(?:    .*\n)*?    default: (.*)\n", ACTION, re.MULTILINE)
    return found.group(1).strip('"') if found else None


class Action(FolderTest):
    def run_step(self, **inputs):
        script, environment = step_of_the_action()
        self.assertEqual(sorted(environment.values()), ["junit", "options", "sturm", "suite"])
        values = {name: inputs.get(name, default_of(name)) for name in environment.values()}
        self.assertNotIn(None, values.values())
        process = subprocess.run(
            ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script], cwd=self.folder, capture_output=True, encoding="utf-8",
            env={"PATH": os.environ["PATH"], "GITHUB_STEP_SUMMARY": str(self.folder / "summary.md"), "GITHUB_OUTPUT": str(self.folder / "outputs"),
                 **{variable: values[name] for variable, name in environment.items()}})
        return process.returncode, (self.folder / "outputs").read_text(), (self.folder / "summary.md").read_text()

    def pair(self, test):
        folder = self.folder / "suite/room"
        folder.mkdir(parents=True)
        shutil.copy(IMAGES / f"{test}.exr", folder / "test.exr")
        shutil.copy(IMAGES / "reference.exr", folder / "reference.exr")

    def test_a_pair_that_agrees(self):
        self.pair("reference")
        (self.folder / "summary.md").write_text("of an earlier step\n")
        (self.folder / "outputs").write_text("earlier=yes\n")
        status, outputs, summary = self.run_step(suite="suite", options="--max-rmse 0 --bound flip=0", sturm=str(STURM))
        self.assertEqual(status, PASSED)
        self.assertEqual(outputs, "earlier=yes\nstatus=0\n")
        self.assertTrue(summary.startswith("of an earlier step\n"))
        self.assertIn("2 of 2 gates passed", summary)
        root = xml.etree.ElementTree.parse(self.folder / "sturm-suite.xml").getroot()
        self.assertEqual((root.get("tests"), root.get("failures")), ("2", "0"))

    def test_a_pair_that_does_not(self):
        self.pair("blur")
        status, outputs, summary = self.run_step(suite="suite", options="--max-rmse 1e-6", sturm=str(STURM), junit="other.xml")
        self.assertEqual(status, FAILED)
        self.assertIn("status=1", outputs)
        self.assertIn("✗", summary)
        self.assertEqual(xml.etree.ElementTree.parse(self.folder / "other.xml").getroot().get("failures"), "1")

    def test_wrong_input_is_told_apart(self):
        (self.folder / "suite").mkdir()
        status, outputs, _ = self.run_step(suite="suite", sturm=str(STURM))
        self.assertEqual(status, WRONG_INPUT)
        self.assertIn("status=2", outputs)

    def test_what_it_asks_for_and_tells(self):
        step, written = re.search(r"steps\.(\w+)\.outputs\.(\w+)", ACTION).groups()
        self.assertIn(f"\n    - id: {step}\n", ACTION)
        self.assertIn(f'echo "{written}=', ACTION)
        required = re.findall(r"(?m)^  (\w+):\n    description: .*\n    required: true$", ACTION)
        self.assertEqual(required, ["suite"])
        self.assertIsNone(default_of("suite"))


class Hooks(FolderTest):
    def test_what_is_handed_to_them(self):
        said = {}
        for hook in re.split(r"(?m)^- ", (SOURCE / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))[1:]:
            keys = dict(re.findall(r"(?m)^(?:  )?(\w+): (.*)$", hook))
            said[keys["id"]] = keys
        self.assertEqual(said["sturm-validate"]["types"], "[json]")
        self.assertNotIn("pass_filenames", said["sturm-validate"])
        suite = said["sturm-compare-suite"]
        self.assertEqual(suite["pass_filenames"], "false")  # its arguments name the folder
        for name in ("test.exr", "reference.png", "reference.hdr"):
            self.assertRegex(name, suite["files"])
        self.assertNotRegex("suite.json", suite["files"])

    def run_hook(self, name, *arguments):
        hooks = (SOURCE / ".pre-commit-hooks.yaml").read_text(encoding="utf-8")
        entry = re.search(rf"- id: {name}\n(?:  .*\n)*?  entry: (\S+)\n", hooks).group(1)
        self.assertTrue(os.access(SOURCE / entry, os.X_OK), entry)
        return subprocess.run([str(SOURCE / entry), *map(str, arguments)], capture_output=True, encoding="utf-8",
                              env={"PATH": os.environ["PATH"], "STURM": str(STURM)})

    def test_valid_documents_and_those_of_others_pass(self):
        other = self.write("package.json", {"format": "something else"})
        self.assertEqual(self.run_hook("sturm-validate", SOURCE / "configs/eyes/oblique_astigmat.json", other).returncode, PASSED)

    def test_a_wrong_document_is_named(self):
        wrong = self.write("eye.json", {"format": "sturm.eye/1", "pupil_diameter_mm": -4})
        process = self.run_hook("sturm-validate", SOURCE / "configs/eyes/oblique_astigmat.json", wrong)
        self.assertEqual(process.returncode, 1)
        self.assertIn("/pupil_diameter_mm", process.stderr)

    def test_a_suite_is_judged(self):
        folder = self.folder / "pictures/room"
        folder.mkdir(parents=True)
        for name in ("test", "reference"):
            shutil.copy(IMAGES / "reference.exr", folder / f"{name}.exr")
        self.assertEqual(self.run_hook("sturm-compare-suite", self.folder / "pictures", "--max-rmse", 0).returncode, PASSED)


if __name__ == "__main__":
    unittest.main()
