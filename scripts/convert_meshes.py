#!/usr/bin/env python3
"""Writes configs/models/bunny.obj and teapot.obj from two unpacked packages of the Node.js world, both in the public domain:
bunny 1.0.1 (Stanford 3D Scanning Repository, range data of 1993/94; coarse mesh) and teapot 1.0.0 (M. Newell's teapot). To convert again:

    npm pack bunny@1.0.1 teapot@1.0.0      # then unpack each .tgz
    scripts/convert_meshes.py bunny/package/index.js teapot/package/teapot.js

Each mesh stands on y = 0 with the middle of its bounding box over the origin, y up, 1 unit high: `scale` of a scene is its height in
metres. Normals are the mean of the faces' around each vertex, weighted by area, for smooth shading. Standard library only.
"""
import json
import math
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "configs/models"


def lists(path):
    """positions and cells of a module that says exports.positions=[[…]] and exports.cells=[[…]]."""
    text = pathlib.Path(path).read_text()
    return [json.loads(re.search(r"exports\." + name + r"\s*=\s*(\[\[.*?\]\s*\])", text, re.S).group(1)) for name in ("positions", "cells")]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normals(points, faces):
    sums = [[0.0, 0.0, 0.0] for _ in points]
    for face in faces:
        a, b, c = (points[i] for i in face)
        twice_area = cross([b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)])
        for corner in face:
            sums[corner] = [s + n for s, n in zip(sums[corner], twice_area)]
    return [[v / math.hypot(*s) for v in s] if math.hypot(*s) > 0 else [0.0, 1.0, 0.0] for s in sums]


def merged(points, faces):
    """Vertices of one position become one, faces without area go."""
    number, kept, of = {}, [], []
    for point in points:
        key = tuple(point)
        if key not in number:
            number[key] = len(kept)
            kept.append(point)
        of.append(number[key])
    faces = [[of[i] for i in face] for face in faces]
    return kept, [face for face in faces if len(set(face)) == 3]


def convert(path, name, title):
    points, faces = merged(*lists(path))
    low, high = ([f(p[i] for p in points) for i in range(3)] for f in (min, max))
    size = high[1] - low[1]
    points = [[(p[0] - (low[0] + high[0]) / 2) / size, (p[1] - low[1]) / size, (p[2] - (low[2] + high[2]) / 2) / size] for p in points]
    lines = [f"# {title}", "# public domain; made by scripts/convert_meshes.py; 1 unit high, stands on y = 0", f"o {name}"]
    lines += ["v " + " ".join(f"{round(v, 5) + 0.0:.5f}" for v in p) for p in points]  # + 0.0: no −0
    lines += ["vn " + " ".join(f"{round(v, 3) + 0.0:.3f}" for v in n) for n in normals(points, faces)]
    lines += ["f " + " ".join(f"{i + 1}//{i + 1}" for i in face) for face in faces]
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / f"{name}.obj").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    convert(sys.argv[1], "bunny", "Stanford bunny (Stanford 3D Scanning Repository), coarse mesh of the package bunny 1.0.1")
    convert(sys.argv[2], "teapot", "Utah teapot (M. Newell 1975), mesh of the package teapot 1.0.0")
