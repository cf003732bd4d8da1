"""`sturm render` with previews, stop rules, adaptive sampling and a denoised layer: files, counters, repeated bytes."""
import time
import unittest

import documents
import png_pixels
from documents import changed
from exr_header import channel_names, packed_pixels, read_header
from sturm_process import WRONG_INPUT, FolderTest, sturm, strict_json


class Adaptive(FolderTest):
    def render(self, document, name, *options):
        path = self.write("view.json", document)
        self.succeed("render", path, "-o", self.folder / f"{name}.exr", "--quiet", *options)
        return (self.folder / f"{name}.exr").read_bytes()

    def manifest(self, name):
        self.succeed("validate", self.folder / f"{name}.manifest.json")
        return strict_json((self.folder / f"{name}.manifest.json").read_text())

    def channels(self, data):
        return set(channel_names(read_header(data)[0]))

    def adaptive_view(self):
        view = changed(documents.view(), "/method/samples_per_pixel", 512)
        view["method"].update({"stop": {"relative_error": 0.15}, "adaptive": {}})
        return view

    def test_adaptive_pictures_repeat_for_any_number_of_threads(self):
        first = self.render(self.adaptive_view(), "a", "--threads", 1)
        self.assertEqual(self.render(self.adaptive_view(), "b", "--threads", 2), first)
        self.assertEqual(self.render(self.adaptive_view(), "c", "--preview", self.folder / "p.png", "--preview-interval-s", 0), first)
        self.assertLessEqual({"samples.Y", "mean_variance.R", "variance.R", "R"}, self.channels(first))

    def test_adaptive_counters(self):
        self.render(self.adaptive_view(), "a")
        counters = self.manifest("a")["counters"]
        sampling = counters["sampling"]
        self.assertEqual(sampling["ended_by"], "relative_error")
        self.assertEqual(sampling["tiles"], 36)
        self.assertEqual(sampling["tiles_converged"], 36)
        self.assertEqual(sampling["samples_spent"], counters["camera_rays"])
        self.assertEqual(sampling["samples_spent"] + sampling["samples_saved"], 48 * 48 * 512)
        self.assertLessEqual(sampling["samples_kept"], sampling["samples_spent"])
        self.assertGreater(sampling["samples_saved"], 0)
        self.assertLess(sampling["measured_relative_error"], 0.3)
        self.render(changed(self.adaptive_view(), "/method/stop/relative_error", 1e-6), "b", "--set", "/method/samples_per_pixel=40")
        sampling = self.manifest("b")["counters"]["sampling"]
        self.assertEqual((sampling["ended_by"], sampling["tiles_converged"]), ("samples", 0))
        self.assertEqual(sampling["kept_samples_per_pixel"], 40)

    def test_a_budget_of_time_ends_a_picture_and_is_noted(self):
        view = changed(documents.view(), "/method/samples_per_pixel", 1 << 22)
        view["method"]["stop"] = {"seconds": 0.5}
        start = time.monotonic()
        self.render(view, "a")
        self.assertLess(time.monotonic() - start, 60)  # 4 million samples would take hours
        manifest = self.manifest("a")
        sampling = manifest["counters"]["sampling"]
        self.assertEqual(sampling["ended_by"], "seconds")
        samples = int(sampling["kept_samples_per_pixel"])
        self.assertEqual(samples % 16, 0)
        note = next(note for note in manifest["notes"] if "stop.seconds" in note)
        self.assertIn(f"samples_per_pixel {samples} ", note)
        # What the note promises.
        again = self.render(changed(documents.view(), "/method/samples_per_pixel", samples), "b")
        self.assertEqual(packed_pixels(again), packed_pixels((self.folder / "a.exr").read_bytes()))

    def test_a_generous_budget_changes_nothing(self):
        view = changed(documents.view(), "/method/stop", {"seconds": 1000})
        self.assertEqual(packed_pixels(self.render(view, "a")), packed_pixels(self.render(documents.view(), "b")))
        manifest = self.manifest("a")
        self.assertEqual(manifest["counters"]["sampling"]["ended_by"], "samples")
        self.assertEqual(manifest["notes"], [])

    def test_the_preview_ends_as_the_picture(self):
        plain = self.render(documents.view(), "a")
        watched = self.render(documents.view(), "b", "--preview", self.folder / "p.png", "--preview-interval-s", 0)
        self.assertEqual(watched, plain)
        self.assertEqual((self.folder / "p.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.assertFalse([path.name for path in self.folder.iterdir() if ".tmp-" in path.name])

    def test_a_stereo_pair(self):
        view = changed(self.adaptive_view(), "/camera/stereo", {"interpupillary_distance_mm": 60})
        self.render(view, "a", "--preview", self.folder / "p.png", "--preview-interval-s", 0)
        self.assertEqual(png_pixels.size((self.folder / "p.png").read_bytes()), (96, 48))
        counters = self.manifest("a")["counters"]
        self.assertIn("sampling", counters["left"])
        self.assertIn("sampling", counters["right"])

    def test_the_raw_picture_stays_beside_the_denoised_one(self):
        view = changed(documents.view(), "/method/denoise", {})
        data = self.render(view, "a")
        self.assertLessEqual({"R", "denoised.R"}, self.channels(data))
        manifest = self.manifest("a")
        self.assertTrue(any("denoised" in note for note in manifest["notes"]), manifest["notes"])
        self.render(documents.view(), "b")
        # The main layer is what it is without the filter: no metric sees a difference. The PNG is the filtered picture.
        process = self.succeed("compare", self.folder / "a.exr", self.folder / "b.exr", "--json", "-")
        self.assertEqual(strict_json(process.stdout)["metrics"]["rmse_linear"], 0)
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_wrong_options(self):
        view = self.write("view.json", documents.view())
        for options in (["--preview", "p.jpg"], ["--preview", "p.png", "--preview-interval-s", "-1"]):
            self.assertEqual(sturm("render", view, "-o", self.folder / "a.exr", *options).returncode, WRONG_INPUT)
        predicted = documents.without(changed(documents.view(), "/method/type", "predict"), "/method/ray_model")
        process = sturm("render", self.write("p.json", predicted), "-o", self.folder / "a.exr", "--preview", self.folder / "p.png")
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("--preview", process.stderr)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"view.json", "p.json"})


if __name__ == "__main__":
    unittest.main()
