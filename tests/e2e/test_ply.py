"""PLY models as scanners and modelling programs write them: text, bytes of either order, colours, textures, polygons."""
import math
import struct
import unittest

import png_pixels
from gltf_models import Model
from model_pictures import BLUE, FACE, GREEN, QUARTERS, RED, SQUARE, YELLOW, ModelTest
from srgb import srgb_to_linear

CORNERS = [(-1, -1, -2), (1, -1, -2), (1, 1, -2), (-1, 1, -2)]  # pixels 8 to 23
COORDINATES = [(0, 0), (1, 0), (1, 1), (0, 1)]
GREY = (0.6, 0.6, 0.6)


INDICES = "property list uchar int vertex_indices\n"


def header(encoding, vertex="", face=INDICES, comments=""):
    return (f"ply\nformat {encoding} 1.0\n{comments}element vertex 4\nproperty float x\nproperty float y\nproperty float z\n{vertex}"
            f"element face 1\n{face}end_header\n")


def text(rows, vertex="", faces="4 0 1 2 3\n", **others):
    """The square as text, with further numbers for each vertex."""
    return header("ascii", vertex, **others) + "".join(" ".join(map(str, (*c, *row))) + "\n" for c, row in zip(CORNERS, rows)) + faces


class Ply(ModelTest):
    def test_text_and_bytes_show_the_same(self):
        pictures = []
        for name, order in (("ascii", None), ("binary_little_endian", "<"), ("binary_big_endian", ">")):
            if order is None:
                content = text([()] * 4)
            else:
                content = header(name).encode() + b"".join(struct.pack(order + "3f", *c) for c in CORNERS) + struct.pack(order + "B4i", 4, 0, 1, 2, 3)
            self.write("m.ply", content)
            pictures.append(self.model("m.ply"))
            self.assertEqual(self.notes, [])
            self.assert_quarters(pictures[-1], GREY, GREY, GREY, GREY)
            depths = [z for row in pictures[-1]["depth.Z"] for z in row if z < 1e9]
            self.assertEqual(len(depths), 16 * 16)
        self.assertEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])

    def test_colours_of_vertices(self):
        colours = "property {0} red\nproperty {0} green\nproperty {0} blue\n"
        for kind, row, right in (("uchar", (51, 102, 255), (0.2, 0.4, 1)), ("ushort", (13107, 26214, 65535), (0.2, 0.4, 1)),
                                 ("float", (0.2, 0.4, 1), (0.2, 0.4, 1)), ("float", (51, 102, 255), (0.2, 0.4, 1)), ("float", (0.2, 0.4, 0.5), (0.2, 0.4, 0.5))):
            with self.subTest(kind=kind, row=row):
                self.write("m.ply", text([row] * 4, colours.format(kind)))
                self.assert_quarters(self.model("m.ply", texture_encoding="linear"), right, right, right, right)
                self.assert_noted("m.ply", "vertex colours", "linear")
        self.write("m.ply", text([(-1, 0, 0)] * 4, colours.format("float")))
        self.refused(self.with_model("m.ply"), "m.ply", "vertex colours", "-1", "0 to 255")

    def test_light_as_from_other_formats(self):
        """One colour, of the vertices or in a texture, from PLY, OBJ and glTF; glTF alone states vertex colours as linear."""
        stored = (51, 102, 255)
        colour = [srgb_to_linear(v / 255) for v in stored]
        self.write("t.png", png_pixels.encode([[stored]]))
        self.write("colours.ply", text([stored] * 4, "property uchar red\nproperty uchar green\nproperty uchar blue\n"))
        self.write("texture.ply", text(COORDINATES, "property float s\nproperty float t\n", comments="comment TextureFile t.png\n"))
        self.write("m.mtl", "newmtl m\nmap_Kd t.png\n")
        self.write("colours.obj", "".join(f"v {x} {y} {z} {' '.join(str(v / 255) for v in stored)}\n" for x, y, z in CORNERS) + "f 1 2 3 4\n")
        self.write("texture.obj", "mtllib m.mtl\n" + SQUARE + "usemtl m\n" + FACE)
        for name, material, attributes in (("colours", {}, {"COLOR_0": [colour] * 4}), ("texture", {"picture": [[stored]]}, {})):
            model = Model()
            texture = model.picture(material["picture"]) if material else None
            model.square(model.material(texture=texture), **{k: model.accessor(v) for k, v in attributes.items()})
            model.write(self.folder / f"{name}.glb")
        x = y = 0.0625  # the middle of the pixel; the sample lies within 1/16 of it, which changes 2/r³ by 1.5 %
        r = math.hypot(x, y, 2)
        for name in ("colours", "texture"):
            pictures = [self.model(f"{name}.{suffix}") for suffix in ("obj", "ply", "glb")]
            for channel, albedo in zip("RGB", colour):
                seen = [picture[channel][15][16] for picture in pictures]
                self.assertAlmostEqual(seen[0], albedo / math.pi * 2 / r**3, delta=0.015 * seen[0])
                for other in seen[1:]:
                    self.assertAlmostEqual(other, seen[0], delta=1e-5 * seen[0], msg=f"{name} {channel}: {seen}")  # single precision

    def test_a_texture_that_a_comment_names(self):
        self.write("scan.png", QUARTERS)
        self.write("m.ply", text(COORDINATES, "property float s\nproperty float t\n", comments="comment TextureFile scan.png\n"))
        self.assert_quarters(self.model("m.ply"), RED, GREEN, BLUE, YELLOW)
        # Coordinates of the faces' corners count, as MeshLab writes them; here a quarter of a turn further.
        turned = COORDINATES[1:] + COORDINATES[:1]
        flat = " ".join(f"{u} {v}" for u, v in turned)
        self.write("m.ply", text(COORDINATES, "property float u\nproperty float v\n", f"4 0 1 2 3 8 {flat}\n", face=INDICES + "property list uchar float texcoord\n",
                                 comments="comment TextureFile scan.png\n"))
        self.assert_quarters(self.model("m.ply"), BLUE, RED, YELLOW, GREEN)
        self.write("m.ply", text(COORDINATES, "property float s\nproperty float t\n", comments="comment TextureFile none.png\n"))
        self.refused(self.with_model("m.ply"), "m.ply", "TextureFile", "none.png")


if __name__ == "__main__":
    unittest.main()
