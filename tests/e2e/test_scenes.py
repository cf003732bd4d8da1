"""The scenes, views and experiments that are shipped: valid, and the same bytes when their scripts run again."""
import shutil
import subprocess
import sys
import unittest

from sturm_process import FolderTest, SOURCE

sys.path.insert(0, str(SOURCE / "scripts"))
sys.dont_write_bytecode = True
import sloan_letters  # noqa: E402

MADE = {"make_cornell_box.py": ["configs/scenes/cornell_box.json"], "make_night_scene.py": ["configs/scenes/night.json"],
        "make_desk_scene.py": ["configs/scenes/desk.json"], "make_street_scene.py": ["configs/scenes/street.json"],
        "make_seed_scene.py": ["configs/scenes/seed.json"], "make_sky.py": ["configs/environments/clear_sky.exr"]}


def area(polygon):
    """Signed: positive where the corners run counter-clockwise."""
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1])) / 2


class Scenes(FolderTest):
    def test_scripts_make_the_shipped_bytes(self):
        copy = self.folder / "tree"
        shutil.copytree(SOURCE / "scripts", copy / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copytree(SOURCE / "configs/data", copy / "configs/data")
        (copy / "configs/scenes").mkdir()
        for script, files in MADE.items():
            with self.subTest(script):
                subprocess.run([sys.executable, "-B", copy / "scripts" / script], check=True)
                for name in files:
                    self.assertEqual((copy / name).read_bytes(), (SOURCE / name).read_bytes(), name)

    def test_every_view_and_experiment_is_valid(self):
        for folder in ("views", "experiments"):
            for path in sorted((SOURCE / "configs" / folder).glob("*.json")):
                with self.subTest(path.name):
                    self.succeed("validate", path)

    def test_letters_are_as_large_as_they_say(self):
        # A letter of logMAR 0 subtends 5 arcmin: at 6 m tan(5/60 deg) * 6 m = 8.727 mm.
        self.assertAlmostEqual(sloan_letters.letter_height(0.0, 6.0), 0.0087266, delta=5e-7)
        self.assertAlmostEqual(sloan_letters.letter_height(1.0, 6.0), 0.0872680, delta=5e-7)
        for letter, polygons in sloan_letters.LETTERS.items():
            with self.subTest(letter):
                xs, ys = ([p[i] for polygon in polygons for p in polygon] for i in (0, 1))
                for low, high in ((min(xs), max(xs)), (min(ys), max(ys))):
                    self.assertAlmostEqual(low, 0.0, delta=0.013)  # arcs of 9 degrees miss the circle by 2.5 (1 - cos 4.5 deg) = 0.008
                    self.assertAlmostEqual(high, 5.0, delta=0.06)  # C's gap ends at cos(asin(0.2)) * 2.5 + 2.5 = 4.949
                for polygon in polygons:
                    self.assertGreater(area(polygon), 0.0)  # faces the reader

    def test_strokes_are_one_unit_wide(self):
        # Areas worked by hand: H = 5 + 5 + 3; O = pi (2.5^2 - 1.5^2) less what chords miss; Z = 5 + 5 + 3 * 1.25.
        areas = {letter: sum(area(p) for p in polygons) for letter, polygons in sloan_letters.LETTERS.items()}
        self.assertAlmostEqual(areas["H"], 13.0, delta=1e-12)
        self.assertAlmostEqual(areas["Z"], 13.75, delta=1e-12)
        self.assertAlmostEqual(areas["O"], 12.566, delta=0.06)  # 1 - sin(9 deg)/0.15708 = 0.4 %

    def test_a_chart_reads_from_left_to_right(self):
        mesh = {"positions_m": [], "faces": []}
        sloan_letters.add_text(mesh, "CV", 1.0, (0, 0, -6))
        left = [p for p in mesh["positions_m"] if p[0] < 0]
        # C is on the wearer's left, and its gap on its right: no vertex of its outer edge lies at the gap's height there.
        self.assertGreater(len(left), len(mesh["positions_m"]) - len(left))
        self.assertFalse([p for p in left if p[0] > -0.6 and abs(p[1]) < 0.09])


if __name__ == "__main__":
    unittest.main()
