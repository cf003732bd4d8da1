"""What the gates of the default run can see, and what they leave alone: mutations of one predictor, and other seeds.

One image instead of two, with a quarter of the pixels, two spots, and a part of the ellipses: light and place of the picture have twice the noise of the
default run, so that a false alarm is likelier here than there, while the largest |z| of ellipses is a function of the same
few numbers however many cases there are (configs/gates/validation.json says why).
"""
import functools
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from sturm_process import FAILED, PASSED, SOURCE, STURM, FolderTest, strict_json, sturm

SEEDS = 8
OTHER_SEED = 21  # of the baseline
MUTATIONS = ["semi_axis", "turned_axis", "mirrored_axis", "vertex_distance", "tangential_term", "half_pixel", "lost_light"]
NOTICED_BY = {  # one of the gates that each was made for
    "semi_axis": "matrix_equals_conoid_relative",
    "turned_axis": "matrix_equals_conoid_relative",
    "mirrored_axis": "psf_equals_conoid",
    "vertex_distance": "matrix_equals_conoid",
    "tangential_term": "psf_equals_conoid_relative",
    "half_pixel": "image_is_in_its_place",
    "lost_light": "image_keeps_its_light",
}


def small_validation():
    """The default experiment with less to do, and paths that hold anywhere."""
    configs = SOURCE / "configs"
    document = strict_json((configs / "experiments/validation.json").read_text())
    document["reference"] = str(SOURCE / "tests/reference/naked_eye_blur.json")
    document["gates"] = str(configs / "gates/validation.json")
    document["baseline"] = "baseline.json"
    ellipses = document["ellipses"]
    ellipses.update(distances_m=[1, "inf"], pupil_diameters_mm=[4], ray_models=["thin_lens", "sin2_radial", "power_matrix"])
    document["psfs"] = [psf for psf in document["psfs"] if psf["id"] in ("oblique_compound", "least_confusion")]
    document["images"] = [image for image in document["images"] if image["id"] == "cornell_myope"]
    document["images"][0].update(scene=str(configs / "scenes/cornell_box.json"))
    document["images"][0]["camera"]["resolution"] = [128, 128]
    return document


@functools.cache
def baseline():
    """The baseline's file as another run writes it."""
    plain = {key: value for key, value in small_validation().items() if key != "baseline"}
    with tempfile.TemporaryDirectory(prefix="sturm_e2e_") as name:
        folder = pathlib.Path(name)
        (folder / "plain.json").write_text(json.dumps({**plain, "mutations": []}))
        sturm("run", folder / "plain.json", "--seed", OTHER_SEED, "--out", folder / "before", "--quiet", timeout=600)  # without a baseline gates fail
        sturm("gate", folder / "before/report.json", "--write-baseline", folder / "baseline.json")
        return (folder / "baseline.json").read_bytes()


class GatePower(FolderTest):
    def setUp(self):
        super().setUp()
        self.document = small_validation()
        self.experiment = self.write("experiment.json", self.document)
        self.write("baseline.json", baseline())
        self.baseline_hash = self.hash_of_baseline()

    def hash_of_baseline(self):
        return hashlib.sha256((self.folder / "baseline.json").read_bytes()).hexdigest()

    def run_experiment(self, name, document):
        """Exit status and report."""
        path = self.write(name + ".json", document)
        process = sturm("run", path, "--out", self.folder / name, "--quiet", timeout=600)
        self.assertIn(process.returncode, (PASSED, FAILED), process.stderr)
        return process.returncode, strict_json((self.folder / name / "report.json").read_text())

    def test_every_mutation_is_noticed(self):
        status, report = self.run_experiment("mutated", self.document)
        self.assertEqual(status, PASSED, report["verdict"]["sentence"])
        power = report["gate_power"]
        self.assertEqual([mutation["id"] for mutation in power["mutations"]], MUTATIONS)
        print()
        for mutation in power["mutations"]:
            noticed = {caught["gate"]: caught for caught in mutation["caught_by"]}
            print(f"{mutation['id']}: {mutation['what']}")
            for name, caught in noticed.items():
                print(f"    {name}: {caught['honest_value']:.4g} -> {caught['value']:.4g} (bound {caught['bound']:g} {caught['unit']})")
            self.assertIn(NOTICED_BY[mutation["id"]], noticed)
        self.assertLess(power["false_alarms_per_run"], 0.005)  # one run in 200

        # The mutations leave no trace in what the report says of the honest predictors.
        self.assertNotIn('"mutated"', json.dumps({key: report[key] for key in ("ellipses", "psfs", "images")}))
        _, plain = self.run_experiment("unmutated", {**self.document, "mutations": []})
        for section in ("ellipses", "psfs"):
            self.assertEqual(report[section], plain[section])
        self.assertEqual(report["images"][0]["metrics"], plain["images"][0]["metrics"])
        self.assertNotIn("gate_power", plain)
        self.assertEqual([gate["id"] for gate in plain["gates"] if not gate["passed"]], ["every_mutation_is_noticed"])

        self.assertEqual(sturm("validate", self.folder / "mutated/report.json").returncode, PASSED)
        self.assertEqual(sturm("gate", self.folder / "mutated/report.json").returncode, PASSED)  # from the stored report alone
        page = (self.folder / "mutated/report.html").read_text()
        self.assertIn("What the gates can see", page)
        for mutation in MUTATIONS:
            self.assertIn(f"<code>{mutation}</code>", page)

    def test_other_seeds_give_no_false_alarm(self):
        process = subprocess.run(
            [sys.executable, "-B", SOURCE / "scripts/gate_seeds.py", self.experiment, "--seeds", str(SEEDS), "--json", self.folder / "seeds.json",
             "--set", '/mutations=["semi_axis"]'], env={**os.environ, "STURM": str(STURM)}, capture_output=True, text=True)
        print("\n" + process.stdout)
        self.assertEqual(process.returncode, 0, process.stdout + process.stderr)
        summary = strict_json((self.folder / "seeds.json").read_text())
        self.assertEqual((summary["runs"], summary["false_alarms"]), (SEEDS, 0))
        self.assertLess(summary["expected"], 0.1)
        # The seed has a part in it: a gate whose value never changed would have been run once.
        for gate in ("matrix_equals_conoid", "psf_equals_conoid", "image_keeps_its_light", "image_is_in_its_place", "image_as_in_baseline"):
            self.assertEqual(len(set(summary["gates"][gate]["values"])), SEEDS, gate)
        self.assertEqual(self.hash_of_baseline(), self.baseline_hash, "a run has touched the baseline")


if __name__ == "__main__":
    unittest.main()
