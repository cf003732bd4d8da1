"""The installed program works away from its build tree, and other programs can link the installed libraries."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import documents
from sturm_process import SOURCE

BUILD = pathlib.Path(os.environ.get("STURM_BUILD", SOURCE / "build/release"))

CONSUMER_CMAKE = """cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(sturm REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE sturm::conoid)
"""

CONSUMER = """#include <cstdio>

#include "conoid/tracing/footprint.h"
#include "lensmodel/ellipse.h"

int main() {
  const auto eye = sturm::Eye::with({-2.0, -1.5, 30.0, 0.0}, 4e-3);
  const auto footprint = sturm::naked_eye_footprint(eye, 0.8);
  const auto ellipse = sturm::Ellipse::image_of_disc(footprint.angular, eye.pupil_radius_m);
  std::printf("%.12g %.12g %.9g\\n", ellipse.semi_major, ellipse.semi_minor, *ellipse.orientation_deg);
}
"""


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
        # The PNG needs the image format module, found beside the installed program and not in the build tree.
        work = self.folder / "work"
        work.mkdir()
        view = documents.changed(documents.view(), "/camera/resolution", [16, 12])
        installed_box = self.prefix / "share/sturm/configs/scenes/cornell_box.json"
        (work / "view.json").write_text(json.dumps(documents.changed(view, "/scene", str(installed_box))))
        mapped = subprocess.run([str(self.prefix / "bin/sturm"), "render", "view.json", "-o", "a.exr", "--quiet"], cwd=work, check=False,
                                env={**os.environ, "LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(work / "loader")}, capture_output=True, text=True)
        self.assertEqual(mapped.returncode, 0, mapped.stderr)
        self.assertEqual((work / "a.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
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

    def test_another_program_links_the_libraries(self):
        project = self.folder / "consumer"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(CONSUMER_CMAKE)
        (project / "main.cpp").write_text(CONSUMER)
        self.run_quietly("cmake", "-G", "Ninja", "-S", project, "-B", project / "build", "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.run_quietly("cmake", "--build", project / "build")
        major, minor, orientation = map(float, self.run_quietly(project / "build/consumer").split())
        # 1/d + F has the principal values 1.25 - 3.5 and 1.25 - 2; the first acts along the wearer's 60 degrees.
        self.assertAlmostEqual(major, 2e-3 * 2.25, delta=1e-12)
        self.assertAlmostEqual(minor, 2e-3 * 0.75, delta=1e-12)
        self.assertAlmostEqual(orientation, 60.0, delta=1e-7)


if __name__ == "__main__":
    unittest.main()
