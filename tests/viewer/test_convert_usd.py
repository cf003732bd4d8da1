"""scripts/convert_usd: USD scenes as glTF files that the program reads. Places, colours and coordinates are derived by hand from what the files state."""
import json
import math
import pathlib
import struct
import subprocess
import sys
import unittest
import zipfile

from model_pictures import BLUE, GREEN, QUARTERS, RED, YELLOW, ModelTest
from picture_files import png
from sturm_process import SOURCE
from usd_crate import ATTRIBUTE, PRIM, RELATIONSHIP, Crate

# Four values a row that are exact in sRGB's straight part or at its ends.
TEXELS = [[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 255)]]
CARD = """
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 1)]
        uniform token subdivisionScheme = "none"
"""
HEAD = '#usda 1.0\n(\n    defaultPrim = "Room"\n    metersPerUnit = 1\n    upAxis = "Y"\n)\n'


def room(body, head=HEAD):
    return head + 'def Xform "Room"\n{\n' + body + "\n}\n"


def card(extra="", name="Card"):
    return f'    def Mesh "{name}"\n    {{{CARD}{extra}\n    }}\n'


def material(name, surface, more=""):
    return f"""    def Material "{name}"
    {{
        token outputs:surface.connect = </Room/{name}/Surface.outputs:surface>
        def Shader "Surface"
        {{
            uniform token info:id = "UsdPreviewSurface"
            {surface}
            token outputs:surface
        }}
{more}
    }}
"""


def texture(owner, name, file, output="rgb", more=""):
    return f"""        def Shader "{name}"
        {{
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{file}@
            {more}
            float3 outputs:{output}
        }}
"""


class Glb:
    """Meshes by their names: corners of their triangles, and what they state of their surface."""

    def __init__(self, path):
        data = path.read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json, self.data = json.loads(data[20:20 + length]), data[28 + length:]
        self.meshes = {node["name"]: self.json["meshes"][node["mesh"]]["primitives"] for node in self.json["nodes"]}

    def accessor(self, number):
        item = self.json["accessors"][number]
        view, size = self.json["bufferViews"][item["bufferView"]], {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[item["type"]]
        form = f"<{size}{ {5123: 'H', 5125: 'I', 5126: 'f'}[item['componentType']] }"
        step, at = view.get("byteStride", struct.calcsize(form)), view.get("byteOffset", 0) + item.get("byteOffset", 0)
        return [struct.unpack_from(form, self.data, at + k * step) for k in range(item["count"])]

    def corners(self, name, what="POSITION", part=0):
        primitive = self.meshes[name][part]
        values = self.accessor(primitive["attributes"][what])
        return [tuple(round(x, 6) + 0.0 for x in values[k]) for (k,) in self.accessor(primitive["indices"])]

    def material(self, name, part=0):
        return self.json["materials"][self.meshes[name][part]["material"]]

    def base(self, name, part=0):
        return self.material(name, part)["pbrMetallicRoughness"]


class ConvertUsd(ModelTest):
    def convert(self, text, name="room.usda", **files):
        (self.folder / name).write_text(text)
        for path, content in files.items():
            (self.folder / f"{path}.usda").write_text(content)
        return self.converted(self.folder / name)

    def converted(self, path, status=0):
        target = self.folder / "out.glb"
        done = subprocess.run([SOURCE / "scripts/convert_usd", path, target], capture_output=True, text=True, cwd=self.folder)
        self.said = done.stderr
        self.assertEqual(done.returncode, status, self.said)
        if status:
            self.assertFalse(list(self.folder.glob("out.glb*")))
            return None
        return Glb(target)

    def refused_text(self, text, *expected, **files):
        (self.folder / "room.usda").write_text(text)
        for path, content in files.items():
            (self.folder / f"{path}.usda").write_text(content)
        self.converted(self.folder / "room.usda", status=2)
        for words in expected:
            self.assertIn(words, self.said)
        self.assertEqual(self.said.count("\n"), 1)

    def test_units_and_the_axis_that_is_up(self):
        glb = self.convert(room(card(), HEAD.replace("= 1\n", "= 0.5\n").replace('"Y"', '"Z"')))
        # x, y, z in half metres are x/2, z/2, -y/2 here; a quadrangle is two triangles.
        self.assertEqual(set(glb.corners("Card")), {(0, 0, 0), (1, 0, 0), (1, 0, -0.5), (0, 0.5, -0.5)})
        self.assertEqual(len(glb.corners("Card")), 6)
        self.assertNotIn("NORMAL", glb.meshes["Card"][0]["attributes"])  # polygons that state none are flat
        glb = self.convert(room(card(), HEAD.replace("    metersPerUnit = 1\n", "")))
        self.assertIn((0.02, 0.01, 0), glb.corners("Card"))
        self.assertIn("centimetres", self.said)

    def test_any_layout_of_the_text(self):
        tidy = self.convert(room(card('        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (\n            interpolation = "vertex"\n        )')))
        crowded = self.convert('#usda 1.0 # a remark\n(metersPerUnit=1;upAxis="Y") /* and\nanother */ def Xform"Room"{def Mesh "Card"(kind="x"){int[] faceVertexCounts=[4] int[]faceVertexIndices=[0,1,2,3,]'
                               'point3f[] points=[(0,0,0),(2,0,0),\n(2,1,0),(0,1,1e0)] token subdivisionScheme="none" texCoord2f[] primvars:st=[(0,0),(1,0),(1,1),(0,1)](interpolation="vertex")}}')
        self.assertEqual(crowded.corners("Card"), tidy.corners("Card"))
        spread = self.convert(HEAD + " \n" * 2_000_000 + "# a line\n" * 100_000 + 'def Xform "Room" (doc = "' + "x" * 1_000_000 + '") {' + card() + "}")
        self.assertEqual(spread.corners("Card"), tidy.corners("Card"))

    def test_all_operations_that_move_a_prim(self):
        def turn(axis, degrees):
            c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
            return lambda p: [c * p[k] - s * p[j] if k == i else s * p[i] + c * p[j] if k == j else p[k] for k in range(3)]

        def move(*by):
            return lambda p: [a + b for a, b in zip(p, by)]

        # The operation that stands last acts first.
        cases = {
            'double3 xformOp:translate = (1, 2, 3) float3 xformOp:rotateXYZ = (30, 40, 50) float3 xformOp:scale = (2, 3, 4) uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateXYZ", "xformOp:scale"]':
                [lambda p: [2 * p[0], 3 * p[1], 4 * p[2]], turn("x", 30), turn("y", 40), turn("z", 50), move(1, 2, 3)],
            'float3 xformOp:rotateZXY = (30, 40, 50) uniform token[] xformOpOrder = ["xformOp:rotateZXY"]': [turn("z", 50), turn("x", 30), turn("y", 40)],
            'float3 xformOp:translate:pivot = (1, 0, 2) float xformOp:rotateY:bend = 90 uniform token[] xformOpOrder = ["xformOp:translate:pivot", "xformOp:rotateY:bend", "!invert!xformOp:translate:pivot"]':
                [move(-1, 0, -2), turn("y", 90), move(1, 0, 2)],
            f'quatf xformOp:orient = ({math.cos(math.radians(20))}, 0, 0, {math.sin(math.radians(20))}) uniform token[] xformOpOrder = ["xformOp:orient"]': [turn("z", 40)],
            'matrix4d xformOp:transform:a = ((0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (5, 6, 7, 1)) uniform token[] xformOpOrder = ["xformOp:transform:a"]': [turn("z", 90), move(5, 6, 7)],
        }
        for text, steps in cases.items():
            with self.subTest(text=text):
                corners = self.convert(room(card(text))).corners("Card")
                expected = (2.0, 1.0, 0.0)
                for step in steps:
                    expected = step(expected)
                self.assertLess(min(math.dist(expected, corner) for corner in corners), 2e-6)  # single precision at 12 m

    def test_a_mirrored_prim_faces_the_way_it_did(self):
        glb = self.convert(room(card('float3 xformOp:scale = (-1, 1, 1) uniform token[] xformOpOrder = ["xformOp:scale"]')))
        a, b, c = glb.corners("Card")[:3]
        u, v = ([q[k] - a[k] for k in range(3)] for q in (b, c))
        # Its first triangle faces +z before and after.
        self.assertGreater(u[0] * v[1] - u[1] * v[0], 0)

    def test_layers_references_and_variants(self):
        chair = room(card("rel material:binding = </Room/Red>") + material("Red", "color3f inputs:diffuseColor = (1, 0, 0)")).replace('"Room"', '"Chair"').replace("/Room/", "/Chair/")
        other = room(card()) + 'class "_leg" {' + card(name="Leg") + '}\ndef Xform "Stool"\n{\n    def "L" (references = </_leg>) { }\n' + card("color3f[] primvars:displayColor = [(0, 1, 0)]", "Seat") + "}\n"
        moved = 'double3 xformOp:translate = (10, 0, 0) uniform token[] xformOpOrder = ["xformOp:translate"]'
        glb = self.convert(HEAD.replace("(\n", "(\n    subLayers = [@./below.usda@]\n", 1) + f"""
class "_kind" {{ {card(name="Kind")} }}
def Xform "Room" (
    variants = {{ string size = "tall" }}
    prepend variantSets = "size"
) {{
    def "A" (prepend references = @chair.usda@) {{ {moved} }}
    def "B" (references = [@./other.usda@</Stool>]) {{ over "Seat" {{ color3f[] primvars:displayColor = [(0, 0, 1)] double3 xformOp:translate = (0, 5, 0) uniform token[] xformOpOrder = ["xformOp:translate"] }} }}
    def "C" (inherits = </_kind>) {{ }}
    def "D" (active = false) {{ {card(name="Gone")} }}
    def Mesh "Hidden" {{ {CARD} token visibility = "invisible" }}
    def Xform "Proxy" {{ uniform token purpose = "proxy" {card(name="Coarse")} }}
    variantSet "size" = {{
        "small" {{ {card(name="Small")} }}
        "tall" {{ def Xform "Tower" (payload = @chair.usda@) {{ }} }}
    }}
}}
""", chair=chair, other=other, below=HEAD + f'over "Room" {{ {card(name="Below")} }}\n')
        self.assertEqual(sorted(glb.meshes), ["Below", "Card", "Kind", "Leg", "Seat"])  # Card stands there twice
        places = [min(glb.corners(name)) for name in ("Below", "Kind", "Seat")]
        self.assertEqual(places, [(0, 0, 0), (0, 0, 0), (0, 5, 0)])
        self.assertEqual(glb.base("Card")["baseColorFactor"][:3], [1, 0, 0])  # bound within the file that is referenced
        self.assertEqual(glb.base("Seat")["baseColorFactor"][:3], [0, 0, 1])  # who references has the last word
        cards = [primitive for node in glb.json["nodes"] if node["name"] == "Card" for primitive in glb.json["meshes"][node["mesh"]]["primitives"]]
        self.assertEqual(sorted(min(glb.accessor(primitive["attributes"]["POSITION"])) for primitive in cards), [(0, 0, 0), (10, 0, 0)])
        self.assertIn("Hidden objects, proxies and guides are left out (2)", self.said)

    def test_surfaces(self):
        binding = "rel material:binding = </Room/{}>".format
        (self.folder / "packed.png").write_bytes(png([[(51, 204, 102), (153, 204, 204)]]))
        (self.folder / "texels.png").write_bytes(png(TEXELS))
        transform = """        def Shader "Moved"
        {
            uniform token info:id = "UsdTransform2d"
            float2 inputs:scale = (2, 0.5)
            float2 inputs:translation = (0.25, 0.125)
            float2 outputs:result
        }
"""
        st = "texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (interpolation = \"vertex\")"
        glb = self.convert(room(
            card(name="Bare") + card("color3f[] primvars:displayColor = [(0.5, 0.25, 0.125)]", "Painted") + card(binding("Plain"), "OfPlain") + card(binding("White") + " color3f[] primvars:displayColor = [(0, 1, 0)]", "OfWhite") +
            card(binding("Metal") + st, "OfMetal") + card(binding("Lamp"), "OfLamp") + card(binding("Veil"), "OfVeil") + card(binding("Mapped") + st, "OfMapped") +
            material("Plain", "") + material("White", "color3f inputs:diffuseColor = (1, 1, 1)") + material("Lamp", "color3f inputs:emissiveColor = (2, 4, 8)") +
            material("Veil", "float inputs:opacity = 0.25") +
            material("Metal", "float inputs:roughness.connect = </Room/Metal/R.outputs:r> float inputs:metallic.connect = </Room/Metal/R.outputs:b>", texture("Metal", "R", "packed.png", "r")) +
            material("Mapped", "color3f inputs:diffuseColor.connect = </Room/Mapped/T.outputs:rgb>",
                     texture("Mapped", "T", "./texels.png", more='float2 inputs:st.connect = </Room/Mapped/Moved.outputs:result> token inputs:wrapS = "clamp" token inputs:wrapT = "mirror"') + transform)))
        self.assertEqual(glb.base("Bare")["baseColorFactor"][:3], [0.6, 0.6, 0.6])  # as everywhere in the program
        self.assertEqual(glb.base("Painted")["baseColorFactor"][:3], [0.5, 0.25, 0.125])
        self.assertEqual(glb.base("OfPlain"), {"baseColorFactor": [0.18, 0.18, 0.18, 1], "roughnessFactor": 0.5, "metallicFactor": 0})  # UsdPreviewSurface's defaults
        self.assertEqual(glb.base("OfWhite").get("baseColorFactor", [1, 1, 1, 1]), [1, 1, 1, 1])  # a material outweighs displayColor
        self.assertEqual((glb.base("OfMetal")["roughnessFactor"], glb.base("OfMetal")["metallicFactor"]), (0.4, 0.6))  # (51 + 153)/2/255, (102 + 204)/2/255
        self.assertIn('roughness and metal of "Metal"', self.said)
        lamp = glb.material("OfLamp")
        self.assertEqual([8 * x / lamp["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] for x in lamp["emissiveFactor"]], [0.25, 0.5, 1])
        self.assertEqual(lamp["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 8)
        self.assertEqual((glb.base("OfVeil")["baseColorFactor"][3], glb.material("OfVeil")["alphaMode"]), (0.25, "BLEND"))
        # (s, t) → (2s + 1/4, t/2 + 1/8), and glTF counts rows from above.
        self.assertEqual({place: at for place, at in zip(glb.corners("OfMapped"), glb.corners("OfMapped", "TEXCOORD_0"))},
                         {(0, 0, 0): (0.25, 0.875), (2, 0, 0): (2.25, 0.875), (2, 1, 0): (2.25, 0.375), (0, 1, 1): (0.25, 0.375)})
        sampler = glb.json["samplers"][glb.json["textures"][glb.base("OfMapped")["baseColorTexture"]["index"]]["sampler"]]
        self.assertEqual((sampler["wrapS"], sampler["wrapT"]), (33071, 33648))
        self.assertTrue(all(m["doubleSided"] for m in glb.json["materials"]))

    def test_parts_of_a_mesh(self):
        two = """    def Mesh "Card"
    {
        int[] faceVertexCounts = [3, 3]
        int[] faceVertexIndices = [0, 1, 2, 0, 2, 3]
        point3f[] points = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 1)]
        uniform token subdivisionScheme = "none"
        def GeomSubset "first" { int[] indices = [0] uniform token elementType = "face" rel material:binding = </Room/Red> }
        def GeomSubset "second" { int[] indices = [1] uniform token elementType = "face" rel material:binding = </Room/Blue> }
    }
"""
        glb = self.convert(room(two + material("Red", "color3f inputs:diffuseColor = (1, 0, 0)") + material("Blue", "color3f inputs:diffuseColor = (0, 0, 1)")))
        found = {tuple(glb.base("Card", k)["baseColorFactor"][:3]): set(glb.corners("Card", part=k)) for k in range(2)}
        self.assertEqual(found, {(1, 0, 0): {(0, 0, 0), (2, 0, 0), (2, 1, 0)}, (0, 0, 1): {(0, 0, 0), (2, 1, 0), (0, 1, 1)}})

    def test_binary_layers(self):
        crate = {
            "/": (7, {"upAxis": ("token", "Z"), "metersPerUnit": ("double", 0.5), "defaultPrim": ("token", "Room"), "primChildren": ("tokens", ["Room"])}),
            "/Room": (PRIM, {"specifier": ("specifier", 0), "typeName": ("token", "Xform"), "primChildren": ("tokens", ["Card", "Red"])}),
            "/Room/Card": (PRIM, {"specifier": ("specifier", 0), "typeName": ("token", "Mesh")}),
            "/Room/Card.points": (ATTRIBUTE, {"typeName": ("token", "point3f[]"), "default": ("float3[]", [(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 1)])}),
            "/Room/Card.faceVertexCounts": (ATTRIBUTE, {"typeName": ("token", "int[]"), "default": ("int[]", [4])}),
            "/Room/Card.faceVertexIndices": (ATTRIBUTE, {"typeName": ("token", "int[]"), "default": ("int[]", [0, 1, 2, 3])}),
            "/Room/Card.primvars:st": (ATTRIBUTE, {"typeName": ("token", "texCoord2f[]"), "default": ("float2[]", [(0, 0), (1, 0), (1, 1), (0, 1)])}),
            "/Room/Card.xformOp:translate": (ATTRIBUTE, {"typeName": ("token", "float3"), "default": ("float3", (1, 2, 3))}),
            "/Room/Card.xformOpOrder": (ATTRIBUTE, {"typeName": ("token", "token[]"), "default": ("token[]", ["xformOp:translate"])}),
            "/Room/Card.material:binding": (RELATIONSHIP, {"targetPaths": ("paths", ["/Room/Red"])}),
            "/Room/Red": (PRIM, {"specifier": ("specifier", 0), "typeName": ("token", "Material"), "primChildren": ("tokens", ["S", "T"])}),
            "/Room/Red/S": (PRIM, {"specifier": ("specifier", 0), "typeName": ("token", "Shader")}),
            "/Room/Red/S.info:id": (ATTRIBUTE, {"typeName": ("token", "token"), "default": ("token", "UsdPreviewSurface")}),
            "/Room/Red/S.inputs:diffuseColor": (ATTRIBUTE, {"typeName": ("token", "color3f"), "connectionPaths": ("paths", ["/Room/Red/T.outputs:rgb"])}),
            "/Room/Red/S.inputs:roughness": (ATTRIBUTE, {"typeName": ("token", "float"), "default": ("float", 0.25)}),
            "/Room/Red/T": (PRIM, {"specifier": ("specifier", 0), "typeName": ("token", "Shader")}),
            "/Room/Red/T.info:id": (ATTRIBUTE, {"typeName": ("token", "token"), "default": ("token", "UsdUVTexture")}),
            "/Room/Red/T.inputs:file": (ATTRIBUTE, {"typeName": ("token", "asset"), "default": ("asset", "textures/a.png")}),
            "/Room/Red/T.outputs:rgb": (ATTRIBUTE, {"typeName": ("token", "float3")}),
        }
        layer, archive = self.folder / "room.usdc", self.folder / "room.usdz"
        Crate(crate).write(layer)
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as package:
            package.write(layer, "room.usdc")
            package.writestr("textures/a.png", png(TEXELS))
        glb = self.converted(archive)
        self.assertEqual(set(glb.corners("Card")), {(0.5, 1.5, -1), (1.5, 1.5, -1), (1.5, 1.5, -1.5), (0.5, 2, -1.5)})
        self.assertEqual(dict(zip(glb.corners("Card"), glb.corners("Card", "TEXCOORD_0")))[(0.5, 2, -1.5)], (0, 0))
        self.assertEqual(glb.base("Card")["roughnessFactor"], 0.25)
        view = glb.json["bufferViews"][glb.json["images"][0]["bufferView"]]
        self.assertEqual(glb.data[view["byteOffset"]:view["byteOffset"] + view["byteLength"]], png(TEXELS))  # as it was

    def test_names_within_an_archive_are_relative_to_the_layer(self):
        archive = self.folder / "room.usdz"
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as package:
            package.writestr("room.usda", room('    def "A" (references = @./parts/card.usda@) { }'))
            package.writestr("parts/card.usda", room(card("rel material:binding = </Room/M>") + material("M", "color3f inputs:diffuseColor.connect = </Room/M/T.outputs:rgb>", texture("M", "T", "../pictures/a.png"))))
            package.writestr("pictures/a.png", png(TEXELS))
        self.assertIn("baseColorTexture", self.converted(archive).base("Card"))

    def test_the_program_draws_it(self):
        """A square of four colours, each seen where the file has it."""
        self.write("quarters.png", QUARTERS)
        square = """    def Mesh "Square"
    {
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(-1, -1, -2), (1, -1, -2), (1, 1, -2), (-1, 1, -2)]
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (interpolation = "vertex")
        rel material:binding = </Room/Paper>
    }
"""
        self.convert(room(square + material("Paper", "color3f inputs:diffuseColor.connect = </Room/Paper/T.outputs:rgb> float inputs:roughness = 1", texture("Paper", "T", "quarters.png"))))
        self.assert_quarters(self.model("out.glb"), RED, GREEN, BLUE, YELLOW)

    def test_what_cannot_be_read_is_said(self):
        self.refused_text(room(card('color3f[] primvars:displayColor = [(0.5, 0.25'.replace("[(", "[("))), "room.usda: line ", 'expected "," or')
        self.refused_text("solid cube", 'room.usda: it does not begin with "#usda 1.0"')
        self.refused_text(room('    def "A" (references = @gone.usda@) { }' + card()), "it names the file gone.usda, which is not there")
        self.refused_text(room('    def "A" (references = @broken.usda@) { }' + card()), "in broken.usda, line 2", broken='#usda 1.0\ndef Xform "A" { int x = ; }\n')
        self.refused_text(room(card("rel material:binding = </Room/M>") + material("M", "color3f inputs:diffuseColor.connect = </Room/M/T.outputs:rgb>", texture("M", "T", "gone.png"))), "it names the file gone.png")
        self.refused_text(room('    def PointInstancer "P" { }'), "there is no surface in it")
        self.refused_text(room(card('float xformOp:shear = 1 uniform token[] xformOpOrder = ["xformOp:shear"]')), "/Room/Card is moved by xformOp:shear")
        self.refused_text('#usda 1.0\n(subLayers = [@room.usda@])\n', "contains itself")
        self.refused_text(room("    def \"A\" (references = </Room>) { }" + card()), "nested more than 50 deep")
        self.refused_text(room("def Xform \"A\" {" * 600 + "}" * 600), "nested more than 500 deep")
        packed = self.folder / "packed.usdz"
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as package:
            package.writestr("room.usda", room(card()))
        self.converted(packed, status=2)
        self.assertIn("compressed", self.said)
        # An archive names nothing outside of it, whatever lies there.
        self.write("beside.usda", room(card()))
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_STORED) as package:
            package.writestr("room.usda", room('    def "A" (references = @../beside.usda@) { }\n    def "B" (references = @beside.usda@) { }' + card()))
        self.converted(packed, status=2)
        self.assertIn("../beside.usda, beside.usda, which is not there", self.said)
        self.converted(self.folder / "nothing.usdz", status=2)
        self.assertIn("no such file", self.said)
        self.converted(self.folder, status=2)
        done = subprocess.run([SOURCE / "scripts/convert_usd", "room.usda", "room.obj"], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual((done.returncode, "Usage" in done.stderr), (2, True))


if __name__ == "__main__":
    if not (pathlib.Path(SOURCE) / "viewer/node_modules").is_dir():
        print("the libraries of the viewer's page are not here")
        sys.exit(77)
    unittest.main()
