"""COLLADA files: units and axes, kinds of faces, textures and their coordinates, and what is noted of materials."""
import unittest

from model_pictures import BLUE, GREEN, QUARTERS, RED, YELLOW, ModelTest

SQUARE = [-1, -1, -2, 1, -1, -2, 1, 1, -2, -1, 1, -2]
PAINT = (0.1, 0.2, 0.3)
NOTHING = (0, 0, 0)
DIFFUSE = "<lambert><diffuse><color>0.1 0.2 0.3 1</color></diffuse></lambert>"
TEXTURED = '<lambert><diffuse><texture texture="sampler" texcoord="{}"/></diffuse></lambert>'
AS_IT_IS, ONE_FURTHER, MIRRORED = [0, 0, 1, 0, 1, 1, 0, 1], [1, 1, 2, 1, 2, 2, 1, 2], [1, 0, 0, 0, 0, 1, 1, 1]


def source(name, numbers, parameters):
    count = len(parameters)
    return (f'<source id="{name}"><float_array id="{name}-array" count="{len(numbers)}">{" ".join(map(str, numbers))}</float_array><technique_common>'
            f'<accessor source="#{name}-array" count="{len(numbers) // count}" stride="{count}">' + "".join(f'<param name="{p}" type="float"/>' for p in parameters) +
            "</accessor></technique_common></source>")


def faces(kind, indices, inputs="", counts=""):
    return f'<{kind} count="1" material="M"><input semantic="VERTEX" source="#v" offset="0"/>{inputs}{counts}<p>{indices}</p></{kind}>'


QUAD = faces("polylist", "0 1 2 3", counts="<vcount>4</vcount>")
TWO_SETS = faces("polylist", "0 0 0 1 1 1 2 2 2 3 3 3", counts="<vcount>4</vcount>",
                 inputs='<input semantic="TEXCOORD" source="#first" offset="1" set="0"/><input semantic="TEXCOORD" source="#second" offset="2" set="1"/>')


def sampler(wrap=""):
    return ('<newparam sid="surface"><surface type="2D"><init_from>image</init_from></surface></newparam>'
            f'<newparam sid="sampler"><sampler2D><source>surface</source>{wrap}</sampler2D></newparam>')


def dae(primitives, positions=SQUARE, first=AS_IT_IS, second=AS_IT_IS, effect=DIFFUSE, parameters="", asset="<unit meter='1'/><up_axis>Y_UP</up_axis>", place=""):
    return f"""<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>{asset}</asset>
<library_images><image id="image"><init_from>t.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>{parameters}<technique sid="t">{effect}</technique></profile_COMMON></effect></library_effects>
<library_materials><material id="paint-id" name="paint"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g" name="square"><mesh>{source("p", positions, "XYZ")}{source("first", first, "ST")}{source("second", second, "ST")}
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>{primitives}</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="vs"><node id="n">{place}<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="M" target="#paint-id">
<bind_vertex_input semantic="UV0" input_semantic="TEXCOORD" input_set="0"/><bind_vertex_input semantic="UV1" input_semantic="TEXCOORD" input_set="1"/>
</instance_material></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/></scene></COLLADA>"""


class Collada(ModelTest):
    def see(self, content, **model):
        self.write("t.png", QUARTERS)
        self.write("m.dae", content)
        return self.model("m.dae", **model)

    def test_units_and_axes(self):
        self.assert_quarters(self.see(dae(QUAD, [100 * v for v in SQUARE], asset="<unit meter='0.01'/><up_axis>Y_UP</up_axis>")), *[PAINT] * 4)
        # The upper right quarter: up is z, x, and into the picture is +y, -z; to the right is x, -y.
        self.assert_quarters(self.see(dae(QUAD, [0, 2, 0, 1, 2, 0, 1, 2, 1, 0, 2, 1], asset="<up_axis>Z_UP</up_axis>")), NOTHING, PAINT, NOTHING, NOTHING)
        self.assert_quarters(self.see(dae(QUAD, [0, 0, -2, 0, -1, -2, 1, -1, -2, 1, 0, -2], asset="<up_axis>X_UP</up_axis>")), NOTHING, PAINT, NOTHING, NOTHING)

    def test_kinds_of_faces(self):
        angle = [-1, -1, -2, 1, -1, -2, 1, 0, -2, 0, 0, -2, 0, 1, -2, -1, 1, -2]  # no upper right quarter
        for start in range(6):
            corners = " ".join(str((start + i) % 6) for i in range(6))
            self.assert_quarters(self.see(dae(faces("polylist", corners, counts="<vcount>6</vcount>"), angle)), PAINT, NOTHING, PAINT, PAINT)
        for kind, corners in (("polygons", "0 1 2 3"), ("trifans", "0 1 2 3"), ("tristrips", "0 1 3 2"), ("triangles", "0 1 2 0 2 3")):
            self.assert_quarters(self.see(dae(faces(kind, corners).replace('count="1"', 'count="2"' if kind == "triangles" else 'count="1"'))), *[PAINT] * 4)
        hole = '<polygons count="1" material="M"><input semantic="VERTEX" source="#v" offset="0"/><ph><p>0 1 2 3</p><h>0 1 2</h></ph></polygons>'
        self.write("m.dae", dae(hole))
        self.refused(self.with_model("m.dae"), "m.dae", "<h>")

    def test_places(self):
        """Turned by a quarter to the left, then moved to the left by 1/2: x is halved before, so the left half of the square is seen."""
        flat = [v + (0, 0, 2)[i % 3] for i, v in enumerate(SQUARE)]
        for place in ("<translate>-0.5 0 -2</translate><rotate>0 0 1 90</rotate><scale>1 0.5 1</scale>", "<matrix>0 -0.5 0 -0.5 1 0 0 0 0 0 1 -2 0 0 0 1</matrix>"):
            self.assert_quarters(self.see(dae(QUAD, flat, place=place)), PAINT, NOTHING, PAINT, NOTHING)

    def test_a_texture_has_its_own_coordinates(self):
        for name, expected in (("UV0", (RED, GREEN, BLUE, YELLOW)), ("UV1", (GREEN, RED, YELLOW, BLUE))):
            picture = self.see(dae(TWO_SETS, second=MIRRORED, effect=TEXTURED.format(name), parameters=sampler()))
            self.assert_quarters(picture, *expected)
            self.assertEqual(self.notes, [])

    def test_a_texture_goes_on_as_its_sampler_says(self):
        """One further along u and v; COLLADA's default is WRAP. Its upper right corner is green."""
        repeated, mirrored = (RED, GREEN, BLUE, YELLOW), (YELLOW, BLUE, GREEN, RED)
        for wrap, expected in (("", repeated), ("<wrap_s>WRAP</wrap_s><wrap_t>WRAP</wrap_t>", repeated), ("<wrap_s>MIRROR</wrap_s><wrap_t> MIRROR</wrap_t>", mirrored),
                               ("<wrap_s>MIRROR</wrap_s>", (GREEN, RED, YELLOW, BLUE)), ("<wrap_s>CLAMP</wrap_s>", (GREEN, GREEN, YELLOW, YELLOW)),
                               ("<wrap_s>CLAMP</wrap_s><wrap_t>CLAMP</wrap_t>", [GREEN] * 4)):
            with self.subTest(wrap):
                content = dae(TWO_SETS, first=ONE_FURTHER, effect=TEXTURED.format("UV0"), parameters=sampler(wrap))
                self.assert_quarters(self.see(content), *expected)
                self.assertEqual(self.notes, [])
                self.assert_quarters(self.see(content, texture_wrap="repeat"), *repeated)
        self.see(dae(TWO_SETS, first=ONE_FURTHER, effect=TEXTURED.format("UV0"), parameters=sampler("<wrap_s>BORDER</wrap_s>")))
        self.assert_noted("m.dae", "paint", "border")

    def test_materials(self):
        self.assert_quarters(self.see(dae(QUAD, effect="<constant><emission><color>0 0 0 1</color></emission></constant>")), *[NOTHING] * 4)
        self.see(dae(QUAD, parameters='<newparam sid="c"><float4>0.4 0.5 0.6 1</float4></newparam>', effect='<lambert><diffuse><param ref="c"/></diffuse></lambert>'))
        self.assert_noted("m.dae", "paint", "parameter")
        for transparency in ('<transparent opaque="A_ONE"><color>1 1 1 0.25</color></transparent>', '<transparent opaque="RGB_ZERO"><color>0.75 0.75 0.75 1</color></transparent>',
                             "<transparency><float>0.25</float></transparency>"):
            self.see(dae(QUAD, effect=DIFFUSE.replace("</lambert>", transparency + "</lambert>")))
            self.assert_noted("m.dae", "paint", "transparency")


if __name__ == "__main__":
    unittest.main()
