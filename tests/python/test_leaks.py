"""The module loses no memory: its tests under LeakSanitizer, which needs no build of its own. What the interpreter never gives back is not
counted: only blocks that were allocated below a function of the module."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
TESTS = ("test_errors", "test_fields", "test_pictures")
# Children, the command line among them, run without the sanitizer.
RUN_TESTS = """
import os, sys, unittest
del os.environ["LD_PRELOAD"]
result = unittest.main(module=None, argv=["tests", *sys.argv[1:]], exit=False).result
assert result.wasSuccessful() and result.testsRun > 0
"""
LOSE_A_ROW = """
import ctypes, numpy, sturm
ctypes.pythonapi.Py_IncRef(ctypes.py_object(sturm.ellipses(sturm.Eye("oblique_astigmat"), numpy.linspace(0.3, 5, 1000))))
"""


def sanitizer():
    found = subprocess.run(["gcc", "-print-file-name=liblsan.so"], capture_output=True, text=True).stdout.strip()
    return found if os.path.isabs(found) else None


@unittest.skipUnless(sanitizer(), "no liblsan.so beside gcc")
class Leaks(unittest.TestCase):
    def lost(self, program, *arguments):
        """Leaks with a frame of the module, each as its lines."""
        environment = {**os.environ, "LD_PRELOAD": sanitizer(), "PYTHONMALLOC": "malloc", "PYTHONPATH": f"{HERE}:{os.environ['PYTHONPATH']}"}
        with tempfile.TemporaryDirectory() as folder:
            environment["LSAN_OPTIONS"] = f"exitcode=0:fast_unwind_on_malloc=0:malloc_context_size=50:log_path={folder}/leaks"
            process = subprocess.run([sys.executable, "-B", "-c", program, *arguments], capture_output=True, text=True, env=environment)
            self.assertEqual(process.returncode, 0, process.stderr)
            report = "".join(log.read_text() for log in pathlib.Path(folder).iterdir())
        self.assertIn("SUMMARY: LeakSanitizer", report)  # the interpreter's own leaks: it has looked
        return [leak for leak in re.split(r"\n\n", report) if "leak of" in leak and re.search(r"/_core\.[^/]*\.so|libsturm", leak)]

    def test_the_tests_of_the_module_lose_nothing(self):
        self.assertEqual(self.lost(RUN_TESTS, *TESTS), [])

    def test_a_lost_row_would_be_seen(self):
        self.assertNotEqual(self.lost(LOSE_A_ROW), [])


if __name__ == "__main__":
    unittest.main()
