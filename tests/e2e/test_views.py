"""`sturm render` with spectacles, other projections and gazes, stereo pairs, spreads over the pupil."""
import unittest

import documents
from documents import changed
from exr_header import packed_pixels, read_header, size
from sturm_process import FolderTest, strict_json

LENS = {"vertex_distance_mm": 12, "center_thickness_mm": 3, "refractive_index": 1.5,
        "front": {"type": "torus", "sweep_radius_mm": 100, "generator_radius_mm": 75, "sweep_meridian_deg": 30},
        "back": {"type": "sphere", "radius_mm": 80}}


class Views(FolderTest):
    def render(self, document, name, *options):
        self.succeed("render", self.write("view.json", document), "-o", self.folder / f"{name}.exr", "--quiet", *options)
        return (self.folder / f"{name}.exr").read_bytes()

    def counters(self, name):
        return strict_json((self.folder / f"{name}.manifest.json").read_text())["counters"]

    def variants(self):
        view = documents.view()
        best = {"mode": "best", "amplitude_D": 3}
        sphere = changed(changed(view, "/camera/projection", "equirectangular"), "/camera/resolution", [32, 16])
        del sphere["camera"]["vfov_deg"]
        pair = changed(view, "/camera/stereo", {"interpupillary_distance_mm": 63})
        return {
            "lens": changed(view, "/spectacles", LENS),
            "foveal": changed(changed(view, "/camera/gaze", "foveal"), "/eye/accommodation", best),
            "foveal lens": changed(changed(changed(view, "/camera/gaze", "foveal"), "/eye/accommodation", best), "/spectacles", LENS),
            "sphere": sphere,
            "sphere pair": changed(sphere, "/camera/stereo", {"interpupillary_distance_mm": 63}),
            "pair": changed(pair, "/left", {"eye": {"prescription": {"sphere_D": -3}, "pupil_diameter_mm": 6}, "spectacles": LENS}),
            "polar": changed(view, "/method/sampling", "uniform_polar"),
            "polar weighted": changed(view, "/method/sampling", "uniform_polar_weighted"),
            "rings": changed(changed(view, "/method/sampling", "rings"), "/method/rings", {"count": 4, "angle_factor": 5}),
            "apodized": changed(view, "/eye/stiles_crawford_per_mm2", 0.05),
            "halton": changed(view, "/method/sampler", "halton"),
            "zernike": changed(view, "/method/ray_model", "zernike"),
        }

    def test_threads_do_not_change_a_byte(self):
        seen = set()
        for name, view in self.variants().items():
            with self.subTest(name):
                first = self.render(view, "first", "--threads", 1)
                self.assertEqual(self.render(view, "second", "--threads", 2), first)
                seen.add(first)
        self.assertEqual(len(seen), len(self.variants()))

    def test_a_pair_is_two_pictures(self):
        pair = self.render(self.variants()["pair"], "pair")
        width, height = documents.view()["camera"]["resolution"]
        self.assertEqual(size(read_header(pair)[0]), (2 * width, height))
        counters = self.counters("pair")
        self.assertEqual(counters["left"]["camera_rays"], counters["right"]["camera_rays"])

    def test_lost_rays_are_counted(self):
        self.render(changed(self.variants()["lens"], "/spectacles/diameter_mm", 10), "small")
        counters = self.counters("small")
        self.assertGreater(counters["lost_rim_rays"], 0)
        self.assertLess(counters["lost_rim_rays"], counters["camera_rays"])
        self.render(self.variants()["lens"], "large")
        self.assertEqual(self.counters("large")["lost_rim_rays"], 0)

    def test_a_lens_file_is_an_input(self):
        path = self.write("lens.json", dict(LENS, format="sturm.spectacles/1"))
        inline = self.render(self.variants()["lens"], "inline")
        named = self.render(changed(documents.view(), "/spectacles", "lens.json"), "named")
        self.assertEqual(packed_pixels(named), packed_pixels(inline))
        manifest = strict_json((self.folder / "named.manifest.json").read_text())
        self.assertIn(str(path), [entry["file"] for entry in manifest["provenance"]["inputs"]])


if __name__ == "__main__":
    unittest.main()
