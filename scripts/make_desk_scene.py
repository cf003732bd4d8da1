#!/usr/bin/env python3
"""Writes configs/scenes/desk.json: a room from 0.3 m (a reading card in the hand) over a desk to an eye chart at 6 m.

Own geometry, but for the two meshes of configs/models. Letters have their true sizes: see scripts/sloan_letters.py. Metres, the eye is at
(0, 1.2, 0) and looks along -z. Standard library only; the same bytes each time.
"""
import math
import pathlib

from scene_parts import append_polygon, box, checker, cylinder, quad, write_scene
from sloan_letters import add_text, chart_rows, text_width

EYE_HEIGHT = 1.2
DESK = 0.78
CARD_DISTANCE = 0.30
CHART_DISTANCE = 6.0
LINES = ["NCKZO", "RHSDK", "DOVHR", "CZRHS", "ONHRC", "DKSNV", "ZSOKN", "CKDNR", "SRZKD", "HZOVC", "NVDOK", "VHCNO", "SVHCZ", "OZDVK"]  # the original chart 1 of Ferris 1982


def chart():
    """Rows from logMAR 1.0 to −0.3 and, above them, one of two letters of logMAR 1.3."""
    rows = chart_rows(1.0, -0.3, LINES, CHART_DISTANCE)
    large = chart_rows(1.3, 1.3, ["HN"], CHART_DISTANCE)[0]
    gap = 0.6 * large[0]
    height = large[0] + gap + rows[-1][2] + rows[-1][0] / 2
    top = EYE_HEIGHT + height / 2
    half = text_width(rows[0][1], rows[0][0]) / 2 + 0.09
    letters = {"name": "chart_letters", "material": "ink", "positions_m": [], "faces": []}
    z = -CHART_DISTANCE
    add_text(letters, large[1], large[0], (0, top - large[2], z))
    for size, text, below in rows:
        add_text(letters, text, size, (0, top - large[0] - gap - below, z))
    return [box("chart_panel", "paper", [-half, top - height - 0.09, z - 0.04], [half, top + 0.09, z - 0.0005]), letters]


def reading_card():
    """A card in the left hand, square to the line from the eye, rows from logMAR 0.9 to 0.1 for its distance."""
    direction = (-0.30, -0.40, -1.0)
    length = math.hypot(*direction)
    normal = [-d / length for d in direction]  # towards the eye
    center = [CARD_DISTANCE * d / length + (EYE_HEIGHT if i == 1 else 0) for i, d in enumerate(direction)]
    side = math.hypot(normal[0], normal[2])
    right = [normal[2] / side, 0.0, -normal[0] / side]
    up = [normal[1] * right[2] - normal[2] * right[1], normal[2] * right[0] - normal[0] * right[2], normal[0] * right[1] - normal[1] * right[0]]

    def place(x, y, lift):
        return [center[i] + x * right[i] + y * up[i] + lift * normal[i] for i in range(3)]

    card = {"name": "card", "material": "paper", "positions_m": [], "faces": []}
    append_polygon(card, [place(x, y, 0) for x, y in ((-0.034, -0.026), (0.034, -0.026), (0.034, 0.026), (-0.034, 0.026))])
    letters = {"name": "card_letters", "material": "ink", "positions_m": [], "faces": []}
    rows = chart_rows(0.9, 0.1, LINES, CARD_DISTANCE)
    middle = (rows[-1][2] + rows[-1][0] / 2) / 2
    for size, text, below in rows:
        add_text(letters, text, size, place(0, middle - below, 0.0002), right, up)
    return [card, letters]


def desk():
    meshes = [box("desk_top", "wood", [-0.95, DESK - 0.03, -1.25], [0.95, DESK, -0.45])]
    for k, (x, z) in enumerate(((-0.9, -1.2), (0.85, -1.2), (-0.9, -0.55), (0.85, -0.55))):
        meshes.append(box(f"desk_leg_{k}", "steel", [x, 0, z], [x + 0.05, DESK - 0.03, z + 0.05]))
    for k, (material, width, depth) in enumerate((("book_red", 0.24, 0.17), ("book_blue", 0.22, 0.16), ("book_cream", 0.20, 0.14))):
        y = DESK + 0.03 * k
        meshes.append(box(f"book_{k}", material, [-0.36 - width / 2, y, -0.78 - depth / 2], [-0.36 + width / 2, y + 0.028, -0.78 + depth / 2]))
    meshes.append(cylinder("mug", "mug", [0.09, DESK, -0.74], 0.04, 0.095, 32))
    meshes.append(cylinder("pen_cup", "steel", [0.60, DESK, -1.10], 0.038, 0.10, 24))
    for k, (dx, dz, material) in enumerate(((-0.015, 0.01, "book_red"), (0.012, -0.012, "book_blue"), (0.008, 0.018, "pencil"))):
        meshes.append(cylinder(f"pencil_{k}", material, [0.60 + dx, DESK + 0.02, -1.10 + dz], 0.004, 0.17, 8))
    return meshes


def room():
    meshes = checker("floor", ("tile_light", "tile_dark"), (-2.4, 2.4), (1.2, -6.2), (8, 12))
    meshes += [quad("back_wall", "wall", [-2.4, 0, -6.2], [2.4, 0, -6.2], [2.4, 2.7, -6.2], [-2.4, 2.7, -6.2]),
               quad("left_wall", "wall_left", [-2.4, 0, 1.2], [-2.4, 0, -6.2], [-2.4, 2.7, -6.2], [-2.4, 2.7, 1.2]),
               quad("right_wall", "wall_right", [2.4, 0, -6.2], [2.4, 0, 1.2], [2.4, 2.7, 1.2], [2.4, 2.7, -6.2]),
               quad("front_wall", "wall", [2.4, 0, 1.2], [-2.4, 0, 1.2], [-2.4, 2.7, 1.2], [2.4, 2.7, 1.2]),
               quad("ceiling", "wall", [-2.4, 2.7, -6.2], [2.4, 2.7, -6.2], [2.4, 2.7, 1.2], [-2.4, 2.7, 1.2])]
    for k, z in enumerate((-0.6, -3.0, -5.0)):  # panels of light below the ceiling, facing down
        meshes.append(quad(f"panel_{k}", "lamp", [-0.8, 2.66, z - 0.25], [0.8, 2.66, z - 0.25], [0.8, 2.66, z + 0.25], [-0.8, 2.66, z + 0.25]))
    return meshes


def shelf_and_chair():
    meshes = [box(f"shelf_{k}", "wood", [-2.4, y, -4.6], [-2.05, y + 0.03, -2.8]) for k, y in enumerate((0.45, 0.95, 1.45, 1.95))]
    colours = ("book_red", "book_blue", "book_cream", "leaf", "pencil")
    number = 0
    for y in (0.48, 0.98, 1.48):
        z = -2.85
        while z > -4.5:
            width, height = 0.035 + 0.013 * (number * 7 % 5), 0.26 + 0.03 * (number * 5 % 4)
            if number % 9 != 8:  # a gap now and then
                meshes.append(box(f"shelf_book_{number}", colours[number * 3 % 5], [-2.35, y, z - width], [-2.10, y + height, z - 0.003]))
            z -= width
            number += 1
    meshes += [box("chair_seat", "book_blue", [0.55, 0.45, -2.4], [1.0, 0.50, -1.95]), box("chair_back", "book_blue", [0.55, 0.62, -2.44], [1.0, 1.0, -2.40])]
    for k, (x, z, height) in enumerate(((0.56, -2.43, 1.0), (0.95, -2.43, 1.0), (0.56, -2.0, 0.45), (0.95, -2.0, 0.45))):
        meshes.append(box(f"chair_leg_{k}", "steel", [x, 0, z], [x + 0.04, height, z + 0.04]))
    return meshes


def plant():
    """A pot at 3.6 m with a sphere for each tuft of leaves."""
    tufts = [(0, 0.95, 0, 0.17), (0.13, 0.82, 0.05, 0.13), (-0.14, 0.84, 0.02, 0.14), (0.03, 1.15, -0.03, 0.12), (-0.06, 0.78, 0.12, 0.11)]
    spheres = [{"center_m": [round(1.65 + x, 4), y, round(-3.4 + z, 4)], "radius_m": r, "material": "leaf"} for x, y, z, r in tufts]
    return cylinder("pot", "book_red", [1.65, 0, -3.4], 0.14, 0.62, 24, 0.19), spheres


def main():
    pot, spheres = plant()
    for k in range(9):  # a string of small lamps along the top shelf, 3 to 5 m away
        spheres.append({"center_m": [-2.03, round(1.93 - 0.03 * (k % 2), 4), round(-2.85 - 0.21 * k, 4)], "radius_m": 0.009, "material": "bulb"})
    scene = {
        "format": "sturm.scene/1",
        "title": "A room: reading card at 0.3 m, desk at 0.7 to 1.2 m, chair, shelf and plant, eye chart at 6 m. The eye is at (0, 1.2, 0) and looks along -z",
        "source": "own geometry, made by scripts/make_desk_scene.py; letters: Sloan 1959, chart: Ferris et al. 1982; meshes: configs/models (public domain)",
        "materials": {
            "paper": {"albedo": [0.82, 0.81, 0.78]}, "ink": {"albedo": [0.03, 0.03, 0.03]},
            "wood": {"albedo": [0.45, 0.29, 0.17]}, "steel": {"albedo": [0.25, 0.26, 0.28]},
            "wall": {"albedo": [0.70, 0.69, 0.66]}, "wall_left": {"albedo": [0.62, 0.66, 0.68]}, "wall_right": {"albedo": [0.70, 0.63, 0.55]},
            "tile_light": {"albedo": [0.55, 0.52, 0.48]}, "tile_dark": {"albedo": [0.20, 0.17, 0.15]},
            "book_red": {"albedo": [0.55, 0.09, 0.07]}, "book_blue": {"albedo": [0.08, 0.16, 0.42]}, "book_cream": {"albedo": [0.75, 0.68, 0.50]},
            "leaf": {"albedo": [0.10, 0.30, 0.08]}, "pencil": {"albedo": [0.80, 0.58, 0.08]},
            "mug": {"albedo": [0.70, 0.35, 0.08]}, "porcelain": {"type": "plastic", "albedo": [0.16, 0.34, 0.52], "roughness": 0.3},
            "clay": {"albedo": [0.62, 0.46, 0.36]},
            "lamp": {"emission": [17, 16.2, 15]}, "bulb": {"emission": [60, 42, 20]}},
        "models": [
            {"file": "../models/teapot.obj", "scale": 0.17, "turn_deg": 20, "position_m": [-0.10, DESK, -1.02], "overrides": [{"mesh": "teapot", "material": "porcelain"}]},
            {"file": "../models/bunny.obj", "scale": 0.21, "turn_deg": -15, "position_m": [0.34, DESK, -0.92], "overrides": [{"mesh": "bunny", "material": "clay"}]}],
        "meshes": room() + desk() + reading_card() + chart() + shelf_and_chair() + [pot],
        "spheres": spheres,
    }
    write_scene(pathlib.Path(__file__).resolve().parents[1] / "configs/scenes/desk.json", scene, 6)


if __name__ == "__main__":
    main()
