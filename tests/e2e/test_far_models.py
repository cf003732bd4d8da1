"""Models that lie far from the origin of their file (map coordinates) and are put back: their shape is that of the file, or a note says so."""
import math
import struct
import unittest

from model_pictures import ModelTest

SIZE = 0.2  # [m], of a square that faces the camera at z = -2


def corners(x, y):
    return [(x - SIZE / 2, y - SIZE / 2, -2), (x + SIZE / 2, y - SIZE / 2, -2), (x + SIZE / 2, y + SIZE / 2, -2), (x - SIZE / 2, y + SIZE / 2, -2)]


def obj(x, y):
    return "".join("v %.3f %.3f %.3f\n" % c for c in corners(x, y)) + "f 1 2 3 4\n"


def stl(x, y):
    a, b, c, d = ("vertex %.3f %.3f %.3f\n" % p for p in corners(x, y))
    facet = "facet normal 0 0 1\nouter loop\n{}{}{}endloop\nendfacet\n".format
    return "solid square\n" + facet(a, b, c) + facet(a, c, d) + "endsolid square\n"


PLY = "ply\nformat {}\ncomment of a survey\nelement vertex 4\nproperty uchar class\nproperty {t} x\nproperty {t} y\nproperty {t} z\nproperty float quality\n" \
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"


def ply_text(x, y):
    return PLY.format("ascii 1.0", t="double") + "".join("7 %.3f %.3f %.3f 0.5\n" % c for c in corners(x, y)) + "4 0 1 2 3\n"


def ply_bytes(order, kind="double"):
    def made(x, y):
        sign, name = ("<", "little") if order == "little" else (">", "big")
        header = PLY.format(f"binary_{name}_endian 1.0", t=kind).encode()
        letter = "d" if kind == "double" else "f"
        body = b"".join(struct.pack(f"{sign}B3{letter}f", 7, *c, 0.5) for c in corners(x, y))
        return header + body + struct.pack(f"{sign}B4i", 4, 0, 1, 2, 3)
    return made


DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="square"><mesh><source id="p"><float_array id="pa" count="12">{}</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 2 3</p></polylist>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="vs"><node id="n">{}<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/></scene></COLLADA>"""


def dae(x, y):
    return DAE.format(" ".join("%.3f %.3f %.3f" % c for c in corners(x, y)), "")


def dae_of_nodes(x, y):
    return DAE.format(" ".join("%.3f %.3f %.3f" % c for c in corners(0, 0)), f"<translate>{x + 0.001:.3f} {y:.3f} 0</translate>")


class FarModels(ModelTest):
    def square_metres(self, name, place, **model):
        """The area of the square, counted in pixels of 1.1 mm."""
        scene = self.with_model(name, position_m=place, **model)
        picture = self.picture(scene, camera={"vfov_deg": 8, "resolution": [256, 256]})
        seen = sum(z < 1e9 for row in picture["depth.Z"] for z in row)
        return seen * (4 * math.tan(math.radians(4)) / 256) ** 2

    def test_what_the_file_states_in_double_keeps_its_shape(self):
        for name, content in (("a.obj", obj), ("a.ply", ply_text), ("b.ply", ply_bytes("little")), ("c.ply", ply_bytes("big")), ("a.stl", stl), ("a.dae", dae)):
            for x, y in ((500000, 0), (4000000, 0), (-400000, 5500000), (1e7, -1e7)):
                with self.subTest(name=name, x=x, y=y):
                    data = content(x, y)
                    self.write(name, data)
                    # A row of pixels more or less is 0.5 %.
                    self.assertAlmostEqual(self.square_metres(name, [-x, -y, 0]) / SIZE ** 2, 1, delta=0.0125)
                    self.assertEqual([n for n in self.notes if "precision" in n], [])

    def test_a_model_is_scaled_and_turned_about_its_origin_in_double(self):
        # In millimetres, and a quarter of a turn to the left, which takes z to x and x to -z.
        square = "".join("v %.0f %.0f %.0f\n" % (-1000 * (z + 500000), 1000 * y, 1000 * (x - 4000000)) for x, y, z in corners(0, 0))
        self.write("a.obj", square + "f 1 2 3 4\n")
        area = self.square_metres("a.obj", [4000000, 0, -500000], scale=0.001, turn_deg=90)
        self.assertAlmostEqual(area / SIZE ** 2, 1, delta=0.0125)
        self.assertEqual(self.notes, [])

    def test_what_is_single_precision_in_the_file_is_noted(self):
        self.write("f.ply", ply_bytes("little", "float")(4000000, 0))
        self.picture({"models": [{"file": "f.ply", "position_m": [-4000000, 0, 0]}, {"file": self.near()}]})
        self.assert_noted("f.ply", "single precision", "4e+06 m", "0.25 m")
        self.write("n.dae", dae_of_nodes(4000000, 0))
        self.picture({"models": [{"file": "n.dae", "position_m": [-4000000, 0, 0]}]})
        self.assert_noted("n.dae", "single precision")

    def near(self):
        self.write("near.obj", obj(0, 0))
        return "near.obj"

    def test_a_scene_far_away_is_noted_and_one_too_far_is_refused(self):
        self.write("a.obj", obj(500000, 0))
        self.picture({"models": [{"file": "a.obj"}]}, camera={"position_m": [500000, 0, 0], "look_at_m": [500000, 0, -1]})
        self.assert_noted("a.obj", "single precision", "0.031 m")
        self.write("a.obj", obj(4000000, 0))
        self.refused({"models": [{"file": "a.obj"}]}, "a.obj", "3999999.9", "1e6 m", "position_m")
        square = {"materials": {"m": {}}, "meshes": [{"name": "far", "material": "m", "positions_m": corners(500000, 0), "faces": [[0, 1, 2, 3]]}]}
        self.picture(square, camera={"position_m": [500000, 0, 0], "look_at_m": [500000, 0, -1]})
        self.assert_noted('"far"', "single precision")

    def test_models_near_the_origin_have_no_notes(self):
        for name, content in (("a.obj", obj), ("a.ply", ply_text), ("a.stl", stl), ("a.dae", dae)):
            self.write(name, content(3, -2))
            self.square_metres(name, [-3, 2, 0])
            self.assertEqual(self.notes, [], name)


if __name__ == "__main__":
    unittest.main()
