"""`sturm compare` on the program's own pictures: seeds of one view against each other, two ray models, and a spot."""
import unittest

import documents
from sturm_process import FolderTest, strict_json


class CompareRenders(FolderTest):
    def render(self, name, seed, *changes):
        view = self.write("view.json", documents.view())
        picture = self.folder / f"{name}.exr"
        self.succeed("render", view, "-o", picture, "--quiet", "--seed", seed, "--set", "/camera/resolution=[128, 128]", *changes)
        return picture

    def compare(self, *arguments):
        return strict_json(self.succeed("compare", *arguments, "--json", "-").stdout)

    def test_seeds_and_ray_models(self):
        model = ("--set", "/method/ray_model=sin2_radial", "--set", "/eye/pupil_diameter_mm=10", "--set", "/method/samples_per_pixel=64")
        wave = ("--set", "/eye/pupil_diameter_mm=10", "--set", "/method/samples_per_pixel=64")
        a, a2, a3 = (self.render(f"wave{seed}", seed, *wave) for seed in (1, 2, 3))
        b, b2 = (self.render(f"sin2_{seed}", seed, *model) for seed in (11, 12))

        same = self.compare(a, a2, "--noise", a3, "--regions")
        self.assertEqual(list(same["regions"]), ["blurred", "highlights", "in_focus", "occlusion_edges"])
        parts = [same, *same["regions"].values()]
        self.assertGreater(same["conditions"]["noise_tests"], 40)
        # The family-wise level is 1 %; the seeds are fixed.
        self.assertFalse(any(flag for part in parts if part["noise"] for flag in part["noise"]["distinguishable"].values()))

        differing = self.compare(b, a, "--noise", b2, a2, "--regions")
        self.assertTrue(differing["noise"]["distinguishable"]["flip"])
        self.assertTrue(differing["noise"]["distinguishable"]["smape"])
        self.assertGreater(differing["noise"]["z"]["flip"], 4)

        regions = differing["regions"]
        self.assertEqual(regions["in_focus"]["pixels"] + regions["blurred"]["pixels"], 128 * 128)
        self.assertGreater(regions["occlusion_edges"]["pixels"], 500)
        self.assertLess(regions["occlusion_edges"]["pixels"], 128 * 128)
        self.assertGreater(regions["highlights"]["pixels"], 20)  # the lamp
        # 39.3077 degrees over 128 px, at the middle: 1 degree / (2 tan(19.65 degrees)/128)
        self.assertAlmostEqual(differing["conditions"]["pixels_per_degree"], 3.12763, delta=1e-4)

    def test_spots_of_two_ray_models(self):
        # A small lamp in a black world: the picture is the point spread function, upside down and left to right alike for both models.
        scene = {"format": "sturm.scene/1", "materials": {"lamp": {"albedo": [0, 0, 0], "emission": [1, 1, 1]}},
                 "meshes": [{"material": "lamp", "positions_m": [[-0.001, -0.001, -2], [0.001, -0.001, -2], [0.001, 0.001, -2], [-0.001, 0.001, -2]],
                             "faces": [[0, 1, 2, 3]]}]}
        self.write("lamp.json", scene)
        view = {**documents.view(), "scene": "lamp.json",
                "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "up": [0, 1, 0], "vfov_deg": 1.2, "resolution": [96, 96]},
                "eye": {"prescription": {"sphere_D": -1.0, "cylinder_D": -2.0, "axis_deg": 30, "vertex_distance_mm": 0}, "pupil_diameter_mm": 4,
                        "accommodation": {"mode": "relaxed"}}}
        self.write("spot.json", view)
        pictures = {}
        for model in ("power_matrix", "sin2_radial"):
            pictures[model] = self.folder / f"{model}.exr"
            self.succeed("render", self.folder / "spot.json", "-o", pictures[model], "--quiet", "--set", f"/method/ray_model={model}",
                         "--set", "/method/samples_per_pixel=1024", "--set", "/method/max_bounces=0")
        psf = self.compare(pictures["sin2_radial"], pictures["power_matrix"], "--psf")["psf"]
        # V = 1/d + F: -0.5 D and -2.5 D, a = 2 mm. Second moments a^2/4 V^2 along the axes (wavefront theory) and of the sin2 pattern,
        # a^2/4 (5 V1^2 + 2 V1 V2 + V2^2)/8 and so on: traces 6.5 and 5.5 times a^2/4, in arcmin^2; the lamp adds side^2/12 per axis.
        arcmin = 3437.746770784939
        unit = 0.25 * 0.002**2 * arcmin**2
        lamp = 2 * (0.002 / 2 * arcmin) ** 2 / 12
        for side, expected in (("reference", 6.5 * unit + lamp), ("test", 5.5 * unit + lamp)):
            xx, _, yy = psf[side]["covariance_arcmin2"]
            self.assertAlmostEqual((xx + yy) / expected, 1, delta=0.02, msg=side)  # the noise of some 10^4 rays: 0.5 %, four times
        self.assertGreater(psf["sliced_wasserstein_arcmin"], 0.1)
        self.assertGreater(psf["total_variation"]["value"], 0.05)
        # sin2 pulls light inwards along the long axis and outwards along the short one: both radii come out different.
        self.assertNotAlmostEqual(psf["test"]["radius_50_arcmin"]["value"], psf["reference"]["radius_50_arcmin"]["value"], delta=0.02)


if __name__ == "__main__":
    unittest.main()
