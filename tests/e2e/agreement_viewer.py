"""The viewer of predicted pictures (section "agreement" of a report): every number by the EXR files' own bytes."""
from exr_header import float_pixels
from srgb import srgb_byte

AGREEMENT = "#agreement .viewer"
HALF = 2.0**-11  # relative error of rounding to binary16
PREDICTIONS = ("ellipses", "layered")
PICTURES = ("path_traced", *PREDICTIONS)  # keys 1, 2, 3
SIZE = 32


def agreement_case(view, scene):
    """A small view with both predictions; `view`: a document of sturm.render/1."""
    return {"id": "room", "scene": str(scene), "camera": {**view["camera"], "resolution": [SIZE, SIZE]}, "eye": view["eye"],
            "predictions": list(PREDICTIONS), "samples_per_pixel": 16, "sharp_samples_per_pixel": 16, "replicates": 2}


class AgreementViewer:
    """Tests for a page with one agreement_case(), to be mixed into those of the page."""

    def agreement_pictures(self):
        return {name: float_pixels((self.run_folder / f"images/room_{name}.exr").read_bytes()) for name in PICTURES}

    def errors_of(self):
        """Whose error maps are among the layers."""
        return self.browser.run(f"return document.querySelector('{AGREEMENT} select.compared').value")

    def test_agreement_flickers_between_all_pictures(self):
        pictures = self.agreement_pictures()
        pixels = [(x, y) for y in range(1, SIZE, 3) for x in range(1, SIZE, 3)]
        for first, second in (PICTURES[:2], PICTURES[1:], PICTURES[::2]):  # the files do differ where they are looked at
            self.assertTrue(any(abs(srgb_byte(pictures[first]["G"][y][x]) - srgb_byte(pictures[second]["G"][y][x])) > 8 for x, y in pixels), (first, second))
        for key, name in list(enumerate(PICTURES, 1)) * 2:
            self.press(str(key), AGREEMENT)
            for (x, y), shown in zip(pixels, self.colours(pixels, AGREEMENT)):
                for byte, channel in zip(shown, "RGB"):
                    # Rounding to a byte, and 2^-11 of a value under the transfer function's root: 0.06.
                    self.assertAlmostEqual(byte, srgb_byte(pictures[name][channel][y][x]), delta=0.57, msg=f"{name} ({x}, {y})")

    def test_agreement_values_are_those_of_the_files(self):
        self.browser.pointer(AGREEMENT + " canvas", (-41, 57))
        x, y = self.pixel(AGREEMENT)
        for name, rows in self.agreement_pictures().items():
            shown = self.values(name, AGREEMENT)
            self.assertGreater(max(shown), 0.0)
            for channel, value in zip("RGB", shown):
                self.assertAlmostEqual(value, rows[channel][y][x], delta=HALF * abs(rows[channel][y][x]) + 3e-8, msg=name)

    def test_agreement_maps_are_of_the_prediction_that_is_chosen(self):
        self.browser.pointer(AGREEMENT + " canvas", (-39, 61))
        x, y = self.pixel(AGREEMENT)
        pictures = self.agreement_pictures()

        def luma(name):
            return sum(weight * srgb_byte(pictures[name][c][y][x]) / 255.0 for weight, c in zip((0.2126, 0.7152, 0.0722), "RGB"))

        shown = {}
        for name in (*PREDICTIONS, PREDICTIONS[0]):  # m goes round
            self.assertEqual(self.errors_of(), name)
            difference, = self.values("difference", AGREEMENT)
            signed = luma(name) - luma("path_traced")
            self.assertAlmostEqual(difference, signed, delta=HALF * abs(signed) + 1e-6)  # 1e-6: numbers near 1 as floats
            square, = self.values("rmse_linear", AGREEMENT)
            exact = sum((pictures[name][c][y][x] - pictures["path_traced"][c][y][x]) ** 2 for c in "RGB") / 3.0
            self.assertAlmostEqual(square, exact, delta=2 * HALF * exact + 3e-8)
            shown[name] = (difference, square)
            self.press("m", AGREEMENT)
        self.assertNotEqual(shown[PREDICTIONS[0]], shown[PREDICTIONS[1]])

    def test_agreement_maps_follow_the_prediction_that_is_looked_at(self):
        for key, of in (("3", "layered"), ("1", "layered"), ("2", "ellipses")):
            self.press(key, AGREEMENT)
            self.assertEqual(self.errors_of(), of)
        self.press("5", AGREEMENT)  # a map, by its place among the layers
        self.assertTrue(self.browser.text(AGREEMENT + " .legend").startswith("ellipses: SSIM"))
        self.choose(AGREEMENT, "compared", "layered")
        self.assertTrue(self.browser.text(AGREEMENT + " .legend").startswith("layered: SSIM"))

    def test_agreement_side_by_side_has_its_prediction(self):
        self.choose(AGREEMENT, "layout", "side")
        panels = f"return Number(document.querySelector('{AGREEMENT} canvas').style.aspectRatio.split('/')[0])"
        self.press("3", AGREEMENT)
        self.assertEqual(self.browser.run(panels), 2)
        self.press("5", AGREEMENT)
        self.assertEqual(self.browser.run(panels), 3)
