"""Experiments of one section, run from a folder with their inputs: what the tests of all such sections do."""
from documents import changed
from sturm_process import FAILED, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm


class StudyTest(FolderTest):
    """Subclasses name the section, the experiment, its gates, and the further files that it needs."""

    section = ""
    document = {}
    gates = {}
    files = {}

    def setUp(self):
        super().setUp()
        self.write("gates.json", self.gates)
        for name, content in self.files.items():
            self.write(name, content)
        self.experiment = self.write("experiment.json", self.document)

    def run_study(self, folder, *options):
        return self.succeed("run", self.experiment, "--out", self.folder / folder, *options)

    def study(self, folder):
        return strict_json((self.folder / folder / "report.json").read_text())[self.section]

    def noticed_by(self, folder):
        """{id of a deliberate error: {id of a gate that noticed it: what it says}}"""
        power = strict_json((self.folder / folder / "report.json").read_text())["gate_power"]
        return {mutation["id"]: {caught["gate"]: caught for caught in mutation["caught_by"]} for mutation in power["mutations"]}

    def expect_a_wrong_bound_to_fail(self, bound):
        """`bound` of the first gate is beyond what can be met."""
        self.write("gates.json", changed(self.gates, "/gates/0/bound", bound))
        self.assertEqual(sturm("run", self.experiment, "--out", self.folder / "out", "--quiet").returncode, FAILED)

    def expect_rejection(self, named):
        process = sturm("run", self.experiment, "--out", self.folder / "out")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertIn(named, process.stderr)

    def expect_rejections(self, cases):
        """Each case: pointer into the experiment, a wrong value, and what the error names. Nothing may be written."""
        before = snapshot(self.folder)
        for pointer, value, named in cases:
            with self.subTest(pointer=pointer, value=value):
                self.write("experiment.json", changed(self.document, pointer, value))
                self.expect_rejection(named)
                self.write("experiment.json", self.document)
                self.assertEqual(snapshot(self.folder), before)
