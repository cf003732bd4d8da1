"""The Debian packages: what they hold and need, and that the program and the Python package work from where they are unpacked."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import documents
from sturm_process import SOURCE

BUILD = pathlib.Path(os.environ.get("STURM_BUILD", SOURCE / "build/release"))


def quietly(*command, **options):
    process = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **options)
    if process.returncode:
        raise AssertionError(f"{command}\n{process.stdout}\n{process.stderr}")
    return process.stdout


class DebianPackages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="sturm_deb_")
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        quietly("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder, cwd=cls.folder)
        cls.packages = {path.name.split("_")[0]: path for path in cls.folder.glob("*.deb")}
        cls.root = cls.folder / "root"
        for path in cls.packages.values():
            quietly("dpkg-deb", "-x", path, cls.root)

    def field(self, package, name):
        return quietly("dpkg-deb", "-f", self.packages[package], name).strip()

    def listed(self, package):
        return {line.split()[-1].lstrip(".") for line in quietly("dpkg-deb", "-c", self.packages[package]).splitlines()}

    def test_the_program_s_package(self):
        files = self.listed("sturm")
        for file in ("/usr/bin/sturm", "/usr/lib/sturm/sturm_imageformats.so", "/usr/share/sturm/configs/views/desk.json"):
            self.assertIn(file, files)
        self.assertFalse([file for file in files if file.endswith((".h", ".a", ".py"))])
        self.assertEqual(self.field("sturm", "Architecture"), "amd64")
        self.assertRegex(self.field("sturm", "Version"), r"^\d+\.\d+\.\d+")
        for library in ("libembree3-3", "libtbb12", "libc6"):
            self.assertIn(library, self.field("sturm", "Depends"))
        self.assertNotIn("-dev", self.field("sturm", "Depends"))

    def test_the_library_s_package(self):
        files = self.listed("libsturm-dev")
        for file in ("/usr/include/sturm/lensmodel/ellipse.h", "/usr/lib/libsturm_conoid.a", "/usr/lib/cmake/sturm/sturm-config.cmake"):
            self.assertIn(file, files)
        self.assertIn("libeigen3-dev", self.field("libsturm-dev", "Depends"))

    def test_the_program_runs_from_where_it_is(self):
        view = documents.changed(documents.view(), "/camera/resolution", [16, 12])
        scene = self.root / "usr/share/sturm/configs/scenes/cornell_box.json"
        (self.folder / "view.json").write_text(json.dumps(documents.changed(view, "/scene", str(scene))))
        quietly(self.root / "usr/bin/sturm", "render", "view.json", "-o", "a.exr", "--quiet", cwd=self.folder)
        self.assertEqual((self.folder / "a.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_first_steps_from_where_it_is(self):
        quietly(sys.executable, "-B", SOURCE / "tests/e2e/test_first_steps.py",
                env={**os.environ, "STURM": str(self.root / "usr/bin/sturm")}, cwd=self.folder)

    def test_the_python_package_runs_from_where_it_is(self):
        if "python3-sturm" not in self.packages:
            self.skipTest("built without STURM_PYTHON")
        self.assertIn("python3-numpy", self.field("python3-sturm", "Depends"))
        printed = quietly("/usr/bin/python3", SOURCE / "examples/ellipse.py",
                          env={**os.environ, "PYTHONPATH": str(self.root / "usr/lib/python3/dist-packages")})
        # At 0.8 m 1/d + F has the principal values 1.25 - 3.5 and 1.25 - 2, at infinity -3.5 and -2.
        rows = [list(map(float, line.split())) for line in printed.splitlines()]
        self.assertEqual([row[0] for row in rows], [0.4, 0.8, 6, float("inf")])
        self.assertAlmostEqual(rows[1][1], 2e-3 * 2.25, delta=1e-12)
        self.assertAlmostEqual(rows[3][1], 2e-3 * 3.5, delta=1e-12)
        self.assertAlmostEqual(rows[3][2], 2e-3 * 2.0, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
