#!/usr/bin/env python3
"""Writes configs/scenes/night.json: a dark street with small bright lights at several depths, some of them behind a post.

Own geometry. Metres, the eye stands at (0, 1.6, 0) and looks along -z.
"""
import json
import pathlib
import random

from scene_parts import box, quad

random.seed(20)
WARM, WHITE, RED, GREEN = "warm", "white", "red", "green"


def light(x, y, z, radius, material):
    return {"center_m": [round(x, 4), round(y, 4), round(z, 4)], "radius_m": radius, "material": material}


spheres = []
for k in range(12):  # street lamps along both kerbs
    side = -1 if k % 2 else 1
    spheres.append(light(side * 3.2, 4.5, -6 - 3.5 * k, 0.012, WARM))
for k in range(30):  # windows of the house at the end, and of those at the sides
    spheres.append(light(random.uniform(-7, 7), random.uniform(2.5, 9), -52 + random.uniform(0, 1), 0.02, random.choice([WARM, WHITE])))
for x in (-1.6, -0.9, 0.8, 1.5):  # headlamps and tail lamps of two cars
    spheres.append(light(x, 0.65, -18 if x > 0 else -13, 0.015, WHITE if x > 0 else RED))
spheres.append(light(2.4, 2.6, -9, 0.01, GREEN))
for k in range(6):  # a string of lights near by, half of it behind the post
    spheres.append(light(-0.55 + 0.06 * k, 1.75 + 0.02 * (k % 2), -1.2, 0.0012, WARM))

scene = {
    "format": "sturm.scene/1",
    "title": "A street at night: small bright lights at 1.2 to 52 m, some of them behind a post",
    "source": "own geometry, made by scripts/make_night_scene.py",
    "materials": {
        "asphalt": {"albedo": [0.06, 0.06, 0.065]},
        "plaster": {"albedo": [0.35, 0.31, 0.27]},
        "post": {"albedo": [0.02, 0.02, 0.02]},
        WARM: {"emission": [9000, 6200, 3000]},
        WHITE: {"emission": [8000, 8200, 9000]},
        RED: {"emission": [5000, 300, 200]},
        GREEN: {"emission": [400, 6000, 1500]},
    },
    "meshes": [
        quad("street", "asphalt", [-30, 0, 1], [30, 0, 1], [30, 0, -60], [-30, 0, -60]),
        quad("end", "plaster", [-30, 0, -53], [30, 0, -53], [30, 14, -53], [-30, 14, -53]),
        box("left", "plaster", [-12, 0, -50], [-5, 8, -4]),
        box("right", "plaster", [5, 0, -50], [12, 9, -4]),
        box("post", "post", [-0.47, 0, -0.92], [-0.42, 3, -0.87]),
    ],
    "spheres": spheres,
}
path = pathlib.Path(__file__).resolve().parents[1] / "configs/scenes/night.json"
path.write_text(json.dumps(scene, indent=1) + "\n")
