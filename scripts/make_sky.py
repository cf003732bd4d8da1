#!/usr/bin/env python3
"""Writes configs/environments/clear_sky.exr: a clear sky with sun, half floats, latitude-longitude (top row up, centre towards -z).

Sky: luminance and chromaticity by the model of Preetham, Shirley & Smits 1999 (A practical analytic model for daylight, SIGGRAPH 99,
appendix A.2), turbidity 3, with Perez' formula. Sun: direct normal illuminance 127.5 klx · exp(−0.21/sin h) of a clear sky at height h
[IESNA Lighting Handbook, 9th ed. 2000, ch. 8], the chromaticity of CIE illuminant D55 (x 0.3324, y 0.3474); it fills the one pixel that
its centre lies in, 0.7 deg wide, where the sun has 0.53 deg: shadows have a penumbra a third too wide, and the right illuminance.
Below the horizon: a grey ground of reflectance 0.2 in that light. Colours beyond Rec. 709 are clipped at 0.

One unit of radiance is 15 kcd/m²: white paper in the sun comes near to 1. The file is not compressed, so that its bytes depend on no
library. Standard library only; the same bytes each time.
"""
import math
import pathlib
import struct

WIDTH, HEIGHT = 512, 256
TURBIDITY = 3.0
SUN_HEIGHT_DEG, SUN_AZIMUTH_DEG = 38.0, 125.0  # azimuth from -z to the right: behind the viewer's right shoulder
UNIT_KCD = 15.0
GROUND_REFLECTANCE = 0.2
REC709_FROM_XYZ = [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]
# Coefficients A … E of Perez' formula as slope and intercept in turbidity, for the luminance Y and the chromaticities x and y.
PEREZ = {"Y": ((0.1787, -1.4630), (-0.3554, 0.4275), (-0.0227, 5.3251), (0.1206, -2.5771), (-0.0670, 0.3703)),
         "x": ((-0.0193, -0.2592), (-0.0665, 0.0008), (-0.0004, 0.2125), (-0.0641, -0.8989), (-0.0033, 0.0452)),
         "y": ((-0.0167, -0.2608), (-0.0950, 0.0092), (-0.0079, 0.2102), (-0.0441, -1.6537), (-0.0109, 0.0529))}
# Rows: turbidity squared, turbidity, 1. Columns: zenith angle of the sun cubed, squared, itself, 1.
ZENITH = {"x": ((0.00166, -0.00375, 0.00209, 0.0), (-0.02903, 0.06377, -0.03202, 0.00394), (0.11693, -0.21196, 0.06052, 0.25886)),
          "y": ((0.00275, -0.00610, 0.00317, 0.0), (-0.04214, 0.08970, -0.04153, 0.00516), (0.15346, -0.26756, 0.06670, 0.26688))}
D55 = (0.3324, 0.3474)


def rec709(x, y, luminance):
    """Linear Rec. 709 of a chromaticity and a luminance; the colour white has the luminance of its three equal values."""
    xyz = (x / y * luminance, luminance, (1 - x - y) / y * luminance)
    return [max(0.0, sum(m * v for m, v in zip(row, xyz))) for row in REC709_FROM_XYZ]


def direction(azimuth, height):
    return math.sin(azimuth) * math.cos(height), math.sin(height), -math.cos(azimuth) * math.cos(height)


class Sky:
    def __init__(self):
        self.sun = direction(math.radians(SUN_AZIMUTH_DEG), math.radians(SUN_HEIGHT_DEG))
        theta, t = math.pi / 2 - math.radians(SUN_HEIGHT_DEG), TURBIDITY
        chi = (4 / 9 - t / 120) * (math.pi - 2 * theta)
        self.zenith = {"Y": (4.0453 * t - 4.9710) * math.tan(chi) - 0.2155 * t + 2.4192}  # kcd/m²
        for key, rows in ZENITH.items():
            self.zenith[key] = sum(f * sum(c * theta ** p for c, p in zip(row, (3, 2, 1, 0))) for f, row in zip((t * t, t, 1.0), rows))
        self.perez = {key: [slope * t + intercept for slope, intercept in table] for key, table in PEREZ.items()}
        self.straight_up = {key: self.perez_value(key, 1.0, theta) for key in self.perez}

    def perez_value(self, key, cos_theta, gamma):
        a, b, c, d, e = self.perez[key]
        return (1 + a * math.exp(b / cos_theta)) * (1 + c * math.exp(d * gamma) + e * math.cos(gamma) ** 2)

    def radiance(self, to):
        """Of the sky without sun towards a direction above the horizon, in units."""
        gamma = math.acos(max(-1.0, min(1.0, sum(a * b for a, b in zip(to, self.sun)))))
        luminance, x, y = (self.zenith[key] * self.perez_value(key, to[1], gamma) / self.straight_up[key] for key in ("Y", "x", "y"))
        return rec709(x, y, luminance / UNIT_KCD)


def half(value):
    return struct.pack("<e", min(value, 65504.0))


def exr(rows):
    """A scan-line OpenEXR file without compression; rows from the top, pixels [r, g, b]."""
    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    height, width = len(rows), len(rows[0])
    channels = b"".join(name + b"\0" + struct.pack("<iB3xii", 1, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = b"\x76\x2f\x31\x01" + struct.pack("<i", 2)
    for name, kind, data in (("channels", "chlist", channels), ("compression", "compression", b"\0"), ("dataWindow", "box2i", window),
                             ("displayWindow", "box2i", window), ("lineOrder", "lineOrder", b"\0"),
                             ("pixelAspectRatio", "float", struct.pack("<f", 1)), ("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
                             ("screenWindowWidth", "float", struct.pack("<f", 1))):
        header += attribute(name, kind, data)
    header += b"\0"
    size = 8 + 6 * width
    offsets = b"".join(struct.pack("<Q", len(header) + 8 * height + k * size) for k in range(height))
    lines = [struct.pack("<ii", y, 6 * width) + b"".join(half(pixel[c]) for c in (2, 1, 0) for pixel in row) for y, row in enumerate(rows)]
    return header + offsets + b"".join(lines)


def picture():
    sky = Sky()
    rows, illuminance = [], [0.0, 0.0, 0.0]
    solid_angle = [2 * math.pi / WIDTH * (math.cos(math.pi * r / HEIGHT) - math.cos(math.pi * (r + 1) / HEIGHT)) for r in range(HEIGHT)]
    for r in range(HEIGHT // 2):
        height = math.pi * (0.5 - (r + 0.5) / HEIGHT)
        row = [sky.radiance(direction(2 * math.pi * (c + 0.5) / WIDTH - math.pi, height)) for c in range(WIDTH)]
        for pixel in row:
            illuminance = [e + v * solid_angle[r] * math.sin(height) for e, v in zip(illuminance, pixel)]
        rows.append(row)
    r = int((0.5 - SUN_HEIGHT_DEG / 180) * HEIGHT)
    c = int((SUN_AZIMUTH_DEG / 360 + 0.5) * WIDTH)
    normal_klx = 127.5 * math.exp(-0.21 / math.sin(math.radians(SUN_HEIGHT_DEG)))
    sun = rec709(*D55, normal_klx / solid_angle[r] / UNIT_KCD)
    rows[r][c] = [a + b for a, b in zip(rows[r][c], sun)]
    illuminance = [e + v * solid_angle[r] * math.sin(math.radians(SUN_HEIGHT_DEG)) for e, v in zip(illuminance, sun)]
    ground = [GROUND_REFLECTANCE * e / math.pi for e in illuminance]
    return rows + [[ground] * WIDTH for _ in range(HEIGHT // 2)]


def main():
    folder = pathlib.Path(__file__).resolve().parents[1] / "configs/environments"
    folder.mkdir(exist_ok=True)
    (folder / "clear_sky.exr").write_bytes(exr(picture()))


if __name__ == "__main__":
    main()
