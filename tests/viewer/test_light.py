"""Light of the page's paths against the program's, by the means of blocks: the Cornell box, and every material that the page draws."""
from page_in_browser import PageTest, main, rectangle
from sturm_process import CORNELL_BOX

SIZE, BLOCK = 48, 12
SAMPLES, PROGRAM_SAMPLES = 64, 512


def materials_scene():
    """Balls of plastic, metal and glass on a floor before a wall, under a lamp and a point light."""
    spheres = [("plastic", -0.45), ("rough_plastic", -0.15), ("metal", 0.15), ("glass", 0.45)]
    def flat(name, corners):
        return {"name": name, "material": name, "positions_m": corners, "faces": [[0, 1, 2, 3]]}
    return {"format": "sturm.scene/1", "materials": {
        "floor": {"albedo": [0.6, 0.55, 0.5]}, "wall": {"albedo": [0.3, 0.4, 0.6]}, "lamp": {"emission": [9, 8, 7]},
        "plastic": {"type": "plastic", "albedo": [0.1, 0.3, 0.65]}, "rough_plastic": {"type": "plastic", "albedo": [0.5, 0.4, 0.1], "roughness": 0.45},
        "metal": {"type": "conductor", "eta": [0.2, 0.9, 1.1], "k": [3.9, 2.4, 2.3], "roughness": 0.4}, "glass": {"type": "dielectric"}},
        "meshes": [flat("floor", [[-2, 0, 1], [2, 0, 1], [2, 0, -2], [-2, 0, -2]]), flat("wall", rectangle(0, 0, -1.2, 2, 2)),
                   flat("lamp", [[-0.5, 1.4, -0.8], [0.5, 1.4, -0.8], [0.5, 1.4, 0.2], [-0.5, 1.4, 0.2]])],
        "spheres": [{"center_m": [x, 0.14, -0.6], "radius_m": 0.14, "material": name} for name, x in spheres],
        "lights": [{"type": "point", "position_m": [-1, 0.9, 0.3], "intensity": [0.5, 0.5, 0.4]}]}


def view_of(scene, camera):
    return {"format": "sturm.render/1", "scene": scene, "camera": {**camera, "resolution": [SIZE, SIZE]},
            "eye": {"prescription": {"sphere_D": -1.5, "cylinder_D": -4, "axis_deg": 55, "vertex_distance_mm": 12}, "pupil_diameter_mm": 6, "accommodation": {"mode": "relaxed"}},
            "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": PROGRAM_SAMPLES, "max_bounces": 8}, "seed": 1}


def block_means(pixels):
    blocks = {}
    for y in range(SIZE):
        for x in range(SIZE):
            for c in range(3):
                blocks.setdefault((y // BLOCK, x // BLOCK, c), []).append(min(pixels[3 * (y * SIZE + x) + c], 4.0))  # a few pixels of caustics would be all noise
    return {key: sum(values) / len(values) for key, values in blocks.items()}


class Light(PageTest):
    def same_light(self, view):
        self.page_of(view)
        page, program = block_means(self.measured(f"picture('path', {SAMPLES})")), block_means(self.rendered(view))
        # 9216 paths a block with a deviation of at most about 1.5 of the mean: σ = 1.6 % of a block, 0.4 % of the picture.
        for key, mean in program.items():
            self.assertAlmostEqual(page[key] / mean, 1, delta=0.065, msg=str(key))
        for c in range(3):
            ratio = sum(page[k] for k in page if k[2] == c) / sum(program[k] for k in program if k[2] == c)
            self.assertAlmostEqual(ratio, 1, delta=0.016)

    def test_the_cornell_box(self):
        self.same_light(view_of(str(CORNELL_BOX), {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0.0], "vfov_deg": 39.3077}))

    def test_materials(self):
        self.same_light(view_of(materials_scene(), {"position_m": [0, 0.5, 1.2], "look_at_m": [0, 0.2, -0.6], "vfov_deg": 42}))


if __name__ == "__main__":
    main()
