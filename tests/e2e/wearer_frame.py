"""Vectors and frames for the tests, written down from docs/theory.md#1-frames-signs-units and independent of the program (no shared code)."""
import math


def folded_deg(angle):
    """An undirected angle in (-90, 90]."""
    angle = math.fmod(angle, 180.0)
    if angle > 90.0:
        angle -= 180.0
    if angle <= -90.0:
        angle += 180.0
    return angle


def from_examiner(xx_xy_yy):
    """A symmetric matrix seen from the wearer's side: x changes sign."""
    xx, xy, yy = xx_xy_yy
    return [xx, -xy, yy]


def frobenius(xx_xy_yy):
    xx, xy, yy = xx_xy_yy
    return math.sqrt(xx * xx + 2.0 * xy * xy + yy * yy)


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


def correction(sphere, cylinder, axis_deg):
    """F [D] at the cornea, wearer frame, [xx, xy, yy]: mean sphere, J0 and J45, the last with the wearer's sign.

    docs/theory.md#2-from-a-prescription-to-a-power-matrix
    """
    j0, j45 = -0.5 * cylinder * math.cos(math.radians(2 * axis_deg)), -0.5 * cylinder * math.sin(math.radians(2 * axis_deg))
    mean = sphere + 0.5 * cylinder
    return [mean + j0, -j45, mean - j0]


def gaze_direction(azimuth_deg, elevation_deg):
    az, el = math.radians(azimuth_deg), math.radians(elevation_deg)
    return [math.sin(az) * math.cos(el), math.sin(el), -math.cos(az) * math.cos(el)]


def turned(vector, direction):
    """`vector` after the smallest rotation that takes -z to `direction` (Rodrigues; direction not +z)."""
    cosine = -direction[2]
    # axis * sine = (-z) x direction
    axis = [direction[1], -direction[0], 0.0]
    cross = [axis[1] * vector[2], -axis[0] * vector[2], axis[0] * vector[1] - axis[1] * vector[0]]
    along = (axis[0] * vector[0] + axis[1] * vector[1]) / (1.0 + cosine)
    return [cosine * v + c + along * a for v, c, a in zip(vector, cross, axis)]
