"""Predictions `layered` and `multipass`: any gaze, through spectacles, the same bytes whatever the threads, close to path tracing; and the
experiment's section `agreement`."""
import unittest

import documents
from documents import changed, without
from exr_header import channel_names, read_header
from sturm_process import CORNELL_BOX, PASSED, SOURCE, WRONG_INPUT, FolderTest, strict_json, sturm

TORIC = str(SOURCE / "configs/lenses/oblique_toric_p195.json")


def prediction(kind, **method):
    view = changed(without(documents.view(), "/method/ray_model"), "/method/type", "predict")
    view["method"].update({"prediction": kind, **method})
    return view


class Predictions(FolderTest):
    def render(self, document, name, *options):
        path = self.write("view.json", document)
        self.succeed("render", path, "-o", self.folder / f"{name}.exr", "--quiet", *options)
        return (self.folder / f"{name}.exr").read_bytes()

    def ssim(self, first, second):
        output = self.succeed("compare", self.folder / f"{first}.exr", self.folder / f"{second}.exr", "--json", "-").stdout
        return strict_json(output)["metrics"]["ssim_display"]

    def test_threads_do_not_change_a_byte(self):
        seen = set()
        for kind in ("layered", "multipass"):
            for gaze, lens in (("camera", None), ("foveal", TORIC)):
                view = changed(prediction(kind), "/camera/gaze", gaze)
                if lens:
                    view["spectacles"] = lens
                with self.subTest(kind=kind, gaze=gaze):
                    first = self.render(view, "first", "--threads", 1)
                    self.assertEqual(self.render(view, "second", "--threads", 2), first)
                    seen.add(first)
        self.assertEqual(len(seen), 4)

    def test_both_are_close_to_path_tracing(self):
        # Astigmatic eye, naked and behind a lens, both gazes, against 512 paths per pixel. Of 48 x 48 pixels the noise of either is what
        # is left: the same comparison of two seeds of path tracing has 0.985; a mirrored axis drops below 0.95.
        for gaze, lens in (("camera", None), ("foveal", None), ("camera", TORIC), ("foveal", TORIC)):
            def with_gaze(view):
                view = changed(view, "/camera/gaze", gaze)
                return {**view, "spectacles": lens} if lens else view
            self.render(with_gaze(changed(documents.view(), "/method/samples_per_pixel", 512)), "traced")
            for kind in ("layered", "multipass"):
                with self.subTest(kind=kind, gaze=gaze, lens=bool(lens)):
                    self.render(with_gaze(prediction(kind, samples_per_pixel=64)), "predicted")
                    self.assertGreater(self.ssim("predicted", "traced"), 0.96)

    def test_what_lies_beside(self):
        self.assertIn("unseen.Y", channel_names(read_header(self.render(prediction("multipass", passes=16), "a"))[0]))
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        # 16 times 16 more where the rim of the ceiling's lamp is within reach, and 256 times where the lamp would still come in steps.
        self.assertEqual(counters["pupil_rays"], (48 * 48 + 16 * counters["lamp_pixels"] + 256 * counters["bright_lamp_pixels"]) * 16)
        self.assertGreater(counters["lamp_pixels"], 0)
        self.assertLess(counters["lamp_pixels"], 0.1 * 48 * 48)
        self.assertGreater(counters["unseen_places"], 0)
        self.assertEqual(counters["lost_pixels"], 0)
        self.assertIn("coverage.Y", channel_names(read_header(self.render(prediction("layered"), "b"))[0]))

    def test_a_stereo_pair_is_predicted(self):
        view = changed(prediction("layered", samples_per_pixel=4), "/camera/stereo", {"interpupillary_distance_mm": 64})
        self.render(view, "a")
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        self.assertGreater(counters["left"]["fragments"], 0)
        self.assertGreater(counters["right"]["fragments"], 0)

    def refused(self, document, pointer):
        process = sturm("render", self.write("bad.json", document), "-o", self.folder / "bad.exr", "--quiet")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertIn(pointer, process.stderr)
        self.assertFalse((self.folder / "bad.exr").exists())

    def test_what_a_prediction_does_not_know_is_refused(self):
        self.refused({**prediction("ellipses"), "spectacles": TORIC}, "/spectacles")
        self.refused(changed(prediction("ellipses"), "/camera/gaze", "foveal"), "/camera/gaze")
        self.refused(prediction("layered", passes=8), "/method/passes")
        self.refused(prediction("ellipses", smooth=False), "/method/smooth")
        self.refused(prediction("guess"), "/method/prediction")
        self.refused(changed(prediction("layered"), "/eye/stiles_crawford_per_mm2", 0.05), "/eye/stiles_crawford_per_mm2")
        for key, value in (("prediction", "layered"), ("passes", 4), ("smooth", True)):
            self.refused(changed(documents.view(), f"/method/{key}", value), f"/method/{key}")
        sphere = changed(without(prediction("multipass"), "/camera/vfov_deg"), "/camera/projection", "equirectangular")
        self.refused(sphere, "/camera/projection")


# Coma and trefoil beside a defocus that leaves the far wall of the box 1 D in front of the focus.
COMATIC = {"wavefront": {"coefficients_um": {"4": 0.9, "6": 0.2, "7": -0.3, "8": 0.25, "9": -0.1, "12": 0.1}, "pupil_diameter_mm": 6, "eye": "right"},
           "pupil_diameter_mm": 6, "accommodation": {"mode": "fixed", "power_D": 0.5}}
# What coma and trefoil become in the other eye (ISO 24157: sines of even and cosines of odd frequencies change their sign).
MIRRORED = {**COMATIC, "wavefront": {**COMATIC["wavefront"], "coefficients_um": {"4": 0.9, "6": 0.2, "7": -0.3, "8": -0.25, "9": 0.1, "12": 0.1}}}


class DepthPsf(Predictions):
    def wavefront_view(self, eye, **method):
        return {**prediction("depth_psf", **method), "eye": eye}

    def test_threads_do_not_change_a_byte(self):
        seen = set()
        for method in ({}, {"psf": "waves"}, {"pupil_parts": 1}, {"oversampling": 2}):
            with self.subTest(method):
                view = self.wavefront_view(COMATIC, samples_per_pixel=4, **method)
                first = self.render(view, "first", "--threads", 1)
                self.assertEqual(self.render(view, "second", "--threads", 2), first)
                seen.add(first)
        self.assertEqual(len(seen), 4)

    def test_both_are_close_to_path_tracing(self):
        # Three bars of light in the dark at 1 m, in a picture of 3 degrees, against 1024 paths per pixel by the whole wavefront. Nothing has noise
        # but the points of the pupil. An ellipse knows nothing of coma, and a mirrored eye has it on the wrong side.
        bars = [[(x, y), (x + width, y + height)] for x, y, width, height in
                ((-0.015, -0.015, 0.004, 0.03), (-0.005, -0.015, 0.015, 0.004), (0.004, 0.0, 0.004, 0.012))]
        meshes = [{"material": "lamp", "positions_m": [[x0, y0, -1], [x1, y0, -1], [x1, y1, -1], [x0, y1, -1]], "faces": [[0, 1, 2, 3]]}
                  for (x0, y0), (x1, y1) in bars]
        scene = {"materials": {"lamp": {"emission": [1, 1, 1]}}, "meshes": meshes}
        camera = {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 3, "resolution": [48, 48]}
        ssim = {}
        for name, view in {"traced": {**changed(changed(documents.view(), "/method/samples_per_pixel", 1024), "/method/ray_model", "zernike"), "eye": COMATIC},
                           "rays": self.wavefront_view(COMATIC, oversampling=2), "mirrored": self.wavefront_view(MIRRORED, oversampling=2),
                           "ellipses": {**prediction("layered", oversampling=2), "eye": COMATIC}}.items():
            self.render({**view, "scene": scene, "camera": camera}, name)
            ssim[name] = self.ssim(name, "traced")
        self.assertGreater(ssim["rays"], 0.99)
        self.assertLess(ssim["mirrored"], 0.9)
        self.assertLess(ssim["ellipses"], 0.9)

    def test_what_lies_beside(self):
        self.render(self.wavefront_view(COMATIC, samples_per_pixel=4), "a")
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        self.assertEqual(counters["pupil_parts"], 4)
        self.assertGreater(counters["hidden_pixels_given"], 0)
        self.assertGreater(counters["margin_px"], 0)
        self.assertEqual(counters["pupil_rays"], 48 * 48 * 16)
        kinds = [counters["layers_" + kind] for kind in ("empty", "covered", "unblurred", "spatial", "transform")]
        self.assertEqual(sum(kinds), counters["tiles"] * counters["planes"])
        method = strict_json((self.folder / "a.manifest.json").read_text())["spec"]["method"]
        self.assertEqual((method["psf"], method["pupil_parts"], "passes" in method), ("rays", 4, False))

    def test_it_explains_what_is_done_with_each_layer(self):
        output = self.succeed("render", "--explain", self.write("view.json", self.wavefront_view(COMATIC))).stdout
        self.assertIn("unseen_emitters", output)
        self.assertIn("4 part(s) of the pupil", output)
        self.assertIn("(0, 0)", output)

    def test_a_stereo_pair_is_predicted(self):
        view = changed(self.wavefront_view(COMATIC, samples_per_pixel=4), "/camera/stereo", {"interpupillary_distance_mm": 64})
        self.render(view, "a")
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        self.assertGreater(counters["left"]["planes"], 0)
        self.assertIn("right eye: ", self.succeed("render", "--explain", self.write("view.json", view)).stdout)

    def test_what_a_prediction_does_not_know_is_refused(self):
        view = self.wavefront_view(COMATIC)
        self.refused({**view, "spectacles": TORIC}, "/spectacles")
        self.refused(changed(view, "/camera/gaze", "foveal"), "/camera/gaze")
        self.refused(self.wavefront_view(COMATIC, passes=8), "/method/passes")
        self.refused(self.wavefront_view(COMATIC, psf="wave"), "/method/psf")
        self.refused(self.wavefront_view(COMATIC, psf="waves", pupil_parts=4), "/method/pupil_parts")
        self.refused(prediction("layered", psf="rays"), "/method/psf")
        self.refused(changed(documents.view(), "/method/psf", "rays"), "/method/psf")
        self.refused(changed(self.wavefront_view(COMATIC, psf="waves"), "/eye/pupil_diameter_mm", 0), "/eye/pupil_diameter_mm")
        both = {**changed(view, "/camera/stereo", {"interpupillary_distance_mm": 64}), "left": {"spectacles": TORIC}}
        self.refused(both, "/left/spectacles")


class Agreement(FolderTest):
    def experiment(self):
        view = documents.view()
        case = {"id": "box", "scene": str(CORNELL_BOX), "camera": {**view["camera"], "resolution": [32, 32]}, "eye": view["eye"],
                "predictions": ["ellipses", "layered", "multipass"], "samples_per_pixel": 16, "sharp_samples_per_pixel": 4, "passes": 8}
        worn = {**case, "id": "worn", "camera": {**case["camera"], "gaze": "foveal"}, "spectacles": TORIC, "predictions": ["multipass"]}
        gate = {"id": "similar", "title": "Similar", "statistic": "agreement_ssim_display_min/multipass", "comparison": "at_least",
                "bound": 0.5, "reason": "a picture of something else is below it"}
        self.write("gates.json", {"format": "sturm.gates/1", "gates": [gate]})
        return {"format": "sturm.experiment/1", "title": "Pictures", "agreement": [case, worn], "gates": "gates.json"}

    def test_a_run(self):
        path = self.write("experiment.json", self.experiment())
        process = sturm("run", path, "--out", self.folder / "out", "--quiet")
        self.assertEqual(process.returncode, PASSED, process.stdout + process.stderr)
        report = strict_json((self.folder / "out/report.json").read_text())
        self.succeed("validate", self.folder / "out/report.json")
        self.assertEqual([[p["kind"] for p in entry["predictions"]] for entry in report["agreement"]],
                         [["ellipses", "layered", "multipass"], ["multipass"]])
        for entry in report["agreement"]:
            for prediction_ in entry["predictions"]:
                whole = prediction_["parts"][0]
                self.assertEqual((whole["name"], whole["pixels"]), ("whole", 1024))
                self.assertGreater(whole["ssim_display"]["value"], 0.5)
                self.assertTrue((self.folder / "out" / prediction_["files"]["predicted"]).exists())
        self.assertIn("Predicted pictures", (self.folder / "out/report.html").read_text())

    def test_point_spreads_are_predictions_like_others(self):
        experiment = self.experiment()
        experiment["agreement"][0].update({"ray_model": "zernike", "eye": COMATIC, "predictions": ["depth_psf", {"prediction": "depth_psf", "psf": "waves"}, "layered"]})
        experiment["mutations"] = ["half_pixel", "mirrored_eye", "vertex_distance"]
        self.write("gates.json", {"format": "sturm.gates/1", "gates": [
            {"id": "similar", "title": "Similar", "statistic": "agreement_ssim_display/box/depth_psf_waves", "comparison": "at_least", "bound": 0.5,
             "reason": "a picture of something else is below it"},
            {"id": "noticed", "title": "Noticed", "statistic": "mutation_min_gates", "comparison": "at_least", "bound": 0, "reason": "a count"}]})
        process = sturm("run", self.write("experiment.json", experiment), "--out", self.folder / "out", "--quiet")
        self.assertEqual(process.returncode, PASSED, process.stdout + process.stderr)
        report = strict_json((self.folder / "out/report.json").read_text())
        self.succeed("validate", self.folder / "out/report.json")
        box = report["agreement"][0]
        self.assertEqual(box["ray_model"], "zernike")
        self.assertNotIn("mutated", box)
        self.assertEqual([mutation["id"] for mutation in report["gate_power"]["mutations"]], experiment["mutations"])
        self.assertEqual([(p["kind"], p.get("psf")) for p in box["predictions"]], [("depth_psf", "rays"), ("depth_psf", "waves"), ("layered", None)])
        self.assertEqual(len({p["files"]["predicted"] for p in box["predictions"]}), 3)
        self.assertIn("depth_psf_waves", (self.folder / "out/report.html").read_text())

    def test_a_prediction_is_listed_once_and_knows_the_view(self):
        for predictions, pointer in ((["depth_psf", {"prediction": "depth_psf", "psf": "rays"}], "/agreement/0/predictions/1"),
                                     (["layred"], "/agreement/0/predictions/0"),
                                     ([{"prediction": "layered", "psf": "rays"}], "/agreement/0/predictions/0/psf")):
            experiment = self.experiment()
            experiment["agreement"][0]["predictions"] = predictions
            process = sturm("run", self.write("experiment.json", experiment), "--out", self.folder / "out", "--quiet")
            self.assertEqual(process.returncode, WRONG_INPUT)
            self.assertIn(pointer, process.stderr)
        experiment = self.experiment()
        experiment["agreement"][1]["predictions"] = ["depth_psf"]
        process = sturm("run", self.write("experiment.json", experiment), "--out", self.folder / "out", "--quiet")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/agreement/1/predictions/0", process.stderr)

    def test_ellipses_through_spectacles_are_refused(self):
        experiment = self.experiment()
        experiment["agreement"][1]["predictions"] = ["ellipses"]
        process = sturm("run", self.write("experiment.json", experiment), "--out", self.folder / "out", "--quiet")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/agreement/1/predictions/0", process.stderr)


if __name__ == "__main__":
    unittest.main()
