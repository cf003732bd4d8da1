"""The Python package for pip: CMake builds it. STURM_BUILD names a build tree that has it already, else one is made (20 minutes on 2 cores)."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"project\(sturm VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


def run(*command):
    subprocess.run([str(part) for part in command], check=True)


class BuildWithCMake(build_ext):
    def run(self):
        build = pathlib.Path(os.environ.get("STURM_BUILD", "") or self.build_temp).resolve()
        if not (build / "CMakeCache.txt").exists():
            run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DSTURM_PYTHON=ON", "-DSTURM_TESTS=OFF",
                f"-DPython_EXECUTABLE={sys.executable}")
        run("cmake", "--build", build, "--target", "sturm_python_package")
        with tempfile.TemporaryDirectory() as prefix:
            run("cmake", "--install", build, "--component", "python", "--prefix", prefix)
            package = next(pathlib.Path(prefix).rglob("sturm/__init__.py")).parent
            shutil.copytree(package, pathlib.Path(self.build_lib) / "sturm", dirs_exist_ok=True)

    def get_outputs(self):
        return [str(path) for path in (pathlib.Path(self.build_lib) / "sturm").rglob("*") if path.is_file()]


(ROOT / "build").mkdir(exist_ok=True)  # setuptools leaves its notes there
setup(version=VERSION, packages=[], ext_modules=[Extension("sturm._core", [])], cmdclass={"build_ext": BuildWithCMake},
      options={"egg_info": {"egg_base": "build"}, "build": {"build_base": "build/wheel"}})
