#!/usr/bin/env python3
"""Makes configs/views/near_screen.json: optotypes on a screen in focus at 0.4 m, and polished beads 0.2 m before the eye that mirror a lamp.

Tumbling E on a grid of 5 x 5 units in three sizes. The screen's light has no noise; all that there is comes from the lamp's highlights, which
the eye sees out of focus: a few samples in a hundred of a few pixels in a hundred.
"""
import json
import pathlib

VIEW = pathlib.Path(__file__).resolve().parents[1] / "configs/views/near_screen.json"
ROWS = [(0.030, 0.0060, 3, 0.060), (-0.010, 0.0040, 4, 0.044), (-0.042, 0.0025, 6, 0.030)]  # height, unit, count, pitch [m]
STROKES = [(0, 0, 1, 5), (1, 0, 5, 1), (1, 2, 5, 3), (1, 4, 5, 5)]


def optotype(x, y, unit, quarter_turns):
    """Rectangles (x0, y0, x1, y1) of an E whose lower left corner is (x, y)."""
    for a, b, c, d in STROKES:
        for _ in range(quarter_turns):
            a, b, c, d = 5 - d, a, 5 - b, c
        yield x + unit * a, y + unit * b, x + unit * c, y + unit * d


def optotypes():
    positions, faces, number = [], [], 0
    for row, (y, unit, count, pitch) in enumerate(ROWS):
        for i in range(count):
            number += 1
            for x0, y0, x1, y1 in optotype(-0.5 * (count - 1) * pitch - 2.5 * unit + i * pitch, y, unit, (number * number + row) % 4):
                first = len(positions)
                positions += [[round(u, 5), round(v, 5), -0.4] for u, v in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
                faces.append([first, first + 1, first + 2, first + 3])
    return {"name": "tumbling E", "material": "ink", "positions_m": positions, "faces": faces}


def view():
    screen = {"name": "screen", "material": "screen", "faces": [[0, 1, 2, 3]],
              "positions_m": [[-0.2, -0.15, -0.4005], [0.2, -0.15, -0.4005], [0.2, 0.15, -0.4005], [-0.2, 0.15, -0.4005]]}
    beads = [{"center_m": [round(-0.0455 - 0.002 * (i % 3), 5), round(0.042 - 0.0085 * i, 5), -0.2], "radius_m": 0.004, "material": "steel"}
             for i in range(12)]
    lamp = {"center_m": [0.25, 0.45, 0.1], "radius_m": 0.08, "material": "lamp"}
    return {
        "$schema": "../schemas/render.schema.json",
        "format": "sturm.render/1",
        "scene": {
            "format": "sturm.scene/1",
            "title": "Optotypes on a screen in focus at 0.4 m, and polished beads 0.2 m before the eye that mirror a lamp",
            "source": "own geometry, made by scripts/make_near_screen_view.py",
            "materials": {"screen": {"emission": [0.5, 0.49, 0.46]}, "ink": {"albedo": [0, 0, 0]},
                          "steel": {"type": "conductor", "metal": "silver", "roughness": 0}, "lamp": {"emission": [25, 23, 20]}},
            "meshes": [screen, optotypes()],
            "spheres": beads + [lamp],
            "environment": {"radiance": [0.35, 0.37, 0.4]},
        },
        "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -0.4], "up": [0, 1, 0], "vfov_deg": 24, "resolution": [480, 320]},
        "eye": {"prescription": {"sphere_D": 0, "cylinder_D": 0, "axis_deg": 180, "vertex_distance_mm": 0}, "pupil_diameter_mm": 4,
                "accommodation": {"mode": "fixed", "focus_distance_m": 0.4}},
        "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": 4096, "max_bounces": 4,
                   "stop": {"relative_error": 0.01}, "adaptive": {}},
        "seed": 1,
    }


if __name__ == "__main__":
    VIEW.write_text(json.dumps(view(), indent=1) + "\n")
