"""What the page says and draws of the blur at the pointer, against `sturm ellipse`: the ellipse on the picture, and the rows of the table."""
import json
import math

from page_in_browser import QUADS, PageTest, emissive_view, main
from sturm_process import PASSED, strict_json, sturm

SIZE, FIELD_DEG, WALL_M, ROTATION_CENTER_M = 64, 36, 6.0, 0.0135
PIXEL_SLOPE = 2 * math.tan(math.radians(FIELD_DEG / 2)) / SIZE
EYES = ({"sphere_D": -6, "cylinder_D": -3, "axis_deg": 30}, {"sphere_D": 1.25, "cylinder_D": -2.5, "axis_deg": 110})


def program(eye, gaze_deg, distance_m):
    query = {"format": "sturm.ellipse/1", "methods": ["conoid"], "targets": [{"gaze_deg": gaze_deg, "distance_m": distance_m}],
             "eye": {"prescription": {**eye, "vertex_distance_mm": 0}, "pupil_diameter_mm": 6, "accommodation": {"mode": "relaxed"}}}
    process = sturm("ellipse", "-", stdin=json.dumps(query))
    if process.returncode != PASSED:
        raise AssertionError(process.stderr)
    return strict_json(process.stdout)["results"][0]


def turned_axes(ahead):
    """Right and up, turned by the smallest rotation that takes straight ahead to a unit vector."""
    x, y, z = ahead
    scale = 1 / (1 - z)
    return (1 - scale * x * x, -scale * x * y, x), (-scale * x * y, 1 - scale * y * y, y)


def on_picture(point, center_m):
    """Where a line from (0, 0, center_m) through a point meets the picture [px, y down]."""
    depth = center_m - point[2]
    return SIZE / 2 + point[0] / depth / PIXEL_SLOPE, SIZE / 2 - point[1] / depth / PIXEL_SLOPE


def drawn(result, distance_m, center_m):
    """The image on the picture of the ellipse in space: middle, semi-axes [px], and its turn as SVG counts it (clockwise)."""
    origin, ahead = result["chief_ray"]["origin_m"], result["chief_ray"]["direction"]
    middle = [o + distance_m * d for o, d in zip(origin, ahead)]
    columns, step = [], 1e-4
    for axis in turned_axes(ahead):
        there, back = (on_picture([m + sign * step * a for m, a in zip(middle, axis)], center_m) for sign in (1, -1))
        columns.append([(p - q) / (2 * step) for p, q in zip(there, back)])
    foot = result["footprint"]
    m = [[0.003 * sum(columns[k][row] * foot[k][column] for k in (0, 1)) for column in (0, 1)] for row in (0, 1)]
    xx, xy, yy = (sum(m[i][k] * m[j][k] for k in (0, 1)) for i, j in ((0, 0), (0, 1), (1, 1)))
    mean, half = 0.5 * (xx + yy), math.hypot(0.5 * (xx - yy), xy)
    return on_picture(middle, center_m), (math.sqrt(mean + half), math.sqrt(mean - half)), 0.5 * math.degrees(math.atan2(2 * xy, xx - yy))


class Readout(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls().page_of(emissive_view(SIZE, QUADS[:1], FIELD_DEG))  # nothing but a wall

    def show(self, eye, gaze, place):
        """The page with the pointer at a place of the picture [px]; returns the program's answer for it, and how far away it is."""
        self.browser.run("const {app} = window.sturmViewer; app.pointing.at = {x: arguments[0] / app.width, y: arguments[1] / app.height};", *place)
        self.change(f"Object.assign(s.eyes.right, {json.dumps(eye)}); s.camera.gaze = '{gaze}';")
        self.wait("!window.sturmViewer.app.changed && !window.sturmViewer.app.pointed && document.querySelector('#overlay .pointer')")
        slopes = (place[0] - SIZE / 2) * PIXEL_SLOPE, (SIZE / 2 - place[1]) * PIXEL_SLOPE
        gaze_deg = [math.degrees(math.atan(slopes[0])), math.degrees(math.asin(slopes[1] / math.hypot(*slopes, 1)))]
        chief = program(eye, gaze_deg, 1)["chief_ray"]
        distance = (WALL_M + chief["origin_m"][2]) / -chief["direction"][2]
        return program(eye, gaze_deg, distance), distance

    def test_the_ellipse_on_the_picture(self):
        for eye in EYES:
            # Off the middle an eye that looks ahead sees through a pupil that stands obliquely, which `sturm ellipse` does not.
            for gaze, place, center_m in (("camera", (32, 32), 0.0), ("foveal", (32, 32), ROTATION_CENTER_M), ("foveal", (52, 17), ROTATION_CENTER_M), ("foveal", (9, 50), ROTATION_CENTER_M)):
                with self.subTest(eye=eye, gaze=gaze, place=place):
                    result, distance = self.show(eye, gaze, place)
                    middle, semi_axes, turn = drawn(result, distance, center_m)
                    shown = self.browser.run("""const e = document.querySelector('#overlay .pointer');
                      return [...['cx', 'cy', 'rx', 'ry'].map((name) => Number(e.getAttribute(name))), e.getAttribute('transform')];""")
                    kind, *numbers = shown[4].replace("(", " ").replace(")", "").split()
                    self.assertEqual(kind, "rotate")
                    for mine, expected in zip(shown[:2] + [float(n) for n in numbers[1:]], middle + middle):
                        self.assertAlmostEqual(mine, expected, delta=1e-3)
                    for mine, expected in zip(shown[2:4], semi_axes):
                        self.assertAlmostEqual(mine, expected, delta=1e-3 * expected)  # differences over a pixel for derivatives
                    self.assertAlmostEqual(math.remainder(float(numbers[0]) - turn, 180), 0, delta=0.05)

    def test_the_rows_of_the_table(self):
        for eye in EYES:
            for place in ((32, 32), (52, 17)):
                with self.subTest(eye=eye, place=place):
                    result, _ = self.show(eye, "foveal", place)
                    rows = self.browser.run("return Object.fromEntries([...document.querySelectorAll('#numbers tbody tr')].map((row) => [row.cells[0].textContent, [...row.cells].slice(1).map((c) => c.textContent)]))")
                    for name, key, scale, digits, unit in (("Semi-axes, angle", "semi_axes_arcmin", 1, 2, "′"), ("Semi-axes there", "semi_axes_m", 1e3, 3, " mm"), ("Vergence errors", "semi_axes_D", 1, 3, " D")):
                        for text, expected in zip(rows[name], result[key], strict=True):
                            self.assertTrue(text.endswith(unit), text)
                            # One more than half of the last digit, for what the table of the scene has in single precision.
                            self.assertAlmostEqual(float(text.removesuffix(unit)), scale * expected, delta=0.6 * 10**-digits)


if __name__ == "__main__":
    main()
