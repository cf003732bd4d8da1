#!/usr/bin/env python3
"""Writes configs/scenes/cornell_box.json from Cornell's measurements in configs/data/cornell_box.json.

Geometry: millimetres to metres, vertices as measured (the walls are not quite square). The ceiling has a hole where the light is, in
the plane of the ceiling: no coincident surfaces, and the light stays where it was measured. The light faces down; walls face into the
room, blocks outwards. Blocks get four sides down to the floor and no bottom.

Colours: spectra to linear Rec. 709 with the CIE 1931 2-degree matching functions in the analytic fit of Wyman, Sloan & Shirley 2013
(JCGT 2(2), multi-lobe; error about 1 % of the peak), 400 to 700 nm, trapezoidal rule at 1 nm on linearly interpolated data.
The light's radiance is scaled so that a spectrum of constant 1 has luminance 1. A reflectance is, per channel, the colour of the
measured light after one reflection divided by the colour of the light: directly lit surfaces have exactly their measured colour,
interreflections are as good as three channels can be.

Python 3 standard library only; the same bytes each time. Run from anywhere: scripts/make_cornell_box.py
"""
import json
import math
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
REC709_FROM_XYZ = [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]


def lobe(wavelength, centre, below, above):
    return math.exp(-0.5 * ((wavelength - centre) / (below if wavelength < centre else above)) ** 2)


def matching_functions(w):
    return (1.056 * lobe(w, 599.8, 37.9, 31.0) + 0.362 * lobe(w, 442.0, 16.0, 26.7) - 0.065 * lobe(w, 501.1, 20.4, 26.2),
            0.821 * lobe(w, 568.8, 46.9, 40.5) + 0.286 * lobe(w, 530.9, 16.3, 31.1),
            1.217 * lobe(w, 437.0, 11.8, 36.0) + 0.681 * lobe(w, 459.0, 26.0, 13.8))


def interpolated(table, wavelength):
    for (w0, v0), (w1, v1) in zip(table, table[1:]):
        if w0 <= wavelength <= w1:
            return v0 + (v1 - v0) * (wavelength - w0) / (w1 - w0)
    raise ValueError(f"{wavelength} nm lies outside of the table")


def rec709(spectrum):
    """Linear Rec. 709 of a spectrum, a function of wavelength in nm; luminance of the constant spectrum 1 is 1."""
    xyz, y_of_white = [0.0, 0.0, 0.0], 0.0
    for w in range(400, 701):
        weight = 0.5 if w in (400, 700) else 1.0
        bars = matching_functions(w)
        y_of_white += weight * bars[1]
        for i in range(3):
            xyz[i] += weight * bars[i] * spectrum(w)
    return [sum(m * v for m, v in zip(row, xyz)) / y_of_white for row in REC709_FROM_XYZ]


def check_against_published(data):
    """Under a light of equal energy the same integrals must give the RGB set that Mitsuba publishes for these paints: within 0.004 of
    reflectance, what the analytic matching functions leave."""
    for name, published in data["rgb_sets"]["Mitsuba"].items():
        if name == "light":  # another interpolation of the four values, not an oracle
            continue
        table = data["reflectance_nm"][name]
        for mine, theirs in zip(rec709(lambda w: interpolated(table, w)), published):
            if abs(mine - theirs) > 0.004:
                raise SystemExit(f"{name}: {mine} is not the published {theirs}")


def metres(points):
    return [[round(v / 1000.0, 7) for v in p] for p in points]


def quad(name, material, points):
    return {"name": name, "material": material, "positions_m": metres(points), "faces": [[0, 1, 2], [0, 2, 3]]}


def block(name, top):
    """Top counter-clockwise from above, as measured; four sides that face outwards."""
    points = top + [[x, 0, z] for x, _, z in top]
    faces = [[0, 1, 2], [0, 2, 3]]
    for i in range(4):
        j = (i + 1) % 4
        faces += [[i, i + 4, j + 4], [i, j + 4, j]]
    return {"name": name, "material": "white", "positions_m": metres(points), "faces": faces}


def ceiling_around(ceiling, light):
    """Four rectangles of the ceiling (axis-parallel, as is the light) that leave the light's place open; facing down."""
    y = ceiling[0][1]
    x0, x1 = (f(p[0] for p in ceiling) for f in (min, max))
    z0, z1 = (f(p[2] for p in ceiling) for f in (min, max))
    a0, a1 = (f(p[0] for p in light) for f in (min, max))
    b0, b1 = (f(p[2] for p in light) for f in (min, max))
    parts = {"front": (x0, x1, z0, b0), "rear": (x0, x1, b1, z1), "left": (a1, x1, b0, b1), "right": (x0, a0, b0, b1)}
    return [quad("ceiling_" + name, "white", [[right, y, near], [right, y, far], [left, y, far], [left, y, near]])
            for name, (left, right, near, far) in parts.items()]


def main():
    data = json.loads((ROOT / "configs/data/cornell_box.json").read_text())
    check_against_published(data)
    emission = data["light_emission_nm"]
    light_rgb = rec709(lambda w: interpolated(emission, w))

    def reflectance(table):
        reflected = rec709(lambda w: interpolated(emission, w) * interpolated(table, w))
        return [round(r / l, 6) for r, l in zip(reflected, light_rgb)]

    materials = {name: {"albedo": reflectance(table)} for name, table in data["reflectance_nm"].items()}
    materials["light"] = {"albedo": [data["light_reflectance"]] * 3, "emission": [round(v, 6) for v in light_rgb]}

    quads = data["quads"]
    meshes = [quad("floor", "white", quads["floor"]), quad("light", "light", quads["light"]),
              *ceiling_around(quads["ceiling"], quads["light"]), quad("back", "white", quads["back"]),
              quad("right_green", "green", quads["right_green"]), quad("left_red", "red", quads["left_red"]),
              block("short_block", data["short_block_top"]), block("tall_block", data["tall_block_top"])]

    scene = {"format": "sturm.scene/1",
             "title": "Cornell box, measured geometry and spectra. Camera of the data: position (0.278, 0.273, -0.8) looking along +z, vfov 39.3077 degrees",
             "source": "configs/data/cornell_box.json by scripts/make_cornell_box.py (says how spectra become colours). " + data["source"],
             "materials": materials, "meshes": meshes}
    # One mesh or material a line keeps the file readable and its differences small.
    lines = ["{"]
    for key in ("format", "title", "source"):
        lines.append(f"  {json.dumps(key)}: {json.dumps(scene[key])},")
    lines.append('  "materials": {')
    lines += [f"    {json.dumps(k)}: {json.dumps(v)}{',' if i + 1 < len(materials) else ''}" for i, (k, v) in enumerate(materials.items())]
    lines.append('  },\n  "meshes": [')
    lines += [f"    {json.dumps(m)}{',' if i + 1 < len(meshes) else ''}" for i, m in enumerate(meshes)]
    lines.append("  ]\n}")
    (ROOT / "configs/scenes/cornell_box.json").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
