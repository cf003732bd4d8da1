"""Pictures of other programs: what `sturm compare` makes of them, and what they are as environments and textures."""
import base64
import math
import random
import resource
import struct
import unittest
import zlib

import picture_files as files
from srgb import srgb_to_linear
from sturm_process import WRONG_INPUT, FolderTest, strict_json, sturm

WIDTH, HEIGHT = 16, 12


def noise(seed, width=WIDTH, height=HEIGHT):
    """Rows of numbers that halves hold exactly."""
    numbers = random.Random(seed)
    return [[numbers.randrange(1, 256) / 256 for _ in range(width)] for _ in range(height)]


def colours(seed):
    return dict(zip("RGB", (noise(seed), noise(seed + 1), noise(seed + 2))))


def rmse(a, b):
    """Over all pixels and channels of two {R, G, B}."""
    squares = [(u - v) ** 2 for c in "RGB" for p, q in zip(a[c], b[c]) for u, v in zip(p, q)]
    return math.sqrt(sum(squares) / len(squares))


def renamed(channels, pattern):
    return {pattern.format(name): rows for name, rows in channels.items()}


def tuples(channels):
    return [list(zip(*rows)) for rows in zip(*(channels[c] for c in "RGB"))]


A, B = colours(1), colours(10)


class Compared(FolderTest):
    def setUp(self):
        super().setUp()
        self.write("b.exr", files.exr(B))

    def compared(self, name, content, *options, reference="b.exr"):
        self.write(name, content)
        return strict_json(self.succeed("compare", name, reference, "--json", "-", *options, cwd=self.folder).stdout)

    def refused(self, name, content, *named, options=(), reference="b.exr"):
        self.write(name, content)
        process = sturm("compare", name, reference, *options, cwd=self.folder)
        self.assertEqual(process.returncode, WRONG_INPUT, process.stdout + process.stderr)
        for text in named:
            self.assertIn(text, process.stderr)
        self.assertEqual(process.stdout, "")

    def expect_a(self, result, delta=1e-7):  # single precision
        self.assertAlmostEqual(result["metrics"]["rmse_linear"], rmse(A, B), delta=delta)


class Layers(Compared):
    def test_channels_by_whatever_name(self):
        grey = noise(20)
        for name, channels in [("plain", A), ("alpha", {**A, "A": grey}), ("leading dot", renamed(A, ".{}")), ("alpha and dot", renamed({**A, "A": grey}, ".{}")),
                               ("small letters", {k.lower(): v for k, v in A.items()}), ("a layer", renamed(A, "rgb.{}")),
                               ("Blender", {**renamed({**A, "A": grey}, "ViewLayer.Combined.{}"), "ViewLayer.Depth.Z": grey}),
                               ("words", dict(zip(("red", "green", "blue"), A.values()))),
                               ("main before others", {**A, **renamed(B, "diffuse.{}"), "id": grey}),
                               ("capitals before small letters", {**A, **{k.lower(): v for k, v in B.items()}})]:
            with self.subTest(name):
                result = self.compared("a.exr", files.exr(channels))
                self.expect_a(result)
                self.assertEqual(result["conditions"]["test_values"], "linear")

    def test_types_may_be_mixed(self):
        mixed = {"R": (files.HALF, A["R"]), "G": (files.FLOAT, A["G"]), "B": (files.HALF, A["B"]), "id": (files.UINT, [[7] * WIDTH] * HEIGHT)}
        self.expect_a(self.compared("a.exr", files.exr(mixed)))
        whole = {c: (files.UINT, [[3] * WIDTH] * HEIGHT) for c in "RGB"}
        self.assertEqual(self.compared("a.exr", files.exr(whole), reference="a.exr")["metrics"]["rmse_linear"], 0)

    def test_layers_are_chosen_by_name(self):
        two = files.exr({**renamed(A, "ViewLayer.Combined.{}"), **renamed(B, "ViewLayer.DiffCol.{}"), "ViewLayer.Depth.Z": noise(5)})
        self.refused("a.exr", two, "a.exr", '"ViewLayer.Combined"', '"ViewLayer.DiffCol"', "--layer")
        for name in ("ViewLayer.Combined", "viewlayer.combined", "Combined"):
            result = self.compared("a.exr", two, "--layer", name, "--layer", "main" if name == "Combined" else "")
            self.expect_a(result)
            self.assertEqual(result["conditions"]["test_layer"], "ViewLayer.Combined")
        self.assertEqual(self.compared("a.exr", two, "--layer", "ViewLayer.DiffCol", "--layer", "")["metrics"]["rmse_linear"], 0)
        self.refused("a.exr", two, "a.exr", '"Specular"', '"ViewLayer.Combined"', '"ViewLayer.Depth"', options=("--layer", "Specular", "--layer", ""))
        self.write("c.exr", files.exr(renamed(B, "beauty.{}")))
        self.write("d.exr", files.exr(renamed(A, "beauty.{}")))
        both = strict_json(self.succeed("compare", "--layer", "beauty", "d.exr", "c.exr", "--json", "-", cwd=self.folder).stdout)
        self.expect_a(both)
        self.write("e.png", files.png([[(1, 2, 3)] * WIDTH] * HEIGHT))
        self.succeed("compare", "e.png", "c.exr", "--layer", "beauty", cwd=self.folder)
        self.refused("e.png", files.png([[(1, 2, 3)] * WIDTH] * HEIGHT), "--layer", options=("--layer", "beauty"), reference="e.png")

    def test_parts(self):
        self.expect_a(self.compared("a.exr", files.exr_parts({"rgba": A, "depth": {"Z": noise(3)}})))
        self.expect_a(self.compared("a.exr", files.exr_parts({"beauty": A, "depth": {"Z": noise(3)}})))
        alike = self.compared("a.exr", files.exr_parts({"beauty": renamed(A, "beauty.{}"), "depth": {"depth.Z": noise(3)}}))
        self.expect_a(alike)
        self.assertEqual(alike["conditions"]["test_layer"], "beauty")
        two = files.exr_parts({"beauty": A, "diffuse": B})
        self.refused("a.exr", two, "a.exr", '"beauty"', '"diffuse"')
        self.expect_a(self.compared("a.exr", two, "--layer", "beauty", "--layer", ""))
        named = files.exr_parts({"x": renamed(A, "beauty.{}"), "y": renamed(B, "diffuse.{}")})
        self.expect_a(self.compared("a.exr", named, "--layer", "x.beauty", "--layer", ""))
        self.expect_a(self.compared("a.exr", named, "--layer", "beauty", "--layer", ""))

    def test_luminance_alone_is_grey(self):
        grey = noise(30)
        for channels in ({"Y": grey}, {"Y": grey, "A": noise(31)}, {"lum.Y": grey}):
            result = self.compared("a.exr", files.exr(channels))
            self.assertAlmostEqual(result["metrics"]["rmse_linear"], rmse(dict.fromkeys("RGB", grey), B), delta=1e-7)
            self.assertTrue(any("luminance" in note for note in result["notes"]))

    def test_what_is_no_picture_is_refused(self):
        self.refused("a.exr", files.exr({"Z": noise(1)}), "a.exr", "no channels R, G and B", '"Z"')
        self.refused("a.exr", files.exr({"R": noise(1), "G": noise(2)}), "a.exr", "no channels R, G and B")
        self.refused("a.png", files.png([[(1, 2, 3)] * WIDTH] * HEIGHT), "a.png", "layer", options=("--layer", "x", "--layer", ""))

    def test_windows(self):
        """Stored pixels from (2, 1) on, of a display window from (1, 1): the first column is empty, what is beyond is cut."""
        wide = {c: [row + [9.0] for row in rows] for c, rows in A.items()}
        file = files.exr(wide, corner=(2, 1), display=(1, 1, WIDTH, HEIGHT))
        shown = {c: [[0.0] + row[: WIDTH - 1] for row in rows] for c, rows in A.items()}
        self.assertAlmostEqual(self.compared("a.exr", file)["metrics"]["rmse_linear"], rmse(shown, B), delta=1e-7)

        self.refused("a.exr", files.exr(A, corner=(100, 0), display=(0, 0, WIDTH - 1, HEIGHT - 1)), "a.exr", "no pixel inside of its display window")

    def test_blocks_of_pixels_with_one_value(self):
        """Red for 2 × 2 pixels, blue for 4 × 4; and a luminance for 2 × 2 alone."""
        def blocks(rows, side):
            return [[rows[y - y % side][x - x % side] for x in range(WIDTH)] for y in range(HEIGHT)]

        result = self.compared("a.exr", files.exr({"R": (files.HALF, A["R"], 2), "G": A["G"], "B": (files.FLOAT, A["B"], 4)}))
        self.assertAlmostEqual(result["metrics"]["rmse_linear"], rmse({"R": blocks(A["R"], 2), "G": A["G"], "B": blocks(A["B"], 4)}, B), delta=1e-7)
        self.assertTrue(any("block of pixels" in note for note in result["notes"]), result["notes"])
        grey = self.compared("a.exr", files.exr({"Y": (files.FLOAT, A["R"], 2)}, corner=(-2, 4)))
        self.assertAlmostEqual(grey["metrics"]["rmse_linear"], rmse(dict.fromkeys("RGB", blocks(A["R"], 2)), B), delta=1e-7)

    def test_other_primaries_are_converted(self):
        """Rec. 2020 green is (-0.5876, 1.1329, -0.1006) in Rec. 709 (ITU-R BT.2087-0, table 4); ACES white stays white under Bradford's transform."""
        rec2020 = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
        zero, half = [[0.0] * WIDTH] * HEIGHT, [[0.5] * WIDTH] * HEIGHT
        green = files.exr({"R": zero, "G": half, "B": zero}, chromaticities=rec2020)
        self.write("b.exr", files.exr({"R": [[-0.29382] * WIDTH] * HEIGHT, "G": [[0.56645] * WIDTH] * HEIGHT, "B": [[-0.05030] * WIDTH] * HEIGHT}))
        result = self.compared("a.exr", green)
        self.assertLess(result["metrics"]["rmse_linear"], 1e-4)  # the table has four digits
        self.assertTrue(any("a.exr" in note and "chromaticities" in note for note in result["notes"]))
        aces = (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.077, 0.32168, 0.33767)
        self.write("b.exr", files.exr(dict.fromkeys("RGB", half)))
        self.assertLess(self.compared("a.exr", files.exr(dict.fromkeys("RGB", half), chromaticities=aces))["metrics"]["rmse_linear"], 1e-6)
        plain = self.compared("a.exr", files.exr(dict.fromkeys("RGB", half), chromaticities=files.REC709))
        self.assertEqual((plain["metrics"]["rmse_linear"], plain["notes"]), (0, []))

    def test_shapes_that_are_not_followed_are_noted(self):
        for stated, word in (({}, None), ({"aspect": 2.0}, "2 times as wide as high"), ({"envmap": 1}, "cube"), ({"envmap": 0}, None)):
            result = self.compared("a.exr", files.exr(A, **stated))
            self.expect_a(result)
            self.assertEqual([word in note for note in result["notes"]] if word else result["notes"], [True] if word else [])

    def test_pixels_that_are_not_finite_come_with_their_file(self):
        broken = {c: [list(row) for row in rows] for c, rows in A.items()}
        broken["G"][5][3] = math.nan
        self.refused("a.exr", files.exr(broken), "a.exr", "(3, 5)", "nan in G")
        broken["G"][5][3] = math.inf
        self.write("c.exr", files.exr(broken))
        self.refused("a.exr", files.exr(A), "c.exr", "(3, 5)", "inf in G", reference="c.exr")
        self.refused("a.exr", files.exr({c: [row[:13] for row in rows] for c, rows in A.items()}), "a.exr", "b.exr", "13 × 12")


class Formats(Compared):
    def test_portable_float_maps(self):
        for big_endian in (False, True):
            self.expect_a(self.compared("a.pfm", files.pfm(tuples(A), big_endian)))
        self.expect_a(self.compared("a.PFM", files.pfm(tuples({c: [[v / 2 for v in row] for row in rows] for c, rows in A.items()}), scale=2.0)))
        grey = noise(40)
        result = self.compared("a.pfm", files.pfm(grey))
        self.assertAlmostEqual(result["metrics"]["rmse_linear"], rmse(dict.fromkeys("RGB", grey), B), delta=1e-7)
        self.refused("a.pfm", files.pfm(grey)[:-4], "a.pfm", "break off")
        self.refused("a.pfm", b"PF\n100000 100000\n-1\n", "a.pfm")

    def test_content_decides(self):
        self.expect_a(self.compared("a.png", files.exr(A)))
        self.expect_a(self.compared("a.jpg", files.pfm(tuples(A))))
        self.expect_a(self.compared("a", files.exr(A)))
        self.expect_a(self.compared("A.EXR", files.exr(A)))

    def test_radiance(self):
        """Mantissa 128 … 255 with exponent 128 is 0.5 … 0.996; EXPOSURE has been multiplied in."""
        bytes_of = {c: [[128 + int(v * 127) for v in row] for row in rows] for c, rows in A.items()}
        pixels = [(*pixel, 128) for row in tuples(bytes_of) for pixel in row]
        light = {c: [[v / 256 for v in row] for row in rows] for c, rows in bytes_of.items()}
        for variables, factor in (((), 1.0), (("EXPOSURE=2.5",), 2.5), (("EXPOSURE= 2", "EXPOSURE=0.25"), 0.5)):
            result = self.compared("a.hdr", files.radiance(f"-Y {HEIGHT} +X {WIDTH}", pixels, variables))
            expected = {c: [[v / factor for v in row] for row in rows] for c, rows in light.items()}
            self.assertAlmostEqual(result["metrics"]["rmse_linear"], rmse(expected, B), delta=2e-7)
        self.refused("a.hdr", files.radiance(f"-Y {HEIGHT} +X {WIDTH}", pixels[:-1]), "a.hdr", "break off")
        self.refused("a.hdr", files.radiance("-Y 100000 +X 100000", pixels), "a.hdr", "claims")
        self.refused("a.hdr", files.radiance(f"-Y {HEIGHT} +X {WIDTH}", pixels, ["EXPOSURE=0"]), "a.hdr", "EXPOSURE")

    def test_radiance_of_other_primaries(self):
        """Green of Rec. 2020 in Rec. 709 (ITU-R BT.2087-0, table 4): 0.5 times (-0.5876, 1.1329, -0.1006)."""
        self.write("b.exr", files.exr({c: [[v] * WIDTH] * HEIGHT for c, v in zip("RGB", (-0.29382, 0.56645, -0.05030))}))
        green = files.radiance(f"-Y {HEIGHT} +X {WIDTH}", [(0, 128, 0, 128)] * (WIDTH * HEIGHT), ["PRIMARIES=0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290"])
        result = self.compared("a.hdr", green)
        self.assertLess(result["metrics"]["rmse_linear"], 1e-4)  # the table has four digits
        self.assertTrue(any("PRIMARIES" in note for note in result["notes"]))

    def test_runs_of_radiance_pictures(self):
        """A run of more than 255 pixels in two digits, the lower one first; and bytes that are not repeated."""
        width, many = 304, (128, 64, 32, 129)
        few = [(64 + i, 128, 200, 128) for i in range(3)]
        light = [[v * 2.0 ** (e - 136) for v in (r, g, b)] for r, g, b, e in [many] * (width - 3) + few]
        self.write("b.exr", files.exr({c: [[pixel[i] for pixel in light]] * HEIGHT for i, c in enumerate("RGB")}))
        line = [many, (1, 1, 1, 300 % 256), (1, 1, 1, 300 // 256), *few]
        self.assertEqual(self.compared("a.hdr", files.radiance(f"-Y {HEIGHT} +X {width}", line * HEIGHT))["metrics"]["rmse_linear"], 0)
        new = bytes([2, 2, width // 256, width % 256])
        for values in zip(*([many] * (width - 3) + few)):
            new += bytes([128 + 127, values[0]]) * 2 + bytes([width - 254, *values[254:]])
        self.assertEqual(self.compared("a.hdr", files.radiance(f"-Y {HEIGHT} +X {width}", []) + new * HEIGHT)["metrics"]["rmse_linear"], 0)

    def test_display_referred_pictures_are_compared_as_such(self):
        a, b = ({c: [[int(255 * v) for v in row] for row in rows] for c, rows in picture.items()} for picture in (A, B))
        self.write("b.png", files.png(tuples(b)))
        result = self.compared("a.png", files.png(tuples(a)), reference="b.png")
        stored = rmse(*({c: [[v / 255 for v in row] for row in rows] for c, rows in p.items()} for p in (a, b)))
        decoded = rmse(*({c: [[srgb_to_linear(v / 255) for v in row] for row in rows] for c, rows in p.items()} for p in (a, b)))
        self.assertAlmostEqual(result["metrics"]["rmse_display"], stored, delta=1e-6)
        self.assertAlmostEqual(result["metrics"]["rmse_linear"], decoded, delta=1e-6)
        self.assertEqual([result["conditions"][f"{side}_values"] for side in ("test", "reference")], ["display", "display"])
        self.assertTrue(any("a.png" in note and "8 bits" in note for note in result["notes"]))
        self.assertIn("a.png: display-referred", self.succeed("compare", "a.png", "b.png", cwd=self.folder).stdout)
        self.refused("a.png", files.png(tuples(a)), "--exposure", options=("--exposure", 2), reference="b.png")
        wide = {c: [[257 * v for v in row] for row in rows] for c, rows in a.items()}
        deep = self.compared("c.png", files.png(tuples(wide), depth=16), reference="a.png")
        self.assertLess(deep["metrics"]["rmse_display"], 1e-6)

    def test_two_kinds_mixed(self):
        """An 8-bit picture of light at exposure 4 against that light: display space finds the rounding alone."""
        encoded = {c: [[round(255 * min(1.0, 1.055 * (4 * v) ** (1 / 2.4) - 0.055)) for v in row] for row in rows] for c, rows in B.items()}
        result = self.compared("a.png", files.png(tuples(encoded)), "--exposure", 4)
        self.assertEqual([result["conditions"][f"{side}_values"] for side in ("test", "reference")], ["display", "linear"])
        self.assertLess(result["metrics"]["rmse_display"], 0.5 / 255)
        self.assertTrue(any("other picture is linear" in note for note in result["notes"]))

    def test_alpha_and_grey(self):
        a = {c: [[int(255 * v) for v in row] for row in rows] for c, rows in A.items()}
        self.write("b.png", files.png(tuples(a)))
        result = self.compared("a.png", files.png([[(*p, 17) for p in row] for row in tuples(a)]), reference="b.png")
        self.assertEqual(result["metrics"]["rmse_linear"], 0)
        self.assertTrue(any("alpha" in note for note in result["notes"]))
        self.write("b.png", files.png([[(v, v, v) for v in row] for row in a["R"]]))
        for grey in (a["R"], [[(v, 200) for v in row] for row in a["R"]]):
            self.assertEqual(self.compared("a.png", files.png(grey), reference="b.png")["metrics"]["rmse_linear"], 0)

    def test_float_tiff_is_linear(self):
        result = self.compared("a.tif", files.float_tiff(tuples(A)))
        self.expect_a(result)
        self.assertEqual(result["conditions"]["test_values"], "linear")

    def test_images_of_a_point(self):
        dark = dict.fromkeys("RGB", [[0.0] * WIDTH] * HEIGHT)
        self.refused("a.exr", files.exr({**dark, "A": noise(1)}), "a.exr", "--psf", options=("--psf", "--pixel-arcmin", 1))
        lit = {c: [list(row) for row in rows] for c, rows in dark.items()}
        for rows in lit.values():
            rows[6][8] = 1.0
        self.write("b.exr", files.exr(renamed(lit, "psf.{}")))
        result = self.compared("a.exr", files.exr({**lit, "A": noise(1)}), "--psf", "--pixel-arcmin", 1)
        self.assertEqual(result["psf"]["shift_arcmin"], [0, 0])


class Claims(Compared):
    """What a header says costs nothing before the pixels are there."""

    SIDE = 16000

    def jpeg(self, frame):
        """Tables of one code of one bit each, a frame of this kind, and a scan that breaks off."""
        tables = b"\xff\xdb\0\x43\0" + b"\1" * 64 + b"".join(b"\xff\xc4\0\x14" + bytes([table, 1]) + b"\0" * 16 for table in (0, 16))
        sizes = struct.pack(">HBHHB", 17, 8, self.SIDE, self.SIDE, 3) + bytes([1, 17, 0, 2, 17, 0, 3, 17, 0])
        return b"\xff\xd8" + tables + b"\xff" + bytes([frame]) + sizes + b"\xff\xda\0\x0c\3\1\0\2\0\3\0\0\0\0"

    def tiff(self, compression, bits=8, channels=3):
        entries = [(256, 4, self.SIDE), (257, 4, self.SIDE), (258, 3, bits), (259, 3, compression), (262, 3, 2 if channels == 3 else 0),
                   (273, 4, 8), (277, 3, channels), (278, 4, self.SIDE), (279, 4, 4)]
        return (struct.pack("<2sHI4sH", b"II", 42, 12, b"abcd", len(entries)) +
                b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in entries) + bytes(4))

    def claims(self):
        side = self.SIDE
        yield "29 bytes of TGA", base64.b64decode("AAAKMgEAAAAAAAAIMiA/MCA/MApqcGVnD4AAskA=")
        yield "TGA with runs", struct.pack("<BBB9xHHBB", 0, 0, 10, side, side, 32, 8) + b"\x80abcd"
        yield "PNG", files.png([[(0, 0, 0)]]).replace(struct.pack(">II", 1, 1), struct.pack(">II", side, side), 1)
        yield "JPEG", self.jpeg(0xC0)
        yield "progressive JPEG", self.jpeg(0xC2)
        yield "BMP with runs", struct.pack("<2s8xIIiiHHII20x", b"BM", 54, 40, side, side, 1, 8, 1, 0) + b"\0\1"
        yield "GIF", struct.pack("<6sHHBBB", b"GIF89a", side, side, 0xF0, 0, 0) + bytes(6) + struct.pack("<BHHHHB", 44, 0, 0, side, side, 0) + b"\2\1\x4c\0;"
        yield "WebP", struct.pack("<4sI8sIBI", b"RIFF", 26, b"WEBPVP8L", 14, 0x2F, (side - 1) | (side - 1) << 14) + b"\x88\x88\x08" + bytes(6)
        yield "DDS", struct.pack("<4s7I44xII4s20x5I", b"DDS ", 124, 0x1007, side, side, 0, 0, 0, 32, 4, b"DXT1", 0x1000, 0, 0, 0, 0)
        yield "PSD", struct.pack(">4sH6xHIIHHIII", b"8BPS", 1, 4, side, side, 8, 3, 0, 0, 0) + b"\0\1"
        yield "PPM", b"P6\n16000 16000\n255\n"
        yield "SGI", struct.pack(">HBBHHHHII", 474, 1, 1, 3, side, side, 4, 0, 255).ljust(512, b"\0")
        for compression in (1, 5, 7, 8, 32773, 34925, 50000):
            yield f"TIFF of compression {compression}", self.tiff(compression)
        yield "fax", self.tiff(4, 1, 1)
        yield "Radiance with runs of old", b"#?RADIANCE\n\n-Y 8000 +X 32768\n" + b"abcd" * 9000

    def test_memory_is_for_pixels_that_are_there(self):
        for name, content in self.claims():
            with self.subTest(name):
                self.refused("a.png", content, "a.png")
        self.assertLess(1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 5e8)  # half of what an input may take

    def test_one_colour_takes_few_bytes_and_is_a_picture(self):
        """4096 x 4096 of one colour, black: 1027 bytes of pixels for one byte of PNG, 64 for one of TGA."""
        side = 4096
        grey = struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0)
        raw = bytes((1 + side) * side)

        def chunk(kind, body):
            return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

        png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", grey) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")
        self.assertGreater(len(raw) / len(png), 1000)
        tga = struct.pack("<BBB9xHHBB", 0, 0, 11, side, side, 8, 0) + b"\xff\0" * (side * side // 128)
        for name, content in (("a.png", png), ("a.tga", tga)):  # it has been read, but has not the size of the other one
            self.refused(name, content, f"{name}: got 4096 × 4096 pixels, expected the size of b.exr")

    def test_what_breaks_off_is_no_picture(self):
        rows = [[(x * y % 251, x, y) for x in range(WIDTH)] for y in range(HEIGHT)]
        strips = files.float_tiff([[tuple(v / 256 for v in pixel) for pixel in row] for row in rows])
        # Its one strip starts so late that most of it would lie behind the end of the file.
        short = strips.replace(struct.pack("<HHII", 273, 4, 1, 8), struct.pack("<HHII", 273, 4, 1, len(strips) - 100))
        self.assertNotEqual(short, strips)
        self.write("b.png", files.png(rows))
        self.refused("a.tif", short, "a.tif", reference="b.png")
        self.refused("a.png", files.png(rows)[:-40], "a.png", reference="b.png")

    def test_other_files_are_not_opened(self):
        """A reader may make up what a name asks for: "a.null" had 1024 x 1024 black pixels."""
        for name in ("a.null", "a.mp4", "a.png", "a"):
            self.refused(name, b"no picture at all", name, "another kind", "PNG, JPEG, TIFF")


if __name__ == "__main__":
    unittest.main()
