"""A wall and a lamp look alike whatever their size is: from a tenth of a micrometre's offset to a hundred metres nothing is an absolute length."""
import math
import unittest

from model_pictures import ModelTest


def lit_wall(size, nearness, around=None):
    """A wall, `nearness` sizes from the origin, and a lamp before it that it sees from above."""
    def place(*points):
        return [[size * x, size * y, size * (z - nearness)] for x, y, z in points]

    scene = {"materials": {"wall": {"albedo": [0.5, 0.5, 0.5]}, "lamp": {"emission": [10, 10, 10]}},
             "meshes": [{"name": "wall", "material": "wall", "positions_m": place((-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)), "faces": [[0, 1, 2, 3]]},
                        {"name": "lamp", "material": "lamp", "positions_m": place((-0.5, 1.5, 1), (-0.5, 1.5, 0.5), (0.5, 1.5, 0.5), (0.5, 1.5, 1)), "faces": [[0, 1, 2, 3]]}]}
    if around:
        scene["environment"] = {"radiance": [around] * 3}
    return scene


class Scales(ModelTest):
    def radiance(self, size, nearness, **options):
        picture = self.picture(lit_wall(size, nearness, **options), camera={"position_m": [0, 0, size * (2 - nearness)], "look_at_m": [0, 0, -size * nearness], "vfov_deg": 60},
                               method={"samples_per_pixel": 64, "max_bounces": 3})
        seen = [picture["R"][y][x] for y in range(2, 30) for x in range(2, 30)]
        return sum(seen) / len(seen)

    def test_a_wall_and_a_lamp_of_every_size(self):
        # The same samples at each size, so that only rounding differs.
        for nearness in (2, 0):
            for around in (None, 0.25):
                right = self.radiance(1, nearness, around=around)
                self.assertGreater(right, 0.05)
                for size in (1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 10, 100, 1e4):
                    with self.subTest(size=size, nearness=nearness, around=around):
                        self.assertAlmostEqual(self.radiance(size, nearness, around=around) / right, 1, delta=1e-3)

    def test_the_closed_form(self):
        # Radiance = albedo / pi * L * integral of cos cos / d^2 over the lamp, by a sum over 8 x 8 points of it for each pixel's centre.
        total, pixels, tangent = 0.0, 28 * 28, 2 * math.tan(math.radians(30))
        for i in range(28):
            for j in range(28):
                x, y = tangent * (i - 13.5) / 16, tangent * (13.5 - j) / 16
                for a in range(8):
                    for b in range(8):
                        across, up, out = -0.4375 + a / 8 - x, 1.5 - y, 0.53125 + b / 16
                        total += up * out / (across ** 2 + up ** 2 + out ** 2) ** 2 * 0.5 / 64
        right = 0.5 / math.pi * 10 * total / pixels
        for size in (1e-5, 1, 100):
            # 50176 samples; sums over points miss less than 0.1 %
            self.assertAlmostEqual(self.radiance(size, 2) / right, 1, delta=0.005, msg=str(size))


if __name__ == "__main__":
    unittest.main()
