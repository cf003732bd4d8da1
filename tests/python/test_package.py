"""`pip install .` and a wheel, each in a fresh virtual environment: no package index is asked."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from sturm_process import SOURCE

BUILD = pathlib.Path(os.environ.get("STURM_BUILD", SOURCE / "build/release"))
PIP = ["-m", "pip", "--disable-pip-version-check"]
OFFLINE = ["--no-index", "--no-build-isolation", "--no-deps"]
USE = """
import sturm, pathlib
assert "site-packages" in sturm.__file__, sturm.__file__
eye = sturm.Eye(prescription="-2.00 -1.50 x 30 VD 0", pupil_diameter_mm=4)
# 1/d + F has the principal values 1.25 - 3.5 and 1.25 - 2.
assert abs(sturm.ellipses(eye, 0.8)["semi_major_rad"] - 4.5e-3) < 1e-12
sturm.Spectacles("progressive_regular", eye)
sturm.write_picture("a.png", sturm.render(VIEW).radiance)  # the scene is found; PNG needs the module beside the package
print(sturm.__version__)
"""


class Package(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="sturm_pip_")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        self.quietly(sys.executable, "-m", "venv", "--system-site-packages", self.folder / "venv")
        self.python = self.folder / "venv/bin/python"

    def quietly(self, *command):
        environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
        process = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, cwd=self.folder,
                                 env={**environment, "STURM_BUILD": str(BUILD)})
        self.assertEqual(process.returncode, 0, process.stdout + process.stderr)
        return process.stdout

    def assert_works(self):
        view = """{"format": "sturm.render/1", "scene": str(sturm.shipped("scenes/cornell_box.json")),
            "camera": {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0], "up": [0, 1, 0], "vfov_deg": 39.3, "resolution": [16, 16]},
            "eye": {"prescription": "-1.00 DS", "pupil_diameter_mm": 4}, "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": 1}}"""
        self.assertRegex(self.quietly(self.python, "-c", USE.replace("VIEW", view)), r"^\d+\.\d+\.\d+$")

    def test_pip_install(self):
        self.quietly(self.python, *PIP, "install", *OFFLINE, SOURCE)
        self.assert_works()

    def test_a_wheel(self):
        self.quietly(self.python, *PIP, "wheel", *OFFLINE, SOURCE, "-w", self.folder / "wheels")
        wheel, = (self.folder / "wheels").glob("sturm-*.whl")
        self.assertRegex(wheel.name, r"^sturm-\d+\.\d+\.\d+-cp3\d+-cp3\d+-linux_x86_64\.whl$")
        self.quietly(self.python, *PIP, "install", *OFFLINE, wheel)
        self.assert_works()


if __name__ == "__main__":
    unittest.main()
