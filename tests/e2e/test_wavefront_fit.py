"""`sturm wavefront`: slopes, pairs of spots and heights become eyes; orders and sides of Zernike coefficients; random eyes."""
import csv
import json
import math
import unittest

from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

REFERENCE = SOURCE / "tests/reference/wavefronts"
REAL = SOURCE / "configs/data/shwfs_mshwfs_centroids.csv"
RIG = ("--pupil-mm", 4, "--pixel-um", 7.4, "--lenslet-mm", 0.3)


class WavefrontFit(FolderTest):
    def fit(self, *arguments):
        """The report, and the coefficients of the eye's file by their number."""
        path = self.folder / "eye.json"
        report = strict_json(self.succeed("wavefront", *arguments, "-o", path).stdout)
        self.assertEqual(report["format"], "sturm.wavefront_report/1")
        self.succeed("validate", path)
        eye = strict_json(path.read_text())
        return report, {int(j): c for j, c in eye["wavefront"]["coefficients_um"].items()}, eye

    def refuse(self, *arguments, says):
        before = snapshot(self.folder)
        process = sturm("wavefront", *arguments, "-o", self.folder / "no.json", "--report", self.folder / "no_report.json")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertEqual(snapshot(self.folder), before)
        for text in [says] if isinstance(says, str) else says:
            self.assertIn(text, process.stderr)

    def point_slopes(self, case, change=lambda row: row):
        spots = [change(list(row)) for row in case["inputs"]["spots"]]
        return self.write("spots.csv", "x_mm,y_mm,slope_x_rad,slope_y_rad\n" + "".join(",".join(map(repr, row)) + "\n" for row in spots))

    def test_mean_slopes_are_the_references(self):
        for case in json.loads((REFERENCE / "shack_hartmann.json").read_text())["cases"]:
            report, c, _ = self.fit(REFERENCE / case["file"], "--pupil-mm", 6, "--lenslet-mm", 0.3, "--order", 6, "--noise", case["noise_rad"])
            self.assertEqual(report["samples"]["spurious"], 0)
            for entry in report["coefficients"]:
                j = str(entry["j"])
                self.assertAlmostEqual(entry["value_um"], case["least_squares_um"][j], delta=1e-9)
                self.assertAlmostEqual(c[int(j)], case["least_squares_um"][j], delta=1e-9)
                self.assertAlmostEqual(entry["standard_error_um"] / case["standard_error_um"][j], 1, delta=1e-6)

    def test_point_slopes_in_other_units_and_frames(self):
        case = json.loads((REFERENCE / "shwfs.json").read_text())["cases"][6]
        options = ("--pupil-mm", 6, "--gradient", "center", "--order", 5)
        expected = case["outputs"]["zernike_lsq_um"]
        report, _, _ = self.fit(self.point_slopes(case), *options)
        self.assertAlmostEqual(report["condition_number"], case["outputs"]["condition_number"], delta=1e-8)
        self.assertAlmostEqual(report["residual_rms"], case["outputs"]["residual_rms_rad"], delta=1e-12)
        self.assertAlmostEqual(report["noise"], case["outputs"]["sigma_hat_rad"], delta=1e-12)
        arcmin = 60 * 180 / math.pi
        variants = {
            "examiner": ("x_mm,y_mm,slope_x_rad,slope_y_rad", lambda r: r, ()),
            "wearer": ("x_mm,y_mm,slope_x_rad,slope_y_rad", lambda r: [-r[0], r[1], -r[2], r[3]], ("--frame", "wearer")),
            "image": ("x_mm,y_mm,slope_x_rad,slope_y_rad", lambda r: [r[0], -r[1], r[2], -r[3]], ("--frame", "image")),
            "negative": ("x_um,y_um,slope_x_mrad,slope_y_mrad", lambda r: [1e3 * r[0], 1e3 * r[1], -1e3 * r[2], -1e3 * r[3]], ("--negative-slopes",)),
            "semicolons": ("X_mm; Y_mm; Slope_x_rad; Slope_y_rad", lambda r: r, ()),
            "decimal commas": ("x_mm;y_mm;slope_x_rad;slope_y_rad", lambda r: r, ()),
            "moved": ("slope_x_arcmin,slope_y_arcmin,x_mm,y_mm", lambda r: [r[2] * arcmin, r[3] * arcmin, r[0] + 7, r[1] - 2], ("--center", 7, -2)),
        }
        for name, (heading, change, more) in variants.items():
            rows = [change(list(row)) for row in case["inputs"]["spots"]]
            numbers = [[repr(x).replace(".", "," if "commas" in name else ".") for x in row] for row in rows]
            file = self.write(name + ".csv", heading + "\n" + "".join((";" if ";" in heading else ",").join(row) + "\n" for row in numbers))
            _, c, _ = self.fit(file, *options, *more)
            for j, value in enumerate(expected, 1):
                self.assertAlmostEqual(c[j], value, delta=1e-9, msg=f"{name} {j}")

    def test_a_real_sensor(self):
        report, _, _ = self.fit(REAL, *RIG, "--order", 5)
        self.assertAlmostEqual(report["residual_rms"], 0.0643e-3, delta=0.0002e-3)
        self.assertEqual(len(report["residuals"]), 127)
        chosen, c, eye = self.fit(REAL, *RIG, "--wavelength-nm", 633, "--side", "left", "--no-tilt", "--eye-pupil-mm", 3)
        self.assertEqual(chosen["radial_order"], 7)
        self.assertEqual([t["radial_order"] for t in chosen["order_trials"]], list(range(2, 11)))
        self.assertEqual((eye["wavefront"]["wavelength_nm"], eye["wavefront"]["eye"], eye["pupil_diameter_mm"]), (633, "left", 3))
        self.assertNotIn(1, c)
        # Pairs of spots instead of slopes: 18 mm focal length. The file's pixels have three decimals.
        pairs, _, _ = self.fit(REAL, *RIG, "--order", 5, "--focal-length-mm", 18)
        for a, b in zip(pairs["coefficients"], report["coefficients"]):
            self.assertAlmostEqual(a["value_um"], b["value_um"], delta=1e-4)
        # A camera's y points down: the same picture read as if it pointed up is mirrored.
        mirrored, _, _ = self.fit(REAL, *RIG, "--order", 5, "--frame", "examiner")
        self.assertAlmostEqual(mirrored["coefficients"][0]["value_um"], -report["coefficients"][0]["value_um"], delta=1e-9)
        self.assertAlmostEqual(mirrored["coefficients"][1]["value_um"], report["coefficients"][1]["value_um"], delta=1e-9)

    def test_missing_and_spurious_spots_are_reported(self):
        case = json.loads((REFERENCE / "shwfs.json").read_text())["cases"][2]
        rows = [list(map(repr, row)) for row in case["inputs"]["spots"]]
        for i in (10, 50):
            rows[i][2] = rows[i][3] = "nan" if i == 10 else ""
        rows[70][2] = "0.02"
        file = self.write("spots.csv", "x_mm,y_mm,slope_x_rad,slope_y_rad\n" + "\n".join(",".join(row) for row in rows))
        report, _, _ = self.fit(file, "--pupil-mm", 6, "--gradient", "center", "--order", 5, "--residuals", self.folder / "map.csv")
        self.assertEqual(report["samples"], {"rows": 145, "used": 142, "missing": 2, "outside": 0, "spurious": 1})
        self.assertEqual([m["line"] for m in report["missing"]], [12, 52])
        self.assertEqual([s["line"] for s in report["spurious"]], [72])
        for entry in report["coefficients"]:
            truth = case["inputs"]["true_zernike_um"][str(entry["j"])]
            self.assertLess(abs(entry["value_um"] - truth), 5 * entry["standard_error_um"])
        with open(self.folder / "map.csv", newline="", encoding="utf-8") as lines:
            table = list(csv.DictReader(lines))
        self.assertEqual(len(table), 143)
        self.assertEqual([row["line"] for row in table if row["used"] == "0"], ["72"])
        kept, _, _ = self.fit(file, "--pupil-mm", 6, "--gradient", "center", "--order", 5, "--keep-spurious")
        self.assertGreater(kept["residual_rms"], 10 * report["residual_rms"])

    def test_heights_as_columns_and_as_a_matrix(self):
        # W = 0.3 Z4 + 0.2 Z8 [µm] over 4 mm: sqrt3 (2 r² − 1) and sqrt8 (3 r³ − 2 r) cos θ.
        def height(x, y):
            r2 = (x * x + y * y) / 4
            return 0.3 * math.sqrt(3) * (2 * r2 - 1) + 0.2 * math.sqrt(8) * (3 * r2 - 2) * x / 2

        grid = [0.25 * i for i in range(-8, 9)]
        columns = self.write("opd.csv", "x_mm,y_mm,opd_nm\n" + "".join(f"{x},{y},{1e3 * height(x, y)!r}\n" for x in grid for y in grid))
        matrix = self.write("matrix.csv", "\n".join(
            ",".join(repr(height(x, y)) if math.hypot(x, y) <= 2 else "" for x in grid) for y in reversed(grid)))
        for file, more in ((columns, ()), (matrix, ("--grid-step-mm", 0.25))):
            report, c, _ = self.fit(file, "--pupil-mm", 4, "--order", 4, *more)
            self.assertEqual(report["measured"], "heights")
            for j in range(15):
                self.assertAlmostEqual(c.get(j, 0), {4: 0.3, 8: 0.2}.get(j, 0), delta=1e-12)

    def test_a_report_is_about_the_eye_that_is_written(self):
        slopes, _, eye = self.fit(REAL, *RIG, "--order", 5)
        mirrored, _, other = self.fit(REAL, *RIG, "--order", 5, "--mirror")
        self.assertNotEqual(eye["wavefront"], other["wavefront"])
        for report, written in ((slopes, eye), (mirrored, other)):
            for mode in report["coefficients"]:
                self.assertEqual(mode["value_um"], written["wavefront"]["coefficients_um"][str(mode["j"])])
        self.assertAlmostEqual(slopes["refraction"]["axis_deg"] + mirrored["refraction"]["axis_deg"], 180, delta=1e-9)
        signs = [a["value_um"] / b["value_um"] for a, b in zip(slopes["coefficients"], mirrored["coefficients"])]
        self.assertIn(-1, signs)
        for i, row in enumerate(slopes["covariance_um2"]):
            for k, value in enumerate(row):
                self.assertEqual(mirrored["covariance_um2"][i][k], signs[i] * signs[k] * value)
        self.assertEqual(slopes["residuals"], mirrored["residuals"])
        oblique = self.write("oblique.json", {"format": "sturm.eye/1", "prescription": {"sphere_D": -1, "cylinder_D": -2, "axis_deg": 30, "vertex_distance_mm": 0},
                                              "pupil_diameter_mm": 6})
        restated, _, _ = self.fit(oblique, "--mirror")
        self.assertAlmostEqual(restated["refraction"]["axis_deg"], 150, delta=1e-9)

    def test_each_result_has_a_file_of_its_own(self):
        before = snapshot(self.folder)
        process = sturm("wavefront", REAL, *RIG, "-o", self.folder / "one.json", "--report", self.folder / "." / "one.json")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertIn("--report", process.stderr)
        self.assertEqual(snapshot(self.folder), before)

    def test_what_else_a_document_says_of_an_eye_is_kept(self):
        others = {"accommodation": {"mode": "fixed", "power_D": 1}, "stiles_crawford_per_mm2": 0.05, "rotation_center_mm": 11}
        given = self.write("given.json", dict(others, format="sturm.eye/1", prescription={"sphere_D": -1}, pupil_diameter_mm=6))
        _, _, eye = self.fit(given)
        self.assertNotIn("prescription", eye)
        self.assertEqual({key: eye[key] for key in others}, others)

    def test_orders_norms_and_sides_of_an_eye(self):
        def restated(wavefront, *options):
            _, c, eye = self.fit(self.write("given.json", {"format": "sturm.eye/1", "wavefront": dict(wavefront, pupil_diameter_mm=6), "pupil_diameter_mm": 6}), *options)
            return {j: value for j, value in c.items() if value}, eye

        cases = [
            ({"coefficients_um": {"8": 0.2}, "order": "noll"}, {8: 0.2}),  # Noll 8 is the cosine coma
            ({"coefficients_um": {"7": 0.2}, "order": "noll"}, {7: 0.2}),
            ({"coefficients_um": {"11": 0.2}, "order": "noll"}, {12: 0.2}),
            ({"coefficients_um": {"9": 0.2}, "order": "fringe"}, {12: 0.2 / math.sqrt(5)}),
            ({"coefficients_um": {"7": 0.2}, "order": "fringe", "normalised": True}, {8: 0.2}),
            ({"coefficients_um": {"4": 0.2}, "normalised": False}, {4: 0.2 / math.sqrt(3)}),
            ({"coefficients_um": [0, 0, 0, 0.2], "order": "noll"}, {4: 0.2}),  # a list starts with number 1
            ({"coefficients_um": {"3": 0.1, "4": 0.2, "8": 0.3}, "eye": "left", "mirror_to": "right"}, {3: -0.1, 4: 0.2, 8: -0.3}),
            ({"coefficients_um": {"8": 0.3}, "eye": "left", "mirror_to": "left"}, {8: 0.3}),
        ]
        for wavefront, expected in cases:
            got, eye = restated(wavefront)
            self.assertEqual(set(got), set(expected), wavefront)
            for j, value in expected.items():
                self.assertAlmostEqual(got[j], value, delta=1e-15)
            self.assertEqual(eye["wavefront"].get("eye"), wavefront.get("mirror_to"))
        got, eye = restated({"coefficients_um": {"8": 0.3}, "eye": "left"}, "--mirror")
        self.assertAlmostEqual(got[8], -0.3, delta=1e-15)
        self.assertEqual(eye["wavefront"]["eye"], "right")
        self.assertNotIn("second_order", eye["wavefront"])
        _, eye = restated({"coefficients_um": {"12": 0.3}, "second_order": "paraxial"})
        self.assertEqual(eye["wavefront"]["second_order"], "paraxial")
        # A smaller pupil: spherical aberration has defocus in its middle; a prescription is a second-order wavefront.
        got, _ = restated({"coefficients_um": {"12": 0.2}}, "--pupil-mm", 3)
        self.assertAlmostEqual(got[12], 0.2 / 16, delta=1e-15)
        self.assertAlmostEqual(got[4], 0.2 * math.sqrt(15) * (1 / 16 - 1 / 4), delta=1e-15)
        myope = self.write("myope.json", {"format": "sturm.eye/1", "prescription": {"sphere_D": -1, "vertex_distance_mm": 0}, "pupil_diameter_mm": 6})
        report, c, _ = self.fit(myope)
        self.assertAlmostEqual(c[4], 1.2990381056766578, delta=1e-12)
        self.assertAlmostEqual(report["refraction"]["M_D"], -1, delta=1e-12)

    def test_random_eyes(self):
        report, first, eye = self.fit("--random", "--seed", 3, "--pupil-mm", 6)
        self.assertEqual(self.fit("--random", "--seed", 3, "--pupil-mm", 6)[1], first)
        self.assertNotEqual(self.fit("--random", "--seed", 4, "--pupil-mm", 6)[1], first)
        self.assertEqual((report["measured"], report["seed"], eye["wavefront"]["eye"]), ("random", 3, "right"))
        left = self.fit("--random", "--seed", 3, "--pupil-mm", 6, "--side", "left")[1]
        self.assertAlmostEqual(left[8], -first[8], delta=1e-12)
        self.assertAlmostEqual(left[7], first[7], delta=1e-12)
        small = self.fit("--random", "--seed", 3, "--pupil-mm", 5)[2]
        self.assertEqual(small["wavefront"]["pupil_diameter_mm"], 5)

    def test_random_left_eyes_are_those_of_the_table(self):
        """The table has left eyes. Mode 10 changes its sign in a mirror, and has the mean -0.0172 um and the deviation 0.0345 um at 6 mm."""
        count, total = 40, 0.0
        for seed in range(count):
            drawn = self.succeed("wavefront", "--random", "--seed", seed, "--pupil-mm", 6, "--side", "left", "-o", self.folder / "eye.json")
            total += strict_json(drawn.stdout)["coefficients"][10]["value_um"]
        self.assertAlmostEqual(total / count, -0.0172, delta=4 * 0.0345 / math.sqrt(count))  # right eyes are 6.3 such errors away

    def test_wrong_input_is_refused(self):
        case = json.loads((REFERENCE / "shwfs.json").read_text())["cases"][0]
        spots = self.point_slopes(case)
        options = ("--pupil-mm", 6, "--gradient", "center")
        self.refuse(spots, "--gradient", "center", says="--pupil-mm")
        self.refuse(spots, "--pupil-mm", 6, says="--lenslet-mm")
        self.refuse(spots, "--pupil-mm", 5, "--gradient", "center", says=["line 2", "--drop-outside"])
        self.assertGreater(self.fit(spots, "--pupil-mm", 5, "--gradient", "center", "--drop-outside", "--order", 3)[0]["samples"]["outside"], 0)
        self.refuse(spots, "--pupil-mm", 9, "--gradient", "center", says="pupil of 9 mm")
        self.refuse(spots, *options, "--order", 16, says="145 spots")
        self.refuse(spots, *options, "--order", "high", says="--order")
        self.refuse(spots, *options, "--eye-pupil-mm", 7, says="--eye-pupil-mm")
        self.refuse(spots, *options, "--wavelength-nm", 5, says="--wavelength-nm")
        self.refuse(spots, *options, "--random", says="--random")
        self.refuse(says="FILE")
        self.refuse(self.folder / "none.csv", *options, says="none.csv")
        self.refuse(REAL, "--pupil-mm", 4, "--lenslet-mm", 0.3, says="--pixel-um")
        self.refuse("--random", "--pupil-mm", 8, says="7.5 mm")
        heading = "x_mm,y_mm,slope_x_rad,slope_y_rad\n"
        tables = {"": "empty", "a,b\n1,2\n": "x_mm", heading: "without a measurement", heading + "0,0,x,1\n": "line 2",
                  heading + "0,,1e-4,1e-4\n": "line 2", heading + "0,0,inf,0\n": "line 2", heading + "".join(f"{0.1 * i},0,0,0\n" for i in range(30)): "tell",
                  "x_mm,y_mm,opd_waves\n0,0,1\n": "--wavelength-nm", "1,2\n3,4\n": "--grid-step-mm"}
        for text, says in tables.items():
            self.refuse(self.write("bad.csv", text), *options, says=says)
        eye = {"format": "sturm.eye/1", "wavefront": {"coefficients_um": {"4": 0.2}, "pupil_diameter_mm": 6}, "pupil_diameter_mm": 6}
        self.refuse(self.write("eye.json", eye), "--pupil-mm", 7, says="measured")
        for change, says in (({"order": "malacara"}, "/wavefront/order"), ({"order": "noll", "coefficients_um": {"0": 1}}, "/wavefront/coefficients_um/0"),
                             ({"order": "fringe", "coefficients_um": {"38": 1}}, "from 1 to 37"), ({"mirror_to": "left"}, "\"eye\""),
                             ({"wavelength_nm": -1}, "/wavefront/wavelength_nm")):
            wrong = dict(eye, wavefront=dict(eye["wavefront"], **change))
            self.refuse(self.write("eye.json", wrong), says=says)


if __name__ == "__main__":
    unittest.main()
