"""`sturm see`: pictures with a depth map in all the forms that it may come in, and what is wrong with them."""
import json
import math
import os
import unittest
import zlib

import png_pixels
from picture_files import exr, exr_parts, pfm, png, radiance
from sturm_process import RUNTIME_FAILURE, SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

WIDTH, HEIGHT = 48, 40
MYOPE = {"format": "sturm.eye/1", "prescription": {"sphere_D": -2, "vertex_distance_mm": 0}, "pupil_diameter_mm": 5}


def to_linear(encoded):
    return encoded / 12.92 if encoded <= 0.04045 else ((encoded + 0.055) / 1.055) ** 2.4


def grey16(data):
    """Rows of 0 … 1 of the red channel of a 16-bit PNG without interlace."""
    (width, height), at, packed = png_pixels.size(data), 8, b""
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    rows = png_pixels.unfiltered(zlib.decompress(packed), 6 * width, 6)
    return [[int.from_bytes(row[6 * x:6 * x + 2], "big") / 65535 for x in range(width)] for row in rows]


def board():
    """Squares of 8 px in two greys."""
    return [[(200,) * 3 if (x // 8 + y // 8) % 2 else (60,) * 3 for x in range(WIDTH)] for y in range(HEIGHT)]


def two_distances(near, far):
    return [[near if x < WIDTH // 2 else far for x in range(WIDTH)] for _ in range(HEIGHT)]


class See(FolderTest):
    def setUp(self):
        super().setUp()
        self.photo = self.write("photo.png", png_pixels.encode(board()))
        self.eye = self.write("eye.json", MYOPE)

    def see(self, *arguments, output="seen.png"):
        self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "-o", self.folder / output, *arguments)
        return png_pixels.decode((self.folder / output).read_bytes())

    def refuse(self, *arguments):
        before = snapshot(self.folder)
        process = sturm("see", *arguments, "-o", self.folder / "seen.png")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertEqual(snapshot(self.folder), before)
        return process.stderr

    def test_depth_means_the_same_in_every_form(self):
        metres = two_distances(0.5, 4.0)
        forms = {
            "mm.png": (png([[round(1000 * d) for d in row] for row in metres], 16), []),
            "scaled.png": (png([[round(5000 * d) for d in row] for row in metres], 16), ["--depth-scale", "0.0002"]),
            "m.pfm": (pfm(metres), []),
            "dioptres.pfm": (pfm([[1 / d for d in row] for row in metres]), ["--depth-unit", "D"]),
            # f b = 100 px m, so that 0.5 m are 200 px and 4 m are 25 px; 5 px are added to the stored ones.
            "disparity.pfm": (pfm([[100 / d - 5 for d in row] for row in metres]),
                              ["--disparity", "--focal-px", "1000", "--baseline-m", "0.1", "--doffs-px", "5"]),
            "disparity8.png": (png([[round(100 / d) for d in row] for row in metres], 8),
                               ["--disparity", "--focal-px", "1000", "--baseline-m", "0.1"]),
        }
        expected = None
        for name, (content, options) in forms.items():
            with self.subTest(form=name):
                seen = self.see("--depth", self.write(name, content), *options)
                expected = expected or seen
                difference = max(abs(a - b) for r, s in zip(seen, expected) for p, q in zip(r, s) for a, b in zip(p, q))
                self.assertLessEqual(difference, 1)

    def test_pictures_come_in_every_form(self):
        """Linear light in floats is the light of the sRGB picture, whatever file it stands in."""
        light = [[tuple(to_linear(v / 255) for v in pixel) for pixel in row] for row in board()]
        channel = [[p[0] for p in row] for row in light]
        colours = {"R": channel, "G": channel, "B": channel}
        other = [[0.5] * WIDTH for _ in range(HEIGHT)]
        depth = two_distances(0.5, 4.0)
        expected = self.see("--depth", self.write("d.pfm", pfm(depth)))
        forms = {
            "photo.pfm": (pfm(light), []),
            "photo.png": (png([[(p[0] * 257,) * 3 for p in row] for row in board()], 16), []),
            "PHOTO.EXR": (exr(colours), []),
            "parts.exr": (exr_parts({"beauty": colours}), []),
            "passes.exr": (exr({**{f"View.Combined.{c}": channel for c in "RGB"}, **{f"View.Diffuse.{c}": other for c in "RGB"}}),
                           ["--picture-layer", "Combined"]),
            "deep.exr": (exr({**colours, "Z": depth}), None),
            "apart.exr": (exr_parts({"rgba": colours, "depth": {"Z": depth}}), None),
            "blender.exr": (exr({**{f"View.Combined.{c}": channel for c in "RGB"}, "View.Depth.Z": depth}), None),
        }
        for name, (content, options) in forms.items():
            with self.subTest(form=name):
                self.photo = self.write(name, content)
                seen = self.see(*(["--depth", self.folder / "d.pfm"] + options if options is not None else []))
                difference = max(abs(a - b) for r, s in zip(seen, expected) for p, q in zip(r, s) for a, b in zip(p, q))
                self.assertLessEqual(difference, 1)
        # RGBE has eight bits of mantissa: 128 · 2^(e − 136) is 0.5, where sRGB has 188.
        self.photo = self.write("flat.hdr", radiance(f"-Y {HEIGHT} +X {WIDTH}", [(128, 128, 128, 128)] * (WIDTH * HEIGHT)))
        self.assertEqual(self.see("--distance-m", "1")[20][20], (188, 188, 188))

    def test_other_primaries_are_converted(self):
        """Green of Rec. 2020 is beyond Rec. 709: its red is negative there, and counts as dark."""
        zero, half = [[0.0] * WIDTH] * HEIGHT, [[0.5] * WIDTH] * HEIGHT
        rec2020 = (0.708, 0.292, 0.17, 0.797, 0.131, 0.046, 0.3127, 0.3290)
        self.photo = self.write("wide.exr", exr({"R": zero, "G": half, "B": zero}, chromaticities=rec2020))
        red, green, blue = self.see("--distance-m", "1")[20][20]
        self.assertEqual((red, blue), (0, 0))
        self.assertEqual(green, 198)  # 1.1329 · 0.5 of linear light
        notes = json.loads((self.folder / "seen.manifest.json").read_text())["notes"]
        self.assertTrue(any("chromaticities" in note for note in notes))

    def test_several_pictures_in_a_file_are_listed(self):
        rows = [[0.5] * WIDTH] * HEIGHT
        file = self.write("passes.exr", exr({f"{layer}.{c}": rows for layer in ("A", "B") for c in "RGB"}))
        message = self.refuse(file, "--eye", self.eye, "--vfov-deg", "2", "--distance-m", "1")
        self.assertIn("--picture-layer", message)
        self.assertIn('"A", "B"', message)

    def test_colours_of_exr_files_are_multiplied_by_their_coverage(self):
        """A half-covered picture before a layer. A colour where nothing is covered shows that a file's colours are not multiplied."""
        def seen(level, bare):
            rows = {"R": level, "G": level, "B": level, "A": 0.5, "Z": 1.0}
            channels = {channel: [[value] * WIDTH for _ in range(HEIGHT)] for channel, value in rows.items()}
            channels["A"][0][0], channels["R"][0][0] = 0.0, bare
            self.photo = self.write("half.exr", exr({**channels, "G": channels["R"], "B": channels["R"]}))
            return self.see("--pupil", 0, "--layer", self.folder / "behind.exr")

        behind = {**{c: [[0.8] * WIDTH] * HEIGHT for c in "RGB"}, "Z": [[4.0] * WIDTH] * HEIGHT}
        self.write("behind.exr", exr(behind))
        multiplied = seen(0.2, 0.0)
        self.assertEqual(multiplied, seen(0.4, 0.4))
        self.assertEqual(multiplied[20][20], (203,) * 3)  # 0.2 + 0.5 · 0.8 of linear light
        self.assertEqual(multiplied[0][0], (231,) * 3)  # 0.8
        self.assertEqual(seen(0.4, 0.0)[20][20], (231,) * 3)  # 0.4 + 0.4

    def test_what_a_picture_does_not_cover_is_black(self):
        """A square that is half covered, in the picture's own field of a colour that must not show."""
        def seen(name, inside, around):
            inner = lambda x, y: abs(x - WIDTH // 2) < 8 and abs(y - HEIGHT // 2) < 8  # noqa: E731
            self.photo = self.write(name, png([[inside if inner(x, y) else around for x in range(WIDTH)] for y in range(HEIGHT)]))
            return self.see("--distance-m", "1")

        grey = 188  # half of white in linear light
        opaque = seen("opaque.png", (grey, grey, grey, 255), (0, 0, 0, 255))
        notes = json.loads((self.folder / "seen.manifest.json").read_text())["notes"]
        self.assertEqual(notes, [])
        transparent = seen("transparent.png", (255, 255, 255, 128), (255, 255, 255, 0))
        self.assertLessEqual(max(abs(a - b) for r, s in zip(opaque, transparent) for p, q in zip(r, s) for a, b in zip(p, q)), 1)
        notes = json.loads((self.folder / "seen.manifest.json").read_text())["notes"]
        self.assertTrue(any(f"{WIDTH * HEIGHT} pixels are transparent" in note for note in notes), notes)

    def test_a_wave_stated_for_another_light_is_noted(self):
        wave = {"coefficients_um": {"12": 0.1}, "pupil_diameter_mm": 5}
        for stated, more in ((None, None), (555, None), (850, "-0.86 D")):
            wavefront = dict(wave, wavelength_nm=stated) if stated else wave
            self.eye = self.write("eye.json", {"format": "sturm.eye/1", "wavefront": wavefront, "pupil_diameter_mm": 5})
            self.see("--distance-m", "1")
            notes = json.loads((self.folder / "seen.manifest.json").read_text())["notes"]
            self.assertEqual([more in note and "850" in note for note in notes], [True] if more else [])

    def test_a_slanted_plane_has_no_steps(self):
        """From 0.3 m at the top to 10 m at the bottom; a ramp of light across the slant stays a ramp. A pixel is 1/28°, so that the kernel
        grows by 13 px on the way."""
        width, height, margin = 96, 160, 24
        ramp = [[0.2 + 0.6 * x / (width - 1) for x in range(width)] for _ in range(height)]
        dioptres = [[3.3333 + (0.1 - 3.3333) * y / (height - 1)] * width for y in range(height)]
        self.photo = self.write("ramp.pfm", pfm(ramp))
        eye = self.write("astigmat.json", dict(MYOPE, prescription={"sphere_D": -1, "cylinder_D": -1, "axis_deg": 30, "vertex_distance_mm": 0}))
        self.succeed("see", self.photo, "--eye", eye, "--hfov-deg", width / 28, "--depth", self.write("slant.pfm", pfm(dioptres)), "--depth-unit", "D",
                     "--png-bits", "16", "-o", self.folder / "slant.png")
        seen = [[to_linear(v) for v in row] for row in grey16((self.folder / "slant.png").read_bytes())]
        inside = [(x, y) for y in range(margin, height - margin) for x in range(margin, width - margin)]
        square = sum((seen[y][x] - ramp[y][x]) ** 2 for x, y in inside) / len(inside)
        self.assertLessEqual(math.sqrt(square), 0.002)
        self.assertLessEqual(max(abs(seen[y][x] - seen[y - 1][x]) for x, y in inside), 1 / 255)

    def test_a_png_may_have_16_bits(self):
        self.photo = self.write("flat.pfm", pfm([[0.3] * WIDTH] * HEIGHT))
        self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "--distance-m", "1", "--png-bits", "16", "-o", self.folder / "A.PNG")
        value = grey16((self.folder / "A.PNG").read_bytes())[20][20]
        self.assertAlmostEqual(to_linear(value), 0.3, delta=2e-5)  # a step of 16 bits is 1.5e-5 of the display's range

    def test_what_was_asked_for_follows_its_schema(self):
        depth = self.write("d.pfm", pfm(two_distances(0.5, 10.0)))
        for options in (["--depth", depth, "--rack-focus-D", "0", "1", "--frames", "2"], ["--distance-m", "inf", "--focus-m", "2"],
                        ["--depth", depth, "--disparity", "--focal-px", "1000", "--baseline-m", "0.1"]):
            self.see_quietly(*options)
            spec = json.loads((self.folder / "seen.manifest.json").read_text())["spec"]
            self.assertEqual(spec["format"], "sturm.see/1")
            self.succeed("validate", self.write("spec.json", spec))

    def test_the_number_of_parts_is_the_one_that_help_states(self):
        self.see_quietly("--distance-m", "2")
        parts = json.loads((self.folder / "seen.manifest.json").read_text())["spec"]["parts"]
        self.assertIn(f"on their own (default: {parts})", " ".join(self.succeed("see", "--help").stdout.split()))

    LINES = (["--distance-m", "inf", "--focus-m", "2"], ["--distance-m", "0.7", "--focus-D", "1.5", "--parts", "3", "--exposure", "1.7"],
             ["--depth", "m.pfm"], ["--depth", "mm.png", "--pupil-mm", "4", "--error", "0.004"], ["--depth", "mm.png", "--depth-scale", "0.001", "--chromatic"],
             ["--depth", "d.pfm", "--depth-unit", "D", "--psf", "waves"], ["--depth", "m.pfm", "--layer", "behind.exr", "--png-bits", "16"],
             ["--depth", "mm.png", "--layer", "behind.exr"], ["--depth", "disparity.pfm", "--disparity", "--focal-px", "1000", "--baseline-m", "0.1", "--doffs-px", "5"],
             ["--disparity", "disparity.pfm", "--focal-px", "1000", "--baseline-m", "0.1"], ["--rx", "+1.50 -0.75 x 170", "--vertex", "0", "--depth", "m.pfm"],
             ["--rx", "-2.00 DS", "--set", "/parts=2", "--set", "/eye/pupil_diameter_mm=3", "--depth", "m.pfm"])

    def write_depth(self):
        metres = two_distances(0.5, 4.0)
        self.write("m.pfm", pfm(metres))
        self.write("mm.png", png([[round(1000 * d) for d in row] for row in metres], 16))
        self.write("d.pfm", pfm([[1 / d for d in row] for row in metres]))
        self.write("disparity.pfm", pfm([[100 / d - 5 for d in row] for row in metres]))
        level = [[0.25] * WIDTH for _ in range(HEIGHT)]
        self.write("behind.exr", exr({**{c: level for c in "RGB"}, "Z": [[6.0] * WIDTH for _ in range(HEIGHT)]}))

    def bytes_of(self, *arguments, output):
        self.succeed("see", *arguments, "-o", output, cwd=self.folder)
        return {path.name: path.read_bytes() for path in self.folder.glob("seen*") if path.suffix in (".png", ".exr")}

    def test_a_line_and_its_document_give_the_same_bytes(self):
        """So does what stands in the manifest; an EXR file has what was asked for in an attribute."""
        self.write_depth()
        for options in self.LINES:
            line = ["photo.png", *(["--eye", "eye.json"] if "--rx" not in options else []), "--vfov-deg", "2", *options]
            output = "seen.png" if "--png-bits" in options else "seen.exr"
            with self.subTest(options=options):
                by_line = self.bytes_of(*line, output=output)
                spec = json.loads((self.folder / "seen.manifest.json").read_text())["spec"]
                self.write("line.json", self.succeed("see", *line, "--print-config", cwd=self.folder).stdout)
                self.assertEqual(self.bytes_of("line.json", output=output), by_line)
                self.write("spec.json", spec)
                self.assertEqual(self.bytes_of("spec.json", output=output), by_line)
                self.assertEqual(json.loads((self.folder / "seen.manifest.json").read_text())["spec"], spec)

    def test_a_sequence_of_a_document_is_that_of_the_line(self):
        self.write_depth()
        line = ["photo.png", "--eye", "eye.json", "--hfov-deg", "2", "--depth", "m.pfm", "--rack-focus-D", "0", "1.7", "--pupil-sequence-mm", "5", "3", "--frames", "3"]
        by_line = self.bytes_of(*line, output="seen.png")
        self.assertEqual(sorted(by_line), ["seen_0001.png", "seen_0002.png", "seen_0003.png"])
        self.write("line.json", self.succeed("see", *line, "--print-config", cwd=self.folder).stdout)
        self.assertEqual(self.bytes_of("line.json", output="seen.png"), by_line)

    def test_options_change_a_document(self):
        """A document in another folder names files from there, the line from the working directory."""
        self.write_depth()
        self.write("sub/photo.png", self.photo.read_bytes())
        document = {"format": "sturm.see/1", "picture": "photo.png", "eye": MYOPE, "hfov_deg": 20, "distance_m": 1, "parts": 2}
        self.write("sub/view.json", document)
        expected = self.bytes_of("photo.png", "--eye", "eye.json", "--vfov-deg", "2", "--depth", "m.pfm", "--pupil", "3", "--focus-D", "1", "--parts", "2", output="seen.png")
        changes = ["--vfov-deg", "2", "--depth", "m.pfm", "--pupil", "3", "--focus-D", "1"]
        self.assertEqual(self.bytes_of("sub/view.json", *changes, output="seen.png"), expected)
        self.write("other.json", dict(MYOPE, pupil_diameter_mm=7))
        self.assertNotEqual(self.bytes_of("sub/view.json", *changes[:4], "--eye", "other.json", output="seen.png"), expected)
        self.assertEqual(self.bytes_of("sub/view.json", "--eye", "eye.json", *changes, output="seen.png"), expected)
        text = json.dumps({**document, "picture": str(self.photo)})
        process = sturm("see", "-", *changes, "-o", self.folder / "seen.png", stdin=text, cwd=self.folder)
        self.assertEqual((process.returncode, (self.folder / "seen.png").read_bytes()), (0, expected["seen.png"]), process.stderr)

    def test_what_is_wrong_with_a_document(self):
        good = {"format": "sturm.see/1", "picture": "photo.png", "eye": MYOPE, "vfov_deg": 2, "distance_m": 1}
        self.write_depth()
        for expected, changes in [("/picture", {"picture": "none.png"}), ("/depth/file", {"distance_m": None, "depth": {"file": "none.pfm"}}),
                                  ("/layers/1", {"layers": ["behind.exr", "none.exr"]}), ("/distance_m", {"depth": {"file": "m.pfm"}}),
                                  ("calibration", {"distance_m": None, "depth": {"file": "m.pfm", "unit": "disparity"}}),
                                  ("stereo", {"stereo": {"focal_px": 1, "baseline_m": 1}}), ("/hfov_deg", {"hfov_deg": 3}), ("/frames", {"frames": 3}),
                                  ("/eye/pupil_diameter_mm", {"eye": dict(MYOPE, pupil_diameter_mm=-1)}), ("/parts", {"parts": 65}),
                                  ("/eye/accommodation", {"distance_m": None, "depth": {"file": "m.pfm"}, "eye": dict(MYOPE, accommodation={"mode": "best", "amplitude_D": 3})}),
                                  ("partz", {"partz": 3}), ("sturm ellipse", {"format": "sturm.ellipse/1"})]:
            with self.subTest(expected=expected):
                document = {key: value for key, value in {**good, **changes}.items() if value is not None}
                message = self.refuse(self.write("view.json", document))
                self.assertIn(expected, message)
                self.assertIn("view.json", message)

    def see_quietly(self, *arguments):
        self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "-o", self.folder / "seen.png", *arguments)

    def test_films(self):
        """ffmpeg is a stand-in here that writes down how it was called."""
        usual = ["see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "--distance-m", "2", "--rack-focus-D", "0", "1", "--frames", "2",
                 "--film", "-o", self.folder / "rack.png"]
        before, path = snapshot(self.folder), os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = str(self.folder)
        process = sturm(*usual)
        self.assertEqual(process.returncode, RUNTIME_FAILURE)
        self.assertIn("ffmpeg", process.stderr)
        self.assertEqual(snapshot(self.folder), before)
        self.write("ffmpeg", '#!/bin/sh\nfor last; do :; done\ncase $last in *.mp4) echo "$@" > "$last";; esac\n').chmod(0o755)
        self.succeed(*usual)
        self.assertIn(f"-i {self.folder}/rack_%04d.png", (self.folder / "rack.mp4").read_text())
        self.assertFalse((self.folder / "rack.unfinished.mp4").exists())
        self.assertEqual(json.loads((self.folder / "rack.manifest.json").read_text())["counters"]["film"], "rack.mp4")
        self.assertIn("--film", self.refuse(self.photo, "--eye", self.eye, "--vfov-deg", "2", "--distance-m", "2", "--film"))

    def test_a_myope_sees_near_things_sharply(self):
        seen, sharp = self.see("--depth", self.write("d.pfm", pfm(two_distances(0.5, 10.0)))), board()
        self.assertEqual([row[: WIDTH // 2 - 12] for row in seen], [row[: WIDTH // 2 - 12] for row in sharp])
        far = [row[-10:] for row in seen]
        self.assertLess(max(p[0] for row in far for p in row) - min(p[0] for row in far for p in row), 139)

    def test_holes_are_filled_and_reported(self):
        rows = two_distances(0.5, 10.0)
        rows[5][30] = rows[6][30] = 0.0
        self.see("--depth", self.write("d.pfm", pfm(rows)))
        manifest = json.loads((self.folder / "seen.manifest.json").read_text())
        self.assertEqual(manifest["counters"]["filled_holes"], 2)
        self.assertTrue(any("without depth" in note for note in manifest["notes"]))

    def test_light_is_added_in_linear_space(self):
        """Far out of focus the squares become the mean of their light, not of their numbers."""
        seen = self.see("--distance-m", "inf", "--pupil-mm", "9", "--focus-D", "8")
        middle = to_linear(seen[HEIGHT // 2][WIDTH // 2][0] / 255)
        self.assertAlmostEqual(middle, 0.5 * (to_linear(200 / 255) + to_linear(60 / 255)), delta=0.02)

    def test_of_a_sequence_that_cannot_be_finished_nothing_is_written(self):
        message = self.refuse(self.photo, "--rx=0", "--vfov-deg", "0.2", "--distance-m", "6", "--rack-focus-D", "0", "40", "--frames", "5")
        self.assertIn("the blur reaches", message)
        message = self.refuse(self.photo, "--rx=-1", "--psf", "waves", "--vfov-deg", "0.01", "--distance-m", "6")
        self.assertIn("the blur reaches", message)

    def test_an_error_that_no_number_of_parts_reaches_is_refused(self):
        message = self.refuse(self.photo, "--eye", self.eye, "--vfov-deg", "2", "--distance-m", "1", "--error", "0.001")
        self.assertIn("at least 0.002", message)

    def test_sequences_and_explanations(self):
        depth = self.write("d.pfm", pfm(two_distances(0.5, 10.0)))
        self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "--depth", depth, "--rack-focus-D", "0", "2",
                     "--frames", "3", "-o", self.folder / "rack.png")
        for name in ("rack_0001.png", "rack_0002.png", "rack_0003.png", "rack.manifest.json"):
            self.assertTrue((self.folder / name).is_file(), name)
        before = snapshot(self.folder)
        text = self.succeed("see", self.photo, "--eye", self.eye, "--vfov-deg", "2", "--depth", depth, "--explain").stdout
        self.assertIn("2 planes", text)
        self.assertEqual(snapshot(self.folder), before)

    def test_a_sharp_picture_costs_no_more_than_reading_and_writing_it(self):
        """In focus, and through a pinhole with half of it at another distance: every layer of every tile is empty or copied."""
        state, rows = 1, []
        for _ in range(480):  # noise, so that files do not shrink
            row = []
            for _ in range(640):
                state = state * 1103515245 + 12345 & 0x7FFFFFFF
                row.append((state >> 23, state >> 15 & 255, state >> 7 & 255))
            rows.append(row)
        photo = self.write("noise.png", png_pixels.encode(rows))
        depth = self.write("halves.pfm", pfm([[0.5 if x < 320 else 4.0 for x in range(640)]] * 480))
        for options in (["--pupil-mm", 5.7, "--distance-m", 0.5], ["--pupil-mm", 0, "--depth", depth]):
            self.succeed("see", photo, "--rx", "plano", "--focus-m", 0.5, "--vfov-deg", 28, *options, "-o", self.folder / "sharp.exr")
            manifest = json.loads((self.folder / "sharp.manifest.json").read_text())
            [frame] = manifest["counters"]["frames"]
            self.assertEqual([frame[f"layers_{work}"] for work in ("covered", "spatial", "transform")], [0, 0, 0])
            seconds = manifest["provenance"]["seconds"]
            seeing = sum(seconds[part] for part in ("kernels", "hidden_surfaces", "blur"))
            self.assertLess(seeing, seconds["total"] - seeing)

    def test_names_need_not_be_utf8(self):
        """A file's name in Latin-1 stands in the manifest, with a replacement character."""
        picture = os.fsencode(self.folder) + b"/gr\xfcn.png"
        with open(picture, "wb") as file:
            file.write(png(board()))
        process = sturm("see", os.fsdecode(picture), "--distance-m", 1, "--eye", self.folder / "eye.json", "--vfov-deg", 2,
                        "-o", self.folder / "named.png")
        self.assertEqual(process.returncode, 0, process.stderr)
        manifest = strict_json((self.folder / "named.manifest.json").read_text())
        self.assertTrue(manifest["spec"]["picture"].endswith("gr\ufffdn.png"))

    def test_wrong_input_is_refused_and_nothing_is_written(self):
        usual = [self.photo, "--eye", self.eye, "--vfov-deg", "2"]
        good = self.write("good.pfm", pfm(two_distances(0.5, 10.0)))
        grey, gap = ([[value] * WIDTH] * HEIGHT for value in (0.5, math.nan))
        for expected, arguments in [
            ("40 x 20 pixels", ["--depth", self.write("small.pfm", pfm([[1.0] * 40] * 20))]),
            ("-1", ["--depth", self.write("negative.pfm", pfm(two_distances(-1.0, 1.0)))]),
            ("nan", ["--depth", self.write("nan.pfm", pfm(two_distances(math.nan, 1.0)))]),
            ("8 bits", ["--depth", self.write("eight.png", png([[9] * WIDTH] * HEIGHT, 8))]),
            ("in colour", ["--depth", self.write("colour.png", png_pixels.encode([[(1, 2, 3)] * WIDTH] * HEIGHT))]),
            ("no depth", []),
            ("calibration", ["--depth", good, "--disparity"]),
            ("no pixel with a depth", ["--depth", self.write("empty.pfm", pfm(two_distances(0.0, 0.0)))]),
            ("there is no file", ["--depth", self.folder / "none.pfm"]),
            ("break off", ["--depth", self.write("broken.pfm", b"Pf\n48 40\n-1.0\nshort")]),
            ("distance", ["--distance-m", "-3"]),
            ("--focus-D: got nan", ["--distance-m", "2", "--focus-D", "nan"]),
            ("--rack-focus-D: got nan", ["--distance-m", "2", "--rack-focus-D", "0", "nan"]),
            ("nan in A", ["--distance-m", "2", "--layer", self.write("gap.exr", exr({"R": grey, "G": grey, "B": grey, "Z": grey, "A": gap}))]),
        ]:
            with self.subTest(expected=expected):
                self.assertIn(expected, self.refuse(*usual, *arguments))
        self.assertIn("field of view", self.refuse(self.photo, "--eye", self.eye, "--depth", good))
        hofer = SOURCE / "configs/eyes/hofer_5.json"
        self.assertIn("pupil_diameter_mm", self.refuse(self.photo, "--eye", hofer, "--vfov-deg", "2", "--depth", good, "--pupil-mm", "7"))
        best = self.write("best.json", dict(MYOPE, accommodation={"mode": "best", "amplitude_D": 3}))
        self.assertIn("accommodation", self.refuse(self.photo, "--eye", best, "--vfov-deg", "2", "--depth", good))


if __name__ == "__main__":
    unittest.main()
