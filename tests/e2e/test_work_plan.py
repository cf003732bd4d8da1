"""The plan of work: `sturm render --explain`, the switches in `method.skip`, and what the manifest counts."""
import unittest

import documents
from documents import changed, without
from exr_header import packed_pixels
from sturm_process import SOURCE, WRONG_INPUT, FolderTest, strict_json, sturm

SPHERICAL = {"prescription": {"sphere_D": -1.5}, "pupil_diameter_mm": 6, "accommodation": {"mode": "relaxed"}}
LENS = {"vertex_distance_mm": 12, "center_thickness_mm": 3, "refractive_index": 1.5,
        "front": {"type": "sphere", "radius_mm": 100}, "back": {"type": "sphere", "radius_mm": 80}}


def outdoors():
    """An emmetrope looks at a wall 40 m away under a sky of one colour; a lamp behind him shines away from everything."""
    view = documents.view()
    view["scene"] = {
        "format": "sturm.scene/1",
        "materials": {"grey": {"albedo": [0.5, 0.5, 0.5]}, "lamp": {"albedo": [0, 0, 0], "emission": [9, 9, 9]}},
        "meshes": [
            {"material": "grey", "positions_m": [[-20, -9, -40], [15, -9, -40], [15, 9, -40], [-20, 9, -40]], "faces": [[0, 1, 2, 3]]},
            {"material": "lamp", "positions_m": [[-1, -1, 5], [1, -1, 5], [1, 1, 5], [-1, 1, 5]], "faces": [[0, 1, 2, 3]]},
        ],
        "environment": {"radiance": [0.2, 0.3, 0.5]},
    }
    view["camera"] = {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [48, 32]}
    view["eye"] = {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 2, "accommodation": {"mode": "relaxed"}}
    view["method"]["max_bounces"] = 2
    return view


class Plan(FolderTest):
    def explain(self, document):
        """The rows of the table as {item: (state, whole line)}; nothing may be written."""
        path = self.write("view.json", document)
        before = sorted(self.folder.iterdir())
        process = self.succeed("render", "--explain", path)
        self.assertEqual(process.stderr, "")
        self.assertEqual(sorted(self.folder.iterdir()), before)
        head, *lines = process.stdout.splitlines()
        self.assertTrue(head.startswith("item"))
        rows = {}
        for line in lines:
            state = next(s for s in ("left out", "done (off)", "needed") if s in line)
            rows[line.split()[0]] = (state, line)
        return rows

    def render(self, document, name="a"):
        self.succeed("render", self.write("view.json", document), "-o", self.folder / f"{name}.exr", "--quiet")
        self.succeed("validate", self.folder / f"{name}.manifest.json")
        return (self.folder / f"{name}.exr").read_bytes()

    def plan(self, name="a", view=None):
        manifest = strict_json((self.folder / f"{name}.manifest.json").read_text())
        return {entry["item"]: entry for entry in manifest["counters"]["plan"] if view is None or entry.get("view", view) == view}


class Explain(Plan):
    def test_a_room_and_an_astigmat(self):
        rows = self.explain(documents.view())
        left_out = {name for name, (state, _) in rows.items() if state == "left out"}
        self.assertEqual(left_out, {"environment_light", "surface_models", "shading_frames", "refraction"})
        self.assertIn("cylinder -4.00 D", rows["scalar_power"][1])

    def test_a_scene_that_needs_little(self):
        rows = self.explain(outdoors())
        left_out = {name for name, (state, _) in rows.items() if state == "left out"}
        self.assertEqual(left_out, {"environment_light", "unseen_emitters", "surface_models", "refraction", "scalar_power", "sharp_pixels"})
        self.assertIn("2 emitting triangles", rows["unseen_emitters"][1])
        self.assertIn("100 % of the pixels", rows["sharp_pixels"][1])

    def test_spectacles_are_refracted(self):
        rows = self.explain(changed(documents.view(), "/spectacles", LENS))
        self.assertEqual(rows["refraction"][0], "needed")
        self.assertIn("spectacles", rows["refraction"][1])

    def test_a_prediction(self):
        rows = self.explain(changed(without(documents.view(), "/method/ray_model"), "/method/type", "predict"))
        self.assertIn("sharp_spots", rows)
        self.assertNotIn("scalar_power", rows)

    def test_switches_show(self):
        rows = self.explain(changed(documents.view(), "/method/skip", {"refraction": False}))
        self.assertEqual(rows["refraction"][0], "done (off)")
        self.assertEqual(rows["surface_models"][0], "left out")

    def test_what_is_wrong(self):
        path = self.write("view.json", changed(documents.view(), "/method/skip", {"refractoin": False}))
        for arguments in (("--explain", path), (path, "-o", self.folder / "a.exr")):
            process = sturm("render", *arguments)
            self.assertEqual(process.returncode, WRONG_INPUT)
            self.assertIn("refractoin", process.stderr)
        good = self.write("good.json", documents.view())
        self.assertEqual(sturm("render", "--explain", good, "-o", self.folder / "a.exr").returncode, WRONG_INPUT)
        self.assertEqual(sturm("render", good).returncode, WRONG_INPUT)
        prediction = changed(without(documents.view(), "/method/ray_model"), "/method/type", "predict")
        process = sturm("render", "--explain", self.write("view.json", changed(prediction, "/method/sharp_below_px", 0.1)))
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("/method/sharp_below_px", process.stderr)
        self.assertFalse((self.folder / "a.exr").exists())


class Manifest(Plan):
    def test_counters(self):
        self.render(outdoors())
        plan = self.plan()
        pixels, samples = 48 * 32, 16
        self.assertEqual(plan["scalar_power"]["saved"], {"camera_rays": pixels * samples})
        self.assertEqual(plan["refraction"]["saved"], {"camera_rays": pixels * samples})
        self.assertEqual(plan["sharp_pixels"]["saved"], {"pixels": pixels})
        self.assertEqual(plan["unseen_emitters"]["saved"], {"emitters": 2})
        self.assertGreater(plan["surface_models"]["saved"]["bounces"], 0)
        self.assertEqual(plan["shading_frames"], {"item": "shading_frames", "left_out": False, "needed": True,
                                                  "reason": "smooth normals or an environment", "saved": {}})

    def test_off_saves_nothing(self):
        off = {name: False for name in ("scalar_power", "zero_pupil", "sharp_pixels", "refraction", "surface_models", "shading_frames",
                                        "environment_light", "unseen_emitters", "converged_tiles", "same_views", "sharp_spots")}
        self.render(changed(outdoors(), "/method/skip", off))
        for entry in self.plan().values():
            self.assertFalse(entry["left_out"])
            self.assertEqual(entry["saved"], {})
        # Lights are sampled where they need not be: the environment is a light now.
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        self.assertGreater(counters["shadow_rays"], 0)

    def test_tiles_end_one_by_one(self):
        view = changed(strict_json((SOURCE / "configs/views/near_screen.json").read_text()), "/camera/resolution", [96, 64])
        view["method"].update({"stop": {"relative_error": 0.03}, "adaptive": {"tile_px": 8}})
        self.render(view)
        saved = self.plan()["converged_tiles"]["saved"]
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        self.assertGreater(saved["samples"], counters["camera_rays"] / 2)
        self.assertGreater(saved["tiles"], 48)  # half of them
        self.render(changed(view, "/method/skip", {"converged_tiles": False}), "off")
        manifest = strict_json((self.folder / "off.manifest.json").read_text())
        entry = [e for e in manifest["counters"]["plan"] if e["item"] == "converged_tiles"]
        self.assertEqual(entry, [{"item": "converged_tiles", "left_out": False, "needed": False, "picture": "same mean",
                                  "reason": "adaptive sampling: tiles end one by one", "saved": {}}])
        off = manifest["counters"]
        # Every pixel has the same number of samples, and the longest tile decides.
        self.assertEqual(off["camera_rays"] % (96 * 64), 0)
        for sampling in (counters["sampling"], off["sampling"]):
            self.assertLess(sampling["measured_relative_error"], 0.045)  # an estimate from two halves scatters

    def test_copied_pixels_of_a_prediction(self):
        view = outdoors()
        del view["method"]["ray_model"]
        view["method"]["type"] = "predict"
        self.render(view)
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        self.assertEqual(self.plan()["sharp_spots"]["saved"], {"pixels": counters["copied_pixels"]})
        self.assertEqual(counters["spread_pixels"], 0)
        self.render(changed(view, "/method/skip", {"sharp_spots": False}), "off")
        counters = strict_json((self.folder / "off.manifest.json").read_text())["counters"]
        self.assertEqual(counters["copied_pixels"], 0)


class Pictures(Plan):
    def test_the_same_bits_without_a_cylinder(self):
        view = changed(documents.view(), "/eye", SPHERICAL)
        first = packed_pixels(self.render(view))
        self.assertTrue(self.plan()["scalar_power"]["left_out"])
        self.assertEqual(packed_pixels(self.render(changed(view, "/method/skip", {"scalar_power": False}))), first)

    def test_the_same_bits_of_a_pinhole(self):
        for sampler in ("sobol", "halton", "independent"):
            view = changed(changed(documents.view(), "/eye/pupil_diameter_mm", 0), "/method/sampler", sampler)
            first = packed_pixels(self.render(view))
            self.assertTrue(self.plan()["zero_pupil"]["left_out"])
            self.assertEqual(packed_pixels(self.render(changed(view, "/method/skip", {"zero_pupil": False}))), first)

    def test_what_does_not_apply_changes_nothing(self):
        view = documents.view()
        first = packed_pixels(self.render(view))
        for name in ("scalar_power", "zero_pupil", "sharp_pixels", "environment_light", "unseen_emitters", "converged_tiles", "same_views", "sharp_spots"):
            with self.subTest(name):
                self.assertEqual(packed_pixels(self.render(changed(view, "/method/skip", {name: False}))), first)

    def test_coinciding_eyes_are_rendered_once(self):
        pair = changed(documents.view(), "/camera/stereo", {"interpupillary_distance_mm": 0})
        self.render(pair)
        saved = self.plan()["same_views"]["saved"]
        self.assertEqual(saved, {"views": 1, "camera_rays": 48 * 48 * 16})
        counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
        self.assertEqual(counters["left"]["camera_rays"], 0)
        self.assertEqual(counters["right"]["camera_rays"], 48 * 48 * 16)
        # Spelt out alike is alike; another pupil, or another place, is not.
        alike = changed(pair, "/left", {"eye": pair["eye"]})
        self.render(alike)
        self.assertTrue(self.plan()["same_views"]["left_out"])
        other = changed(pair, "/left", {"eye": changed(pair["eye"], "/pupil_diameter_mm", 5)})
        for needed in (other, changed(pair, "/camera/stereo/interpupillary_distance_mm", 1)):
            self.render(needed)
            self.assertFalse(self.plan()["same_views"]["left_out"])
            counters = strict_json((self.folder / "a.manifest.json").read_text())["counters"]
            self.assertEqual(counters["left"]["camera_rays"], 48 * 48 * 16)


if __name__ == "__main__":
    unittest.main()
