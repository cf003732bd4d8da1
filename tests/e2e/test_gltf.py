"""glTF files through the command line: models of the features that Khronos' sample models have, each with its right numbers."""
import json
import math
import unittest

import gltf_models
from exr_header import float_pixels
from gltf_models import (CLAMP, COORDINATES, CORNERS, FLOAT, MIRROR, NEAREST, REPEAT, SHORT, BYTE, UNSIGNED_BYTE, UNSIGNED_INT,
                         UNSIGNED_SHORT, Model, mixed, png)
from sturm_process import PASSED, WRONG_INPUT, FolderTest, sturm

RED, GREEN, BLUE, YELLOW, BLACK, WHITE = (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 0, 0), (1, 1, 1)
QUARTERS = [[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 0)]]  # as a picture: rows from the top
IN_PLACE = [RED, GREEN, BLUE, YELLOW]                                    # how the square then looks: upper row, lower row
PLACES = [(12, 12), (20, 12), (12, 20), (20, 20)]                        # pixels of the square's quarters
LIGHT = {"type": "point", "position_m": [0, 0, 0], "intensity": [1, 1, 1]}
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


class Gltf(FolderTest):
    def view(self, file, lights=(LIGHT,), samples=1, bounces=1, camera=None, **model):
        model.setdefault("texture_filter", "nearest")
        view = {"format": "sturm.render/1",
                "scene": {"models": [{"file": file, **{k: v for k, v in model.items() if v is not None}}], "lights": list(lights)},
                "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 90, "resolution": [32, 32], **(camera or {})},
                "eye": {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 0},
                "method": {"type": "path_trace", "ray_model": "pinhole", "samples_per_pixel": samples, "max_bounces": bounces}}
        return self.write("view.json", view)

    def shown(self, model, name="model.glb", **options):
        """Channels of the picture of a model (a file's name, or a Model that is written first); self.notes are its notes."""
        if isinstance(model, Model):
            model.write(self.folder / name)
        else:
            name = model
        self.succeed("render", self.view(name, **options), "-o", self.folder / "out.exr", "--quiet")
        self.notes = json.loads((self.folder / "out.manifest.json").read_text())["notes"]
        return float_pixels((self.folder / "out.exr").read_bytes())

    def refused(self, model, *named, name="model.glb"):
        if isinstance(model, Model):
            model.write(self.folder / name)
        process = sturm("render", self.view(name), "-o", self.folder / "out.exr", "--quiet")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        for word in (name, *named):
            self.assertIn(word, process.stderr)

    def assert_noted(self, *words):
        self.assertTrue(any(all(w in note for w in words) for note in self.notes), f"{words}: {self.notes}")

    def assert_not_noted(self, word):
        self.assertFalse(any(word in note for note in self.notes), self.notes)

    def assert_near(self, seen, right, tolerance=2e-3, what=""):
        """The tolerance is 16-bit halves' of the layers, unless stated."""
        for a, b in zip(seen, right):
            self.assertAlmostEqual(a, b, delta=tolerance * max(1, abs(b)), msg=f"{what}: {seen}, right: {right}")

    @staticmethod
    def albedo(picture, x, y):
        return [picture["albedo." + c][y][x] for c in "RGB"]

    @staticmethod
    def radiance(picture, x, y):
        return [picture[c][y][x] for c in "RGB"]

    @staticmethod
    def mean(picture, layer="", low=9, high=23):
        return [sum(picture[layer + c][y][x] for y in range(low, high) for x in range(low, high)) / (high - low) ** 2 for c in "RGB"]

    def assert_quarters(self, picture, right, what=""):
        for (x, y), colour in zip(PLACES, right):
            self.assert_near(self.albedo(picture, x, y), colour, what=f"{what} at {x}, {y}")


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
                model.square(model.material((0.5, 0.5, 1, 1)), COLOR_0=colours)
                self.assert_near(self.albedo(self.shown(model), 16, 16), (0.5, 0.1, 0), what=f"{component} {alpha}")

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


class Emission(Gltf):
    """EmissiveStrengthTest, emissive textures, double-sided lamps, NegativeScaleTest."""

    LAMP = {"emissiveFactor": [1, 0.5, 0.25]}

    def lamp(self, **more):
        model = Model()
        material = model.material((0, 0, 0, 1), **{**self.LAMP, **more})
        return model, material

    def test_emissive_strength(self):
        model, lamp = self.lamp(extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 10}})
        model.extension("KHR_materials_emissive_strength")
        model.square(lamp)
        self.assert_near(self.radiance(self.shown(model, lights=()), 16, 16), (10, 5, 2.5))

    def test_an_emissive_texture_is_seen_and_lights(self):
        model, lamp = self.lamp()
        model.json["materials"][lamp]["emissiveTexture"] = model.picture(QUARTERS)
        model.square(lamp)
        picture = self.shown(model, lights=())
        for (x, y), colour in zip(PLACES, IN_PLACE):
            self.assert_near(self.radiance(picture, x, y), [a * b for a, b in zip(colour, (1, 0.5, 0.25))])
        # Half of a lamp: black on the left. What it sends to a wall beside is what a lamp sends that has only that half.
        def lit(half):
            model = Model()
            texture = {"emissiveTexture": model.picture([[(0, 0, 0), (255, 255, 255)]])} if not half else {}
            lamp = model.material((0, 0, 0, 1), emissiveFactor=[1, 1, 1], **texture)
            left = 0 if half else -1
            model.square(lamp, corners=[(left, 3, -1), (left, 3, -3), (1, 3, -3), (1, 3, -1)],
                         coordinates=[(0, 1), (0, 0), (1, 0), (1, 1)])
            model.wall()
            return self.mean(self.shown(model, lights=(), samples=256), low=0, high=32)[1]

        half, textured = lit(True), lit(False)
        self.assertGreater(half, 0.005)
        self.assertAlmostEqual(textured / half, 1, delta=0.02)  # 4 sigma of 1024 pixels of 256 samples

    def test_only_double_sided_lamps_shine_backwards(self):
        for double, turned, right in ((False, False, 1), (False, True, 0), (True, False, 1), (True, True, 1)):
            model, lamp = self.lamp(doubleSided=double)
            corners = [CORNERS[i] for i in (0, 3, 2, 1)] if turned else CORNERS
            model.square(lamp, corners=corners)
            self.assert_near(self.radiance(self.shown(model, lights=()), 16, 16), [right * c for c in (1, 0.5, 0.25)])

    def test_a_double_sided_lamp_lights_both_sides_alike(self):
        def lit(double, turned):
            model, lamp = self.lamp(doubleSided=double, emissiveFactor=[1, 1, 1])
            corners = [(-1, 3.5, -3), (1, 3.5, -3), (1, 5.5, -3), (-1, 5.5, -3)]  # above the view, parallel to the wall
            model.square(lamp, corners=corners if turned else corners[::-1])
            model.wall()
            return self.mean(self.shown(model, lights=(), samples=64), low=0, high=32)[0]

        to_the_wall = lit(False, False)
        self.assertGreater(to_the_wall, 0.01)
        self.assertEqual(lit(False, True), 0)
        for turned in (False, True):
            self.assertAlmostEqual(lit(True, turned) / to_the_wall, 1, delta=0.02)  # 4 sigma of 1024 pixels of 64 samples

    def test_mirrored_nodes_keep_their_front(self):  # NegativeScaleTest, OrientationTest
        half_turn = [0, 1, 0, 0]
        for node, right in (({}, 1), ({"scale": [-1, 1, 1]}, 1), ({"scale": [-1, -1, 1]}, 1), ({"scale": [-1, -1, -1], "translation": [0, 0, -4]}, 0),
                            ({"rotation": half_turn, "translation": [0, 0, -4]}, 0),
                            ({"matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}, 1)):
            model, lamp = self.lamp()
            model.node(model.primitive(lamp), **node)
            self.assert_near(self.radiance(self.shown(model, lights=()), 16, 16), [right * c for c in (1, 0.5, 0.25)], what=str(node))

    def test_a_mirror_mirrors_the_texture(self):
        model = Model()
        model.node(model.primitive(model.material(texture=model.picture(QUARTERS))), scale=[-1, 1, 1])
        self.assert_quarters(self.shown(model), [GREEN, RED, YELLOW, BLUE])


class Alpha(Gltf):
    """AlphaBlendModeTest: holes and veils before a wall, for eyes and for light."""

    HALVES = [[(255, 0, 0, 0), (255, 0, 0, 255)]]  # a hole on the left

    def before_a_wall(self, rows=None, base=(1, 0, 0, 1), colours=None, **mode):
        model = Model()
        texture = model.picture(rows) if rows else None
        more = {"COLOR_0": model.accessor(colours)} if colours else {}
        model.square(model.material(base, texture, **mode), **more)
        model.wall((0, 1, 0, 1))
        return model

    def test_a_mask_is_a_hole_below_its_cutoff(self):
        picture = self.shown(self.before_a_wall(self.HALVES, alphaMode="MASK"))
        self.assert_quarters(picture, [GREEN, RED, GREEN, RED])
        for mode, right in (({}, RED), ({"alphaMode": "OPAQUE"}, RED)):
            self.assert_quarters(self.shown(self.before_a_wall(self.HALVES, **mode)), [right] * 4)
        for alpha, cutoff, right in ((0.4, None, GREEN), (0.6, None, RED), (0.6, 0.7, GREEN), (0.4, 0.3, RED), (0.5, None, RED)):
            mode = {"alphaMode": "MASK", **({} if cutoff is None else {"alphaCutoff": cutoff})}
            picture = self.shown(self.before_a_wall(base=(1, 0, 0, alpha), **mode))
            self.assert_near(self.albedo(picture, 16, 16), right, what=f"{alpha} {cutoff}")
            picture = self.shown(self.before_a_wall(base=(1, 0, 0, 1), colours=[(1, 1, 1, alpha)] * 4, **mode))
            self.assert_near(self.albedo(picture, 16, 16), right, what=f"vertices {alpha} {cutoff}")

    def test_alpha_is_the_product_of_factor_texture_and_vertices(self):
        rows = [[(255, 0, 0, 204)]]  # 0.8
        for factor, vertices, right in ((1, 1, RED), (0.8, 1, RED), (0.8, 0.7, GREEN), (0.6, 1, GREEN)):  # 0.8, 0.64, 0.448, 0.48
            model = self.before_a_wall(rows, (1, 0, 0, factor), [(1, 1, 1, vertices)] * 4, alphaMode="MASK")
            self.assert_near(self.albedo(self.shown(model), 16, 16), right, what=f"{factor} {vertices}")

    def test_light_goes_through_holes(self):
        # The lamp is at the eye. A wall 4 m off with nothing before it, and through a hole, has the same radiance.
        for rows in (self.HALVES, None):
            model = self.before_a_wall(rows, (1, 0, 0, 1) if rows else (1, 0, 0, 0.3), alphaMode="MASK")
            x, y = 12, 16
            through = self.radiance(self.shown(model, samples=16), x, y)
            free = Model()
            free.wall((0, 1, 0, 1))
            self.assert_near(through, self.radiance(self.shown(free, samples=16), x, y), what=str(rows))
        shadowed = self.radiance(self.shown(self.before_a_wall(), camera={"position_m": [0, 0, -3], "look_at_m": [0, 0, -4]}), 16, 16)
        self.assert_near(shadowed, BLACK)

    def test_a_veil_stops_its_share_of_sight_and_light(self):
        alpha = 0.25
        picture = self.shown(self.before_a_wall(base=(1, 0, 0, alpha), alphaMode="BLEND"), samples=256)
        # 196 pixels of 256 samples: 4 sigma of the share are 0.008.
        self.assert_near(self.mean(picture, "albedo."), (alpha, 1 - alpha, 0), 0.008)
        self.assert_noted("blended")
        # Light passes twice: to the wall behind, and back to the eye.
        free = Model()
        free.wall((0, 1, 0, 1))
        unveiled = self.mean(self.shown(free, samples=16))[1]
        self.assertAlmostEqual(self.mean(picture)[1] / unveiled, (1 - alpha) ** 2, delta=0.01)
        # From behind the veil only light is stopped.
        view = {"camera": {"position_m": [0, 0, -2.5], "look_at_m": [0, 0, -4]}, "samples": 256}
        shadow = self.mean(self.shown(self.before_a_wall(base=(1, 0, 0, alpha), alphaMode="BLEND"), **view))[1]
        bright = self.mean(self.shown(free, **view))[1]
        self.assertAlmostEqual(shadow / bright, 1 - alpha, delta=0.01)  # 4 sigma of 50176 samples

    def test_full_alpha_is_opaque_and_none_is_nothing(self):
        picture = self.shown(self.before_a_wall(alphaMode="BLEND"))
        self.assert_near(self.albedo(picture, 16, 16), RED)
        self.assert_not_noted("blended")
        picture = self.shown(self.before_a_wall(base=(1, 0, 0, 0), alphaMode="BLEND"))
        self.assert_near(self.albedo(picture, 16, 16), GREEN)

    def test_a_lamp_with_holes_shines_where_it_is(self):
        def lit(rows, corners):
            model = Model()
            texture = model.picture(rows) if rows else None
            lamp = model.material((1, 1, 1, 1), texture, alphaMode="MASK", emissiveFactor=[1, 1, 1])
            model.square(lamp, corners=corners)
            model.wall()
            return self.mean(self.shown(model, lights=(), samples=256), low=0, high=32)[1]

        right_half = lit(None, [(0, 3, -1), (1, 3, -1), (1, 3, -3), (0, 3, -3)][::-1])
        self.assertGreater(right_half, 0.005)
        holed = [(-1, 3, -1), (1, 3, -1), (1, 3, -3), (-1, 3, -3)][::-1]
        rows = [[(255, 255, 255, 255), (255, 255, 255, 0)], [(255, 255, 255, 255), (255, 255, 255, 0)]]
        half = lit(rows, holed)
        self.assertAlmostEqual(half / right_half, 1, delta=0.05)  # the halves mirror one another, and so do the pictures

    def test_repeated_meshes_have_holes(self):
        model = self.before_a_wall(self.HALVES, alphaMode="MASK")
        again = model.add("nodes", mesh=0, translation=[0, 0, -0.5])
        model.json["scenes"][0]["nodes"].append(again)
        self.assert_quarters(self.shown(model), [GREEN, RED, GREEN, RED])

    def test_the_predictor_sees_through_holes(self):
        self.before_a_wall(self.HALVES, alphaMode="MASK").write(self.folder / "model.glb")
        path = self.view("model.glb")
        view = json.loads(path.read_text())
        view["method"] = {"type": "predict", "samples_per_pixel": 16, "max_bounces": 1}
        view["eye"]["pupil_diameter_mm"] = 1
        path.write_text(json.dumps(view))
        self.succeed("render", path, "-o", self.folder / "out.exr", "--quiet")
        picture = float_pixels((self.folder / "out.exr").read_bytes())
        hole, solid = self.radiance(picture, 11, 16), self.radiance(picture, 20, 16)
        self.assertGreater(hole[1], 0.005)
        self.assertLess(hole[0], 1e-4)
        self.assertGreater(solid[0], 0.02)
        self.assertLess(solid[1], 1e-4)


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
