"""The notebooks of docs/notebooks run, and their pages have what they print."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from sturm_process import SOURCE

NOTEBOOKS = SOURCE / "docs/notebooks"


class Notebooks(unittest.TestCase):
    def test_pages_are_what_the_notebooks_print(self):
        notebooks = sorted(path.stem for path in NOTEBOOKS.glob("*.py"))
        self.assertEqual(len(notebooks), 5)
        with tempfile.TemporaryDirectory() as folder:
            for name in notebooks:
                with self.subTest(name):
                    if "pandas" in name:
                        try:
                            import pandas  # noqa: F401
                        except ImportError:
                            self.skipTest("python3-pandas is not installed")
                    process = subprocess.run([sys.executable, "-B", SOURCE / "scripts/render_notebooks.py", "--output", folder, name],
                                             capture_output=True, text=True, check=False)
                    self.assertEqual(process.returncode, 0, process.stderr)
                    page = f"{name}.md"
                    self.assertEqual((pathlib.Path(folder) / page).read_text(encoding="utf-8"), (NOTEBOOKS / page).read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
