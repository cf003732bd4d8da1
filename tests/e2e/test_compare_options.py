"""Options of `sturm compare` on the stored reference images: bounds, exposures, error maps, the document, and what is refused."""
import json
import unittest

from sturm_process import FAILED, SOURCE, WRONG_INPUT, FolderTest, strict_json, sturm

IMAGES = SOURCE / "tests/reference/images"


def image(name):
    return IMAGES / f"{name}.exr"


class CompareOptions(FolderTest):
    def metrics(self, test, reference, *options):
        return strict_json(self.succeed("compare", image(test), image(reference), "--json", "-", *options).stdout)

    def test_bounds_by_name(self):
        value = self.metrics("noise", "reference")["metrics"]["hdr_flip"]
        self.succeed("compare", image("noise"), image("reference"), "--bound", f"hdr_flip={value!r}", "--bound", "ssim_display=0.5")
        process = sturm("compare", image("noise"), image("reference"), "--bound", f"hdr_flip={value * 0.999!r}")
        self.assertEqual(process.returncode, FAILED)
        self.assertIn("FAILED", process.stdout)
        # A metric without a value keeps no bound, but the PSNR of equal pictures is infinite.
        self.assertEqual(sturm("compare", image("noise"), image("reference"), "--bound", "ms_ssim_display=0").returncode, FAILED)
        self.succeed("compare", image("blur"), image("blur"), "--bound", "psnr_linear_dB=1000")

    def test_wrong_options(self):
        for options, part in [(["--bound", "flap=1"], "flap"), (["--bound", "flip"], "METRIC=VALUE"), (["--bound", "flip=x"], "METRIC=VALUE"),
                              (["--bound", "flip=nan"], "METRIC=VALUE"), (["--hdr-exposures", "3", "1", "2"], "START"),
                              (["--hdr-exposures", "0", "1", "1.5"], "COUNT"), (["--edge", "0", "0", "500", "20"], "16"),
                              (["--edge", "0", "0", "20", "8"], "16"), (["--psf"], "--pixel-arcmin"), (["--noise", "missing.exr"], "missing.exr"),
                              (["--pixels-per-degree", "0"], "pixels-per-degree")]:
            with self.subTest(options):
                process = sturm("compare", image("noise"), image("reference"), *options, "--json", self.folder / "no.json", "--maps", self.folder / "no")
                self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
                self.assertIn(part, process.stderr)
                self.assertEqual(list(self.folder.iterdir()), [])

    def test_the_document_follows_its_schema(self):
        path = self.write("comparison.json", self.succeed("compare", image("noise"), image("reference"), "--json", "-", "--regions", "--noise", image("blur"),
                                                          "--psf", "--pixel-arcmin", 1).stdout)
        self.succeed("validate", path)
        document = strict_json(path.read_text())
        self.assertEqual(list(document["regions"]), ["highlights"])  # no layers tell the others
        self.assertIn("depth", document["regions_note"])
        self.assertEqual(len(document["psf"]["test"]["mtf"]), 4)
        self.assertIsNone(document["psf"]["test"]["mtf"][0][9])  # 30 cycles/degree are half a cycle per pixel of 1'
        self.assertIsNotNone(document["psf"]["test"]["mtf"][0][8])

    def test_maps(self):
        folder = self.folder / "maps"
        self.succeed("compare", image("noise"), image("reference"), "--maps", folder)
        scales = json.loads((folder / "scales.json").read_text())
        self.assertEqual({path.stem for path in folder.glob("*.png")}, set(scales))
        self.assertEqual(scales["flip"]["peak"], 1.0)
        self.assertIn("ssim_display", scales)

    def test_hdr_exposures(self):
        one = self.metrics("noise", "reference", "--hdr-exposures", 0, 0, 1)
        more = self.metrics("noise", "reference", "--hdr-exposures", -4, 4, 9)
        self.assertEqual(more["conditions"]["hdr_exposures"], {"start_stops": -4.0, "stop_stops": 4.0, "count": 9})
        self.assertGreater(more["metrics"]["hdr_flip"], one["metrics"]["hdr_flip"])


if __name__ == "__main__":
    unittest.main()
