"""OBJ and MTL files as programs and people write them: each is a square of which the right picture is known."""
import unittest

import picture_files
import png_pixels
from model_pictures import BLUE, FACE, GREEN, QUARTERS, RED, SQUARE, YELLOW, ModelTest
from sturm_process import WRONG_INPUT, sturm

DARK = (0.1, 0.2, 0.3)
MATERIAL = "newmtl m\nKd 0.1 0.2 0.3\n"
USING = "mtllib m.mtl\n" + SQUARE + "usemtl m\n" + FACE
PAINTED = "newmtl m\nKd 1 1 1\n"
IN_PLACE = (RED, GREEN, BLUE, YELLOW)


class Statements(ModelTest):
    def assert_dark(self, obj, mtl=MATERIAL, **model):
        self.assert_albedo(self.obj(obj, mtl, **model), 16, 16, DARK)

    def test_statements_are_known_by_their_whole_word(self):
        self.assert_dark(USING, "newmtl m\nNs 250\nKa 1 1 1\nKd 0.1 0.2 0.3\nKs 0 0 0\nNi 1.45\nd 1\nTr 0\nTf 1 1 1\nillum 3\nPr 0.5\nPm 0\nPs 0\n"
                                "Pc 0\nPcr 0.03\naniso 0\nanisor 0\nnew statement\nKdx 9 9 9\nsharpness 60\nKm 0.5\n")
        self.assertEqual(self.notes, [])
        self.assert_dark(USING + "shadow_obj x\nvp 1 2\nfancy 1 2 3\nmg 0\nbevel on\nlod 3\ncstype bezier\n")

    def test_what_is_left_out_is_noted_and_nothing_else(self):
        self.write("n.png", QUARTERS)
        self.obj(USING, MATERIAL + "Pm 1\nPs 0.5\nPc 0.5\naniso 0.2\nKs 1 1 1\nillum 2\nnorm n.png\nmap_Pr n.png\nrefl -type sphere n.png\n")
        self.assert_noted("m.obj", '"m"', "metallic, specular, sheen, clear coat, anisotropy, normal map, roughness texture, reflection map")
        self.obj(USING, MATERIAL + "Ks 1 1 1\nillum 1\nTf 0 0 0\n")  # a model without highlights, and nothing to look through
        self.assertEqual(self.notes, [])

    def test_case_of_letters(self):
        upper = "MTLLIB m.mtl\n" + SQUARE.upper() + "USEMTL m\nF 1/1 2/2 3/3 4/4\n"
        self.assert_dark(upper, "NEWMTL m\nKD 0.1 0.2 0.3\n", name="UPPER.OBJ")
        self.write("Lib.MTL", MATERIAL)
        self.assert_dark(USING.replace("m.mtl", "LIB.mtl"))

    def test_line_ends_and_marks(self):
        for name, change in {"CR LF": lambda t: t.replace("\n", "\r\n").encode(), "CR": lambda t: t.replace("\n", "\r").encode(),
                             "mark": lambda t: b"\xef\xbb\xbf" + t.encode(), "UTF-16": lambda t: t.encode("utf-16"),
                             "UTF-16 BE": lambda t: b"\xfe\xff" + t.encode("utf-16-be"),
                             "no last one": lambda t: t.strip().encode()}.items():
            with self.subTest(name):
                self.assert_dark(change(USING), change(MATERIAL))

    def test_lines_go_on_behind_a_backslash(self):
        self.assert_dark(USING.replace("f 1/1 2/2", "f 1/1 \\\n2/2 \\\r\n").replace("v 1 1", "v 1\\\n1").replace("# x", ""),
                         "# a comment does not \\\nnewmtl m\nKd 0.1 \\\n 0.2 0.3\n")

    def test_comments_at_the_ends_of_lines(self):
        self.assert_dark(SQUARE.replace("-2\n", "-2 # metres\n").replace("0\n", "0 # uv\n") +
                         "mtllib m.mtl # ours\nusemtl m # the dark one\nf 1 2 3 4 # all\n", "newmtl m # dark\nKd 0.1 0.2 0.3 # measured\n")

    def test_numbers(self):
        square = "v -1. -1.0e0 -.2e+1\nv +1 -1 -2.\nv +1.0 1 -2\nv -1 +1e0 -2\n"
        self.assert_dark("mtllib m.mtl\n" + square + "usemtl m\nf 1 2 3 4\n", "newmtl m\nKd +.1 2.e-1 .3\n")
        self.assert_dark(USING.replace("f 1/1 2/2 3/3 4/4", "f -4/-4 -3/-3 -2/-2 -1/-1"))
        self.assert_dark("mtllib m.mtl\nusemtl m\n" + FACE + SQUARE)  # corners that follow
        for line, *named in (("v 1 2\n", "2 numbers"), ("v 1,5 0 0\n", '"1,5"', "decimal point"), ("v 1 2 inf\n", "finite"), ("f 1 2 0\n", '"0"'),
                             ("f 1 2 -9\n", '"-9"'), ("f 1 2 99\n", "99", "at most 4"), ("f 1/1/1 2/2/2 3/3/3\n", "vn"), ("f 1 2 x\n", '"x"'),
                             ("v 1 2 3 4 5\n", "5 numbers"), ("vt\n", "vt")):
            with self.subTest(line):
                self.write("bad.obj", SQUARE + line)
                self.refused("bad.obj", "bad.obj:9", *named)

    def test_names(self):
        for name in ("two  blanks", "tab\tin it", "Material #25", "ümläut", "-minus", 'a "quote"'):
            with self.subTest(name):
                self.assert_dark(f"mtllib m.mtl\n{SQUARE}usemtl \t{name} \t\n{FACE}", f"newmtl other\nKd 1 1 1\nnewmtl  {name}\t \nKd 0.1 0.2 0.3\n")

    def test_polygons_that_are_not_convex(self):
        # A chevron: (-1,-1) (0,0) (1,-1) (0,1). Its notch, below the middle, is open.
        for start in range(4):
            corners = ["-1 -1 -2", "0 0 -2", "1 -1 -2", "0 1 -2"]
            corners = corners[start:] + corners[:start]
            picture = self.obj("".join(f"v {c}\n" for c in corners) + "f 1 2 3 4\n")
            self.assertGreater(picture["depth.Z"][19][16], 1e9)
            self.assertLess(picture["depth.Z"][12][16], 3)
            self.assertLess(picture["depth.Z"][20][10], 3)
            self.assertLess(picture["depth.Z"][20][21], 3)

    def test_nothing_to_see(self):
        for text in ("", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 0 0 0\nv 1 0 0\nl 1 2\np 1\nf 1 2\n"):
            self.write("none.obj", text)
            self.refused("none.obj", "none.obj", "triangle")
        self.obj(SQUARE + FACE + "l 1 2\nl 2 3\np 1\nsurf 0 1\n")
        self.assert_noted("2 lines are left out")
        self.assert_noted("1 points are left out")
        self.assert_noted("free-form")


class Materials(ModelTest):
    def test_one_number_is_grey(self):
        self.assert_albedo(self.obj(USING, "newmtl m\nKd 0.5\n"), 16, 16, (0.5, 0.5, 0.5))
        for text in ("spectral paint.rfl", "xyz 0.1 0.2 0.3", "0.1 0.2", "", "a b c", "nan 0 0"):
            with self.subTest(text):
                self.write("m.mtl", f"newmtl m\nKd {text}\n")
                self.refused(self.with_model("m.obj"), "m.mtl:2", "Kd", '"m"')
        self.write("m.mtl", "newmtl unused\nKd spectral x.rfl\nmap_Kd gone.png\n" + MATERIAL)
        self.assert_albedo(self.model("m.obj"), 16, 16, DARK)

    def test_numbers_can_be_told_from_the_bound(self):
        self.write("m.mtl", "newmtl m\nKd 1.0000001 1 1\n")
        self.write("m.obj", USING)
        self.assertNotIn("got 1.000000,", self.refused(self.with_model("m.obj"), "m.mtl:2", "got 1.0000001"))
        self.write("m.mtl", "newmtl m\nKd -1e-9 1 1\n")
        self.refused(self.with_model("m.obj"), "m.mtl:2", "got -1e-09")

    def test_libraries(self):
        self.write("a.mtl", "newmtl n\nKd 0 0 0\n")
        self.write("b.mtl", MATERIAL)
        self.write("my lib.mtl", MATERIAL)
        self.write("sub/c.mtl", MATERIAL)
        for named in ("a.mtl b.mtl", "b.mtl a.mtl", "my lib.mtl", "a.mtl my lib.mtl", "my lib.mtl a.mtl", '"my lib.mtl"', "sub/c.mtl", "sub\\c.mtl",
                      "./b.mtl", "C:\\models\\b.mtl", "B.MTL", "a.mtl\nmtllib b.mtl", "b.mtl \t"):
            with self.subTest(named):
                self.assert_albedo(self.obj(f"mtllib {named}\n{SQUARE}usemtl m\n{FACE}"), 16, 16, DARK)
        self.assert_albedo(self.obj(f"{SQUARE}usemtl m\n{FACE}mtllib b.mtl\n"), 16, 16, DARK)  # it may stand anywhere
        self.write("m.obj", f"mtllib a.mtl gone.mtl\n{SQUARE}{FACE}")
        self.refused("m.obj", "m.obj:1", "mtllib", "gone.mtl")
        self.write("m.obj", f"mtllib a.mtl\n{SQUARE}usemtl gone\n{FACE}")
        self.refused("m.obj", "m.obj:10", "usemtl", '"gone"')
        self.write("first.mtl", "newmtl m\nKd 0.1 0.2 0.3\n")
        self.write("second.mtl", "newmtl m\nKd 1 0 0\n")
        self.assert_albedo(self.obj(f"mtllib first.mtl second.mtl\n{SQUARE}usemtl m\n{FACE}"), 16, 16, DARK)

    def test_a_material_without_a_library(self):
        self.assert_albedo(self.obj(f"{SQUARE}usemtl wood\n{FACE}"), 16, 16, (0.6, 0.6, 0.6))
        self.assert_noted("m.obj", "line 9", '"wood"', "0.6")
        self.assert_albedo(self.obj(f"{SQUARE}usemtl\n{FACE}"), 16, 16, (0.6, 0.6, 0.6))
        self.assertEqual(self.notes, [])

    def test_overrides_mean_all_faces_of_a_name(self):
        dark = {"albedo": DARK}
        self.write("m.mtl", "newmtl l\nKd 1 0 0\nnewmtl g\nKd 0 1 0\n")
        two = f"mtllib m.mtl\n{SQUARE}o box\ng {{}}\nusemtl l\nf 1 2 3\n{{}}usemtl g\nf 1 3 4\n"
        for groups, name in ((("", ""), "box"), (("left", "g right\n"), "box"), (("both left", "g right both\n"), "both"), (("a b", ""), "a b")):
            with self.subTest(name):
                picture = self.obj(two.format(*groups), overrides=[{"mesh": name, "material": dark}])
                self.assert_albedo(picture, 20, 18, DARK)
                self.assert_albedo(picture, 11, 12, DARK)
        picture = self.obj(two.format("left", "g right\n"), overrides=[{"mesh": "right", "material": dark}])
        self.assert_albedo(picture, 20, 18, RED)
        self.assert_albedo(picture, 11, 12, DARK)
        self.refused(self.with_model("m.obj", overrides=[{"mesh": "rigth", "material": dark}]), '"rigth"', '"right"', '"box"')

    def test_emission_and_opacity(self):
        lamp = self.obj(USING, "newmtl m\nKd 0 0 0\nKe 3\n")
        self.assertAlmostEqual(lamp["R"][16][16], 3, delta=1e-6)
        behind = "v -9 -9 -4\nv 9 -9 -4\nv 9 9 -4\nv -9 9 -4\nusemtl wall\nf 5 6 7 8\n"
        for statement, share in (("d 0.25", 0.25), ("Tr 0.75", 0.25), ("d -halo 0.25", 0.25), ("Tr 1\nd 1", 1), ("Tr 1", 1), ("d 1", 1)):
            with self.subTest(statement):
                self.write("m.mtl", f"newmtl m\nKd 0 0 0\n{statement}\nnewmtl wall\nKd 0 0 0\nKe 1 1 1\n")
                self.write("m.obj", USING + behind)
                picture = self.picture(self.with_model("m.obj"), method={"samples_per_pixel": 256})
                seen = [picture["R"][y][x] for y in range(10, 22) for x in range(10, 22)]
                self.assertAlmostEqual(sum(seen) / len(seen), 1 - share, delta=5 * 0.5 / 192)  # 5 sigma of 144 x 256 rays
                self.assertEqual(share < 1, any("transparency" in note for note in self.notes))

    def test_vertex_colours(self):
        coloured = "v -1 -1 -2 1 0 0\nv 1 -1 -2 1 0 0\nv 1 1 -2 1 0 0\nv -1 1 -2 1 0 0\nf 1 2 3 4\n"
        self.assert_albedo(self.obj(coloured), 16, 16, RED)
        self.assert_noted("vertex colours")
        grey = coloured.replace("1 0 0\n", "0.5 0.5 0.5\n")
        self.assert_albedo(self.obj(grey, texture_encoding="linear"), 16, 16, (0.5, 0.5, 0.5))
        self.assert_albedo(self.obj(grey), 16, 16, (0.21404,) * 3)  # ((0.5 + 0.055) / 1.055)^2.4
        self.assert_albedo(self.obj(coloured.replace("1 0 0\n", "51 0 255\n"), texture_encoding="linear"), 16, 16, (0.2, 0, 1))
        self.assert_noted("255")
        self.assert_albedo(self.obj("mtllib m.mtl\nusemtl m\n" + coloured, MATERIAL), 16, 16, (0.1, 0, 0))
        plain = coloured.replace(" 1 0 0\n", " 1\n")  # a weight of 1
        self.assert_albedo(self.obj(plain), 16, 16, (0.6, 0.6, 0.6))
        self.write("m.obj", plain.replace("-2 1\n", "-2 2\n"))
        self.refused("m.obj", "m.obj:1", "weight of 2")


class Textures(ModelTest):
    def setUp(self):
        super().setUp()
        self.write("t.png", QUARTERS)

    def test_names_of_files(self):
        self.write("my pic.png", QUARTERS)
        self.write("-s.png", QUARTERS)
        self.write("sub/s.png", QUARTERS)
        for text in ("t.png ", "t.png\t", "\t t.png \t ", '"t.png"', "my pic.png", '"my pic.png"', "T.PNG", "sub\\s.png", "sub/s.png", "SUB\\S.png",
                     "..\\x\\t.png", "C:\\textures\\t.png", "/textures/of another/t.png", "-s.png", "-s 1 1 t.png", "t.png # ours", ".\\t.png"):
            with self.subTest(text):
                self.assert_quarters(self.obj(USING, f"{PAINTED}map_Kd {text}\n"), *IN_PLACE)
        self.write("gr\u00fcn.png", QUARTERS)  # a library in Latin-1 that came with files whose names became UTF-8
        self.assert_quarters(self.obj(USING, f"{PAINTED}map_Kd gr\u00fcn.png\n".encode("latin-1")), *IN_PLACE)
        self.obj(USING, f"{PAINTED}map_Kd C:\\textures\\t.png\n")
        self.assert_noted("t.png", "does not exist")
        self.write("m.mtl", f"{PAINTED}map_Kd gone.png\n")
        self.refused("m.obj", "m.obj", "m.mtl:3", "map_Kd", '"m"', "gone.png")
        self.assert_quarters(self.obj(USING, "newmtl m\nmap_Kd t.png\n"), *IN_PLACE)  # white where no Kd is stated

    def test_textures_beside_the_library_come_first(self):
        self.write("parts/m.mtl", f"{PAINTED}map_Kd t.png\n")
        obj = USING.replace("m.mtl", "parts/m.mtl")
        self.assert_quarters(self.obj(obj), *IN_PLACE)  # beside the OBJ alone
        self.write("parts/t.png", png_pixels.encode([[(0, 0, 255)]]))
        self.assert_quarters(self.obj(obj), BLUE, BLUE, BLUE, BLUE)

    def test_scale_and_offset(self):
        # The square's left lower corner is (0, 0); a quarter of the picture is 1/2 wide.
        def colour(u, v):
            return [[BLUE, YELLOW], [RED, GREEN]][int(v % 1 >= 0.5)][int(u % 1 >= 0.5)]

        for options, (su, sv), (ou, ov) in (("-s 2 2 1 -o 0.25 0.25 0", (2, 2), (0.25, 0.25)), ("-s 2", (2, 1), (0, 0)), ("-s 1 2", (1, 2), (0, 0)),
                                            ("-o 0.5", (1, 1), (0.5, 0)), ("-o 0 +.5", (1, 1), (0, 0.5)), ("-o -0.25 0.5 0 -s 4 1 1", (4, 1), (-0.25, 0.5)),
                                            ("-blendu on -S 2 1 -mm 0 1 -cc off -t 0 0 0", (2, 1), (0, 0))):
            for text in (f"{options} t.png", f"t.png {options}"):
                with self.subTest(text):
                    picture = self.obj(USING, f"{PAINTED}map_Kd {text}\n", texture_wrap="repeat")
                    for y in range(9, 23):
                        for x in range(9, 23):
                            u, v = (x + 0.5 - 8) / 16, (24 - y - 0.5) / 16
                            self.assert_albedo(picture, x, y, colour(su * u + ou, sv * v + ov))
                    self.assertEqual(self.notes, [])

    def test_other_options_are_noted(self):
        for option in ("-mm 0 2", "-bm 0.5", "-t 1 1 1", "-boost 2", "-texres 512", "-imfchan r", "-cc on", "-blendu off", "-type sphere"):
            with self.subTest(option):
                self.assert_quarters(self.obj(USING, f"{PAINTED}map_Kd {option} t.png\n"), *IN_PLACE)
                self.assert_noted("option " + option.split()[0], "map_Kd", '"m"')

    def test_clamp(self):
        far = USING.replace("vt 1 0\nvt 1 1\n", "vt 2 0\nvt 2 1\n")  # twice as wide: the picture, then what lies beyond
        for mtl, wrap, right in (("", "repeat", (RED, RED)), ("-clamp on ", "repeat", (RED, GREEN)), ("-clamp off ", None, (RED, RED)), ("", None, (RED, GREEN))):
            with self.subTest(mtl=mtl, wrap=wrap):
                picture = self.obj(far, f"{PAINTED}map_Kd {mtl}t.png\n", **({"texture_wrap": wrap} if wrap else {}))
                self.assert_albedo(picture, 9, 12, right[0])    # u = 0.19
                self.assert_albedo(picture, 17, 12, right[1])   # u = 1.19
        self.assert_noted("outside of 0 to 1", "texture_wrap")

    def test_opacity_texture(self):
        self.write("d.png", png_pixels.encode([[(255, 255, 255), (0, 0, 0)]]))  # the right half is a hole
        picture = self.obj(USING, "newmtl m\nKd 0.1 0.2 0.3\nmap_d d.png\n")
        self.assert_albedo(picture, 12, 16, DARK)
        self.assertGreater(picture["depth.Z"][16][20], 1e9)
        self.write("d.png", picture_files.png([[(0, 0, 0, 255), (255, 255, 255, 0)]]))  # where there is alpha, it counts
        picture = self.obj(USING, "newmtl m\nKd 0.1 0.2 0.3\nmap_d d.png\n")
        self.assert_albedo(picture, 12, 16, DARK)
        self.assertGreater(picture["depth.Z"][16][20], 1e9)

    def test_emission_texture(self):
        picture = self.obj(USING, "newmtl m\nKd 0 0 0\nKe 2 2 2\nmap_Ke t.png\n")
        for x, y, right in ((12, 12, RED), (20, 12, GREEN), (12, 20, BLUE), (20, 20, YELLOW)):
            for c, value in zip("RGB", right):
                self.assertAlmostEqual(picture[c][y][x], 2 * value, delta=1e-3)

    def test_faces_without_coordinates(self):
        self.write("m.mtl", f"{PAINTED}map_Kd t.png\n")
        self.write("m.obj", f"mtllib m.mtl\n{SQUARE}o board\nusemtl m\nf 1 2 3 4\n")
        self.refused("m.obj", "m.obj", '"board"', '"m"', "texture coordinates")
        self.assert_albedo(self.model("m.obj", overrides=[{"mesh": "board", "material": {"albedo": DARK}}]), 16, 16, DARK)


class Safety(ModelTest):
    def test_texts_that_are_no_text(self):
        for data in (b"\x00\xff\x13\x37" * 50, b"usemtl " + b"\xff\xfe\x00" * 400 + b"\nf 1 2 3\n", b"mtllib " + b"A" * 100000 + b"\n", b"\\\n\\\n\\", b"f\n", b"v\n"):
            with self.subTest(data[:20]):
                self.write("noise.obj", data)
                process = sturm("render", self.view("noise.obj"), "-o", self.folder / "none.exr")
                self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
                self.assertLess(len(process.stderr), 1000)


if __name__ == "__main__":
    unittest.main()
