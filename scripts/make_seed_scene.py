#!/usr/bin/env python3
"""Writes configs/scenes/seed.json: spheres of METALSTIGMATISM's three materials on a chequered floor under an even sky.

Own geometry; materials seed_diffuse, seed_metal and seed_dielectric (docs/theory.md#9-the-path-tracer). Metres, the eye is at (0, 0.42, 0) and
looks along -z; the middle row lies at 1.6 m. Standard library only; the same bytes each time.
"""
import pathlib

from scene_parts import checker, write_scene

ROWS = [(-0.8, 0.26, 0.07), (-1.15, 0.34, 0.08), (-1.6, 0.42, 0.10), (-2.3, 0.55, 0.12), (-3.4, 0.75, 0.15), (-5.2, 1.1, 0.20)]  # z, pitch, radius
MATERIALS = ("red", "gold", "blue", "glass", "white", "steel", "green", "brass")


def main():
    spheres = []
    for row, (z, pitch, radius) in enumerate(ROWS):
        for column in range(-2, 3):
            x = pitch * (column + (0.5 if row % 2 else 0.0))
            material = MATERIALS[(3 * row + 2 * column + 8) % len(MATERIALS)]
            spheres.append({"center_m": [round(x, 4), radius, z], "radius_m": radius, "material": material})
    for k in range(7):  # small lamps: their images show the shape of the blur
        spheres.append({"center_m": [round(-1.35 + 0.45 * k, 4), 0.86, -4.0], "radius_m": 0.02, "material": "lamp"})
    scene = {
        "format": "sturm.scene/1",
        "title": "Spheres of METALSTIGMATISM's materials at 0.8 to 5.2 m, small lamps at 4 m. The eye is at (0, 0.42, 0) and looks along -z",
        "source": "own geometry, made by scripts/make_seed_scene.py",
        "materials": {
            "floor_light": {"type": "seed_diffuse", "albedo": [0.62, 0.60, 0.56]}, "floor_dark": {"type": "seed_diffuse", "albedo": [0.12, 0.14, 0.17]},
            "red": {"type": "seed_diffuse", "albedo": [0.66, 0.13, 0.10]}, "blue": {"type": "seed_diffuse", "albedo": [0.10, 0.20, 0.55]},
            "green": {"type": "seed_diffuse", "albedo": [0.12, 0.42, 0.14]}, "white": {"type": "seed_diffuse", "albedo": [0.80, 0.79, 0.76]},
            "gold": {"type": "seed_metal", "albedo": [0.90, 0.70, 0.35], "alpha": 0.08}, "steel": {"type": "seed_metal", "albedo": [0.75, 0.76, 0.78], "alpha": 0.0},
            "brass": {"type": "seed_metal", "albedo": [0.78, 0.60, 0.30], "alpha": 0.3}, "glass": {"type": "seed_dielectric"},
            "lamp": {"emission": [3, 2.7, 2.2]}},
        "environment": {"radiance": [0.62, 0.74, 0.95]},
        "meshes": checker("floor", ("floor_light", "floor_dark"), (-4.0, 4.0), (1.0, -9.0), (32, 40)),
        "spheres": spheres,
    }
    write_scene(pathlib.Path(__file__).resolve().parents[1] / "configs/scenes/seed.json", scene)


if __name__ == "__main__":
    main()
