"""glTF files through the command line, as Khronos' sample models have them: textures and colours."""
import math
import unittest

from gltf_models import CLAMP, COORDINATES, FLOAT, MIRROR, NEAREST, REPEAT, UNSIGNED_BYTE, UNSIGNED_SHORT, Model
from gltf_pictures import RED, GREEN, BLUE, YELLOW, QUARTERS, IN_PLACE, Gltf


class TextureCoordinates(Gltf):
    """BoxTextured, TextureSettingsTest, MultiUVTest, TextureTransformTest, quantized coordinates."""

    def test_a_texture_without_sampler_repeats(self):  # BoxTextured: coordinates up to 6
        model = Model()
        model.square(model.material(texture=model.picture(QUARTERS)), coordinates=[(u + 5, v - 3) for u, v in COORDINATES])
        self.assert_quarters(self.shown(model), IN_PLACE)
        self.assert_quarters(self.shown(model, texture_wrap="clamp"), [GREEN] * 4)  # beyond u = 1, v < 0: the upper right corner

    def test_each_axis_wraps_as_its_sampler_says(self):
        # The quarters show u, v = 1.25 and 1.75: repeated .25 .75, mirrored .75 .25, clamped 1.
        def colour(wrap, t):
            return {REPEAT: t - 1, MIRROR: 2 - t, CLAMP: 1}[wrap] > 0.5

        for wrap_s in (REPEAT, MIRROR, CLAMP):
            for wrap_t in (REPEAT, MIRROR, CLAMP):
                model = Model()
                texture = model.picture(QUARTERS, {"wrapS": wrap_s, "wrapT": wrap_t})
                model.square(model.material(texture=texture), coordinates=[(u + 1, v + 1) for u, v in COORDINATES])
                right = [IN_PLACE[2 * colour(wrap_t, v) + colour(wrap_s, u)] for v in (1.25, 1.75) for u in (1.25, 1.75)]
                self.assert_quarters(self.shown(model), right, f"{wrap_s} {wrap_t}")
        self.assert_quarters(self.shown(model, texture_wrap="mirror"), [YELLOW, BLUE, GREEN, RED])

    def test_filters_blend_across_a_repeated_and_a_mirrored_border(self):
        # At u = 0 of black | white texels a bilinear filter sees half of the last texel where it repeats, only the first where it mirrors.
        for wrap, right in ((REPEAT, 0.5), (MIRROR, 0.0), (CLAMP, 0.0)):
            model = Model()
            texture = model.picture([[(0, 0, 0), (255, 255, 255)]], {"wrapS": wrap})
            model.square(model.material(texture=texture), coordinates=[(0, 0.5)] * 4)
            self.assert_near(self.albedo(self.shown(model, texture_filter="bilinear"), 16, 16), [right] * 3, what=str(wrap))

    def test_a_sampler_of_nearest_texels_is_heard_unless_the_scene_says_otherwise(self):
        for filters, stated, right in (({"magFilter": NEAREST}, None, 1), ({}, None, 0.75), ({"magFilter": NEAREST}, "bilinear", 0.75)):
            model = Model()
            texture = model.picture([[(0, 0, 0), (255, 255, 255)]], {"wrapS": CLAMP, **filters})
            model.square(model.material(texture=texture), coordinates=[(0.625, 0.5)] * 4)  # three quarters of the way to white
            self.assert_near(self.albedo(self.shown(model, texture_filter=stated), 16, 16), [right] * 3)

    def test_the_second_set_of_coordinates(self):  # MultiUVTest
        model = Model()
        texture = {**model.picture(QUARTERS), "texCoord": 1}
        swapped = model.accessor([(v, u) for u, v in COORDINATES])
        model.square(model.material(texture=texture), TEXCOORD_1=swapped)
        self.assert_quarters(self.shown(model), [RED, BLUE, GREEN, YELLOW])

    def test_a_missing_set_is_noted(self):
        model = Model()
        model.square(model.material(texture={**model.picture(QUARTERS), "texCoord": 3}))
        self.assert_near(self.albedo(self.shown(model), 16, 16), RED)
        self.assert_noted("TEXCOORD_3")

    def transformed(self, **transform):
        model = Model()
        model.extension("KHR_texture_transform", required=True)
        texture = {**model.picture(QUARTERS), "extensions": {"KHR_texture_transform": transform}}
        model.square(model.material(texture=texture), TEXCOORD_1=model.accessor([(v, u) for u, v in COORDINATES]))
        return self.shown(model)

    def test_transforms(self):
        self.assert_quarters(self.transformed(offset=[0.5, 0]), [GREEN, RED, YELLOW, BLUE])
        self.assert_quarters(self.transformed(offset=[0, 0.5]), [BLUE, YELLOW, RED, GREEN])
        self.assert_quarters(self.transformed(scale=[2, 1], offset=[0.25, 0]), [GREEN, GREEN, YELLOW, YELLOW])
        # A quarter turn takes (u, v) to (v, -u): the quarter at u = v = 1/4 shows (1/4, 3/4), the one at u = 3/4, v = 1/4 shows (1/4, 1/4).
        self.assert_quarters(self.transformed(rotation=math.pi / 2), [BLUE, RED, YELLOW, GREEN])
        # Scale comes first, then the turn, then the offset: (u, v) -> (0.1 + v, 0.2 - 2 u).
        self.assert_quarters(self.transformed(rotation=math.pi / 2, scale=[2, 1], offset=[0.1, 0.2]), [BLUE, BLUE, YELLOW, YELLOW])
        self.assert_quarters(self.transformed(texCoord=1), [RED, BLUE, GREEN, YELLOW])

    def test_integer_coordinates(self):
        for component, full, normalized in ((UNSIGNED_BYTE, 255, True), (UNSIGNED_SHORT, 65535, True)):
            for stride in (None, 8):
                model = Model()
                coordinates = model.accessor([(full * u, full * v) for u, v in COORDINATES], component, stride or (4 if full == 255 else None),
                                             normalized=normalized)
                model.square(model.material(texture=model.picture(QUARTERS)), TEXCOORD_0=coordinates, coordinates=None)
                self.assert_quarters(self.shown(model), IN_PLACE, f"{component} {stride}")

    def test_quantized_coordinates_that_a_transform_scales(self):  # gltfpack
        model = Model()
        model.extension("KHR_mesh_quantization", required=True)
        texture = {**model.picture(QUARTERS), "extensions": {"KHR_texture_transform": {"scale": [1 / 1000, 1 / 1000]}}}
        model.square(model.material(texture=texture), coordinates=None,
                     TEXCOORD_0=model.accessor([(1000 * u, 1000 * v) for u, v in COORDINATES], UNSIGNED_SHORT))
        self.assert_quarters(self.shown(model), IN_PLACE)


class Colours(Gltf):
    """BoxVertexColors, VertexColorTest, metals, SpecGlossVsMetalRough, UnlitTest."""

    def test_vertex_colours_multiply_the_base_colour(self):
        full = {FLOAT: 1, UNSIGNED_BYTE: 255, UNSIGNED_SHORT: 65535}
        for component, one in full.items():
            for alpha in ((), (one,)):
                model = Model()
                row = (one, 0.2 * one if component == FLOAT else one // 5, 0, *alpha)
                stride = 4 if component == UNSIGNED_BYTE else 8 if component == UNSIGNED_SHORT else None
                colours = model.accessor([row] * 4, component, stride, normalized=component != FLOAT)
                model.square(model.material((1, 0.5, 1, 1)), COLOR_0=colours)  # 255/256 would be seen
                self.assert_near(self.albedo(self.shown(model), 16, 16), (1, 0.1, 0), what=f"{component} {alpha}")

    def test_vertex_colours_are_interpolated_and_multiply_the_texture(self):
        model = Model()
        colours = model.accessor([(0, 0, 0), (1, 1, 1), (1, 1, 1), (0, 0, 0)])  # from left to right
        model.square(model.material(texture=model.picture([[(255, 0, 0)]])), COLOR_0=colours)
        picture = self.shown(model)
        for x in (10, 16, 21):  # a pixel's centre; the square is 16 pixels wide from 8 on; samples lie anywhere in the pixel
            self.assertAlmostEqual(self.albedo(picture, x, 16)[0], (x + 0.5 - 8) / 16, delta=0.5 / 16 + 1e-3)
            self.assertEqual(self.albedo(picture, x, 16)[1], 0)

    def test_a_metal_is_tinted_by_its_colours_and_its_texture(self):
        model = Model()
        model.square(COLOR_0=model.accessor([(0.9, 0.5, 0.2)] * 4))  # glTF's default material is a rough metal
        picture = self.shown(model)
        self.assert_near(self.albedo(picture, 16, 16), (0.9, 0.5, 0.2))
        model = Model()
        metal = model.add("materials", pbrMetallicRoughness={"baseColorTexture": model.picture(QUARTERS)})
        model.square(metal)
        self.assert_quarters(self.shown(model), IN_PLACE)

    def test_specular_glossiness(self):
        model = Model()
        model.extension("KHR_materials_pbrSpecularGlossiness")
        model.square(model.add("materials", extensions={"KHR_materials_pbrSpecularGlossiness": {
            "diffuseFactor": [0.5, 1, 1, 1], "diffuseTexture": model.picture(QUARTERS), "glossinessFactor": 0}}))
        self.assert_quarters(self.shown(model), [(0.5 * r, g, b) for r, g, b in IN_PLACE])
        self.assert_noted("KHR_materials_pbrSpecularGlossiness", "specular")

    def test_unlit_surfaces_keep_their_colour_and_are_noted(self):
        model = Model()
        model.extension("KHR_materials_unlit")
        model.square(model.add("materials", pbrMetallicRoughness={"baseColorFactor": [0.2, 0.4, 0.6, 1]},
                               extensions={"KHR_materials_unlit": {}}))
        self.assert_near(self.albedo(self.shown(model), 16, 16), (0.2, 0.4, 0.6))
        self.assert_noted("KHR_materials_unlit")


if __name__ == "__main__":
    unittest.main()
