"""`sturm run` with a section sampling_study: what is biased is seen to be, and nothing else."""
import unittest

import documents
from sturm_process import CORNELL_BOX, FAILED, FolderTest, strict_json, sturm

STUDY = {
    "scene": str(CORNELL_BOX), "pupil_diameter_mm": 60, "accommodation": {"mode": "fixed", "focus_distance_m": 0.7},
    "camera": {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0], "vfov_deg": 39.3, "resolution": [24, 24]},
    "configurations": [{"id": "sharp", "prescription": {"sphere_D": 0}, "ray_model": "pinhole"},
                       {"id": "lens", "note": "focused before the box", "prescription": {"sphere_D": 0}, "ray_model": "thin_lens"}],
    "samplings": ["uniform_disk", "uniform_polar", "uniform_polar_weighted", "rings"], "rings": {"count": 2},
    "samplers": ["halton"], "samples_per_pixel": 64, "replicates": 6, "max_bounces": 1}
# Products of 6 pictures: 15 of them; |z| of 6 numbers exceeds 5 with probability below 1e-3 (t with 15 degrees of freedom).
GATES = [("unbiased", "sampling_unbiased_max_z", "at_most"), ("polar", "sampling_raw_polar_min_z", "differs")]


class SamplingStudy(FolderTest):
    def experiment(self, study):
        self.write("gates.json", {"format": "sturm.gates/1", "gates": [
            {"id": name, "title": name, "statistic": statistic, "comparison": comparison, "bound": 5, "unit": "σ", "reason": "see above"}
            for name, statistic, comparison in GATES]})
        return self.write("samplings.json", {"format": "sturm.experiment/1", "title": "Samplings", "gates": "gates.json", "sampling_study": study})

    def test_only_what_is_biased_is_seen(self):
        out = self.folder / "out"
        self.succeed("run", self.experiment(STUDY), "--out", out, "--quiet")
        self.succeed("validate", out / "report.json")
        report = strict_json((out / "report.json").read_text())
        entries = {(e["configuration"], e["sampling"]): e for e in report["sampling_study"]["entries"]}
        self.assertEqual(len(entries), 8)
        for sampling in STUDY["samplings"]:
            self.assertTrue((out / entries["lens", sampling]["files"]["picture"]).is_file())
        # Rings at 1/2 and 1 carry 6 and 12 points: E[r^2] = 3/4 of a^2 in place of 1/2.
        self.assertAlmostEqual(entries["lens", "rings"]["pupil_rms_ratio"], 1.22474, delta=1e-5)
        self.assertGreater(entries["lens", "uniform_polar"]["z"], 5)
        self.assertIn("sampling_study_halton", [figure["id"] for figure in report["figures"]])
        sheet = (out / "figures/sampling_study_halton.svg").read_text()
        self.assertEqual(sheet.count("data:image/png;base64,"), 8)
        self.assertIn("Pupil samplings", (out / "report.html").read_text())

    def test_a_bias_that_is_not_there_is_missed(self):
        """Through a pinhole no sampling is biased: the gate that raw polar sampling must differ has no case and fails."""
        study = documents.changed(STUDY, "/configurations/1/ray_model", "pinhole")
        process = sturm("run", self.experiment(study), "--out", self.folder / "out", "--quiet")
        self.assertEqual(process.returncode, FAILED, process.stderr)


if __name__ == "__main__":
    unittest.main()
