"""The cases of tests/reference/thick_lens.json as documents of the program.

The file is in the examiner's frame (x flipped), its z runs from the eye to the object.
"""
import json
import math

from sturm_process import SOURCE

CASES = json.loads((SOURCE / "tests/reference/thick_lens.json").read_text())["cases"]


def direction(v):
    return [-v[0], v[1], -v[2]]


def surface(s):
    """A torus as it stands in the file; its curvatures are negative where the centre lies towards the eye. 0 is flat."""
    def radius(c):
        return None if c == 0.0 else -1.0 / c

    if s["cx_per_mm"] == s["cy_per_mm"]:
        return {"type": "sphere", "radius_mm": radius(s["cx_per_mm"])}
    return {"type": "torus", "sweep_radius_mm": radius(s["cx_per_mm"]), "generator_radius_mm": radius(s["cy_per_mm"]), "sweep_meridian_deg": s["local_x_deg"]}


def gaze_deg(out):
    x, y, z = direction(out["gaze_dir"])
    return [math.degrees(math.atan2(x, -z)), math.degrees(math.asin(y))]


def lens_of(case):
    """The spectacles of a case, without a format."""
    lens = case["inputs"]["lens"]
    return {"vertex_distance_mm": 12, "center_thickness_mm": lens["center_thickness_mm"], "refractive_index": lens["index"],
            "front": surface(lens["front"]), "back": surface(lens["back"])}


class EveryCase:
    """For a test class: every case goes through its `check(case)`."""

    def test_all_cases(self):
        self.assertEqual(len(CASES), 117)
        for case in CASES:
            with self.subTest(case["id"]):
                self.check(case)
