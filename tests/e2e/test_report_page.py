"""report.html in a browser: tables that sort and filter, and the image viewer, whose numbers are those of the EXR files."""
import pathlib
import tempfile
import unittest

import documents
from exr_header import float_pixels
from sturm_process import sturm
from webdriver import KEYS, Browser

HALF = 2.0**-11  # relative error of rounding to binary16
CASES = "table.cases"
VIEWER = ".viewer"
CANVAS = VIEWER + " canvas"
# The canvas' pixels, read from a copy: reading the canvas itself again and again makes Chromium complain.
PIXELS = f"""
  const canvas = document.querySelector("{CANVAS}");
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", {{willReadFrequently: true}});
  copy.drawImage(canvas, 0, 0);
"""
# What is on the canvas: a number that changes with any pixel.
PICTURE = PIXELS + """
  const bytes = copy.getImageData(0, 0, canvas.width, canvas.height).data;
  let sum = 0;
  for (let i = 0; i < bytes.length; ++i) sum = (sum * 31 + bytes[i]) % 4294967291;
  return sum;"""


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="sturm_page_", ignore_cleanup_errors=True)
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        cls.run_folder = cls.folder / "out"
        experiment = documents.experiment()
        experiment["images"][0]["ray_models"] = ["power_matrix", "sin2_radial"]
        (cls.folder / "experiment.json").write_text(documents.json_text(experiment))
        (cls.folder / "gates.json").write_text(documents.json_text(documents.gates()))
        process = sturm("run", cls.folder / "experiment.json", "--out", cls.run_folder, "--quiet")
        if process.returncode != 0:
            raise RuntimeError(process.stderr)
        cls.browser = Browser(cls.folder / "profile")
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.open(self.run_folder / "report.html")

    def tearDown(self):
        self.assertEqual(self.browser.console(), [])

    def column(self, number, shown="tr:not([hidden])"):
        return self.browser.run(
            f"return Array.from(document.querySelectorAll('{CASES} tbody {shown}'), row => row.children[{number}].textContent)")

    def picture(self):
        return self.browser.run(PICTURE)

    def press(self, text):
        self.browser.type(CANVAS, text)

    def values(self, layer):
        """The numbers that the viewer shows of a layer."""
        return [float(text) for text in self.browser.run(
            f"return Array.from(document.querySelectorAll('{VIEWER} tr[data-layer={layer}] td[data-value]'), cell => cell.dataset.value)")]

    def pixel(self):
        caption = self.browser.text(VIEWER + " .readout caption")
        return tuple(int(part) for part in caption[caption.index("(") + 1:caption.index(")")].split(","))

    def test_cases_sort_by_a_column(self):
        button = CASES + " thead th:nth-child(6) button"
        self.browser.click(button)
        self.assertEqual(self.browser.run(f"return document.querySelector('{CASES} thead th:nth-child(6)').ariaSort"), "descending")
        keys = self.browser.run(f"return Array.from(document.querySelectorAll('{CASES} tbody tr'), row => row.children[5].dataset.order)")
        numbers = [float(key) for key in keys if key is not None]
        self.assertGreater(len(numbers), 8)
        self.assertEqual(numbers, sorted(numbers, reverse=True))
        self.assertNotIn(None, keys[:len(numbers)])  # absent numbers come last
        self.browser.click(button)
        self.assertEqual(self.browser.run(f"return document.querySelector('{CASES} thead th:nth-child(6)').ariaSort"), "ascending")

    def test_cases_filter_by_text_and_status(self):
        everything = len(self.column(0))
        self.assertEqual(everything, 4 * 4 + 2 + 2)  # ellipses x ray models, PSFs, images
        self.browser.type(".filters:has(+ .scroll > table.cases) input", "sin2 oblique")
        names = self.column(0)
        self.assertEqual(names, ["oblique|1 m|4 mm", "oblique|inf|4 mm"])
        self.assertIn("2 of 20 rows", self.browser.text(".filters:has(+ .scroll > table.cases) output"))
        self.browser.open(self.run_folder / "report.html")
        self.browser.run("""
          const list = document.querySelector('.filters:has(+ .scroll > table.cases) select');
          list.value = 'no result';
          list.dispatchEvent(new Event('change'));""")
        self.assertEqual(set(self.column(1)), {"no result"})
        self.assertEqual(set(self.column(2)), {"metalstigmatism"})  # a relaxed eye states no focus distance

    def test_keys_switch_between_layers(self):
        seen = set()
        for key in "123456789":
            self.press(key)
            self.assertEqual(self.browser.run(f"return document.querySelectorAll('{VIEWER}')[0].querySelectorAll('.layers [aria-pressed=true]').length"), 1)
            self.assertTrue(self.browser.text(VIEWER + " .layers [aria-pressed=true]").startswith(key))
            seen.add(self.picture())
        self.assertEqual(len(seen), 9)

    def test_zoom_and_whole_picture(self):
        whole = self.picture()
        self.press("+++")
        near = self.picture()
        self.assertNotEqual(near, whole)
        linked = self.browser.run("const all = document.querySelectorAll('.viewer canvas'); return all.length")
        self.assertEqual(linked, 2)
        self.press("0")
        self.assertEqual(self.picture(), whole)

    def test_split_moves(self):
        self.browser.run(f"const list = document.querySelector('{VIEWER} select.layout'); list.value = 'split'; list.dispatchEvent(new Event('change'));")
        middle = self.picture()
        self.press("]]]")
        self.assertAlmostEqual(float(self.browser.run(f"return document.querySelector('{VIEWER} input.split').value")), 0.56)
        moved = self.picture()
        self.assertNotEqual(moved, middle)
        width = self.browser.run(f"return document.querySelector('{CANVAS}').clientWidth")
        at = round(0.06 * width)
        self.browser.pointer(CANVAS, (at, 0), "down", (at - 100, 0), "up")
        self.assertLess(float(self.browser.run(f"return document.querySelector('{VIEWER} input.split').value")), 0.5)

    def test_exposure_is_of_linear_values(self):
        before = self.picture()
        self.press("ee")  # one stop
        self.assertNotEqual(self.picture(), before)
        self.assertEqual(self.browser.text(VIEWER + " .controls label:has(.exposure) output"), "+1 stops")
        # A pixel far from white: twice the light, by the transfer function of sRGB.
        self.press("0")
        shown = self.browser.run(PIXELS + """
          return Array.from(copy.getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data).slice(0, 3);""")
        rows = self.exr("path_traced", "power_matrix")
        for byte, channel in zip(shown, "RGB"):
            linear = min(1.0, 2.0 * rows[channel][16][16])
            encoded = 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
            self.assertAlmostEqual(byte, 255.0 * encoded, delta=0.51 + 0.13)  # rounding to a byte, and 2^-11 of 255

    def exr(self, which, model):
        name = f"images/box_{model if which == 'path_traced' else 'predicted'}.exr"
        return float_pixels((self.run_folder / name).read_bytes())

    def test_values_under_the_cursor_are_those_of_the_files(self):
        self.browser.pointer(CANVAS, (37, -51))
        x, y = self.pixel()
        for layer in ("path_traced", "predicted"):
            rows, shown = self.exr(layer, "power_matrix"), self.values(layer)
            for channel, value in zip("RGB", shown):
                exact = rows[channel][y][x]
                self.assertAlmostEqual(value, exact, delta=HALF * abs(exact) + 3e-8)
            self.assertGreater(max(shown), 0.0)

    def test_arrow_keys_choose_a_pixel(self):
        self.press(KEYS["right"])
        x, y = self.pixel()
        self.press(KEYS["down"] + KEYS["down"] + KEYS["left"])
        self.assertEqual(self.pixel(), (x - 1, y + 2))

    def test_maps_have_the_mean_that_the_report_states(self):
        """The mean of the SSIM map over the picture is the metric; read pixel by pixel as a reader would, along the margin it has none."""
        self.browser.pointer(CANVAS, (0, 0))
        self.assertEqual(len(self.values("ssim_display")), 1)
        self.assertEqual(len(self.values("flip")), 1)
        for _ in range(4):
            self.press(KEYS["shift"] + KEYS["left"] + KEYS["shift"])
        self.assertEqual(self.pixel()[0], 0)
        self.assertEqual(self.browser.text(VIEWER + " tr[data-layer=ssim_display] td"), "–")


if __name__ == "__main__":
    unittest.main()
