"""Rendered, predicted and seen pictures have the command line's bits, and their arrays the renderer's own memory."""
import unittest

import numpy as np

import documents
import sturm
from sturm_process import SOURCE, FolderTest, strict_json
from sturm_process import sturm as program

IMAGES = SOURCE / "tests/reference/images"


def view(**method):
    document = documents.changed(documents.view(), "/camera/resolution", [40, 30])
    for key, value in method.items():
        document = documents.changed(document, f"/method/{key}", value)
    return document


class Pictures(FolderTest):
    def from_command_line(self, document):
        self.succeed("render", self.write("view.json", document), "-o", self.folder / "a.exr", "--quiet")
        return sturm.read_picture(self.folder / "a.exr")

    def test_a_path_traced_picture(self):
        document = view()
        picture = sturm.render(document)
        np.testing.assert_array_equal(picture.radiance, self.from_command_line(document))
        self.assertEqual((picture.radiance.shape, picture.radiance.dtype), ((30, 40, 3), np.float32))
        self.assertEqual(picture.layers["depth"].shape, (30, 40))
        self.assertEqual(picture.counters["camera_rays"], 30 * 40 * 16)
        self.assertGreater(picture.radiance.mean(), 0.01)
        self.assertEqual(picture.document["method"]["filter"], "box")  # a default

    def test_a_prediction_has_the_samples_of_its_own_kind(self):
        """Those of a path-traced view are not a sharp view's, which has 16; those of a view that is a prediction are."""
        for kind, samples in (("path_trace", 16), ("predict", 4)):
            document = documents.changed(view(samples_per_pixel=4), "/method/type", kind)
            for key in ("ray_model", "sampler") if kind == "predict" else ():
                document["method"].pop(key, None)
            self.assertEqual(sturm.predict(document).document["method"]["samples_per_pixel"], samples, kind)

    def test_a_prediction(self):
        document = view()
        predicted = sturm.predict(document)
        self.assertEqual(predicted.document["method"]["type"], "predict")
        self.assertEqual(predicted.document["method"]["max_bounces"], document["method"]["max_bounces"])
        np.testing.assert_array_equal(predicted.radiance, self.from_command_line(predicted.document))
        # It predicts the path traced picture, whose noise of 16 samples is larger than any difference.
        np.testing.assert_allclose(predicted.radiance.mean(), sturm.render(document).radiance.mean(), rtol=0.05)

    def test_a_seen_picture(self):
        sharp = sturm.render(documents.changed(view(samples_per_pixel=4), "/eye/pupil_diameter_mm", 0))
        eye = {"prescription": {"sphere_D": -3, "cylinder_D": -1, "axis_deg": 30}, "pupil_diameter_mm": 5}
        self.write("eye.json", eye)
        self.succeed("render", self.write("view.json", sharp.document), "-o", self.folder / "sharp.exr", "--quiet")
        self.succeed("see", self.folder / "sharp.exr", "--eye", self.folder / "eye.json", "-o", self.folder / "seen.exr")
        told = []
        seen = sturm.see(sharp.radiance, sharp.layers["depth"], sturm.Eye(eye), vfov_deg=sharp.document["camera"]["vfov_deg"], progress=told.append)
        np.testing.assert_array_equal(seen, sturm.read_picture(self.folder / "seen.exr"))
        self.assertEqual(told[-1], 1.0)
        self.assertGreater(np.abs(seen - sharp.radiance).max(), 0.1)

    def test_what_a_picture_hides(self):
        """A black wall with a black card before it: only a layer can bring light, from behind the card's blurred edge."""
        black, depth_m = np.zeros((24, 36, 3), np.float32), np.full((24, 36), 3.0)
        depth_m[:, :18] = 0.25
        eye = sturm.Eye(prescription="0", pupil_diameter_mm=6)
        red = np.broadcast_to(np.float32([1, 0, 0]), black.shape)
        for psf in ("rays", "waves"):
            alone = sturm.see(black, depth_m, eye, vfov_deg=4, psf=psf)
            layered = sturm.see(black, depth_m, eye, vfov_deg=4, psf=psf, layers=[(red, np.full((24, 36), 3.0))])
            self.assertEqual(np.abs(alone).max(), 0)
            self.assertGreater(layered[:, :18, 0].max(), 0.05)
            self.assertLess(np.abs(layered[..., 1:]).max(), 1e-6)

    def test_pictures_come_without_a_copy(self):
        picture = sturm.render(view(samples_per_pixel=1))
        for name, layer in {**picture.layers, "read": sturm.read_picture(IMAGES / "blur.exr")}.items():
            with self.subTest(name):
                self.assertFalse(layer.flags.owndata)
                self.assertEqual(type(layer.base).__name__, "PyCapsule")  # holds the picture as C++ made it
                self.assertTrue(layer.flags.c_contiguous and layer.flags.aligned)
        self.assertIs(picture.radiance, picture.layers[""])

    def test_files_round_trip(self):
        picture = np.linspace(0, 1.5, 6 * 5 * 3, dtype=np.float32).reshape(6, 5, 3)
        sturm.write_picture(self.folder / "a.exr", picture)
        np.testing.assert_array_equal(sturm.read_picture(self.folder / "a.exr"), picture)
        sturm.write_picture(self.folder / "a.png", picture, exposure=0.5)
        # 8 bits: half a step of 1/255 of the encoded value, which is at most 2.3 times as much of the light below 1.
        np.testing.assert_allclose(sturm.read_picture(self.folder / "a.png"), 0.5 * picture, atol=2.3 * 0.5 / 255)


class Metrics(FolderTest):
    def test_the_values_of_the_command_line(self):
        printed = strict_json(self.succeed("compare", IMAGES / "blur.exr", IMAGES / "reference.exr", "--json", "-").stdout)["metrics"]
        comparison = sturm.compare(sturm.read_picture(IMAGES / "blur.exr"), sturm.read_picture(IMAGES / "reference.exr"))
        self.assertEqual(comparison.values, printed)
        self.assertEqual(set(comparison.values), set(sturm.METRICS))
        flip = comparison.maps["flip"]
        self.assertEqual(flip.shape, (128, 160))
        self.assertAlmostEqual(float(flip.mean(dtype=np.float64)), comparison.values["flip"], delta=1e-6)  # rounded to single precision

    def test_options_of_a_comparison(self):
        printed = strict_json(self.succeed("compare", IMAGES / "blur.exr", IMAGES / "reference.exr", "--exposure", 0.5, "--pixels-per-degree", 30, "--json", "-").stdout)["metrics"]
        test, reference = sturm.read_picture(IMAGES / "blur.exr"), sturm.read_picture(IMAGES / "reference.exr")
        self.assertEqual(sturm.compare(test, reference, exposure=0.5, pixels_per_degree=30).values, printed)
        for only in ({"exposure": 0.5}, {"pixels_per_degree": 30}):
            self.assertNotEqual(sturm.compare(test, reference, **only).values["flip"], printed["flip"])

    def test_equal_pictures_have_no_psnr(self):
        picture = sturm.read_picture(IMAGES / "reference.exr")
        values = sturm.compare(picture, picture).values
        self.assertIsNone(values["psnr_display_dB"])
        self.assertEqual((values["rmse_linear"], values["ssim_display"]), (0, 1))


class Gates(FolderTest):
    def test_a_report_is_judged_as_by_the_command_line(self):
        report, gates = SOURCE / "tests/reference/reports/sin2_study.json", sturm.shipped("gates/sin2_study.json")
        judgement = sturm.judge(report, gates)
        process = program("gate", report, "--gates", gates)
        self.assertEqual(judgement.passed, process.returncode == 0)
        lines = [line.split() for line in process.stdout.splitlines()]
        self.assertEqual([[("pass" if gate["passed"] else "FAIL"), gate["id"]] for gate in judgement.gates], [line[:2] for line in lines[: len(judgement.gates)]])
        self.assertEqual(sturm.judge(sturm.load(report), sturm.load(gates)), judgement)


if __name__ == "__main__":
    unittest.main()
