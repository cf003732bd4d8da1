"""Pages of `sturm view` in a browser, and pictures of the program to hold them against."""
import array
import base64
import json
import math
import os
import pathlib
import sys
import tempfile
import unittest

from exr_header import float_pixels
from sturm_process import PASSED, SOURCE, sturm
from webdriver import Browser

TEMPLATE = pathlib.Path(os.environ.get("VIEWER_BUILD", SOURCE / "build")) / "viewer/viewer.html"
SKIPPED = 77
# Chromium without a graphics card: its software rasteriser, which newer ones want to be asked for.
SOFTWARE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
# The compositor of a machine without a graphics card reads the canvas back, and the driver remarks on that.
DRIVER_REMARK = "GL Driver Message (OpenGL, Performance"


def main():
    """Runs the tests of the file; exit status 77 where the page was not built."""
    if not TEMPLATE.exists():
        print(f"skipped: {TEMPLATE} was not built")
        sys.exit(SKIPPED)
    unittest.main()


class PageTest(unittest.TestCase):
    """A browser for all tests of a class, and a folder."""

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="sturm_viewer_")
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        cls.browser = cls.start()
        cls.browser.allow_scripts(110)

    @classmethod
    def start(cls):
        """The browser, which ends with the class."""
        browser = Browser(cls.folder / "profile", switches=SOFTWARE)
        cls.addClassCleanup(browser.close)
        return browser

    def tearDown(self):
        self.assertEqual(self.messages(), [])

    def messages(self):
        return [m for m in self.browser.console() if DRIVER_REMARK not in m["message"]]

    def write_page(self, view, name="page"):
        """The page of a view, a document of sturm.render/1."""
        document, page = self.folder / f"{name}.json", self.folder / f"{name}.html"
        document.write_text(json.dumps(view))
        process = sturm("view", document, "-o", page, "--template", TEMPLATE)
        self.assertEqual(process.returncode, PASSED, process.stderr)
        return page

    def page_of(self, view, name="page"):
        """Opens the page of a view and waits until it is ready."""
        page = self.write_page(view, name)
        self.browser.open(page)
        self.wait("window.sturmViewer")
        return page

    def wait(self, condition):
        script = f"""return new Promise((done) => {{
          const look = () => {{ const value = {condition}; if (value) done(true); else setTimeout(look, 50); }};
          setTimeout(() => done(false), 25000);
          look();
        }});"""
        self.assertTrue(self.browser.run(script), f"{condition}: {self.browser.text('#message')}")

    def change(self, edit):
        self.browser.run(f"window.sturmViewer.app.change((s) => {{ {edit} }})")

    def measured(self, call):
        """Numbers that the page computes on request; of pictures RGB, row by row from the top."""
        values = array.array("f")
        values.frombytes(base64.b64decode(self.browser.run(f"return window.sturmViewer.measured.{call}")))
        return values

    def rendered(self, view, name="render"):
        """The program's picture of a view, in the page's order of numbers."""
        document, picture = self.folder / f"{name}.json", self.folder / f"{name}.exr"
        document.write_text(json.dumps(view))
        process = sturm("render", document, "-o", picture, "--quiet")
        self.assertEqual(process.returncode, PASSED, process.stderr)
        channels = float_pixels(picture.read_bytes())
        rows = list(zip(channels["R"], channels["G"], channels["B"]))
        return array.array("f", (value for row in rows for pixel in zip(*row) for value in pixel))


def rectangle(x, y, z, half_width, half_height, turn=0.0):
    """Four corners, counter-clockwise as seen from +z."""
    c, s = math.cos(turn), math.sin(turn)
    return [[x + c * u - s * v, y + s * u + c * v, z] for u, v in
            ((-half_width, -half_height), (half_width, -half_height), (half_width, half_height), (-half_width, half_height))]


QUADS = (("wall", rectangle(0, 0, -6, 4, 4), 8), ("far", rectangle(0.35, -0.25, -2.5, 0.3, 0.12, 0.5), 12), ("middle", rectangle(-0.2, 0.1, -1, 0.09, 0.14, -0.3), 10),
         ("near", rectangle(0.05, 0.06, -0.4, 0.03, 0.02, 1.0), 15))
# Seen away from the middle of a lens, upper right and lower left.
QUADS_ASIDE = (("wall", rectangle(0, 0, -6, 12, 12), 8), ("far", rectangle(1.1, 0.8, -2.5, 0.4, 0.16, 0.5), 12), ("middle", rectangle(-0.4, -0.42, -1, 0.15, 0.08, -0.3), 10),
               ("near", rectangle(0.17, 0.11, -0.4, 0.05, 0.03, 1.0), 15), ("lower", rectangle(-0.55, 0.5, -1.2, 0.14, 0.1, 0.8), 13))


def emissive_view(size=128, quads=QUADS, vfov_deg=36):
    """Glowing rectangles at 0.4 to 2.5 m before a wall at 6 m, no two alike, nothing symmetric. Radiances are multiples of 1/32, so that sums
    over passes are exact in single precision, and lie within a factor of 1.9, so that no lamp gets passes of its own."""
    scene = {"format": "sturm.scene/1", "materials": {name: {"emission": [k / 16, k / 16 - 1 / 32, (8 + (k + 3) % 7) / 16]} for name, _, k in quads},
             "meshes": [{"name": name, "material": name, "positions_m": corners, "faces": [[0, 1, 2, 3]]} for name, corners, _ in quads]}
    return {"format": "sturm.render/1", "scene": scene, "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": vfov_deg, "resolution": [size, size]},
            "eye": {"prescription": {"sphere_D": -6, "cylinder_D": -3, "axis_deg": 30, "vertex_distance_mm": 0}, "pupil_diameter_mm": 6, "accommodation": {"mode": "relaxed"}},
            "method": {"type": "predict", "prediction": "multipass", "passes": 64}, "seed": 1}
