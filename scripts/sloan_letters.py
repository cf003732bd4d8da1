"""The ten Sloan letters as convex polygons, for eye charts and signs in scenes. Standard library only.

Design: every letter fills a square of five units, every stroke is one unit wide, without serifs; O is a ring, C the Landolt ring with a gap
of one unit, and the curves of D, R and S are arcs whose outer edge touches the square [Sloan1959: L. L. Sloan, New test charts for the
measurement of visual acuity at far and near distances, Am. J. Ophthalmol. 48, 1959; NAS-NRC Committee on Vision 1980, Adv.
Ophthalmol. 41]. Where that rule leaves an edge open (how the arms of K meet, where S ends) the simplest construction stands here.

A letter of logMAR v subtends 5·10^v arcmin at its distance: 8.727 mm at 6 m for v = 0.
"""
import math

from scene_parts import append_polygon

ARC_STEP = math.radians(9)
FULL = 2 * math.pi


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def clipped(polygon, a, b, c):
    """What of a convex polygon has a·x + b·y ≥ c [SutherlandHodgman1974]."""
    kept = []
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        s0, s1 = a * x0 + b * y0 - c, a * x1 + b * y1 - c
        if s0 >= 0:
            kept.append((x0, y0))
        if s0 * s1 < 0:
            t = s0 / (s0 - s1)
            kept.append((x0 + t * (x1 - x0), y0 + t * (y1 - y0)))
    return kept


def arc(x, y, outer, first, last, inner_first=None, inner_last=None):
    """A stroke of width 1 along an arc, counter-clockwise; the inner edge may begin and end at angles of its own."""
    inner_first = first if inner_first is None else inner_first
    inner_last = last if inner_last is None else inner_last
    count = max(1, math.ceil((last - first) / ARC_STEP - 1e-9))

    def point(radius, begin, end, k):
        angle = begin + (end - begin) * k / count
        return x + radius * math.cos(angle), y + radius * math.sin(angle)

    inner = outer - 1
    return [[point(outer, first, last, k), point(outer, first, last, k + 1), point(inner, inner_first, inner_last, k + 1),
             point(inner, inner_first, inner_last, k)] for k in range(count)]


def diagonal_width(run, rise):
    """Horizontal width w of a slanted stroke of width 1 that moves sideways by run − w over `rise`: w·rise = √((run − w)² + rise²)."""
    a, b, c = rise * rise - 1, 2 * run, -(run * run + rise * rise)
    return (-b + math.sqrt(b * b - 4 * a * c)) / (2 * a)


def letter_c():
    gap = [math.asin(0.5 / radius) for radius in (2.5, 1.5)]
    return arc(2.5, 2.5, 2.5, gap[0], FULL - gap[0], gap[1], FULL - gap[1])


def letter_d():
    return [rectangle(0, 0, 1, 5), rectangle(1, 0, 2.5, 1), rectangle(1, 4, 2.5, 5)] + arc(2.5, 2.5, 2.5, -math.pi / 2, math.pi / 2)


def letter_h():
    return [rectangle(0, 0, 1, 5), rectangle(4, 0, 5, 5), rectangle(1, 2, 4, 3)]


def letter_k():
    w = math.sqrt(2)
    upper = [(-w, 0), (0, 0), (5, 5), (5 - w, 5)]
    lower = clipped([(5 - w, 0), (5, 0), (0, 5), (-w, 5)], 1, -1, 0)
    return [rectangle(0, 0, 1, 5), clipped(upper, 1, 0, 1), clipped(lower, 1, 0, 1)]


def letter_n():
    w = diagonal_width(5, 5)
    stroke = [(5 - w, 0), (5, 0), (w, 5), (0, 5)]
    return [rectangle(0, 0, 1, 5), rectangle(4, 0, 5, 5), clipped(clipped(stroke, 1, 0, 1), -1, 0, -4)]


def letter_o():
    return arc(2.5, 2.5, 2.5, 0, FULL)


def letter_r():
    w = diagonal_width(2.5, 2)
    bars = [rectangle(0, 0, 1, 5), rectangle(1, 4, 3.5, 5), rectangle(1, 2, 3.5, 3)]
    return bars + arc(3.5, 3.5, 1.5, -math.pi / 2, math.pi / 2) + [[(5 - w, 0), (5, 0), (2.5 + w, 2), (2.5, 2)]]


def letter_s():
    quarter = math.pi / 2
    return (arc(3.5, 3.5, 1.5, 0, quarter) + [rectangle(1.5, 4, 3.5, 5)] + arc(1.5, 3.5, 1.5, quarter, 3 * quarter) +
            [rectangle(1.5, 2, 3.5, 3)] + arc(3.5, 1.5, 1.5, -quarter, quarter) + [rectangle(1.5, 0, 3.5, 1)] +
            arc(1.5, 1.5, 1.5, 2 * quarter, 3 * quarter))


def letter_v():
    w = 1.0
    for _ in range(60):  # the foot is as wide as the stroke's horizontal width, so the run depends on it; a contraction
        w = math.hypot(2.5 - w / 2, 5) / 5
    left = [(2.5 - w / 2, 0), (2.5 + w / 2, 0), (w, 5), (0, 5)]
    right = [(5 - x, y) for x, y in reversed(left)]
    edge = 2.5 - w / 2  # the left arm's right edge runs from (w, 5) to (2.5 + w/2, 0)
    return [left, clipped(right, 5, edge, 5 * (2.5 + w / 2))]


def letter_z():
    w = diagonal_width(5, 5)
    stroke = [(0, 0), (w, 0), (5, 5), (5 - w, 5)]
    return [rectangle(0, 0, 5, 1), rectangle(0, 4, 5, 5), clipped(clipped(stroke, 0, 1, 1), 0, -1, -4)]


LETTERS = {"C": letter_c(), "D": letter_d(), "H": letter_h(), "K": letter_k(), "N": letter_n(), "O": letter_o(), "R": letter_r(),
           "S": letter_s(), "V": letter_v(), "Z": letter_z()}


def letter_height(log_mar, distance):
    """Height [m] of a letter of that logMAR at that distance [m]."""
    return 2 * distance * math.tan(math.radians(5 * 10 ** log_mar / 60) / 2)


def text_width(text, height, gap=1.0):
    """Width of a line whose letters stand `gap` letter widths apart."""
    return height * (len(text) + gap * (len(text) - 1))


def add_text(mesh, text, height, center, right=(1, 0, 0), up=(0, 1, 0), gap=1.0):
    """Adds a line of letters to a mesh, centred at `center` in the plane of `right` and `up` (unit vectors). Blanks are one letter wide."""
    left = -text_width(text, height, gap) / 2
    for k, letter in enumerate(text):
        if letter == " ":
            continue
        for polygon in LETTERS[letter]:
            corners = [(left + height * (k * (1 + gap) + x / 5), height * (y / 5 - 0.5)) for x, y in polygon]
            append_polygon(mesh, [[center[i] + x * right[i] + y * up[i] for i in range(3)] for x, y in corners])


def chart_rows(largest, smallest, lines, distance):
    """(height, text, centre below the top edge of the first row) of each row, logMAR in steps of 0.1; the space below a row is as high as the
    next one [BaileyLovie1976; Ferris1982]."""
    rows, top = [], 0.0
    for k in range(round((largest - smallest) * 10) + 1):
        height = letter_height(largest - 0.1 * k, distance)
        if rows:
            top += height  # the space above
        rows.append((height, lines[k % len(lines)], top + height / 2))
        top += height
    return rows
