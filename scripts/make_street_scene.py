#!/usr/bin/env python3
"""Writes configs/scenes/street.json: a street by day under configs/environments/clear_sky.exr, from a post at 2 m to a wall at 200 m.

Own geometry. Signs carry Sloan letters (scripts/sloan_letters.py) of stated heights. Metres, the eye is at (0, 1.6, 0) and looks along
-z; the sun stands behind the right shoulder. Standard library only; the same bytes each time.
"""
import pathlib
import random

from scene_parts import append_polygon, box, cylinder, quad, write_scene
from sloan_letters import add_text, text_width

RANDOM = random.Random(7)  # uniform() is the same in all versions of Python
ROAD, KERB = 3.5, 5.6  # half widths of the carriageway and to the house fronts [m]


def flat(name, material, rectangles, y):
    """Rectangles (x0, z0, x1, z1) that face up, as one mesh."""
    mesh = {"name": name, "material": material, "positions_m": [], "faces": []}
    for x0, z0, x1, z1 in rectangles:
        append_polygon(mesh, [[x0, y, z0], [x1, y, z0], [x1, y, z1], [x0, y, z1]])
    return mesh


def ground():
    stripes = [(-ROAD + 0.5 + k, -4.5, -ROAD + 1.0 + k, -8.0) for k in range(7)]
    dashes = [(-0.07, -z, 0.07, -z - 3) for z in range(12, 195, 9)]
    return [quad("earth", "earth", [-400, -0.02, 60], [400, -0.02, 60], [400, -0.02, -600], [-400, -0.02, -600]),
            flat("road", "asphalt", [(-ROAD, 30, ROAD, -203)], 0.0), flat("marks", "white_paint", stripes + dashes, 0.006),
            box("pavement_left", "pavement", [-KERB - 0.4, -0.02, -203], [-ROAD, 0.12, 30]),
            box("pavement_right", "pavement", [ROAD, -0.02, -203], [KERB + 0.4, 0.12, 30])]


def houses():
    """Rows of houses along both sides, with windows that stand 2 cm before the front; then the wall at 200 m."""
    meshes = []
    facades = ("plaster_cream", "plaster_rose", "brick", "plaster_grey", "plaster_ochre")
    panes = {"name": "panes", "material": "pane", "positions_m": [], "faces": []}
    for side in (-1, 1):
        z, number = 14.0, 0 if side < 0 else 2
        while z > -195:
            length, height = RANDOM.uniform(9, 15), 3.2 * int(RANDOM.uniform(2.5, 5.5)) + 0.8
            front, far = side * KERB, max(z - length, -196.0)
            low, high = sorted((front, front + side * 9))
            meshes.append(box(f"house_{side}_{number}", facades[(number * 3 + 5) % 5], [low, 0, far], [high, height, z]))
            for floor in range(int(height / 3.2)):
                at = z - 1.2
                while at - 1.1 > far + 0.6:
                    x, y0 = front - side * 0.02, 0.9 + 3.2 * floor
                    near, back = at, at - 1.1
                    corners = [[x, y0, near], [x, y0, back], [x, y0 + 1.5, back], [x, y0 + 1.5, near]]
                    append_polygon(panes, corners if side > 0 else corners[::-1])
                    at -= 2.4
            z = far - (0.0 if RANDOM.uniform(0, 1) < 0.75 else 3.5)
            number += 1
    meshes += [panes, box("end_wall", "plaster_cream", [-40, 0, -206], [40, 16, -200])]
    return meshes


def sign(name, text, letter, center, plate="sign_plate", ink="sign_ink", posts=1):
    """A plate towards the viewer with one line of letters `letter` metres high, on one or two posts (0: none)."""
    x, y, z = center
    half, rim = text_width(text, letter, 0.4) / 2 + 0.7 * letter, 0.95 * letter
    meshes = [box(name, plate, [x - half, y - rim, z - 0.03], [x + half, y + rim, z - 0.002])]
    mesh = {"name": name + "_letters", "material": ink, "positions_m": [], "faces": []}
    add_text(mesh, text, letter, (x, y, z), gap=0.4)
    for k in range(posts):
        at = x if posts == 1 else x + (2 * k - 1) * (half - 0.1)
        meshes.append(cylinder(f"{name}_post_{k}", "steel", [at, 0, z - 0.07], 0.03, y + rim, 12))
    return meshes + [mesh]


def car(name, paint, x, z, towards_viewer):
    """Body, cabin and wheels; 4.2 m long from z backwards."""
    length, half = 4.2, 0.85
    meshes = [box(name + "_body", paint, [x - half, 0.28, z - length], [x + half, 0.85, z])]
    front, back = (z - 1.3, z - 3.9) if towards_viewer else (z - 0.3, z - 2.9)
    cabin = {"name": name + "_cabin", "material": "pane", "positions_m": [], "faces": []}
    low = [[x - 0.78, 0.85, front + 0.35], [x + 0.78, 0.85, front + 0.35], [x + 0.78, 0.85, back - 0.35], [x - 0.78, 0.85, back - 0.35]]
    high = [[x - 0.62, 1.38, front - 0.3], [x + 0.62, 1.38, front - 0.3], [x + 0.62, 1.38, back + 0.3], [x - 0.62, 1.38, back + 0.3]]
    for k in range(4):
        j = (k + 1) % 4
        append_polygon(cabin, [low[k], low[j], high[j], high[k]])
    roof = {"name": name + "_roof", "material": paint, "positions_m": [], "faces": []}
    append_polygon(roof, high)
    meshes += [cabin, roof]
    for k, (dx, dz) in enumerate(((-half, -0.75), (half - 0.2, -0.75), (-half, -3.4), (half - 0.2, -3.4))):
        meshes.append(box(f"{name}_wheel_{k}", "tyre", [x + dx, 0, z + dz - 0.3], [x + dx + 0.2, 0.58, z + dz + 0.3]))
    lamps = "head_lamp" if towards_viewer else "tail_lamp"
    for k, dx in enumerate((-0.68, 0.42)):
        meshes.append(quad(f"{name}_lamp_{k}", lamps, [x + dx, 0.6, z + 0.004], [x + dx + 0.26, 0.6, z + 0.004], [x + dx + 0.26, 0.74, z + 0.004], [x + dx, 0.74, z + 0.004]))
    return meshes


def trees():
    meshes, spheres = [], []
    for k, z in enumerate((-11, -24, -39, -58, -82, -110, -145)):
        for side in (-1, 1):
            x, foot = side * 4.6, z - (5 if side > 0 else 0)
            meshes.append(cylinder(f"trunk_{side}_{k}", "bark", [x, 0, foot], 0.11, 2.6, 12))
            for dx, dy, dz, r in ((0, 3.3, 0, 0.95), (0.35, 2.8, 0.4, 0.65), (-0.4, 2.9, -0.2, 0.7), (0.05, 4.0, 0.1, 0.65)):
                spheres.append({"center_m": [round(x + dx, 3), dy, round(foot + dz, 3)], "radius_m": r, "material": "leaf"})
    return meshes, spheres


def main():
    trunks, spheres = trees()
    meshes = ground() + houses() + trunks
    meshes += sign("post_sign", "ZH", 0.05, (-0.52, 1.42, -2.0), "sign_yellow")
    meshes += sign("place", "NORD", 0.12, (2.1, 1.9, -6.0))
    meshes += sign("lane", "HORN", 0.20, (-3.1, 2.6, -15.0), "sign_blue", "white_paint")
    meshes += sign("gantry", "DORN SVOR", 0.45, (0, 5.4, -40.0), "sign_blue", "white_paint", 2)
    meshes += sign("far", "ZOO", 2.4, (0, 10.5, -199.9), "plaster_cream", "sign_ink", 0)
    for k, (x, z) in enumerate(((-1.15, -2.6), (1.25, -2.4), (1.25, -3.6))):
        meshes.append(cylinder(f"bollard_{k}", "bollard", [x, 0, z], 0.06, 0.95, 20))
    for k, (paint, x, z, towards) in enumerate((("car_red", 2.5, -9.5, False), ("car_white", -2.4, -18, True), ("car_blue", 2.5, -17, False),
                                                ("car_green", -1.7, -34, True), ("car_white", 1.8, -48, False), ("car_red", -1.7, -75, True))):
        meshes += car(f"car_{k}", paint, x, z, towards)
    scene = {
        "format": "sturm.scene/1",
        "title": "A street by day, 2 to 200 m: letters of 5 cm at 2 m, 12 cm at 6 m, 20 cm at 15 m, 45 cm at 40 m, 2.4 m at 200 m. The eye is at (0, 1.6, 0) and looks along -z",
        "source": "own geometry, made by scripts/make_street_scene.py; sky by scripts/make_sky.py (Preetham, Shirley & Smits 1999)",
        "materials": {
            "earth": {"albedo": [0.19, 0.22, 0.10]}, "asphalt": {"albedo": [0.11, 0.11, 0.115]}, "pavement": {"albedo": [0.33, 0.32, 0.30]},
            "white_paint": {"albedo": [0.78, 0.78, 0.76]}, "steel": {"albedo": [0.30, 0.31, 0.33]}, "bollard": {"albedo": [0.55, 0.07, 0.05]},
            "plaster_cream": {"albedo": [0.66, 0.61, 0.50]}, "plaster_rose": {"albedo": [0.58, 0.38, 0.32]}, "brick": {"albedo": [0.38, 0.17, 0.12]},
            "plaster_grey": {"albedo": [0.50, 0.50, 0.49]}, "plaster_ochre": {"albedo": [0.62, 0.45, 0.20]},
            "pane": {"type": "plastic", "albedo": [0.03, 0.04, 0.05], "roughness": 0.2}, "bark": {"albedo": [0.16, 0.11, 0.07]}, "leaf": {"albedo": [0.09, 0.22, 0.05]},
            "sign_plate": {"albedo": [0.75, 0.75, 0.73]}, "sign_ink": {"albedo": [0.025, 0.025, 0.03]}, "sign_yellow": {"albedo": [0.75, 0.55, 0.04]},
            "sign_blue": {"albedo": [0.03, 0.10, 0.40]}, "tyre": {"albedo": [0.03, 0.03, 0.03]},
            "car_red": {"type": "plastic", "albedo": [0.50, 0.03, 0.03], "roughness": 0.3}, "car_white": {"type": "plastic", "albedo": [0.70, 0.70, 0.68], "roughness": 0.3},
            "car_blue": {"type": "plastic", "albedo": [0.04, 0.10, 0.38], "roughness": 0.3}, "car_green": {"type": "plastic", "albedo": [0.05, 0.22, 0.12], "roughness": 0.3},
            "head_lamp": {"emission": [5, 4.8, 4.4]}, "tail_lamp": {"emission": [1.6, 0.08, 0.05]}},
        "environment": {"file": "../environments/clear_sky.exr"},
        "meshes": meshes,
        "spheres": spheres,
    }
    write_scene(pathlib.Path(__file__).resolve().parents[1] / "configs/scenes/street.json", scene, 4)


if __name__ == "__main__":
    main()
