"""Pictures as environments and textures: which numbers are light, which way is up, and what is no light."""
import json
import math
import unittest

import exr_header
import picture_files as files
from sturm_process import WRONG_INPUT, FolderTest, sturm

SIDE = 32
WIDTH, HEIGHT = 16, 8


def srgb_to_linear(v):
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


def view(scene, **changes):
    document = {"format": "sturm.render/1", "scene": scene, "eye": {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 0},
                "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 90, "resolution": [SIDE, SIDE]},
                "method": {"type": "path_trace", "ray_model": "pinhole", "samples_per_pixel": 1, "max_bounces": 1}}
    document.update(changes)
    return document


class Rendered(FolderTest):
    def render(self, scene):
        self.write("view.json", view(scene))
        self.succeed("render", "view.json", "-o", "view.exr", "--quiet", cwd=self.folder)
        self.notes = json.loads((self.folder / "view.manifest.json").read_text())["notes"]
        return exr_header.float_pixels((self.folder / "view.exr").read_bytes())

    def refuse(self, scene, *named):
        self.write("view.json", view(scene))
        process = sturm("render", "view.json", "-o", "refused.exr", "--quiet", cwd=self.folder)
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        for text in named:
            self.assertIn(text, process.stderr)
        self.assertFalse((self.folder / "refused.exr").exists())


class Environments(Rendered):
    def sky(self, **environment):
        """Seen at 45 degrees up, down, to the left and to the right, in the middle of each side of the picture."""
        scene = {"environment": environment, "materials": {"m": {}}, "spheres": [{"center_m": [0, -1e4, 0], "radius_m": 0.01, "material": "m"}]}
        rows = self.render(scene)
        at = lambda x, y: tuple(rows[c][y][x] for c in "RGB")
        middle = SIDE // 2
        return {"up": at(middle, 1), "down": at(middle, SIDE - 2), "left": at(1, middle), "right": at(SIDE - 2, middle)}

    def quarters(self):
        """Four colours: the upper and lower halves left and right of the centre."""
        return [[(1.0, 0.5, 0.25) if x < WIDTH // 2 else (0.5, 1.0, 0.25) for x in range(WIDTH)] if y < HEIGHT // 2 else
                [(0.25, 0.5, 1.0) if x < WIDTH // 2 else (1.0, 1.0, 1.0) for x in range(WIDTH)] for y in range(HEIGHT)]

    def test_radiance_in_all_eight_orders(self):
        rows = [[tuple(int(v * 128) for v in pixel) + (129,) for pixel in row] for row in self.quarters()]
        columns = [list(column) for column in zip(*rows)]
        for sizes, lines in [("-Y {h} +X {w}", rows), ("-Y {h} -X {w}", [row[::-1] for row in rows]), ("+Y {h} +X {w}", rows[::-1]),
                             ("+Y {h} -X {w}", [row[::-1] for row in rows[::-1]]), ("+X {w} -Y {h}", columns), ("-X {w} -Y {h}", columns[::-1]),
                             ("+X {w} +Y {h}", [column[::-1] for column in columns]), ("-X {w} +Y {h}", [column[::-1] for column in columns[::-1]])]:
            with self.subTest(sizes):
                self.write("sky.hdr", files.radiance(sizes.format(w=WIDTH, h=HEIGHT), [pixel for line in lines for pixel in line]))
                scene = {"environment": {"file": "sky.hdr"}, "materials": {"m": {}}, "spheres": [{"center_m": [0, -1e4, 0], "radius_m": 0.01, "material": "m"}]}
                picture = self.render(scene)
                for x, y, expected in [(4, 4, (1.0, 0.5, 0.25)), (28, 4, (0.5, 1.0, 0.25)), (4, 28, (0.25, 0.5, 1.0)), (28, 28, (1.0, 1.0, 1.0))]:
                    self.assertEqual(tuple(picture[c][y][x] for c in "RGB"), expected)

    def test_radiance_header(self):
        pixels = [(64, 128, 255, 129)] * (WIDTH * HEIGHT)
        sizes = f"-Y {HEIGHT} +X {WIDTH}"
        plain = (0.5, 1.0, 255 / 128)
        for variables, expected in [((), plain), (("EXPOSURE=4",), tuple(v / 4 for v in plain)),
                                    (("COLORCORR=2 1 0.5",), (0.25, 1.0, 255 / 64)), (("EXPOSURE=2", "COLORCORR=1 2 1"), (0.25, 0.25, 255 / 256)),
                                    (("PRIMARIES=0.64 0.33 0.30 0.60 0.15 0.06 0.3127 0.329",), plain)]:
            with self.subTest(variables):
                self.write("sky.hdr", files.radiance(sizes, pixels, variables))
                for got, wanted in zip(self.sky(file="sky.hdr")["up"], expected):
                    self.assertAlmostEqual(got, wanted, delta=1e-6)
                self.assertEqual(len(self.notes), len([v for v in variables if not v.startswith("PRIMARIES")]))
        # White of the format's own primaries is white here.
        self.write("sky.hdr", files.radiance(sizes, [(128, 128, 128, 129)] * len(pixels), ["PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.3333 0.3333"]))
        for got in self.sky(file="sky.hdr")["up"]:
            self.assertAlmostEqual(got, 1.0, delta=1e-6)
        self.write("sky.hdr", files.radiance(sizes, pixels).replace(b"rle_rgbe", b"rle_xyze"))
        self.refuse({"environment": {"file": "sky.hdr"}}, "sky.hdr", "xyze")

    def test_old_run_lengths(self):
        """Each line is one pixel, repeated 10 times, and another, repeated 4 times."""
        line = [(128, 64, 64, 129), (1, 1, 1, 7), (64, 64, 128, 129), (1, 1, 1, 7)]
        self.write("sky.hdr", files.radiance(f"-Y {HEIGHT} +X {WIDTH}", line * HEIGHT))
        seen = self.sky(file="sky.hdr")
        self.assertEqual((seen["left"], seen["right"]), ((1.0, 0.5, 0.5), (0.5, 0.5, 1.0)))
        self.write("sky.hdr", files.radiance(f"-Y {HEIGHT} +X {WIDTH}", [(1, 1, 1, 7), *line[1:]] * HEIGHT))
        self.refuse({"environment": {"file": "sky.hdr"}}, "sky.hdr", "run")

    def test_new_run_lengths(self):
        def component(left, right):
            return bytes([128 + 8, left, 8, *[right] * 8])
        line = bytes([2, 2, 0, WIDTH]) + component(128, 64) + component(64, 64) + component(64, 128) + component(129, 129)
        head = files.radiance(f"-Y {HEIGHT} +X {WIDTH}", [])
        self.write("sky.hdr", head + line * HEIGHT)
        seen = self.sky(file="sky.hdr")
        self.assertEqual((seen["left"], seen["right"]), ((1.0, 0.5, 0.5), (0.5, 0.5, 1.0)))
        self.write("sky.hdr", head + line.replace(bytes([128 + 8]), bytes([128 + 17])) * HEIGHT)
        self.refuse({"environment": {"file": "sky.hdr"}}, "sky.hdr", "run")

    def test_formats(self):
        rows = self.quarters()
        channels = {c: [[pixel[i] for pixel in row] for row in rows] for i, c in enumerate("RGB")}
        for name, content in [("sky.exr", files.exr(channels)), ("sky.EXR", files.exr({f"World.{c}": v for c, v in channels.items()})),
                              ("sky.exr", files.exr({**channels, "A": channels["R"]})), ("sky.pfm", files.pfm(rows)), ("sky.tif", files.float_tiff(rows)),
                              ("sky.exr", files.exr_parts({"rgba": channels}))]:
            with self.subTest(name):
                self.write(name, content)
                self.sky(file=name)
                rows_seen = exr_header.float_pixels((self.folder / "view.exr").read_bytes())
                self.assertEqual([tuple(rows_seen[c][4][x] for c in "RGB") for x in (4, 28)], [(1.0, 0.5, 0.25), (0.5, 1.0, 0.25)])

    def test_eight_bits_are_decoded(self):
        self.write("sky.png", files.png([[(128, 51, 255)] * WIDTH] * HEIGHT))
        for encoding, expected in [({}, [srgb_to_linear(v / 255) for v in (128, 51, 255)]), ({"encoding": "srgb"}, [srgb_to_linear(v / 255) for v in (128, 51, 255)]),
                                   ({"encoding": "linear"}, [128 / 255, 51 / 255, 1.0])]:
            for got, wanted in zip(self.sky(file="sky.png", **encoding)["up"], expected):
                self.assertAlmostEqual(got, wanted, delta=1e-6)
        self.write("sky.exr", files.exr(dict.fromkeys("RGB", [[0.5] * WIDTH] * HEIGHT)))
        self.assertEqual(self.sky(file="sky.exr", encoding="srgb")["up"], (0.5, 0.5, 0.5))

    def test_a_layer_is_chosen(self):
        one, half = ([[v] * WIDTH] * HEIGHT for v in (1.0, 0.5))
        self.write("sky.exr", files.exr({**{f"a.{c}": one for c in "RGB"}, **{f"b.{c}": half for c in "RGB"}}))
        self.refuse({"environment": {"file": "sky.exr"}}, "sky.exr", '"a"', '"b"', "layer")
        self.assertEqual(self.sky(file="sky.exr", layer="b")["up"], (0.5, 0.5, 0.5))

    def test_what_is_no_light(self):
        for value, shown in ((-0.001, "-0.001"), (math.inf, "inf"), (-math.inf, "-inf"), (math.nan, "nan")):
            with self.subTest(shown):
                rows = [[1.0] * WIDTH for _ in range(HEIGHT)]
                rows[2][5] = rows[3][5] = value
                self.write("sky.exr", files.exr({"R": rows, "G": [[1.0] * WIDTH] * HEIGHT, "B": [[1.0] * WIDTH] * HEIGHT}))
                self.refuse({"environment": {"file": "sky.exr"}}, "sky.exr", "(5, 2)", shown + " in R", "clamp")
                if math.isnan(value):
                    self.refuse({"environment": {"file": "sky.exr", "clamp": True}}, "sky.exr", "(5, 2)", "nan")
                    continue
                for clamp in (True, 100):
                    self.sky(file="sky.exr", clamp=clamp)
                    limit = "65504" if clamp is True else "100"
                    self.assertEqual(self.notes, [f"sky.exr: 2 pixels with values below 0 clamped to 0" if value < 0 else
                                                  f"sky.exr: 2 pixels with values above {limit} clamped to it"])
        self.refuse({"environment": {"file": "sky.exr", "clamp": -1}}, "/scene/environment/clamp", "-1")


class Textures(Rendered):
    def albedo(self, name, **model):
        """Of a square over the whole view with this texture, at its middle and near its upper left corner."""
        self.write("m.mtl", f"newmtl m\nKd 1 1 1\nmap_Kd {name}\n")
        self.write("m.obj", "mtllib m.mtl\nv -2 -2 -2\nv 2 -2 -2\nv 2 2 -2\nv -2 2 -2\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n")
        return {"models": [{"file": "m.obj", **model}], "lights": [{"type": "point", "position_m": [0, 0, 0], "intensity": [1, 1, 1]}]}

    def seen(self, name, **model):
        rows = self.render(self.albedo(name, **model))
        return tuple(rows[f"albedo.{c}"][SIDE // 2][SIDE // 2] for c in "RGB")

    def expect(self, seen, wanted):
        for a, b in zip(seen, wanted):
            self.assertAlmostEqual(a, b, delta=1e-6)

    def test_floats_are_linear(self):
        colour = (0.5, 0.25, 0.125)
        rows = [[colour] * 4] * 4
        channels = {c: [[colour[i]] * 4] * 4 for i, c in enumerate("RGB")}
        for name, content in [("t.exr", files.exr(channels)), ("t.exr", files.exr({**channels, "A": channels["R"]})),
                              ("t.exr", files.exr({c: (files.HALF, v) for c, v in channels.items()})),
                              ("t.hdr", files.radiance("-Y 4 +X 4", [(128, 64, 32, 128)] * 16)), ("t.pfm", files.pfm(rows)), ("t.tif", files.float_tiff(rows)),
                              ("t.png", files.exr(channels)), ("T.HDR", files.radiance("+Y 4 +X 4", [(128, 64, 32, 128)] * 16))]:
            for encoding in ("srgb", "linear"):
                with self.subTest(name, encoding=encoding):
                    self.write(name, content)
                    self.expect(self.seen(name, texture_encoding=encoding), colour)

    def test_integers_are_decoded(self):
        self.write("t.png", files.png([[(128, 64, 32)] * 4] * 4))
        self.expect(self.seen("t.png"), [srgb_to_linear(v / 255) for v in (128, 64, 32)])
        self.expect(self.seen("t.png", texture_encoding="linear"), [v / 255 for v in (128, 64, 32)])
        self.write("t.png", files.png([[(32896, 257 * 64)] * 4] * 4, depth=16))
        self.expect(self.seen("t.png"), [srgb_to_linear(32896 / 65535)] * 3)

    def test_what_is_no_reflectance(self):
        for value, shown in ((-0.25, "-0.25"), (math.inf, "inf"), (math.nan, "nan")):
            rows = [[0.5] * 4 for _ in range(4)]
            rows[1][2] = value
            for name, content in [("t.exr", files.exr({"R": [[0.5] * 4] * 4, "G": rows, "B": rows})),
                                  ("t.pfm", files.pfm([[(0.5, v, v) for v in row] for row in rows]))]:
                with self.subTest(name, value=shown):
                    self.write(name, content)
                    self.refuse(self.albedo(name), name, "(2, 1)", shown + " in G")

    def test_a_picture_that_needs_a_choice(self):
        half = [[0.5] * 4] * 4
        self.write("t.exr", files.exr({f"{layer}.{c}": half for layer in ("a", "b") for c in "RGB"}))
        self.refuse(self.albedo("t.exr"), "t.exr", '"a"', '"b"')
        self.write("t.exr", files.exr({"Y": half}))
        self.expect(self.seen("t.exr"), (0.5, 0.5, 0.5))


if __name__ == "__main__":
    unittest.main()
