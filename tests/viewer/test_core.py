"""The WebAssembly core in node against the same sources compiled for this machine, and against `sturm ellipse`."""
import concurrent.futures
import json
import math
import os
import shutil
import subprocess
import unittest

from core_queries import CORE, LENS_TARGETS, PRESCRIPTION_TARGETS, core, lens_queries, prescription_queries
from sturm_process import FolderTest, strict_json, sturm
from viewer_page import skip

REFERENCE = os.environ["VIEWER_REFERENCE"]
TWELVE_DIGITS = 1e-12
PUPIL_RADIUS_M = 2e-3


def ask(query):
    """The results of `sturm ellipse`."""
    process = sturm("ellipse", "-", stdin=json.dumps(query))
    if process.returncode:
        raise AssertionError(process.stderr)
    return strict_json(process.stdout)["results"]


def ask_all(queries):
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(ask, queries))


class Bits(FolderTest):
    def test_fields_are_the_same_bits(self):
        native = strict_json(subprocess.run([REFERENCE, "fields"], capture_output=True, text=True, check=True).stdout)
        self.assertEqual(sorted(native), ["naked", "progressive", "toric"])
        self.assertEqual(core("fields"), native)
        self.assertEqual(len({field["voxels"] for field in native.values()}), 3)

    def test_ellipses_differ_by_the_last_bits_of_the_mathematics_library(self):
        file = self.folder / "ellipses.bin"
        subprocess.run([REFERENCE, "ellipses", file], check=True)
        worst = core("ellipses", str(file))
        self.assertGreater(worst["count"], 19000)  # some chief rays pass the lens by
        self.assertEqual(worst["maps"], 0)
        # Sine and cosine of an angle of gaze are an ulp apart in a few cases out of a hundred, and their differences grow on the way.
        self.assertLessEqual(worst["askance"], 5e-14)
        # hypot and atan2 of another library: at most an ulp or two. Measured 4.4e-16 and 1.4e-14.
        self.assertLessEqual(worst["semi_axes"], 1e-15)
        self.assertLessEqual(worst["angles_deg"], 3e-14)


class Sights(unittest.TestCase):
    def test_nodes_between_traced_ones_in_half_the_time(self):
        for lens, found in core("sights").items():
            with self.subTest(lens=lens):
                print(f"lines of sight of a picture, {lens}: {found['ms']:.1f} ms, each traced {found['traced_ms']:.1f} ms", flush=True)
                # A quarter of them is traced, and of the others those next to the rim.
                self.assertLess(found["ms"], 0.5 * found["traced_ms"])
                self.assertGreater(found["stopped"], 100)  # by the rim, to which nodes are right
                self.assertEqual(found["wrong"], 0)
                # Straight lines between nodes, as in the program and on the graphics card, are off by 2e-5 rad (conoid/pictures/sight_field.h); here
                # the next two nodes bend them. The surface of a progressive lens is a spline, whose fourth derivative is where its knots are.
                self.assertLess(found["directions"], {"toric": 2e-6, "progressive": 2e-5, "tilted": 2e-6}[lens])
                self.assertLess(found["places"], 1e-7)
                self.assertLess(found["powers"], {"toric": 1e-5, "progressive": 0.03, "tilted": 1e-5}[lens])

    def test_places_between_nodes_follow_the_rim(self):
        for lens, found in core("sights").items():
            with self.subTest(lens=lens):
                print(f"at the rim, {lens}: {found['rim']}", flush=True)
                rim = found["rim"]
                self.assertGreater(rim["places"], 500)
                # The distance from the axis is nearly a parabola over a cell, so the rim is off by 5e-5 in slope: 1/400 of a cell.
                self.assertLess(rim["wrong"], 0.005 * rim["places"])
                self.assertLess(rim["directions"], 1e-4)  # as by straight lines between nodes within; without those beyond the rim 7e-4

    def test_strong_lenses_end_where_they_do(self):
        for lens, off in core("edges").items():
            with self.subTest(lens=lens):
                print(f"the end of a lens of {lens} D: off by at most {off['largest']:.1e} in slope, {off['mean']:.1e} in the mean", flush=True)
                # A lens of +8 D ends within its rim, where its surfaces meet; how far away that is nodes do not know, so it is put half-way between two
                # of them, which are up to 0.02 √2 apart.
                self.assertLess(off["largest"], 0.0142 if lens == "plus 8" else 1e-4)


class Answers(FolderTest):
    def close(self, mine, theirs, scale):
        self.assertEqual(mine is None, theirs is None)
        if mine is None:
            return
        for a, b in zip(mine, theirs, strict=True):
            self.assertLessEqual(abs(a - b), TWELVE_DIGITS * scale)

    def compare(self, answer, result, targets):
        self.assertEqual(answer["status"], result["status"])
        if answer["status"] != "ok":
            self.assertIsNone(answer["semi_axes_rad"])
            return
        self.assertLessEqual(abs(answer["accommodation_D"] - result["accommodation_D"]), TWELVE_DIGITS)
        # Where the lens makes a point sharp, what is left is what cancels out: twelve digits of a dioptre's blur, then.
        distance = targets[result["target"]]["distance_m"]
        reach = None if distance == "inf" else distance
        for key, unit in (("semi_axes_rad", 1.0), ("semi_axes_m", reach or 1.0)):
            self.close(answer[key], result[key], max(result[key][0], PUPIL_RADIUS_M * unit) if result[key] else 0.0)
        rows = result["footprint"]
        flat = [*rows[0], *rows[1]]
        self.close(answer["footprint"] or answer["angular_footprint"], flat, max(reach or 1.0, *map(abs, flat)))
        curvature = result["wavefront_curvature_D"]
        self.close(answer["wavefront_curvature_D"], curvature, max(1.0, *map(abs, curvature)) if curvature else 0.0)
        self.close(answer["chief_ray"]["origin_m"], result["chief_ray"]["origin_m"], 1e-2)
        self.close(answer["chief_ray"]["direction"], result["chief_ray"]["direction"], 1.0)
        self.assertEqual(answer["orientation_deg"] is None, result["orientation_deg"] is None)
        if result["orientation_deg"] is not None:
            # A nearly round ellipse turns by what its axes differ by.
            major, minor = result["semi_axes_rad"]
            turn = abs(math.remainder(answer["orientation_deg"] - result["orientation_deg"], 180.0))
            self.assertLessEqual(turn * (major - minor), math.degrees(TWELVE_DIGITS * max(major, PUPIL_RADIUS_M)))

    def compare_all(self, documents, numbers, targets):
        for document, answers, results in zip(documents, core("answers", stdin=json.dumps(numbers)), ask_all(documents), strict=True):
            for answer, result in zip(answers, results, strict=True):
                with self.subTest(eye=document["eye"], lens=document.get("spectacles"), target=result["target"]):
                    self.compare(answer, result, targets)

    def test_real_prescriptions(self):
        documents, numbers = prescription_queries()
        self.assertEqual(len(documents), 413)
        self.compare_all(documents, numbers, PRESCRIPTION_TARGETS)

    def test_lenses_as_sturm_view_hands_them_over(self):
        """JSON, numbers of the page, WebAssembly, against the program."""
        documents, numbers = lens_queries(self.folder)
        self.assertGreaterEqual(len(documents), 11)  # one of them is made for the eye
        self.compare_all(documents, numbers, LENS_TARGETS)


class Manners(unittest.TestCase):
    def test_messages_are_the_programs(self):
        manners = core("manners")
        messages = manners["messages"]
        self.assertEqual(messages["sphere"], "sphere [D] is -99, expected -40 to 40")
        self.assertIn("expected relaxed, fixed or best", messages["mode"])
        self.assertIn("pupil_diameter_m", messages["missing"])
        self.assertIn("refractive index", messages["lens"])
        self.assertIn("an axis behind the cylinder", messages["notation"])
        self.assertEqual([noted["eye"] for noted in manners["noted"]], ["right", "left"])
        self.assertEqual(manners["noted"][0]["addition_D"], 2)

    def test_power_matrix_rays_and_clear_vision(self):
        manners = core("manners")
        # F of -2.00 -1.50 x 30 at 12 mm: vergences move by v/(1 - dv), then Long's matrix, in the wearer frame (axis 180 - 30).
        along, across = (v / (1 - 12e-3 * v) for v in (-2.0, -3.5))
        s, c = math.sin(math.radians(150)), math.cos(math.radians(150))
        xx, xy, yy = along * c * c + across * s * s, (along - across) * s * c, along * s * s + across * c * c
        for mine, expected in zip(manners["rays"], [1e-3 * xx, 1e-3 * xy, 1e-3 * xy, 1e-3 * yy], strict=True):
            self.assertAlmostEqual(mine, expected, delta=1e-9)  # single precision
        # The larger semi-axis a·max|V + F| is least where both meridians are equally off.
        clear = manners["clear"]
        self.assertEqual(clear["status"], "never_clear")
        self.assertAlmostEqual(clear["best_vergence_D"], -0.5 * (along + across), delta=1e-8)
        self.assertAlmostEqual(clear["best_semi_major_rad"], 2e-3 * 0.5 * (along - across), delta=1e-12)


if __name__ == "__main__":
    if not CORE.exists():
        skip(f"{CORE} was not built (preset wasm)")
    if not shutil.which("node"):
        skip("no node")
    unittest.main()
