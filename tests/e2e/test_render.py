"""`sturm render`: the same bytes whatever the threads, and what lies beside the picture."""
import json
import re
import unittest

import documents
import png_pixels
from documents import changed, without
from exr_header import channel_names, packed_pixels, read_header, size
from sturm_process import CORNELL_BOX, SOURCE, FolderTest, strict_json

PLAIN_ROOM = SOURCE / "tests/reference/scene_plain/scene.obj"


class Render(FolderTest):
    def render(self, document, name, *options):
        """Renders to NAME.exr and returns its bytes."""
        path = self.write("view.json", document)
        process = self.succeed("render", path, "-o", self.folder / f"{name}.exr", "--quiet", *options)
        self.assertEqual(process.stdout, "")
        self.assertEqual(process.stderr, "")
        return (self.folder / f"{name}.exr").read_bytes()

    def prediction(self):
        return changed(without(documents.view(), "/method/ray_model"), "/method/type", "predict")


class SameBytes(Render):
    def test_threads_and_repetitions_do_not_change_a_byte(self):
        views = {model: changed(documents.view(), "/method/ray_model", model) for model in ("power_matrix", "sin2_radial", "pinhole")}
        views["independent"] = changed(documents.view(), "/method/sampler", "independent")
        views["predict"] = self.prediction()
        views["predict oversampled"] = changed(self.prediction(), "/method/oversampling", 2)
        seen = set()
        for name, view in views.items():
            with self.subTest(name):
                first = self.render(view, "first", "--threads", 1)
                self.assertEqual(self.render(view, "second", "--threads", 2), first)
                self.assertEqual(self.render(view, "third"), first)
                seen.add(first)
        self.assertEqual(len(seen), len(views))

    def test_the_seed_changes_the_picture(self):
        for view in (documents.view(), self.prediction()):
            first = self.render(view, "first")
            self.assertNotEqual(packed_pixels(self.render(changed(view, "/seed", 2), "second")), packed_pixels(first))
            # --seed is the document's seed: the same bytes, the recorded spec included.
            by_option = self.render(changed(view, "/seed", 1), "third", "--seed", 2)
            self.assertEqual(by_option, (self.folder / "second.exr").read_bytes())

    def test_set_is_the_documents_value(self):
        small = changed(documents.view(), "/camera/resolution", [20, 12])
        expected = self.render(small, "edited")
        self.assertEqual(size(read_header(expected)[0]), (20, 12))
        self.assertEqual(self.render(documents.view(), "set", "--set", "/camera/resolution=[20, 12]"), expected)
        self.assertEqual(self.render(documents.view(), "twice", "--set", "/camera/resolution/0=20", "--set", "/camera/resolution/1=12"), expected)


class Costs(Render):
    def last_line(self, view, *options):
        return self.succeed("render", self.write("view.json", view), "-o", self.folder / "a.exr", *options).stderr.splitlines()[-1]

    def test_it_ends_with_what_a_picture_took_and_bought(self):
        said = re.fullmatch(r"path traced in (\S+) s \((.*)\): 8 paths per pixel, noise at most (\S+) % of the light \(RMS\)",
                            self.last_line(documents.view(), "--samples", 8))
        self.assertIn("path tracing", said[2])
        # A fourth of the variance with four times the samples; 5 % for the variance's own noise and for three printed digits.
        more = re.search(r"noise at most (\S+) %", self.last_line(documents.view(), "--samples", 32))
        self.assertAlmostEqual(float(more[1]) / float(said[3]), 0.5, delta=0.05)

    def test_a_prediction_takes_16_paths_unless_told_otherwise(self):
        view = without(self.prediction(), "/method/samples_per_pixel")
        self.assertRegex(self.last_line(view), r"^ellipses in .* s \(.*\): sharp view of 16 paths per pixel, .* about 16 path-traced samples$")
        spec = strict_json((self.folder / "a.manifest.json").read_text())["spec"]
        self.assertEqual(spec["method"]["samples_per_pixel"], 16)
        self.assertTrue(self.last_line(view, "--samples", 4).endswith("): sharp view of 4 paths per pixel"))


class Files(Render):
    def test_a_picture_and_a_manifest_lie_beside(self):
        self.render(documents.view(), "a", "--threads", 2)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"view.json", "a.exr", "a.png", "a.manifest.json"})
        png = (self.folder / "a.png").read_bytes()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(png_pixels.size(png), (48, 48))
        manifest = strict_json((self.folder / "a.manifest.json").read_text())
        self.succeed("validate", self.folder / "a.manifest.json")
        provenance = manifest["provenance"]
        self.assertEqual(provenance["threads"], 2)
        self.assertEqual(provenance["seed"], 1)
        self.assertEqual(manifest["counters"]["camera_rays"], 48 * 48 * 16)
        files = [entry["file"] for entry in provenance["inputs"]]
        self.assertIn(str(CORNELL_BOX), files)
        self.assertEqual(len(files), len(set(files)), "every input once")

    def test_a_large_pupil_is_noted(self):
        self.render(changed(documents.view(), "/eye/pupil_diameter_mm", 40), "a")
        notes = strict_json((self.folder / "a.manifest.json").read_text())["notes"]
        self.assertEqual(len(notes), 1)
        self.assertIn("40", notes[0])
        self.render(documents.view(), "b")
        self.assertEqual(strict_json((self.folder / "b.manifest.json").read_text())["notes"], [])

    def test_metadata_is_the_resolved_spec_and_nothing_of_the_run(self):
        view = without(documents.view(), "/method/max_bounces")
        data = self.render(view, "a", "--threads", 2)
        attributes, header_end = read_header(data)
        kind, text = attributes["sturm"]
        self.assertEqual(kind, "string")
        spec = strict_json(text.decode())
        skip = ("scalar_power", "zero_pupil", "sharp_pixels", "refraction", "surface_models", "shading_frames", "environment_light", "unseen_emitters", "converged_tiles", "same_views",
                "sharp_spots")
        self.assertEqual(spec["method"], {**view["method"], "max_bounces": 16, "guide_emitters": True, "sampler": "sobol", "sampling": "uniform_disk", "filter": "box",
                                          "sharp_below_px": 0.02, "skip": dict.fromkeys(skip, True)})
        self.assertEqual(spec["eye"]["rotation_center_mm"], 13.5)
        self.assertEqual(spec["seed"], 1)
        header = data[:header_end].lower()
        provenance = strict_json((self.folder / "a.manifest.json").read_text())["provenance"]
        for word in (b"thread", b"second", b"started", b"hostname", b"capdate", provenance["started_utc"][:10].encode(), str(self.folder).encode()):
            self.assertNotIn(word, header)

    def test_layers(self):
        channels = set(channel_names(read_header(self.render(documents.view(), "a"))[0]))
        self.assertLessEqual({"R", "G", "B", "albedo.R", "normal.X", "variance.R"}, channels)
        self.assertTrue(any(name.startswith("depth") for name in channels), channels)
        self.assertLessEqual({"R", "G", "B"}, set(channel_names(read_header(self.render(self.prediction(), "b"))[0])))

    def test_progress_is_plain_lines_where_there_is_no_terminal(self):
        path = self.write("view.json", documents.view())
        process = self.succeed("render", path, "-o", self.folder / "a.exr")
        self.assertEqual(process.stdout, "")
        self.assertIn("100 %", process.stderr)
        self.assertNotIn("\r", process.stderr)
        self.assertNotIn("\033", process.stderr)

    def test_a_picture_is_replaced(self):
        self.write("a.exr", "an old file")
        self.assertEqual(self.render(documents.view(), "a")[:4], b"\x76\x2f\x31\x01")


class Scenes(Render):
    def test_inline_and_named_scene_are_the_same(self):
        scene = json.loads(CORNELL_BOX.read_text())
        self.write("scenes/box.json", scene)
        inline, named = (self.render(changed(documents.view(), "/scene", s), "a") for s in (scene, "scenes/box.json"))
        self.assertEqual(packed_pixels(inline), packed_pixels(named))

    def test_an_obj_file_is_a_scene(self):
        view = documents.view()
        by_path = self.render(changed(view, "/scene", str(PLAIN_ROOM)), "a")
        by_model = self.render(changed(view, "/scene", {"models": [{"file": str(PLAIN_ROOM), "scale": 1}]}), "b")
        self.assertEqual(packed_pixels(by_path), packed_pixels(by_model))
        self.assertNotEqual(packed_pixels(by_path), packed_pixels(self.render(view, "c")))

    def test_the_room_is_lit_and_not_mirrored(self):
        # Seen by its camera the box has its red wall on the left and its green wall on the right.
        self.render(changed(documents.view(), "/eye/pupil_diameter_mm", 0), "a")
        picture = png_pixels.decode((self.folder / "a.png").read_bytes())
        left, right = png_pixels.mean_colour(picture, 0, 16), png_pixels.mean_colour(picture, 32, 48)
        self.assertGreater(left[0] / left[1], right[0] / right[1])

    def test_a_texture_comes_through_the_image_module(self):
        red, green, blue, white = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)
        self.write("paint.png", png_pixels.encode([[red, green], [blue, white]]))
        self.write("wall.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd paint.png\n")
        self.write("wall.obj", "mtllib wall.mtl\nusemtl paint\nv -1 -1 -2\nv 1 -1 -2\nv 1 1 -2\nv -1 1 -2\n"
                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
        view = changed(documents.view(), "/scene", {
            "models": [{"file": "wall.obj", "texture_filter": "nearest"}],
            "lights": [{"type": "point", "position_m": [0, 0, 0], "intensity": [9, 9, 9]}]})
        view["camera"].update({"position_m": [0, 0, 0], "look_at_m": [0, 0, -2], "vfov_deg": 50})
        view["eye"]["pupil_diameter_mm"] = 0
        self.render(view, "a")
        picture = png_pixels.decode((self.folder / "a.png").read_bytes())
        for x, y, seen in [(12, 12, red), (36, 12, green), (12, 36, blue), (36, 36, white)]:
            for value, full in zip(picture[y][x], seen):
                self.assertTrue(value > 60 if full else value == 0, f"pixel {x} {y}: {picture[y][x]}")


if __name__ == "__main__":
    unittest.main()
