"""Light of the page's paths against the program's, by the means of blocks: the Cornell box, every material that the page draws, and gloss under small lamps. Both sides are
drawn with several seeds, so that the noise of a block is known from its pixels; what differs more than noise does in one of some hundred blocks fails."""
import json
import math
import statistics

from page_in_browser import PageTest, main
from sturm_process import CORNELL_BOX, SOURCE

SIZE, BLOCK = 64, 16
# Chosen before anything was drawn with them. The places in a pixel and in the pupil are the same for one seed in both, so none is used twice.
PAGE_SEEDS, PROGRAM_SEEDS = (11, 12, 13, 14), (21, 22, 23, 24)
PAGE_SAMPLES, PROGRAM_SAMPLES = 8, 128
FALSE_ALARMS = 0.01  # of all comparisons of all scenes together
COMPARISONS = 3 * 3 * ((SIZE // BLOCK) ** 2 + 1)  # colours, and blocks with the whole picture


def bound():
    """Of a normal deviate, by Šidák."""
    each = 1 - (1 - FALSE_ALARMS) ** (1 / COMPARISONS)
    return statistics.NormalDist().inv_cdf(1 - each / 2)


def materials_scene():
    """The shipped scene without the balls of what the page draws otherwise."""
    scene = json.loads((SOURCE / "configs/scenes/materials.json").read_text())
    scene.pop("$schema", None)
    left_out = {"seed_diffuse", "seed_metal", "seed_dielectric", "frosted"}
    scene["spheres"] = [ball for ball in scene["spheres"] if ball["material"] not in left_out]
    scene["materials"] = {name: m for name, m in scene["materials"].items() if name not in left_out}
    return scene


def gloss_scene():
    """A rough metal floor and a roughly coated wall under a lamp without size and one that is small: most of their light is highlights."""
    return {"format": "sturm.scene/1", "lights": [{"type": "point", "position_m": [-0.5, 0.8, -1.2], "intensity": [0.5, 0.4, 0.3]}],
            "materials": {"floor": {"type": "conductor", "metal": "copper", "roughness": 0.5}, "wall": {"type": "plastic", "albedo": [0.1, 0.3, 0.2], "roughness": 0.6},
                          "lamp": {"emission": [90, 110, 150]}},
            "meshes": [{"name": "floor", "material": "floor", "positions_m": [[-2, 0, 0], [2, 0, 0], [2, 0, -2.5], [-2, 0, -2.5]], "faces": [[0, 1, 2, 3]]},
                       {"name": "wall", "material": "wall", "positions_m": [[-2, 0, -2.5], [2, 0, -2.5], [2, 2, -2.5], [-2, 2, -2.5]], "faces": [[0, 1, 2, 3]]}],
            "spheres": [{"center_m": [0.5, 0.5, -1.6], "radius_m": 0.03, "material": "lamp"}]}


def view_of(scene, camera):
    return {"format": "sturm.render/1", "scene": scene, "camera": {**camera, "resolution": [SIZE, SIZE]},
            "eye": {"prescription": {"sphere_D": -1.5, "cylinder_D": -4, "axis_deg": 55, "vertex_distance_mm": 12}, "pupil_diameter_mm": 6, "accommodation": {"mode": "relaxed"}},
            "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": PROGRAM_SAMPLES, "max_bounces": 8}, "seed": 1}


def blocks():
    """Numbers of the pixels of each block, and of all."""
    for top in range(0, SIZE, BLOCK):
        for left in range(0, SIZE, BLOCK):
            yield f"block at {left}, {top}", [y * SIZE + x for y in range(top, top + BLOCK) for x in range(left, left + BLOCK)]
    yield "picture", range(SIZE * SIZE)


def mean_and_variance(pictures, pixels, c):
    """Of the mean over pixels, which are independent of each other, from pictures with several seeds."""
    means, variance = [], 0.0
    for i in pixels:
        values = [picture[3 * i + c] for picture in pictures]
        means.append(sum(values) / len(values))
        variance += statistics.variance(values) / len(values)
    return sum(means) / len(means), variance / len(means) ** 2


class Light(PageTest):
    def same_light(self, view):
        self.page_of(view)
        page = [self.measured(f"picture('path', {PAGE_SAMPLES}, false, {seed})") for seed in PAGE_SEEDS]
        program = [self.rendered({**view, "seed": seed}) for seed in PROGRAM_SEEDS]
        largest, widest = 0.0, 0.0
        for name, pixels in blocks():
            for c in range(3):
                (a, va), (b, vb) = mean_and_variance(page, pixels, c), mean_and_variance(program, pixels, c)
                if va + vb == 0:  # nothing but surroundings of one colour
                    self.assertAlmostEqual(a, b, delta=1e-6 * b)
                    continue
                deviate = (a - b) / math.sqrt(va + vb)
                largest, widest = max(largest, abs(deviate)), max(widest, math.sqrt(va + vb) / b)
                self.assertLess(abs(deviate), bound(), f"{name}, colour {c}: {a} and {b}")
        print(f"largest deviate {largest:.2f} of {bound():.2f}; the widest standard error is {100 * widest:.1f} % of its block")

    def test_the_cornell_box(self):
        self.same_light(view_of(str(CORNELL_BOX), {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0.0], "vfov_deg": 39.3077}))

    def test_materials(self):
        self.same_light(view_of(materials_scene(), {"position_m": [0, 0.55, 0.35], "look_at_m": [0, 0.08, -1.1], "vfov_deg": 42}))

    def test_gloss_under_small_lamps(self):
        self.same_light(view_of(gloss_scene(), {"position_m": [0, 0.6, 0.4], "look_at_m": [0, 0.4, -2], "vfov_deg": 42}))


if __name__ == "__main__":
    main()
