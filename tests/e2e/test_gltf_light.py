"""glTF files through the command line, as Khronos' sample models have them: what shines, and what light goes through."""
import json
import unittest

from exr_header import float_pixels
from gltf_models import CORNERS, Model
from gltf_pictures import RED, GREEN, BLUE, YELLOW, BLACK, QUARTERS, IN_PLACE, PLACES, Gltf


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


if __name__ == "__main__":
    unittest.main()
