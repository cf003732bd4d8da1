"""`sturm run` with a section depth_psf_study: rays against waves, measured eyes, spacing of planes; the sum of layers in `agreement`."""
import json
import math
import unittest

from study_test import StudyTest
from sturm_process import CORNELL_BOX, SOURCE

MAP = {"pupil_diameters_mm": [4], "defocus_D": [0, 1], "step_nm": 20}
# Trefoil alone: W = c √8 (r/a)³ sin 3θ, whose slope c·3√8 r²/a³ is the same all around and reaches all of it at the rim.
TABLE = "# made by hand\nsubject,c3,c6\n1,0.3,0.1\n2,-0.2,-0.2\n3,0.1,0.3\n4,nan,9\n"
STUDY = {"map": MAP, "eyes": [{"id": "trefoil", "title": "By hand", "file": "eyes.csv", "pupil_diameter_mm": 4}], "banding": {"spacings_px": [1, 4]}}
GATES = {"format": "sturm.gates/1", "gates": [
    {"id": "white", "title": "Rays do in white light", "statistic": "depth_psf_study/map/white/4", "comparison": "at_most", "bound": 0.075, "reason": "a prototype"},
    {"id": "step", "title": "No band shows", "statistic": "depth_psf_study/banding/linear/4/1/step", "comparison": "at_most", "bound": 1 / 255, "reason": "a level of 8 bits"}]}


class DepthPsfStudy(StudyTest):
    section = "depth_psf_study"
    document = {"format": "sturm.experiment/1", "title": "Spreads", "gates": "gates.json", "depth_psf_study": STUDY}
    gates = GATES
    files = {"eyes.csv": TABLE}

    def test_the_three_questions(self):
        self.run_study("out", "--quiet")
        self.succeed("validate", self.folder / "out/report.json")
        study = self.study("out")
        self.assertEqual([(c["light"], c["defocus_D"]) for c in study["map"]], [("one_wavelength", 0), ("one_wavelength", 1), ("white", 0), ("white", 1)])
        for cell in study["map"]:
            id_ = f"ideal_4mm_{cell['defocus_D']:g}D"
            expected = next(c for c in json.loads((SOURCE / "tests/reference/wavefronts/rays_vs_waves.json").read_text())["cases"] if c["id"] == id_)["outputs"]
            pair = "rays_wave555" if cell["light"] == "one_wavelength" else "rayspoly_wavepoly"
            self.assertAlmostEqual(cell["total_variation"], expected[f"tv_{pair}_cell1"], delta=0.005)
        # Half of the rays of 1 D through 2 mm land within 1 D · 2 mm / √2.
        self.assertAlmostEqual(study["map"][1]["rays_r50_arcmin"], 2e-3 / math.sqrt(2) * 60 * 180 / math.pi, delta=0.01)
        [eyes] = study["eyes"]
        self.assertEqual(eyes["eyes"], 3)
        for got, rms in zip(eyes["rms_um"], (0.1, 0.2, 0.3)):
            self.assertAlmostEqual(got, rms, delta=1e-12)
        for got, rms in zip(eyes["defocus_D"], (0.1, 0.2, 0.3)):
            self.assertAlmostEqual(got, 4 * math.sqrt(3) * rms / 4, delta=1e-12)
        for got, rms in zip(eyes["r80_arcmin"], (0.1, 0.2, 0.3)):
            r80 = 0.8 * 3 * math.sqrt(8) * rms * 1e-6 / 2e-3 * 60 * 180 / math.pi
            self.assertAlmostEqual(got / r80, 1, delta=2e-3)  # 65536 rays
        self.assertAlmostEqual(eyes["share_above_step"], 2 / 3, delta=1e-12)
        rows = {(row["spacing_px"], row["weights"], row["pupil_parts"]): row for row in study["banding"]}
        self.assertEqual(len(rows), 6)
        self.assertLess(rows[1, "linear", 4]["rmse"], rows[1, "nearest", 1]["rmse"])
        self.assertGreater(rows[4, "nearest", 1]["largest_step"], 1 / 255)
        self.assertGreater(rows[1, "linear", 4]["planes"], rows[4, "linear", 4]["planes"])
        page = (self.folder / "out/report.html").read_text()
        for shown in ("Rays against waves, white light", "By hand", "to the nearest plane"):
            self.assertIn(shown, page)
        self.expect_a_wrong_bound_to_fail(0.01)

    def test_what_is_wrong_is_named(self):
        self.expect_rejections([
            ("/depth_psf_study", {}, "/depth_psf_study"),
            ("/depth_psf_study/map/pupil_diameters_mm", [0], "/depth_psf_study/map/pupil_diameters_mm/0"),
            ("/depth_psf_study/map/step_nm", 0, "/depth_psf_study/map/step_nm"),
            ("/depth_psf_study/eyes/0/file", "none.csv", "/depth_psf_study/eyes/0/file"),
            ("/depth_psf_study/eyes/0/file", "gates.json", "c0, c1"),
            ("/depth_psf_study/banding/farthest_m", 0.2, "/depth_psf_study/banding/farthest_m"),
            ("/depth_psf_study/banding/spacings_px", [], "/depth_psf_study/banding/spacings_px"),
        ])


class LayerSum(StudyTest):
    """The sum of layers beside their composition, of a view that is small and noisy."""

    section = "agreement"
    document = {"format": "sturm.experiment/1", "title": "Sums", "agreement": [{
        "id": "box", "scene": str(CORNELL_BOX), "camera": {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.2, 0], "vfov_deg": 30, "resolution": [32, 32]},
        "eye": {"prescription": {"sphere_D": -3}, "pupil_diameter_mm": 10}, "predictions": ["depth_psf"], "layer_sum": True, "samples_per_pixel": 16, "max_bounces": 2}]}

    def test_composition_is_nearer_to_the_truth(self):
        self.run_study("out", "--quiet")
        self.succeed("validate", self.folder / "out/report.json")
        [view] = self.study("out")
        composited, added = view["predictions"]
        self.assertEqual([p.get("layer_sum") for p in (composited, added)], [None, True])
        self.assertIn("layer_sum", added["seconds"])
        self.assertLess(composited["squared_error"]["method"], added["squared_error"]["method"])
        self.assertTrue((self.folder / "out/images/box_depth_psf_sum.exr").is_file())
        self.assertIn("Layers blurred and added", (self.folder / "out/report.html").read_text())

    def test_it_needs_layers(self):
        self.expect_rejections([("/agreement/0/predictions", ["multipass"], "/agreement/0/layer_sum")])


if __name__ == "__main__":
    unittest.main()
