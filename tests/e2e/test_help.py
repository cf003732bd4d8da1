"""`sturm doctor`, `sturm init`, completions and manual pages, which come from the definitions that --help shows."""
import os
import pty
import re
import select
import shutil
import subprocess
import time
import unittest

import documents
import picture_files
import png_pixels
from sturm_process import RUNTIME_FAILURE, SOURCE, STURM, WRONG_INPUT, FolderTest, sturm

COMMANDS = re.findall(r"(?m)^  ([a-z-]+) {2,}", sturm("--help").stdout.split("Subcommands:")[1])


class Terminal:
    """A program on a terminal of its own."""

    def __init__(self, command, folder):
        self.pid, self.file = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, {**os.environ, "TERM": "dumb"})

    def type(self, text, wanted):
        """Types; returns once the terminal shows `wanted`. Throws AssertionError after 30 s."""
        os.write(self.file, text.encode())
        shown, end = "", time.monotonic() + 30
        while wanted not in shown:
            if time.monotonic() > end:
                raise AssertionError(f"{text!r}: no {wanted!r} in {shown!r}")
            if select.select([self.file], [], [], 0.2)[0]:
                shown += os.read(self.file, 65536).decode(errors="replace")

    def close(self):
        os.close(self.file)
        os.waitpid(self.pid, 0)


class Examples(FolderTest):
    """The lines at the end of each command's help, as a user would copy them."""

    # Pictures of shipped views are small, since it is the lines that are tested here.
    SMALL = ("--size", "96x72")
    # These take minutes, need the page of the browser, or go on until they are stopped: their documents alone are made.
    DOCUMENT_ALONE = ("run ", "bench ", "render desk --rx", "view ", "serve ")

    def lines(self, command):
        return re.findall(r"(?m)^  sturm (.*)$", sturm(command, "--help").stdout.split("Examples:\n")[1])

    def run_line(self, line):
        if line.startswith(self.DOCUMENT_ALONE):
            line = re.sub(r" -o \S+", "", line) + " --print-config"
        elif re.match(r"render (?!check/)", line) and self.SMALL[0] not in line:
            line += " " + " ".join(self.SMALL)
        environment = {**os.environ, "PATH": f"{STURM.parent}:{os.environ['PATH']}"}
        process = subprocess.run(["bash", "-c", f"set -o pipefail; sturm {line}"], cwd=self.folder, env=environment,
                                 capture_output=True, text=True, check=False, timeout=120)
        self.assertEqual(process.returncode, 0, f"{line}: {process.stderr}")

    def prepare(self):
        for name, rx in (("query", "-1 DS"), ("one", "-2 DS"), ("two", "-3 DS")):
            self.succeed("ellipse", "--rx", rx, "--print-config", "-o", f"{name}.json", cwd=self.folder)
        for name in ("photo", "pairs/box/test", "pairs/box/reference"):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            self.succeed("render", "cornell", "--rx", "-1 DS", "--samples", 1, *self.SMALL, "-o", f"{name}.png", cwd=self.folder)
        width, height = png_pixels.size((self.folder / "photo.png").read_bytes())
        self.write("depth.png", picture_files.png([[2000] * width] * height, 16))
        self.succeed("init", "view", ".", cwd=self.folder)
        self.write("table.csv", "id,sphere_D,cylinder_D,axis_deg\nA,-2,-0.5,20\n")
        shutil.copy(SOURCE / "configs/data/shwfs_mshwfs_centroids.csv", self.folder / "spots.csv")
        self.write("gates.json", documents.gates())
        self.write("experiment.json", documents.without(documents.experiment(), "/images"))
        for run in ("before", "after"):
            self.succeed("run", "experiment.json", "--quiet", "--out", run, cwd=self.folder)

    def test_every_line_works(self):
        self.prepare()
        for command in COMMANDS:
            for line in self.lines(command):
                with self.subTest(line):
                    self.run_line(line)


class Completion(FolderTest):
    def complete(self, *words):
        """What bash offers for the last of these words."""
        script = self.write("completion.bash", sturm("completion", "bash").stdout)
        line = " ".join(f"'{word}'" for word in words)
        program = (f"source {script}; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _sturm; printf '%s\\n' \"${{COMPREPLY[@]}}\"; "
                   "complete -p sturm >&2")
        process = subprocess.run(["bash", "--norc", "-c", program], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertIn("-F _sturm sturm", process.stderr)
        return process.stdout.split()

    def test_bash(self):
        self.assertGreater(len(COMMANDS), 20)
        self.assertEqual(sorted(set(COMMANDS) - set(self.complete("sturm", ""))), [])
        self.assertEqual(self.complete("sturm", "ell"), ["ellipse"])
        self.assertEqual(self.complete("sturm", "ellipse", "--di"), ["--distance"])
        self.assertEqual(self.complete("sturm", "--sandbox", "ellipse", "--print"), ["--print-config"])
        self.assertEqual(sorted(self.complete("sturm", "see", "p.png", "--psf", "")), ["rays", "waves"])
        self.assertEqual(sorted(self.complete("sturm", "init", "")), ["experiment", "lens", "sweep", "view"])
        self.assertEqual(self.complete("sturm", "compare", "de"), [])  # bash goes on with files

    def test_names_of_shipped_documents(self):
        for words, offered in ((["render", "de"], ["desk"]), (["render", "desk", "corn"], ["cornell"]), (["lens", "progressive_w"], ["progressive_wide_far", "progressive_wide_near"]),
                               (["ellipse", "--rx", "-1", "--lens", "gla"], ["glasses"]), (["plot", "blur", "pol"], ["polans_5"]), (["plot", "power", "gla"], ["glasses"]),
                               (["wearers", "table.csv", "oblique_t"], ["oblique_toric_p195"]), (["see", "p.png", "--eye", "hof"], ["hofer_5"]), (["run", "compare_d"], ["compare_designs"]),
                               (["validate-camera", "x", "--write", "--eye", "jaeken_3"], ["jaeken_36_right"]), (["plot", "blu"], ["blur"]), (["lens", "--ma"], ["--map"])):
            with self.subTest(words=words):
                self.assertEqual(sorted(self.complete("sturm", *words)), offered)
        names = {file.stem for file in (SOURCE / "configs/views").glob("*.json")}
        self.assertEqual(set(self.complete("sturm", "serve", "")) - {"completion.bash"}, names)
        self.write("desk_of_mine.json", {})
        self.assertEqual(sorted(self.complete("sturm", "render", "desk")), ["desk", "desk_of_mine.json"])

    def test_every_option_of_the_help_is_there(self):
        script = sturm("completion", "bash").stdout
        for command in COMMANDS:
            words = re.search(rf'(?m)^    {command}\) options="([^"]*)"', script)[1].split()
            for option in re.findall(r"(?m)^  (?:-\w,)?(--[\w-]+)", sturm(command, "--help").stdout):
                self.assertIn(option, words, command)

    @unittest.skipUnless(shutil.which("shellcheck"), "no shellcheck")
    def test_bash_is_clean(self):
        script = self.write("completion.bash", "#!/bin/bash\n" + sturm("completion", "bash").stdout)
        process = subprocess.run(["shellcheck", "-S", "warning", str(script)], capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 0, process.stdout)

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh(self):
        self.write("_sturm", sturm("completion", "zsh").stdout)
        program = f"fpath=({self.folder} $fpath); autoload -Uz compinit; compinit -u -d {self.folder}/dump; print $_comps[sturm]; source {self.folder}/_sturm"
        process = subprocess.run(["zsh", "-f", "-c", program], capture_output=True, text=True, check=False)
        self.assertEqual((process.stdout, process.stderr), ("_sturm\n", ""))

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh_completes(self):
        """What zsh makes of a line and a tabulator, on a terminal: the line with what is added, and below it what may follow."""
        (self.folder / "functions").mkdir()
        self.write("functions/_sturm", sturm("completion", "zsh").stdout)
        (self.folder / "here").mkdir()
        terminal = Terminal(["zsh", "-f", "-i"], self.folder / "here")
        self.addCleanup(terminal.close)
        terminal.type("PS1='> '; setopt no_beep; unsetopt zle_bracketed_paste; LISTMAX=1000; autoload -Uz compinit; "
                      f"fpath=({self.folder}/functions $fpath); compinit -u -D; echo READY''NOW\n", "READYNOW")
        for typed, seen in (("sturm ell", "sturm ellipse"), ("sturm ellipse --dis", "--distance"), ("sturm render de", "sturm render desk"),
                            ("sturm ellipse --lens gla", "--lens glasses"), ("sturm psf --eye pol", "--eye polans_5"), ("sturm plot blu", "plot blur"),
                            ("sturm plot blur pol", "blur polans_5"), ("sturm see p.png --psf w", "--psf waves"), ("sturm init v", "init view"),
                            ("sturm --sandbox ellipse --pri", "--print-config"), ("sturm --sandbox elli", "--sandbox ellipse"), ("sturm man doc", "man doctor"),
                            ("sturm lens progressive_o", "lens progressive_occupational")):
            with self.subTest(typed=typed):
                terminal.type(typed + "\t", seen)
                terminal.type("\x15", "")  # the line is emptied

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish(self):
        script = self.write("sturm.fish", sturm("completion", "fish").stdout)
        process = subprocess.run(["fish", "-c", f"source {script}; complete -C 'sturm ell'; complete -C 'sturm ellipse --dis'"],
                                 capture_output=True, text=True, check=True)
        self.assertIn("ellipse", process.stdout)
        self.assertIn("--distance", process.stdout)

    def test_unknown_shell(self):
        self.assertEqual(sturm("completion", "tcsh").returncode, WRONG_INPUT)


class Manual(FolderTest):
    def formatted(self, page):
        """The page as a terminal shows it; the formatter must not complain."""
        process = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-Kutf8", "-P-cbou"], input=page, capture_output=True, text=True, check=True)
        self.assertEqual(process.stderr, "")
        return process.stdout

    @unittest.skipUnless(shutil.which("groff"), "no groff")
    def test_every_command_has_its_page_with_every_option(self):
        program = self.formatted(sturm("man").stdout)
        for command in COMMANDS:
            self.assertIn(f"sturm-{command}(1)", program)
            page = re.sub(r"\s+", " ", self.formatted(sturm("man", command).stdout))
            for option in re.findall(r"(?m)^  (?:-\w,)?(--[\w-]+)", sturm(command, "--help").stdout):
                self.assertIn(option, page, command)
        self.assertIn('sturm ellipse --rx "-3.25 -1.75 x 160"', self.formatted(sturm("man", "ellipse").stdout))

    def test_all_pages_in_a_folder(self):
        self.succeed("man", "--folder", self.folder / "man1")
        self.assertEqual({path.name for path in (self.folder / "man1").iterdir()}, {"sturm.1", *(f"sturm-{command}.1" for command in COMMANDS)})

    def test_unknown_command(self):
        process = sturm("man", "elipse")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn('did you mean "ellipse"', process.stderr)


class Doctor(FolderTest):
    def test_what_it_says(self):
        text = self.succeed("doctor").stdout
        for word in ("version", "instruction set", "threads", "shipped data", "cornell", "PNG", "working directory", "python3"):
            self.assertIn(word, text)
        self.assertIn(str(SOURCE / "configs"), text)
        self.assertNotIn("FAIL", text)

    def test_what_is_missing(self):
        """The program alone, without its data and its module for pictures."""
        lonely = self.folder / "some/where/else/bin/sturm"
        lonely.parent.mkdir(parents=True)
        shutil.copy(STURM, lonely)
        process = subprocess.run([str(lonely), "doctor"], capture_output=True, text=True, check=False, cwd=self.folder)
        self.assertEqual(process.returncode, RUNTIME_FAILURE, process.stdout)
        self.assertRegex(process.stdout, "(?m)^FAIL +shipped data +not found; STURM_DATA")
        environment = {**os.environ, "STURM_DATA": str(SOURCE / "configs")}
        process = subprocess.run([str(lonely), "doctor"], capture_output=True, text=True, check=False, env=environment)
        self.assertRegex(process.stdout, f"(?m)^ok +shipped data +{SOURCE}/configs")


class Init(FolderTest):
    def test_starters_are_valid_and_nothing_is_written_over(self):
        for kind in ("experiment", "lens", "sweep", "view"):
            with self.subTest(kind):
                files = self.succeed("init", kind, cwd=self.folder).stdout.split()
                self.assertEqual(files, [f"{kind}/{kind}.json", f"{kind}/{kind}.md"])
                self.succeed("validate", files[0], cwd=self.folder)
                process = sturm("init", kind, cwd=self.folder)
                self.assertEqual(process.returncode, WRONG_INPUT)
                self.assertIn(files[0], process.stderr)
        self.succeed("init", "view", "a/b", cwd=self.folder)
        self.succeed("init", "lens", "a/b", cwd=self.folder)
        self.assertEqual(len(list((self.folder / "a/b").iterdir())), 4)

    def test_unknown_kind(self):
        process = sturm("init", "veiw", cwd=self.folder)
        self.assertEqual((process.returncode, list(self.folder.iterdir())), (WRONG_INPUT, []))


if __name__ == "__main__":
    unittest.main()
