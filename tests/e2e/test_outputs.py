"""Whatever is written arrives whole, or the program says so: standard output, pipes, devices, links, full disks and limits."""
import json
import os
import pathlib
import resource
import signal
import stat
import subprocess
import unittest

import documents
from sturm_process import PASSED, RUNTIME_FAILURE, SOURCE, STURM, WRONG_INPUT, FolderTest, strict_json, sturm

REFERENCE = SOURCE / "tests/reference/images/reference.exr"
REPORTS = sorted((SOURCE / "tests/reference/reports").glob("*.json"))


def plate():
    """A small view that is rendered at once."""
    return {"format": "sturm.render/1", "scene": {"environment": {"radiance": [1, 1, 1]}, "materials": {"m": {}},
                                                  "spheres": [{"center_m": [0, 0, -2], "radius_m": 0.5, "material": "m"}]},
            "eye": {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 0},
            "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [64, 64]},
            "method": {"type": "path_trace", "ray_model": "pinhole", "samples_per_pixel": 1, "max_bounces": 1}}


class Outputs(FolderTest):
    def setUp(self):
        super().setUp()
        self.write("query.json", documents.query())
        self.write("view.json", plate())

    def expect_failure(self, process, *named):
        self.assertEqual(process.returncode, RUNTIME_FAILURE, process.stderr)
        lines = process.stderr.strip().splitlines()
        self.assertEqual(len(lines), 1, process.stderr)
        for text in ("error: ", *named):
            self.assertIn(text, lines[0])

    def temporary_files(self):
        return [path for path in self.folder.rglob(".*")]

    def commands_that_print(self):
        self.write("lens.json", {"format": "sturm.spectacles/1", **documents.spectacles()})
        yield from [["--help"], ["--version"], ["render", "--help"], ["schema"], ["schema", "scene"], ["validate", "query.json"], ["ellipse", "query.json"],
                    ["compare", REFERENCE, REFERENCE], ["compare", REFERENCE, REFERENCE, "--json", "-"], ["plan-samples"],
                    ["stress", "--cases", 10, "--quiet"], ["render", "view.json", "--explain"], ["lens", "lens.json", "--azimuth-deg", 0, "--elevation-deg", 0],
                    ["psf", "--rx", "-2", "--pupil", 1], ["wavefront", "--random"], ["doctor"], ["completion", "bash"], ["man", "see"],
                    ["render", "view.json", "--print-config"]]


class StandardOutput(Outputs):
    def test_full_disk(self):
        for arguments in self.commands_that_print():
            with self.subTest(arguments), open("/dev/full", "w") as full:
                process = subprocess.run([str(STURM), *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, text=True, cwd=self.folder)
                self.expect_failure(process, "standard output", "No space left")

    def test_pipe_that_nobody_reads(self):
        for arguments in self.commands_that_print():
            with self.subTest(arguments):
                read_end, write_end = os.pipe()
                os.close(read_end)
                process = subprocess.run([str(STURM), *map(str, arguments)], stdout=write_end, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                                         preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL))
                os.close(write_end)
                self.expect_failure(process, "standard output", "Broken pipe")

    def test_closed(self):
        process = subprocess.run(f"exec {STURM} ellipse query.json >&-", shell=True, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.expect_failure(process, "standard output")
        # What prints nothing loses nothing, and no file takes the place of the stream.
        process = subprocess.run(f"exec {STURM} ellipse query.json -o answer.json >&-", shell=True, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.assertEqual((process.returncode, process.stderr), (PASSED, ""))
        strict_json((self.folder / "answer.json").read_text())

    def test_stored_reports(self):
        report = next(path for path in REPORTS if json.loads(path.read_text()).get("format") == "sturm.report/1")
        for arguments in (["gate", report], ["compare-runs", report, report], ["compare-runs", report, report, "--json", "-"], ["report", report, "-o", "page.html"]):
            with self.subTest(arguments[0]), open("/dev/full", "w") as full:
                process = subprocess.run([str(STURM), *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, text=True, cwd=self.folder)
                self.expect_failure(process, "standard output")

    def test_wrong_input_stays_wrong_input(self):
        with open("/dev/full", "w") as full:
            process = subprocess.run([str(STURM), "ellipse", "nowhere.json"], stdout=full, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)


class NamedOutputs(Outputs):
    """-o and its like on what is no plain file."""

    def writers(self, name):
        """Commands that write a text to `name`."""
        report = next(path for path in REPORTS if json.loads(path.read_text()).get("format") == "sturm.report/1")
        return [["ellipse", "query.json", "-o", name], ["compare", REFERENCE, REFERENCE, "--json", name], ["stress", "--cases", 5, "--quiet", "-o", name],
                ["gate", report, "--junit", name], ["gate", report, "--markdown", name], ["compare-runs", report, report, "--json", name],
                ["report", report, "-o", name], ["wavefront", "--random", "-o", name], ["psf", "--rx", "-2", "--pupil", 1, "-o", name]]

    def test_pipe(self):
        for arguments in self.writers("pipe"):
            with self.subTest(arguments[0]):
                os.mkfifo(self.folder / "pipe")
                reader = subprocess.Popen(["timeout", "20", "cat", "pipe"], stdout=subprocess.PIPE, cwd=self.folder)
                process = sturm(*arguments, cwd=self.folder)
                received = reader.communicate()[0]
                self.assertIn(process.returncode, (0, 1), process.stderr)
                self.assertTrue(stat.S_ISFIFO(os.stat(self.folder / "pipe").st_mode))
                os.unlink(self.folder / "pipe")
                self.assertTrue(received)
                if arguments[0] in ("ellipse", "compare", "gate"):  # others tell the time
                    sturm(*[a if a != "pipe" else "plain" for a in arguments], cwd=self.folder)
                    self.assertEqual(received, (self.folder / "plain").read_bytes().replace(b"plain", b"pipe"))
                self.assertEqual(self.temporary_files(), [])

    def test_full_device(self):
        os.symlink("/dev/full", self.folder / "device")
        for name in ("/dev/full", "device"):
            for arguments in self.writers(name):
                with self.subTest(arguments[0], name=name):
                    self.expect_failure(sturm(*arguments, cwd=self.folder), "No space left", name)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))
        self.assertTrue((self.folder / "device").is_symlink())

    def test_null_device(self):
        self.succeed("ellipse", "query.json", "-o", "/dev/null", cwd=self.folder)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_standard_output_by_its_name(self):
        expected = self.succeed("ellipse", "query.json", cwd=self.folder).stdout
        for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "-"):
            self.assertEqual(self.succeed("ellipse", "query.json", "-o", name, cwd=self.folder).stdout, expected)
        # A file that it is appended to keeps what it had.
        log = self.write("log", "before\n")
        with open(log, "a") as stream:
            subprocess.run([str(STURM), "ellipse", "query.json", "-o", "/dev/stdout"], stdout=stream, cwd=self.folder, check=True)
        self.assertEqual(log.read_text(), "before\n" + expected)
        self.assertTrue(pathlib.Path("/dev/stdout").is_symlink())

    def test_links_are_followed(self):
        (self.folder / "place").mkdir()
        self.write("place/old.json", "old")
        os.chmod(self.folder / "place/old.json", 0o640)
        for target, mode in (("place/old.json", 0o640), ("place/new.json", None)):
            os.symlink(target, self.folder / "link")
            os.symlink("link", self.folder / "second")
            self.succeed("ellipse", "query.json", "-o", "second", cwd=self.folder)
            self.assertTrue((self.folder / "second").is_symlink() and (self.folder / "link").is_symlink())
            strict_json((self.folder / target).read_text())
            if mode:
                self.assertEqual(stat.S_IMODE(os.stat(self.folder / target).st_mode), mode)
            os.unlink(self.folder / "link")
            os.unlink(self.folder / "second")
        os.symlink("circle", self.folder / "circle")
        self.expect_failure(sturm("ellipse", "query.json", "-o", "circle", cwd=self.folder), "circle")
        os.symlink("nowhere/x.json", self.folder / "lost")
        self.expect_failure(sturm("ellipse", "query.json", "-o", "lost", cwd=self.folder), "lost")
        self.expect_failure(sturm("ellipse", "query.json", "-o", "place", cwd=self.folder), "place", "folder")
        self.assertEqual(self.temporary_files(), [])

    def test_pictures(self):
        os.mkfifo(self.folder / "pipe.exr")
        reader = subprocess.Popen(["timeout", "20", "cat", "pipe.exr"], stdout=subprocess.PIPE, cwd=self.folder)
        self.succeed("render", "view.json", "-o", "pipe.exr", "--quiet", cwd=self.folder)
        received = reader.communicate()[0]
        self.succeed("render", "view.json", "-o", "plain.exr", "--quiet", cwd=self.folder)
        self.assertEqual(received, (self.folder / "plain.exr").read_bytes())
        strict_json((self.folder / "pipe.manifest.json").read_text())
        os.symlink("/dev/full", self.folder / "full.exr")
        self.expect_failure(sturm("render", "view.json", "-o", "full.exr", "--quiet", cwd=self.folder), "full.exr", "No space left")
        os.mkfifo(self.folder / "show.png")
        process = sturm("render", "view.json", "-o", "a.exr", "--preview", "show.png", "--quiet", cwd=self.folder)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("--preview", process.stderr)
        self.succeed("render", "view.json", "-o", "BIG.EXR", "--quiet", cwd=self.folder)

    def test_text_is_not_named_as_a_picture(self):
        self.write("lens.json", {"format": "sturm.spectacles/1", **documents.spectacles()})
        self.write("wearers.csv", "id,eye,sph_D,cyl_D,axis_deg\nA,OD,0,0,\n")
        thin = {"format": "sturm.spectacles/1", "single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5}}
        self.write("thin.json", thin)
        for arguments in (["render", "view.json", "--print-config", "-o", "x.exr"], ["ellipse", "query.json", "--print-config", "-o", "x.png"],
                          ["ellipse", "query.json", "-o", "x.SVG"], ["lens", "lens.json", "-o", "x.svg"], ["psf", "--rx", "-2", "--pupil", 3, "-o", "x.png"],
                          ["wavefront", "--random", "-o", "x.pdf"], ["stress", "--cases", 3, "--quiet", "-o", "x.html"],
                          ["wearers", "wearers.csv", "thin.json", "-o", "x.png"]):
            with self.subTest(arguments):
                process = sturm(*arguments, cwd=self.folder)
                self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""), process.stderr)
                self.assertIn("a name that ends in", process.stderr)
                self.assertEqual(list(self.folder.glob("x.*")), [])

    def test_long_names(self):
        name = "x" * 250 + ".json"
        self.succeed("ellipse", "query.json", "-o", name, cwd=self.folder)
        strict_json((self.folder / name).read_text())


class NoRoom(Outputs):
    """Nothing half-written stays where there is no room."""

    def test_limit_of_file_size(self):
        def limited(bytes_):
            return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (bytes_, bytes_))

        for arguments, name in [(["ellipse", "query.json", "-o", "a.json"], "a.json"), (["render", "view.json", "-o", "a.exr", "--quiet"], "a.exr"),
                                (["compare", REFERENCE, REFERENCE, "--maps", "maps"], "maps")]:
            with self.subTest(arguments[0]):
                process = subprocess.run([str(STURM), *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                                         preexec_fn=limited(100))
                self.expect_failure(process, "File too large", name)
                self.assertEqual({path.name for path in self.folder.rglob("*") if path.is_file()}, {"query.json", "view.json"})

    def test_small_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4k", "tmpfs", str(disk)], capture_output=True).returncode != 0:
            self.skipTest("only root may mount")
        self.addCleanup(subprocess.run, ["umount", str(disk)], check=True)
        self.expect_failure(sturm("render", "view.json", "-o", "disk/a.exr", "--quiet", cwd=self.folder), "disk/a.exr", "No space left")
        self.assertEqual(list(disk.iterdir()), [])
        self.write("field.json", {"format": "sturm.blurfield/1", "eye": {"prescription": {"sphere_D": -2}, "pupil_diameter_mm": 4},
                                  "field": {"hfov_deg": 40, "directions": [48, 36], "depths": 16, "near_m": 0.4}})
        process = sturm("blurfield", "field.json", "-o", "disk/field.exr", cwd=self.folder)
        self.expect_failure(process, "disk/field.exr", "No space left")
        self.assertEqual(list(disk.iterdir()), [])


class Names(Outputs):
    """Names that are no text."""

    def test_names_of_files(self):
        name = b"gr\xfcn.json"
        with open(os.path.join(os.fsencode(self.folder), name), "wb") as stream:
            stream.write(json.dumps(documents.query()).encode())
        for arguments in ([b"validate", name], [b"ellipse", b"no_" + name]):
            process = subprocess.run([os.fsencode(STURM), *arguments], capture_output=True, cwd=self.folder)
            (process.stdout + process.stderr).decode("utf-8")
        picture = os.path.join(os.fsencode(self.folder), b"gr\xfcn.exr")
        with open(picture, "wb") as stream:
            stream.write(REFERENCE.read_bytes())
        process = subprocess.run([os.fsencode(STURM), b"compare", picture, os.fsencode(REFERENCE), b"--json", b"-"], capture_output=True)
        self.assertEqual(process.returncode, PASSED, process.stderr)
        self.assertIn("gr\ufffdn.exr", strict_json(process.stdout.decode("utf-8"))["test"])

    def test_names_in_models(self):
        """Bytes of other encodings, control characters, and long names."""
        for name in (b"gr\xfcn", b"\xe3\x81\x82\xe3", b"bell\x07\x1b[31m", "日本".encode() * 150, b"\xc3\x28" * 400):
            with self.subTest(name[:20]):
                self.write("m.mtl", b"newmtl " + name + b"\nKd 0.1 0.2 0.3\nKs 1 1 1\n")
                self.write("m.obj", b"mtllib m.mtl\nv -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nusemtl " + name + b"\nf 1 2 3\n")
                document = plate()
                document["scene"] = {"models": [{"file": "m.obj"}], "lights": [{"type": "point", "position_m": [0, 0, 0], "intensity": [1, 1, 1]}]}
                self.write("named.json", document)
                self.succeed("render", "named.json", "-o", "named.exr", "--quiet", cwd=self.folder)
                notes = strict_json((self.folder / "named.manifest.json").read_bytes().decode("utf-8"))["notes"]
                self.assertTrue(any("specular" in note for note in notes), notes)
                self.write("m.mtl", b"newmtl " + name + b"\nKd 2 0.2 0.3\n")
                process = subprocess.run([str(STURM), "render", "named.json", "-o", "named.exr", "--quiet"], capture_output=True, cwd=self.folder)
                self.assertEqual(process.returncode, WRONG_INPUT)
                message = process.stderr.decode("utf-8")
                self.assertLess(len(message), 1200)
                self.assertFalse(any(ord(c) < 32 for c in message.strip()), message)


if __name__ == "__main__":
    unittest.main()
