"""What files for a display state of their numbers: gamma, primaries, profiles, ink, and which way is up."""
import json
import struct
import unittest
import zlib

import exr_header
import picture_files as files
from model_pictures import FACE, SQUARE, ModelTest
from srgb import srgb_to_linear
from sturm_process import WRONG_INPUT, FolderTest, strict_json, sturm

WIDTH, HEIGHT = 24, 16
LINEAR, MAC, OF_SRGB = (struct.pack(">I", number) for number in (100000, 55556, 45455))  # gAMA; 1/1.8 and 1/2.2
SRGB = struct.pack(">8I", 31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000)  # cHRM: white, red, green, blue
P3 = struct.pack(">8I", 31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000)
P3_COLORANTS = ((0.5151, 0.2412, -0.0011), (0.2919, 0.6922, 0.0419), (0.1572, 0.0666, 0.7841))


def profile(content):
    return b"iCCP", b"p\0\0" + zlib.compress(content)


def bands(channels=3):
    """Numbers from 0 to 255 from the left to the right, another one in each channel."""
    return [[tuple((40 * c + 10 * x) % 256 for c in range(channels)) for x in range(WIDTH)] for _ in range(HEIGHT)]


class Compared(FolderTest):
    def compared(self, name, content, light):
        """A picture against floats of what it is as light, a function of its numbers from 0 to 1."""
        self.write(name, content)
        rows = bands()
        self.write("b.exr", files.exr({c: [[light(pixel[i] / 255) for pixel in row] for row in rows] for i, c in enumerate("RGB")}))
        result = strict_json(self.succeed("compare", name, "b.exr", "--json", "-", cwd=self.folder).stdout)
        self.notes = [note for note in result["notes"] if "display-referred" not in note and "other picture is linear" not in note]
        return result["metrics"]["rmse_linear"]

    def test_gamma_of_a_png(self):
        rounding = 1e-6  # single precision
        for name, chunks, light, noted in [
                ("linear", [(b"gAMA", LINEAR)], lambda v: v, True), ("1.8", [(b"gAMA", MAC)], lambda v: v ** (100000 / 55556), True),
                ("as encoders of sRGB write it", [(b"gAMA", OF_SRGB), (b"cHRM", SRGB)], srgb_to_linear, False),
                ("sRGB counts more", [(b"sRGB", b"\0"), (b"gAMA", LINEAR), (b"cHRM", P3)], srgb_to_linear, False),
                ("a profile counts more", [profile(files.icc("s", srgb_to_linear)), (b"gAMA", LINEAR)], srgb_to_linear, False),
                ("cICP of sRGB counts most", [(b"cICP", b"\1\x0d\0\1"), (b"gAMA", LINEAR)], srgb_to_linear, False),
                ("no gamma at all", [(b"gAMA", bytes(4))], srgb_to_linear, False)]:
            with self.subTest(name):
                self.assertLess(self.compared("a.png", files.png(bands(), chunks=chunks), light), rounding)
                self.assertEqual([note for note in self.notes if "power of" in note], self.notes)
                self.assertEqual(bool(self.notes), noted, self.notes)

    def test_what_is_not_followed_is_noted(self):
        for name, chunks, word in [
                ("primaries", [(b"gAMA", OF_SRGB), (b"cHRM", P3)], "cHRM"), ("cICP", [(b"cICP", b"\x09\x10\0\1")], "primaries 9, transfer 16"),
                ("another curve", [profile(files.icc("Gamma 2.2", lambda v: v ** 2.2))], '"Gamma 2.2"'),
                ("linear", [profile(files.icc("Linear", lambda v: v))], '"Linear"'),
                ("other primaries", [profile(files.icc("Display P3", srgb_to_linear, P3_COLORANTS))], '"Display P3"'),
                ("a broken profile", [profile(b"no profile at all, but long enough to be one" * 4)], "")]:
            with self.subTest(name):
                self.assertLess(self.compared("a.png", files.png(bands(), chunks=chunks), srgb_to_linear), 1e-6)
                self.assertEqual([note for note in self.notes if word in note and ("not followed" in note or "not applied" in note)], self.notes)
                if word:
                    self.assertEqual(len(self.notes), 1, self.notes)

    def test_profiles_of_jpegs_and_grey_pictures(self):
        grey = files.png([[pixel[0] for pixel in row] for row in bands()], chunks=[profile(files.icc("Dot gain", lambda v: v ** 1.75, space=b"GRAY"))])
        self.compared("a.png", grey, srgb_to_linear)
        self.assertIn('"Dot gain"', self.notes[0])
        blocks = [[(40, 50, 60)] * (WIDTH // 8)] * (HEIGHT // 8)
        for name, colorants, noted in (("sRGB", {}, False), ("Display P3", {"colorants": P3_COLORANTS}, True)):
            self.compared("a.jpg", files.jpeg(blocks, [files.ADOBE_AS_STORED, (0xE2, b"ICC_PROFILE\0\1\1" + files.icc(name, srgb_to_linear, **colorants))]), srgb_to_linear)
            self.assertEqual([note.count('"Display P3" is not applied') for note in self.notes], [1] if noted else [])

    def test_what_a_tiff_states(self):
        """ExtraSamples 1: colours are stored times alpha; 2: they are not. Photometric 8 is CIELAB, 274 the orientation."""
        times_alpha = [[tuple(v // 3 for v in pixel) + (85,) for pixel in row] for row in bands()]
        as_light = lambda v: srgb_to_linear(round(255 * v) // 3 * 3 / 255)  # what is left of a byte
        self.assertLess(self.compared("a.tif", files.tiff_bytes(times_alpha, further=[(338, 1)]), as_light), 1e-6)
        self.assertTrue(any("divided by alpha" in note for note in self.notes), self.notes)
        plain = [[(*pixel, 85) for pixel in row] for row in bands()]
        for further in ([(338, 2)], [(338, 0)], []):
            self.assertLess(self.compared("a.tif", files.tiff_bytes(plain, further=further), srgb_to_linear), 1e-6)
            self.assertEqual(self.notes, ["a.tif: alpha is left out"])
        turned = [row[::-1] for row in bands()[::-1]]
        self.assertLess(self.compared("a.tif", files.tiff_bytes(turned, further=[(274, 3)]), srgb_to_linear), 1e-6)
        self.write("lab.tif", files.tiff_bytes(bands(), photometric=8))
        refused = sturm("compare", "lab.tif", "b.exr", cwd=self.folder)
        self.assertEqual(refused.returncode, WRONG_INPUT)
        self.assertIn("CIELAB", refused.stderr)

    def test_the_first_of_several_pages_is_taken(self):
        page = files.tiff_bytes(bands())
        directory = page[struct.unpack("<I", page[4:8])[0]:]
        second = directory.replace(struct.pack("<HHII", 262, 3, 1, 2), struct.pack("<HHII", 262, 3, 1, 6))  # not RGB
        self.assertLess(self.compared("a.tif", page[:-4] + struct.pack("<I", len(page)) + second, srgb_to_linear), 1e-6)
        self.assertEqual(self.notes, ["a.tif: the first of its pictures is taken"])
        self.compared("a.tif", page, srgb_to_linear)
        self.assertEqual(self.notes, [])

    def test_see_decodes_as_the_file_says(self):
        """A uniform picture stays what it is through any lens: 100/255 as light, not its square or so."""
        self.write("a.png", files.png([[(100, 150, 200)] * 40] * 40, chunks=[(b"gAMA", LINEAR)]))
        self.write("eye.json", {"format": "sturm.eye/1", "prescription": {"sphere_D": -1, "vertex_distance_mm": 0}, "pupil_diameter_mm": 4})
        self.succeed("see", "a.png", "--eye", "eye.json", "--vfov-deg", "2", "--distance-m", "2", "-o", "seen.exr", cwd=self.folder)
        seen = exr_header.float_pixels((self.folder / "seen.exr").read_bytes())
        for channel, value in zip("RGB", (100, 150, 200)):
            self.assertAlmostEqual(seen[channel][20][20], value / 255, delta=1e-3)
        self.assertIn("power of 1", "".join(json.loads((self.folder / "seen.manifest.json").read_text())["notes"]))


class Upright(FolderTest):
    """Which way a picture is to be seen, after the tables of EXIF: "6: the 0th row is the visual right-hand side"."""

    SEEN = [[(200, 30, 40), (50, 160, 70), (80, 90, 220)], [(10, 20, 30), (90, 80, 70), (240, 230, 100)]]

    @staticmethod
    def stored(seen, orientation):
        mirrored, flipped, transposed = [row[::-1] for row in seen], seen[::-1], [list(column) for column in zip(*seen)]
        turned = [row[::-1] for row in transposed]  # a quarter clockwise
        return {1: seen, 2: mirrored, 3: [row[::-1] for row in flipped], 4: flipped, 5: transposed, 6: transposed[::-1],
                7: [row[::-1] for row in transposed[::-1]], 8: turned}[orientation]

    def test_all_orientations(self):
        self.write("seen.jpg", files.jpeg(self.SEEN))
        pixels = [[pixel for pixel in row for _ in range(8)] for row in self.SEEN for _ in range(8)]
        self.write("seen.png", files.png(pixels))
        plain = strict_json(self.succeed("compare", "seen.jpg", "seen.png", "--json", "-", cwd=self.folder).stdout)
        self.assertEqual(plain["metrics"]["rmse_linear"], 0)
        for orientation in range(1, 9):
            with self.subTest(orientation):
                self.write("a.jpg", files.jpeg(self.stored(self.SEEN, orientation), [files.ADOBE_AS_STORED, (0xE1, b"Exif\0\0" + files.exif(orientation))]))
                result = strict_json(self.succeed("compare", "a.jpg", "seen.png", "--json", "-", cwd=self.folder).stdout)
                self.assertEqual(result["metrics"]["rmse_linear"], 0)
                self.assertEqual(any(f"orientation {orientation}" in note for note in result["notes"]), orientation > 1)

    def test_ink(self):
        """Adobe's programs store the ink that is left out; of other files nobody can tell."""
        ink = [[(*pixel, 255) for pixel in row] for row in self.SEEN]
        self.write("seen.jpg", files.jpeg(self.SEEN))
        self.write("a.jpg", files.jpeg(ink))
        result = strict_json(self.succeed("compare", "a.jpg", "seen.jpg", "--json", "-", cwd=self.folder).stdout)
        self.assertEqual(result["metrics"]["rmse_linear"], 0)
        self.assertTrue(any("CMYK" in note for note in result["notes"]))
        self.write("a.jpg", files.jpeg(ink, []))
        refused = sturm("compare", "a.jpg", "seen.jpg", cwd=self.folder)
        self.assertEqual(refused.returncode, WRONG_INPUT)
        self.assertIn("CMYK", refused.stderr)


class Textures(ModelTest):
    MTL = "newmtl m\nmap_Kd t.png\n"
    OBJ = "mtllib m.mtl\n" + SQUARE + "usemtl m\n" + FACE

    def texture(self, chunks, **model):
        self.write("t.png", files.png([[(100, 150, 200)] * 2] * 2, chunks=chunks))
        return self.obj(self.OBJ, self.MTL, **model)

    def test_gamma_of_a_texture(self):
        stored = [v / 255 for v in (100, 150, 200)]
        self.assert_albedo(self.texture([(b"gAMA", LINEAR)]), 16, 16, stored)
        self.assert_noted("t.png", "power of 1")
        self.assert_albedo(self.texture([(b"gAMA", MAC)]), 16, 16, [v ** 1.8 for v in stored])
        self.assert_albedo(self.texture([(b"gAMA", MAC), (b"cHRM", P3)], texture_encoding="linear"), 16, 16, stored)
        self.assertEqual(self.notes, [])
        self.assert_albedo(self.texture([]), 16, 16, [srgb_to_linear(v) for v in stored])
        self.texture([(b"cHRM", P3)])
        self.assert_noted("t.png", "cHRM")

    def test_gltf_says_what_its_textures_mean(self):
        """glTF 2.0, 3.8.3: colour space information of an image must be ignored."""
        positions = struct.pack("<12f", -1, -1, -2, 1, -1, -2, 1, 1, -2, -1, 1, -2) + struct.pack("<8f", *[0.5] * 8) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
        self.write("m.bin", positions)
        self.write("t.png", files.png([[(100, 150, 200)] * 2] * 2, chunks=[(b"gAMA", LINEAR)]))
        view = lambda start, length: {"buffer": 0, "byteOffset": start, "byteLength": length}
        self.write("m.gltf", json.dumps({
            "asset": {"version": "2.0"}, "buffers": [{"uri": "m.bin", "byteLength": len(positions)}], "bufferViews": [view(0, 48), view(48, 32), view(80, 12)],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, -2], "max": [1, 1, -2]},
                          {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"}, {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
            "images": [{"uri": "t.png"}], "textures": [{"source": 0}],
            "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 1}}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]}))
        self.assert_albedo(self.model("m.gltf"), 16, 16, [srgb_to_linear(v / 255) for v in (100, 150, 200)])
        self.assertEqual(self.notes, [])

    def test_gamma_of_an_environment(self):
        self.write("sky.png", files.png([[(100, 150, 200)] * 8] * 4, chunks=[(b"gAMA", LINEAR)]))
        scene = {"environment": {"file": "sky.png"}, "materials": {"m": {}}, "spheres": [{"center_m": [0, -1e4, 0], "radius_m": 0.01, "material": "m"}]}
        picture = self.picture(scene)
        for channel, value in zip("RGB", (100, 150, 200)):
            self.assertAlmostEqual(picture[channel][3][16], value / 255, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
