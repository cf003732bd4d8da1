"""report.html in browsers: tables that sort and filter, and the viewer of images, predictions and point spreads, whose numbers are those of the EXR files."""
import base64
import json
import math
import pathlib
import tempfile
import unittest

import documents
from agreement_viewer import HALF, PREDICTIONS, AgreementViewer, agreement_case
from exr_header import float_pixels
from marionette import Firefox, firefox
from srgb import srgb_byte
from sturm_process import CORNELL_BOX, sturm
from webdriver import KEYS, Browser

CASES = "table.cases"
VIEWER = "#images .viewer"
SPREADS = "#psfs .viewer"
CANVAS = VIEWER + " canvas"
LOG_DECADES = 3  # of point spreads
# The canvas' pixels, read from a copy: reading the canvas itself again and again makes Chromium complain.
PIXELS = """
  const canvas = document.querySelector(arguments[0] + " canvas");
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", {willReadFrequently: true});
  copy.drawImage(canvas, 0, 0);
"""
# What is on the canvas: a number that changes with any pixel.
PICTURE = PIXELS + """
  const bytes = copy.getImageData(0, 0, canvas.width, canvas.height).data;
  let sum = 0;
  for (let i = 0; i < bytes.length; ++i) sum = (sum * 31 + bytes[i]) % 4294967291;
  return sum;"""
# The colours of some pixels of a picture of arguments[1] x arguments[2] pixels that stands whole in the middle of the canvas.
COLOURS = PIXELS + """
  const [width, height, wanted] = [arguments[1], arguments[2], arguments[3]];
  const scale = Math.min(canvas.width / width, canvas.height / height);
  const left = (canvas.width - scale * width) / 2, top = (canvas.height - scale * height) / 2;
  return wanted.map(([x, y]) =>
    Array.from(copy.getImageData(Math.floor(left + (x + 0.5) * scale), Math.floor(top + (y + 0.5) * scale), 1, 1).data).slice(0, 3));"""


def setUpModule():
    """The page that all browsers open."""
    global FOLDER, RUN_FOLDER
    holder = tempfile.TemporaryDirectory(prefix="sturm_page_", ignore_cleanup_errors=True)
    unittest.addModuleCleanup(holder.cleanup)
    FOLDER = pathlib.Path(holder.name)
    RUN_FOLDER = FOLDER / "out"
    experiment = documents.experiment()
    experiment["images"][0]["ray_models"] = ["power_matrix", "sin2_radial"]
    experiment["agreement"] = [agreement_case(documents.view(), CORNELL_BOX)]
    (FOLDER / "experiment.json").write_text(documents.json_text(experiment))
    (FOLDER / "gates.json").write_text(documents.json_text(documents.gates()))
    process = sturm("run", FOLDER / "experiment.json", "--out", RUN_FOLDER, "--quiet")
    if process.returncode != 0:
        raise RuntimeError(process.stderr)


def picture_of(name):
    """Channels of an EXR file of the run, rows of numbers."""
    return float_pixels((RUN_FOLDER / name).read_bytes())


class ReportPage(AgreementViewer):
    """The tests of the page, with those of its predicted pictures; each browser has a class of its own below."""

    @classmethod
    def setUpClass(cls):
        cls.run_folder = RUN_FOLDER
        cls.browser = cls.start()
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.open(self.run_folder / "report.html")

    def tearDown(self):
        self.assertEqual(self.browser.console(), [])

    def column(self, number, shown="tr:not([hidden])"):
        return self.browser.run(
            f"return Array.from(document.querySelectorAll('{CASES} tbody {shown}'), row => row.children[{number}].textContent)")

    def picture(self, viewer=VIEWER):
        return self.browser.run(PICTURE, viewer)

    def colours(self, pixels, viewer=VIEWER, size=(32, 32)):
        """What the canvas shows at the middle of some pixels of the whole picture."""
        return self.browser.run(COLOURS, viewer, *size, pixels)

    def press(self, text, viewer=VIEWER):
        self.browser.type(viewer + " canvas", text)

    def choose(self, viewer, name, value):
        self.browser.run(f"const list = document.querySelector('{viewer} select.{name}'); list.value = arguments[0]; "
                         "list.dispatchEvent(new Event('change'));", value)

    def values(self, layer, viewer=VIEWER):
        """The numbers that the viewer shows of a layer."""
        return [float(text) for text in self.browser.run(
            f"return Array.from(document.querySelector('{viewer}').querySelectorAll('tr[data-layer={layer}] td[data-value]'), "
            "cell => cell.dataset.value)")]

    def pixel(self, viewer=VIEWER):
        caption = self.browser.text(viewer + " .readout caption")
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
        self.assertEqual(everything, 4 * 4 + 2 + 2 + len(PREDICTIONS))  # ellipses x ray models, PSFs, images, predictions
        self.browser.type(".filters:has(+ .scroll > table.cases) input", "sin2 oblique")
        names = self.column(0)
        self.assertEqual(names, ["oblique|1 m|4 mm", "oblique|inf|4 mm"])
        self.assertIn("2 of 22 rows", self.browser.text(".filters:has(+ .scroll > table.cases) output"))
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
            self.assertEqual(self.browser.run(f"return document.querySelector('{VIEWER}').querySelectorAll('.layers [aria-pressed=true]').length"), 1)
            self.assertTrue(self.browser.text(VIEWER + " .layers [aria-pressed=true]").startswith(key))
            seen.add(self.picture())
        self.assertEqual(len(seen), 9)

    def test_zoom_and_whole_picture(self):
        whole = self.picture()
        self.press("+++")
        near = self.picture()
        self.assertNotEqual(near, whole)
        linked = self.browser.run("const all = document.querySelectorAll('#images .viewer canvas'); return all.length")
        self.assertEqual(linked, 2)
        self.press("0")
        self.assertEqual(self.picture(), whole)

    def telling(self, first, second):
        """Pixels where two pictures of the box differ by more than 8 bytes in each channel, in both halves of the picture."""
        found = [(x, y) for y in range(2, 32)  # labels stand above
                 for x in range(32)
                 if all(abs(srgb_byte(first[c][y][x]) - srgb_byte(second[c][y][x])) > 8 for c in "RGB")]
        left, right = [p for p in found if p[0] < 14][:20], [p for p in found if p[0] > 18][:20]
        self.assertTrue(len(left) > 3 and len(right) > 3, found)
        return left, right

    def assert_shows(self, pixels, rows):
        """The canvas has the colours of an EXR file; by the file's own bytes, not the viewer's."""
        for (x, y), shown in zip(pixels, self.colours(pixels)):
            for byte, channel in zip(shown, "RGB"):
                # Rounding to a byte, and 2^-11 of a value under the transfer function's root: 0.06.
                self.assertAlmostEqual(byte, srgb_byte(rows[channel][y][x]), delta=0.57, msg=f"pixel ({x}, {y})")

    def test_flicker_shows_the_picture_of_the_key(self):
        """Keys 1 and 2 of the second case, where sin² is path traced, so that the pictures differ."""
        self.browser.run("document.querySelectorAll('#images article')[0].remove()")
        traced, predicted = self.exr("path_traced", "sin2_radial"), self.exr("predicted", "sin2_radial")
        left, right = self.telling(traced, predicted)
        for _ in range(2):
            self.press("1")
            self.assert_shows(left + right, traced)
            self.press("2")
            self.assert_shows(left + right, predicted)

    def test_split_shows_the_layer_on_its_left(self):
        self.browser.run("document.querySelectorAll('#images article')[0].remove()")
        traced, predicted = self.exr("path_traced", "sin2_radial"), self.exr("predicted", "sin2_radial")
        left, right = self.telling(traced, predicted)
        self.choose(VIEWER, "layout", "split")
        self.press("1")
        self.choose(VIEWER, "behind", "1")
        self.assert_shows(left, traced)
        self.assert_shows(right, predicted)

    def test_split_moves(self):
        self.choose(VIEWER, "layout", "split")
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
        rows = self.exr("path_traced", "power_matrix")
        pixels = [(16, 16), (9, 21)]
        for (x, y), shown in zip(pixels, self.colours(pixels)):
            for byte, channel in zip(shown, "RGB"):
                self.assertAlmostEqual(byte, srgb_byte(2.0 * rows[channel][y][x]), delta=0.51 + 0.13)  # a byte, and 2^-11 of 255

    def exr(self, which, model):
        return picture_of(f"images/box_{model if which == 'path_traced' else 'predicted'}.exr")

    def test_values_under_the_cursor_are_those_of_the_files(self):
        self.browser.pointer(CANVAS, (37, -51))
        x, y = self.pixel()
        width, height = self.browser.run(f"const c = document.querySelector('{CANVAS}'); return [c.clientWidth, c.clientHeight]")
        side = min(width, height) / 32  # of a pixel, the picture in the middle; the pointer is within a pixel of where it was sent
        self.assertAlmostEqual(x + 0.5, 16 + 37 / side, delta=0.5 + 1 / side)
        self.assertAlmostEqual(y + 0.5, 16 - 51 / side, delta=0.5 + 1 / side)
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


    def spreads(self):
        """Pictures of the point spread as the run has written them: by key of the layer, rows of numbers."""
        return {key: picture_of(f"psf/spot_{key}.exr")["R"] for key in ("predicted", "power_matrix", "sin2_radial")}

    def test_point_spreads_have_the_values_of_the_files(self):
        spreads = self.spreads()
        layers = self.browser.run(f"return Array.from(document.querySelectorAll('{SPREADS} tbody tr'), row => row.dataset.layer)")
        self.assertEqual(layers, [*spreads, "difference_power_matrix", "difference_sin2_radial"])
        self.browser.pointer(SPREADS + " canvas", (61, -133))
        x, y = self.pixel(SPREADS)
        self.assertGreater(spreads["sin2_radial"][y][x], 0.0)
        for key, rows in spreads.items():
            shown, = self.values(key, SPREADS)
            self.assertAlmostEqual(shown, rows[y][x], delta=HALF * rows[y][x] + 1e-9, msg=key)
        for model in ("power_matrix", "sin2_radial"):
            difference = spreads[model][y][x] - spreads["predicted"][y][x]  # signed
            self.assertAlmostEqual(self.values("difference_" + model, SPREADS)[0], difference, delta=HALF * abs(difference) + 1e-8)

    def test_point_spreads_tell_where_a_pixel_lies(self):
        pixel = json.loads((RUN_FOLDER / "report.json").read_text())["psfs"][0]["pixel_arcmin"]
        self.browser.pointer(SPREADS + " canvas", (83, -121))  # to the right and up
        x, y = self.pixel(SPREADS)
        self.assertTrue(x > 12 and y < 12, (x, y))
        caption = self.browser.text(SPREADS + " .readout caption")
        self.assertIn(f"at (+{(x - 11.5) * pixel:.2f}, +{(11.5 - y) * pixel:.2f}) arcmin", caption)

    def table(self, name="sequential"):
        """The 256 colours of densities, or of signed maps."""
        address = self.browser.run("return JSON.parse(document.getElementById('viewer-payload').textContent).colours[arguments[0]]", name)
        colours = base64.b64decode(address.split(",")[1])
        return [list(colours[3 * i:3 * i + 3]) for i in range(256)]

    def assert_spread_shown(self, key, position):
        """The canvas has the colours of a layer at `position`(value over the common peak)."""
        spreads, table = self.spreads(), self.table()
        peak = max(max(max(row) for row in rows) for rows in spreads.values())
        pixels = [(x, y) for y in range(0, 24, 2) for x in range(1, 24, 3)]
        lit = 0
        for (x, y), colour in zip(pixels, self.colours(pixels, SPREADS, (24, 24))):
            entry = 255 * min(1.0, max(0.0, position(spreads[key][y][x] / peak)))
            near = [table[i] for i in range(max(0, math.ceil(entry - 0.8)), min(255, math.floor(entry + 0.8)) + 1)]  # 2^-11 of 255 moves it
            self.assertIn(colour, near, (key, x, y))
            lit += spreads[key][y][x] > 0
        self.assertGreater(lit, 5)

    def test_point_spreads_are_linear_or_logarithmic(self):
        def logarithmic(share):
            return 1 + math.log10(share) / LOG_DECADES if share > 0 else 0

        for number, key in enumerate(("predicted", "power_matrix", "sin2_radial"), 1):
            self.press(str(number), SPREADS)
            self.assert_spread_shown(key, logarithmic)
        self.press("l", SPREADS)
        self.assertIn("linear", self.browser.text(SPREADS + " .legend"))
        for number, key in enumerate(("predicted", "power_matrix", "sin2_radial"), 1):
            self.press(str(number), SPREADS)
            self.assert_spread_shown(key, lambda share: share)
        self.press("ee", SPREADS)  # one stop brighter
        self.assert_spread_shown("sin2_radial", lambda share: 2 * share)
        self.choose(SPREADS, "tone", "log")
        self.assert_spread_shown("sin2_radial", lambda share: logarithmic(2 * share))

    def test_differences_of_point_spreads_are_red_where_there_is_more(self):
        spreads, table = self.spreads(), self.table("diverging")
        self.press("5", SPREADS)
        ends = []
        for stops in range(2):
            end = float(self.browser.text(SPREADS + " .legend").rsplit("+", 1)[1])
            ends.append(end)
            pixels = [(x, y) for y in range(24) for x in range(24)]
            for (x, y), colour in zip(pixels, self.colours(pixels, SPREADS, (24, 24))):
                share = (spreads["sin2_radial"][y][x] - spreads["predicted"][y][x]) / end
                entry = min(255.0, max(0.0, 127.5 + 127.5 * share))
                near = [table[i] for i in range(max(0, math.ceil(entry - 0.7)), min(255, math.floor(entry + 0.7)) + 1)]
                self.assertIn(colour, near, (x, y, share))
            self.press("ee", SPREADS)
        self.assertAlmostEqual(ends[1], 0.5 * ends[0])

    def test_point_spreads_and_images_have_views_of_their_own(self):
        images = self.picture()
        self.press("+++", SPREADS)
        self.press("e", SPREADS)
        self.assertEqual(self.picture(), images)
        self.press("ll")
        self.assertIn("logarithmic", self.browser.text(VIEWER + " .legend"))


class InChromium(ReportPage, unittest.TestCase):
    @classmethod
    def start(cls):
        return Browser(FOLDER / "chromium")


@unittest.skipUnless(firefox(), "Firefox is not installed (Debian's package firefox-esr)")
class InFirefox(ReportPage, unittest.TestCase):
    @classmethod
    def start(cls):
        return Firefox(FOLDER / "firefox")


if __name__ == "__main__":
    unittest.main()
