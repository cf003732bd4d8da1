"""glTF files through the command line, as Khronos' sample models have them: geometry, names, extensions, and what is wrong."""
import math
import unittest

import gltf_models
from gltf_models import COORDINATES, CORNERS, FLOAT, REPEAT, SHORT, BYTE, UNSIGNED_BYTE, Model, png
from gltf_pictures import WHITE, QUARTERS, IN_PLACE, IDENTITY, Gltf


class Geometry(Gltf):
    """BoxInterleaved, SimpleSparseAccessor, SimpleMorph, MeshPrimitiveModes, SimpleSkin, SimpleInstancing, quantized positions."""

    def extent(self, picture):
        """Columns and rows in which something is seen, as (first, last) each."""
        seen = [(x, y) for y in range(32) for x in range(32) if picture["albedo.R"][y][x] > 0]
        return (min(x for x, _ in seen), max(x for x, _ in seen), min(y for _, y in seen), max(y for _, y in seen)) if seen else None

    SQUARE = (8, 23, 8, 23)

    def test_interleaved_attributes(self):
        model = Model()
        rows = b"".join(gltf_models.struct.pack("<3f2f", *p, *c) for p, c in zip(CORNERS, COORDINATES))
        view = model.view(rows, byteStride=20)
        position = model.add("accessors", bufferView=view, componentType=FLOAT, count=4, type="VEC3")
        coordinates = model.add("accessors", bufferView=view, byteOffset=12, componentType=FLOAT, count=4, type="VEC2")
        model.square(model.material(texture=model.picture(QUARTERS)), POSITION=position, TEXCOORD_0=coordinates)
        self.assert_quarters(self.shown(model), IN_PLACE)

    def test_sparse_accessors(self):
        model = Model()
        wide = {1: (3, -1, -2), 2: (3, 1, -2)}  # the right edge goes out of the picture
        model.square(model.material(), POSITION=model.accessor(CORNERS, sparse=wide))
        self.assertEqual(self.extent(self.shown(model)), (8, 31, 8, 23))
        model = Model()
        model.square(model.material(), POSITION=model.accessor([(0, 0, 0)] * 4, sparse=dict(enumerate(CORNERS)), plain=False))
        self.assertEqual(self.extent(self.shown(model)), self.SQUARE)

    def test_quantized_positions_and_normals(self):
        model = Model()
        model.extension("KHR_mesh_quantization", required=True)
        position = model.accessor([(100 * x, 100 * y, 0) for x, y, _ in CORNERS], BYTE, stride=4)
        normal = model.accessor([(0, 0, 127)] * 4, BYTE, stride=4, normalized=True)
        model.node(model.primitive(model.material(), POSITION=position, NORMAL=normal), scale=[0.01, 0.01, 1], translation=[0, 0, -2])
        self.assertEqual(self.extent(self.shown(model)), self.SQUARE)
        model = Model()
        position = model.accessor([(32767 * x, 32767 * y, 0) for x, y, _ in CORNERS], SHORT, stride=8, normalized=True)
        model.node(model.primitive(model.material(), POSITION=position), translation=[0, 0, -2])
        self.assertEqual(self.extent(self.shown(model)), self.SQUARE)

    def test_default_morph_weights(self):
        def morphed(mesh=None, **node):
            model = Model()
            primitive = model.primitive(model.material())
            primitive["targets"] = [{"POSITION": model.accessor([(4, 0, 0)] * 4)}, {"POSITION": model.accessor([(0, 1, 0)] * 4)}]
            model.node(primitive, mesh=mesh, **node)
            return self.extent(self.shown(model))

        self.assertEqual(morphed(), self.SQUARE)
        self.assertEqual(morphed({"weights": [0, 0.5]}), (8, 23, 4, 19))  # half a metre is four pixels, upwards
        self.assertEqual(morphed({"weights": [0, 0.5]}, weights=[0.125, 0]), (12, 27, 8, 23))  # the node's weights rule

    def test_primitive_modes(self):
        strip, fan = [0, 1, 3, 2], [0, 1, 2, 3]
        for mode, indices in ((5, strip), (6, fan), (4, gltf_models.TRIANGLES)):
            model = Model()
            lamp = model.material((1, 1, 1, 1), emissiveFactor=[1, 1, 1])  # which shines only where it faces the eye
            primitive = model.primitive(lamp, indices=indices)
            primitive["mode"] = mode
            model.node(primitive)
            picture = self.shown(model, lights=())
            self.assertEqual(self.extent(picture), self.SQUARE, mode)
            self.assert_near(self.mean(picture), WHITE, what=str(mode))
        model = Model()
        corners = [CORNERS[i] for i in gltf_models.TRIANGLES]
        model.square(model.material(), corners=corners, coordinates=None, indices=None)
        self.assertEqual(self.extent(self.shown(model)), self.SQUARE)

    def test_points_and_lines_are_noted(self):
        model = Model()
        points = {**model.primitive(model.material()), "mode": 0}
        model.node(points, model.primitive(model.material()))
        self.assertEqual(self.extent(self.shown(model)), self.SQUARE)
        self.assert_noted("points or lines")

    def test_a_skinned_mesh_stands_as_its_joints_do(self):
        model = Model()
        joint = model.add("nodes", translation=[0.5, 0, 0])
        model.json["scenes"][0]["nodes"].append(joint)
        matrices = model.accessor([tuple(IDENTITY)])
        skin = model.add("skins", joints=[joint], inverseBindMatrices=matrices)
        weights = {"JOINTS_0": model.accessor([(0, 0, 0, 0)] * 4, UNSIGNED_BYTE), "WEIGHTS_0": model.accessor([(1, 0, 0, 0)] * 4)}
        # The node's own place counts nothing for a skinned mesh.
        model.node(model.primitive(model.material(), **weights), skin=skin, translation=[0, 9, 0])
        self.assertEqual(self.extent(self.shown(model)), (12, 27, 8, 23))

    def test_instancing(self):
        model = Model()
        model.extension("EXT_mesh_gpu_instancing", required=True)
        small = [(x / 4, y / 4, z) for x, y, z in CORNERS]
        model.node(model.primitive(model.material(), corners=small), extensions={"EXT_mesh_gpu_instancing": {
            "attributes": {"TRANSLATION": model.accessor([(-1, 0, 0), (1, 0, 0)])}}})
        self.assertEqual(self.extent(self.shown(model)), (6, 25, 14, 17))

    def test_nodes_in_nodes_and_a_flattened_one(self):
        model = Model()
        child = model.add("nodes", mesh=0, scale=[0.5, 0.5, 1])
        mesh = model.add("meshes", primitives=[model.primitive(model.material())])
        self.assertEqual(mesh, 0)
        model.node(children=[child], translation=[0.5, 0, 0])
        model.json["scenes"][0]["nodes"].append(model.add("nodes", mesh=0, scale=[0, 0, 0]))  # nothing is seen of it, and it does no harm
        self.assertEqual(self.extent(self.shown(model)), (16, 23, 12, 19))

    def test_a_matrix_says_what_its_parts_say(self):
        """x is halved, a quarter turn takes it upwards, and all moves to the right by 1/2; a matrix stands column by column."""
        half, root = [(0, -1, -2), (1, -1, -2), (1, 1, -2), (0, 1, -2)], 0.5 ** 0.5
        for place in ({"matrix": [0, 0.5, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1]},
                      {"translation": [0.5, 0, 0], "rotation": [0, 0, root, root], "scale": [0.5, 1, 1]}):
            model = Model()
            model.node(model.primitive(model.material(), corners=half), **place)
            self.assertEqual(self.extent(self.shown(model)), (12, 27, 12, 15), place)

    def test_the_scene_that_the_file_names(self):
        model = Model()
        model.square(model.material())
        other = model.add("nodes", mesh=0, translation=[0.5, 0, 0])
        model.add("scenes", nodes=[other])
        model.json["scene"] = 1
        self.assertEqual(self.extent(self.shown(model)), (12, 27, 8, 23))
        self.assert_noted("scene 1")

    def test_shared_vertices_of_many_primitives(self):
        model = Model()
        position = model.accessor([(9, 9, 9)] * 50 + CORNERS)
        model.node(*(model.primitive(model.material(), POSITION=position, indices=[50 + i for i in three], coordinates=None)
                     for three in ((0, 1, 2), (0, 2, 3))))
        self.assertEqual(self.extent(self.shown(model)), self.SQUARE)


class Names(Gltf):
    """Box With Spaces, Unicode❤♻Test, files in capitals, data in the document."""

    def textured(self, uri):
        model = Model()
        texture = {"index": model.add("textures", source=model.add("images", uri=uri))}
        model.square(model.material(texture=texture))
        return model

    def test_uris(self):
        for written, file in (("my%20tex.png", "my tex.png"), ("my tex.png", "my tex.png"), ("%E2%9D%A4%E2%99%BB.png", "❤♻.png"),
                              ("❤♻.png", "❤♻.png"), ("100%25.png", "100%.png"), ("100%.png", "100%.png"), ("a%20b.png", "a%20b.png"),
                              ("T.PNG", "T.PNG"), ("deep/t.png", "deep/t.png"), ("deep%2Ft.png", "deep/t.png"), ("deep\\t.png", "deep/t.png"),
                              ("./t.png", "t.png")):
            with self.subTest(written):
                self.write(file, png(QUARTERS))
                self.assert_quarters(self.shown(self.textured(written)), IN_PLACE, written)
                (self.folder / file).unlink()

    def test_buffers_are_named_by_uris_and_suffixes_may_be_capitals(self):
        for uri, buffer, name in (("my%20data.bin", "my data.bin", "model.gltf"), ("%E2%9D%A4.BIN", "❤.BIN", "Unicode❤♻Test.gltf"),
                                  ("m.bin", "m.bin", "M.GLTF"), (None, None, "E.Gltf"), (None, None, "M.GLB"), (None, None, "Box With Spaces.glb")):
            model = Model()
            model.square(model.material(texture=model.picture(QUARTERS)))
            if buffer:
                self.write(buffer, bytes(model.binary))
            model.write(self.folder / name, uri)
            with self.subTest(name):
                self.assert_quarters(self.shown(name), IN_PLACE, name)

    def test_pictures_as_data(self):
        data = gltf_models.base64.b64encode(png(QUARTERS)).decode()
        self.assert_quarters(self.shown(self.textured("data:image/png;base64," + data)), IN_PLACE)

    def test_what_is_missing_is_named(self):
        self.refused(self.textured("no%20where.png"), "/images/0/uri", "no where.png")
        self.refused(self.textured("https://example.org/t.png"), "/images/0/uri", "https://example.org/t.png")
        model = Model()
        model.square(model.material())
        model.write(self.folder / "model.gltf", "nowhere.bin")
        self.refused("model.gltf", "/buffers/0/uri", "nowhere.bin", name="model.gltf")


class Extensions(Gltf):
    def test_unknown_ones_that_are_required_are_refused(self):
        for names, pointer, named in ((["EXT_future"], "/extensionsRequired/0", "EXT_future"),
                                      (["KHR_materials_ior", "KHR_draco_mesh_compression"], "/extensionsRequired/1", "Draco"),
                                      (["EXT_meshopt_compression"], "/extensionsRequired/0", "meshopt"),
                                      (["KHR_texture_basisu"], "/extensionsRequired/0", "KTX2"),
                                      (["KHR_materials_future"], "/extensionsRequired/0", "KHR_materials_future")):
            model = Model()
            model.square(model.material())
            for name in names:
                model.extension(name, required=True)
            self.refused(model, pointer, named)

    def test_what_is_left_out_is_noted_by_name(self):
        left_out = ["KHR_materials_transmission", "KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_specular",
                    "KHR_materials_volume", "KHR_materials_anisotropy", "KHR_materials_iridescence", "KHR_materials_dispersion",
                    "KHR_lights_punctual", "EXT_texture_webp", "KHR_texture_basisu", "KHR_draco_mesh_compression",
                    "EXT_meshopt_compression", "KHR_materials_variants", "EXT_future"]
        model = Model()
        picture = model.picture([[(255, 255, 255)]])
        model.square(model.material(name="thing", normalTexture=picture, occlusionTexture=picture,
                                    extensions={"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_sheen": {}}))
        for name in left_out:
            model.extension(name)
        model.add("cameras", type="perspective", perspective={"yfov": 1, "znear": 0.1})
        model.add("animations", channels=[], samplers=[])
        model.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}
        self.shown(model)
        for name in left_out:
            self.assert_noted(name)
        self.assert_noted('"thing"', "normal map", "occlusion texture", "transmission", "sheen")
        self.assert_noted("1 lights")
        self.assert_noted("1 cameras")
        self.assert_noted("animations")

    def test_what_is_read_is_not_noted(self):
        model = Model()
        model.square(model.material(extensions={"KHR_materials_ior": {"ior": 1.3}}))
        for name in ("KHR_texture_transform", "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_mesh_quantization"):
            model.extension(name, required=True)
        self.shown(model)
        self.assertEqual(self.notes, [])


class Wrong(Gltf):
    """Values that no writer should write: status 2, with the place."""

    def test_values(self):
        def changed(change):
            model = Model()
            model.square(model.material(texture=model.picture(QUARTERS, {"wrapS": REPEAT}), name="m"))
            change(model.json)
            return model

        primitive = lambda g: g["meshes"][0]["primitives"][0]
        for change, *named in [
            (lambda g: g["samplers"][0].update(wrapS=7), "/samplers/0/wrapS", "7"),
            (lambda g: g["materials"][0].update(alphaMode="GLASS"), "/materials/0/alphaMode", "GLASS"),
            (lambda g: g["materials"][0].update(alphaMode="MASK", alphaCutoff=-1), "/materials/0/alphaCutoff", "-1"),
            (lambda g: g["materials"][0].update(emissiveFactor=[-1, 0, 0]), "/materials/0/emissiveFactor", "-1"),
            (lambda g: g["materials"][0]["pbrMetallicRoughness"].update(baseColorFactor=[2, 0, 0, 1]), "/baseColorFactor", "2", "from 0 to 1"),
            (lambda g: g["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"].update(index=9), "/baseColorTexture/index", "9"),
            (lambda g: primitive(g).update(material=5), "/meshes/0/primitives/0/material", "5"),
            (lambda g: primitive(g).update(mode=9), "/meshes/0/primitives/0/mode", "9"),
            (lambda g: primitive(g)["attributes"].update(POSITION=1), "/attributes/POSITION", "VEC2"),
            (lambda g: primitive(g)["attributes"].update(POSITION=77), "/attributes/POSITION", "77"),
            (lambda g: g["nodes"][0].update(mesh=3), "/nodes/0/mesh", "3"),
            (lambda g: g["nodes"][0].update(scale=[1, 1]), "/nodes/0/scale", "[1,1]"),
            (lambda g: g.update(scene=4), "/scene", "4"),
            (lambda g: g["asset"].update(version="1.0"), "/asset/version", "1.0"),
            (lambda g: g["accessors"][0].update(sparse={"count": 9, "indices": {}, "values": {}}), "/accessors/0/sparse/count", "9"),
        ]:
            with self.subTest(named):
                self.refused(changed(change), *named)

    def test_a_triangle_of_a_vertex_that_is_not_there(self):
        model = Model()
        model.square(model.material(), indices=[0, 1, 9])
        self.refused(model, "/meshes/0/primitives/0/indices", "9")

    def test_coordinates_that_are_not_finite(self):
        for attribute in ("POSITION", "TEXCOORD_0", "COLOR_0"):
            model = Model()
            values = [list(row) for row in {"POSITION": CORNERS, "TEXCOORD_0": COORDINATES}.get(attribute, [(1, 1, 1)] * 4)]
            values[2][1] = math.nan
            model.square(model.material(texture=model.picture(QUARTERS)), **{attribute: model.accessor(values)})
            self.refused(model, "/attributes/" + attribute, "finite")


if __name__ == "__main__":
    unittest.main()
