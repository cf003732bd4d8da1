"""Parts of scene files (sturm.scene/1) that the scripts of this folder share. Metres, y up. Standard library only."""
import json
import math


def quad(name, material, a, b, c, d):
    """Faces the side from which a b c d run counter-clockwise."""
    return {"name": name, "material": material, "positions_m": [a, b, c, d], "faces": [[0, 1, 2, 3]]}


def box(name, material, low, high):
    """Axis-parallel, faces outwards."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    corners = [[x, y, z] for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    faces = [[4, 5, 7, 6], [1, 0, 2, 3], [5, 1, 3, 7], [0, 4, 6, 2], [6, 7, 3, 2], [0, 1, 5, 4]]
    return {"name": name, "material": material, "positions_m": corners, "faces": faces}


def cylinder(name, material, foot, radius, height, sides=24, top_radius=None):
    """Upright prism, or frustum, about the axis over `foot`; closed above, open below."""
    x, y, z = foot
    upper = radius if top_radius is None else top_radius
    rings = [[[x + r * math.cos(2 * math.pi * k / sides), h, z - r * math.sin(2 * math.pi * k / sides)] for k in range(sides)]
             for r, h in ((radius, y), (upper, y + height))]
    faces = [[k, (k + 1) % sides, sides + (k + 1) % sides, sides + k] for k in range(sides)]
    faces += [[2 * sides, sides + k, sides + (k + 1) % sides] for k in range(sides)]
    return {"name": name, "material": material, "positions_m": rings[0] + rings[1] + [[x, y + height, z]], "faces": faces}


def checker(name, materials, x_range, z_range, tiles, y=0.0):
    """Two meshes of the tiles of a floor, facing up; `tiles` = (across, along)."""
    (x0, x1), (z0, z1), (nx, nz) = x_range, z_range, tiles
    meshes = [{"name": f"{name}_{k}", "material": material, "positions_m": [], "faces": []} for k, material in enumerate(materials)]
    for i in range(nx):
        for k in range(nz):
            left, right = (x0 + (x1 - x0) * j / nx for j in (i, i + 1))
            near, far = (z0 + (z1 - z0) * j / nz for j in (k, k + 1))
            append_polygon(meshes[(i + k) % 2], [[left, y, near], [right, y, near], [right, y, far], [left, y, far]])
    return meshes


def append_polygon(mesh, corners):
    """Adds a convex polygon as triangles."""
    first = len(mesh["positions_m"])
    mesh["positions_m"] += corners
    mesh["faces"] += [[first, first + k, first + k + 1] for k in range(1, len(corners) - 1)]


def rounded(value, digits):
    if isinstance(value, float):
        return round(value, digits) + 0.0  # no −0
    return [rounded(v, digits) for v in value] if isinstance(value, (list, tuple)) else value


def write_scene(path, scene, digits=5):
    """One entry of a list or object a line: readable, and small differences. Positions are rounded to 10^−digits m."""
    lines = ["{"]
    keys = list(scene)
    for key in keys:
        end = "" if key == keys[-1] else ","
        value = scene[key]
        if key == "meshes":
            value = [dict(mesh, positions_m=rounded(mesh["positions_m"], digits)) for mesh in value]
        if isinstance(value, list):
            entries = [f"    {json.dumps(entry)}" for entry in value]
            lines += [f"  {json.dumps(key)}: [", ",\n".join(entries), f"  ]{end}"]
        elif isinstance(value, dict) and key == "materials":
            entries = [f"    {json.dumps(name)}: {json.dumps(entry)}" for name, entry in value.items()]
            lines += [f"  {json.dumps(key)}: {{", ",\n".join(entries), f"  }}{end}"]
        else:
            lines.append(f"  {json.dumps(key)}: {json.dumps(value, ensure_ascii=False)}{end}")
    path.write_text("\n".join(lines + ["}"]) + "\n", encoding="utf-8")
