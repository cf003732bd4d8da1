"""The installed program works away from its build tree, and other programs can link the installed libraries."""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import documents
from sturm_process import SOURCE

BUILD = pathlib.Path(os.environ.get("STURM_BUILD", SOURCE / "build/release"))

class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="sturm_install_")
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        cls.prefix = cls.folder / "prefix"
        cls.run_quietly("cmake", "--install", BUILD, "--prefix", cls.prefix)

    @classmethod
    def run_quietly(cls, *command, **options):
        process = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **options)
        if process.returncode:
            raise AssertionError(f"{command}\n{process.stdout}\n{process.stderr}")
        return process.stdout

    def sturm(self, *arguments, cwd):
        return self.run_quietly(self.prefix / "bin/sturm", *arguments, cwd=cwd, env={"PATH": os.environ["PATH"]})

    def test_version(self):
        self.assertRegex(self.sturm("--version", cwd="/"), r"^sturm \d+\.\d+\.\d+ \(commit (unknown|[0-9a-f]{12}(\+changes)?)\)\n")

    def test_render_from_another_folder(self):
        work = self.folder / "work"
        work.mkdir()
        view = documents.changed(documents.view(), "/camera/resolution", [16, 12])
        installed_box = self.prefix / "share/sturm/configs/scenes/cornell_box.json"
        (work / "view.json").write_text(json.dumps(documents.changed(view, "/scene", str(installed_box))))
        self.sturm("render", "view.json", "-o", "a.exr", "--quiet", cwd=work)
        self.assertEqual((work / "a.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        # To read a TGA takes the image format module, found beside the installed program and not in the build tree.
        (work / "a.tga").write_bytes(bytes([0, 0, 2, *[0] * 9, 16, 0, 12, 0, 24, 32, *range(16 * 12), *[128] * (2 * 16 * 12)]))
        mapped = subprocess.run([str(self.prefix / "bin/sturm"), "compare", "a.tga", "a.tga"], cwd=work, check=False,
                                env={**os.environ, "LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(work / "loader")}, capture_output=True, text=True)
        self.assertEqual(mapped.returncode, 0, mapped.stderr)
        loaded = "".join(path.read_text(errors="replace") for path in work.glob("loader.*"))
        self.assertIn(str(self.prefix / "lib/sturm/sturm_imageformats.so"), loaded)
        self.assertNotIn(str(BUILD), loaded)

    def test_installed_configurations_are_valid(self):
        configs = self.prefix / "share/sturm/configs"
        paths = [path for folder in ("experiments", "scenes", "eyes", "gates", "benchmarks") for path in (configs / folder).glob("*.json")]
        self.assertGreaterEqual(len(paths), 4)
        for path in paths:
            with self.subTest(path.name):  # an experiment names files: each must have been installed where the experiment expects it
                self.sturm("validate", path, cwd="/")

    def test_shipped_things_by_name_manual_pages_and_completion(self):
        self.sturm("ellipse", "--rx", "-2.00 -1.50 x 30", "--lens", "progressive_regular", cwd="/")
        self.assertIn(f"shipped data       {self.prefix}/share/sturm/configs", self.sturm("doctor", cwd="/"))
        page = self.prefix / "share/man/man1/sturm-ellipse.1"
        self.assertIn("\\-\\-distance", page.read_text())
        self.assertTrue((page.parent / "sturm.1").exists())
        for place in ("bash-completion/completions/sturm", "zsh/site-functions/_sturm", "fish/vendor_completions.d/sturm.fish"):
            self.assertIn("ellipse", (self.prefix / "share" / place).read_text())

    def test_public_headers_alone_are_installed(self):
        include = self.prefix / "include"
        self.assertEqual([path.name for path in include.iterdir()], ["sturm"])  # nothing lies bare on the include path
        installed = {str(path.relative_to(include)) for path in include.rglob("*.h")}
        listed = [line for line in (SOURCE / "cmake/public_headers.txt").read_text().splitlines() if not line.startswith("#")]
        self.assertLessEqual({f"sturm/{line}" for line in listed}, installed)
        self.assertNotIn("sturm/conoid/pictures/fragment_filter.h", installed)
        for header in installed:
            text = (include / header).read_text()
            self.assertNotIn('#include "', text, header)
            self.assertLessEqual(set(re.findall(r"#include <(sturm/[^>]+)>", text)), installed, header)

    def test_public_headers_stand_on_their_own(self):
        project = self.folder / "headers"
        project.mkdir()
        include = self.prefix / "include"
        lines = [f"#include <{path.relative_to(include)}>\n" for path in sorted(include.rglob("*.h"))]
        (project / "all.cpp").write_text("".join(lines))
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(headers LANGUAGES CXX)\nfind_package(sturm REQUIRED)\n"
            "add_library(headers OBJECT all.cpp)\ntarget_link_libraries(headers PRIVATE sturm::stages)\n")
        self.build(project)

    def build(self, project):
        build = self.folder / f"{project.name}_build"
        self.run_quietly("cmake", "-G", "Ninja", "-S", project, "-B", build, "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.run_quietly("cmake", "--build", build)
        return build

    def test_examples(self):
        build = self.build(SOURCE / "examples")
        major, minor, orientation = map(float, self.run_quietly(build / "ellipse").split())
        # 1/d + F has the principal values 1.25 - 3.5 and 1.25 - 2; the first acts along the wearer's 60 degrees.
        self.assertAlmostEqual(major, 2e-3 * 2.25, delta=1e-12)
        self.assertAlmostEqual(minor, 2e-3 * 0.75, delta=1e-12)
        self.assertAlmostEqual(orientation, 60.0, delta=1e-7)

        work = self.folder / "example_work"
        work.mkdir()
        (work / "view.json").write_text(json.dumps(documents.changed(documents.view(), "/camera/resolution", [24, 20])))
        self.run_quietly(build / "render", work / "view.json", work / "example.exr")
        self.sturm("render", "view.json", "-o", "program.exr", "--quiet", cwd=work)
        printed = dict(line.split() for line in self.run_quietly(build / "compare", work / "example.exr", work / "program.exr").splitlines())
        self.assertEqual(float(printed["rmse_linear"]), 0.0)
        self.assertEqual(float(printed["ssim_display"]), 1.0)
        (work / "view.json").write_text('{"format": "sturm.render/1", "seed": -1}')
        process = subprocess.run([str(build / "render"), "view.json", "bad.exr"], cwd=work, capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 2)
        self.assertIn("at /seed: expected", process.stderr)

    def test_versions_are_semantic(self):
        (self.folder / "newer").mkdir()
        for version, found in (("0.1", True), ("0.2", False), ("1.0", False)):
            (self.folder / "newer/CMakeLists.txt").write_text(
                f"cmake_minimum_required(VERSION 3.25)\nproject(newer LANGUAGES CXX)\nfind_package(sturm {version} REQUIRED)\n")
            process = subprocess.run(["cmake", "-G", "Ninja", "-S", str(self.folder / "newer"), "-B", str(self.folder / f"newer_{version}"),
                                      f"-DCMAKE_PREFIX_PATH={self.prefix}"],
                                     capture_output=True, text=True, check=False)
            self.assertEqual(process.returncode == 0, found, version + process.stderr)


if __name__ == "__main__":
    unittest.main()
