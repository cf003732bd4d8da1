"""`sturm compare` on the stored reference images."""
import json
import math
import unittest

from sturm_process import FAILED, SOURCE, WRONG_INPUT, FolderTest, strict_json, sturm

IMAGES = SOURCE / "tests/reference/images"
# Our name of a metric, and the reference's in tests/reference/images/values.json.
CONVENTIONS = {
    "ssim_display": "ssim_luma_srgb",
    "psnr_display_dB": "psnr_rgb_srgb",
    "ssim_linear": "ssim_luma_linear",
    "psnr_linear_dB": "psnr_rgb_linear",
    "rmse_linear": "rmse_rgb_linear",
    "relative_mse": "relmse_rgb_linear_eps0.01",
    "flip": "flip_mean_ppd67.02",
}
SIMILARITIES = {"ssim_display", "ssim_linear"}
NONE_FOR_EQUAL_PICTURES = {"psnr_display_dB", "psnr_linear_dB"}
NONE_FOR_SMALL_PICTURES = {"ms_ssim_display", "ms_ssim_linear"}  # 160 x 128: five scales need 176


def image(name):
    return IMAGES / f"{name}.exr"


class Compare(FolderTest):
    def metrics(self, test, reference, *options):
        return strict_json(self.succeed("compare", image(test), image(reference), "--json", "-", *options).stdout)

    def test_reference_values(self):
        for name, values in json.loads((IMAGES / "values.json").read_text())["values"].items():
            measured = self.metrics(name, "reference")["metrics"]
            for ours, theirs in CONVENTIONS.items():
                # 1e-4: the images are stored in single precision, and the reference rounds its window differently at that level.
                self.assertAlmostEqual(measured[ours], values[theirs], delta=1e-4 * max(1.0, values[theirs]), msg=f"{name} {ours}")

    def test_an_image_equals_itself(self):
        result = self.metrics("blur", "blur")
        self.assertEqual(len(result["metrics"]), 17)
        for key, value in result["metrics"].items():
            expected = None if key in NONE_FOR_EQUAL_PICTURES | NONE_FOR_SMALL_PICTURES else 1.0 if key in SIMILARITIES else 0.0
            self.assertEqual(value, expected, key)
        self.assertEqual(result["bounds"], {})
        self.assertTrue(result["passed"])
        self.succeed("compare", image("blur"), image("blur"), "--min-ssim", 1, "--max-rmse", 0, "--max-relative-mse", 0, "--min-psnr", 1000)

    def test_symmetry(self):
        there, back = (self.metrics(*pair)["metrics"] for pair in (("noise", "reference"), ("reference", "noise")))
        self.assertEqual(there["rmse_linear"], back["rmse_linear"])
        self.assertAlmostEqual(there["ssim_display"], back["ssim_display"], delta=1e-12)
        self.assertNotEqual(there["relative_mse"], back["relative_mse"])  # relative to the second image

    def test_each_bound_is_a_gate(self):
        values = self.metrics("noise", "reference")["metrics"]
        for option, metric, towards in [("--min-ssim", "ssim_display", 1), ("--min-psnr", "psnr_display_dB", 1),
                                        ("--max-rmse", "rmse_linear", -1), ("--max-relative-mse", "relative_mse", -1)]:
            with self.subTest(option):
                met, missed = values[metric] * (1 - 1e-6 * towards), values[metric] * (1 + 1e-6 * towards)
                self.assertIn("passed", self.succeed("compare", image("noise"), image("reference"), option, repr(met)).stdout)
                process = sturm("compare", image("noise"), image("reference"), option, repr(missed))
                self.assertEqual(process.returncode, FAILED, process.stderr)
                self.assertIn("FAILED", process.stdout)
                process = sturm("compare", image("noise"), image("reference"), option, repr(missed), "--json", "-")
                self.assertEqual(process.returncode, FAILED)
                result = strict_json(process.stdout)
                self.assertFalse(result["passed"])
                self.assertEqual(result["bounds"], {metric: missed})

    def test_json_file_beside_the_table(self):
        path = self.folder / "metrics.json"
        process = self.succeed("compare", image("noise"), image("reference"), "--json", path)
        self.assertIn("SSIM", process.stdout)
        self.assertEqual(strict_json(path.read_text()), self.metrics("noise", "reference"))

    def test_sample_plan(self):
        self.assertEqual(self.succeed("plan-samples").stdout, "4000000\n")  # (2 - 1)/4 * (4/0.001)^2
        self.assertEqual(self.succeed("plan-samples", "--difference", 0.01, "--sigma", 3, "--both-measured", "--kurtosis", 3).stdout, "90000\n")
        self.assertEqual(self.succeed("plan-samples", "--coefficient-of-variation", 2, "--difference", 0.01, "--sigma", 3).stdout, "360000\n")
        self.assertEqual(sturm("plan-samples", "--difference", 0).returncode, WRONG_INPUT)
        self.assertEqual(sturm("plan-samples", "--power", 1).returncode, WRONG_INPUT)

    def test_exposure_changes_the_display_space_only(self):
        plain, bright = self.metrics("noise", "reference")["metrics"], self.metrics("noise", "reference", "--exposure", 2)["metrics"]
        self.assertEqual(plain["rmse_linear"], bright["rmse_linear"])
        self.assertGreater(math.fabs(plain["psnr_display_dB"] - bright["psnr_display_dB"]), 0.1)


if __name__ == "__main__":
    unittest.main()
