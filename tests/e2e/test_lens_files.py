"""Lens files of the trade, written here, through `sturm lens`: powers by the lensmaker's equation for a thick lens."""
import json
import unittest

from sturm_process import PASSED, WRONG_INPUT, FolderTest, strict_json, sturm

STRAIGHT = ("--azimuth-deg", "0", "--elevation-deg", "0")


def back_vertex_power(front_D, back_D, thickness_mm, index):
    return back_D + front_D / (1 - thickness_mm * 1e-3 / index * front_D)


def zmx(front_mm, back, thickness_mm, glass="___BLANK 1 0 1.6 41 0 0 0 0 0 0"):
    return "\r\n".join(["VERS 190513", "MODE SEQ", "UNIT MM X W X CM MR CPMM", "SURF 0", "  TYPE STANDARD", "  CURV 0", "  DISZ INFINITY", "SURF 1", "  STOP",
                        "  TYPE STANDARD", f"  CURV {1 / front_mm!r} 0 0 0 0", f"  GLAS {glass}", f"  DISZ {thickness_mm}", "  DIAM 30 1 0 0 1 \"\"", "SURF 2",
                        *back, "  DISZ 12", "  DIAM 32 1 0 0 1 \"\"", "SURF 3", "  TYPE STANDARD", "  CURV 0", "  DISZ 0", ""])


class LensFiles(FolderTest):
    def report(self, path, *options):
        process = sturm("lens", path, *STRAIGHT, *options)
        self.assertEqual(process.returncode, PASSED, process.stderr)
        return strict_json(process.stdout), process.stderr

    def test_a_zemax_file(self):
        text = zmx(120, ["  TYPE TOROIDAL", f"  CURV {1 / 90!r}", "  PARM 1 75"], 2.5)
        across, along = (back_vertex_power(600 / 120, -600 / radius, 2.5, 1.6) for radius in (75, 90))
        for name, data in (("a.zmx", text.encode()), ("b.ZMX", text.encode("utf-16"))):
            report, notes = self.report(self.write(name, data))
            self.assertEqual(notes, "")
            xx, xy, yy = report["back_vertex"]["matrix_D"]
            self.assertAlmostEqual(xx, across, delta=1e-9)  # x is horizontal: the radius of the rotation
            self.assertAlmostEqual(xy, 0, delta=1e-9)
            self.assertAlmostEqual(yy, along, delta=1e-9)
            self.assertEqual(report["diameter_mm"], 60)
        tilted = text.replace("SURF 1\r\n", "SURF 7\r\n  TYPE COORDBRK\r\n  PARM 3 10\r\n  DISZ 0\r\nSURF 1\r\n").replace("  DIAM", "  MEMA")
        report, notes = self.report(self.write("tilted.zmx", tilted))
        self.assertIn("coordinate break of surface 7 does not count", notes)
        self.assertIn("no DIAM; the diameter is taken as 70 mm", notes)
        self.assertAlmostEqual(report["back_vertex"]["matrix_D"][0], across, delta=1e-9)
        named = {"format": "sturm.spectacles/1", "lens_file": {"file": "a.zmx", "diameter_mm": 50, "vertex_distance_mm": 14, "material": "MR-8"}}
        report, _ = self.report(self.write("lens.json", named))
        self.assertEqual((report["diameter_mm"], report["vertex_distance_mm"], report["material"]["name"]), (50, 14, "MR-8"))

    def test_a_job(self):
        job = "JOB=1\r\nDO=B\r\nSPH=-2.00;+1.25\r\nCYL=-1.50;0\r\nAX=30;?\r\nPRVM=0;1.5\r\nPRVA=?;90\r\nLIND=1.6\r\nCTHICK=2;3\r\nFRNT=4;6\r\nDIA=60\r\n"
        path = self.write("job.oma", job)
        right, _ = self.report(path, "--set", "/lens_file/eye=right")
        power = right["back_vertex"]
        self.assertAlmostEqual(power["sphere_D"], -2, delta=1e-9)
        self.assertAlmostEqual(power["cylinder_D"], -1.5, delta=1e-9)
        self.assertAlmostEqual(power["axis_deg"], 30, delta=1e-9)
        self.assertAlmostEqual(right["front"]["sphere_D"], 0.6 * 4 / 0.53, delta=1e-12)  # a curve for the tooling index
        left, _ = self.report(path, "--set", "/lens_file/eye=left")
        prism = left["gazes"][0]["prism"]
        self.assertAlmostEqual(prism["prism_cm_per_m"], 1.5, delta=1e-9)
        self.assertAlmostEqual(prism["base_deg"], 90, delta=1e-6)
        process = sturm("lens", path)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn('"eye"', process.stderr)
        one_eye, _ = self.report(self.write("one.oma", "DO=R;\r\n" + job.replace("DO=B\r\n", "")))
        self.assertEqual(one_eye["back_vertex"], power)
        # Surfaces alone, one eye.
        surfaces = self.write("one.vca", "do=L\nfrnt=;5.00\nback=;7.00\nlind=;1.67\ncthick=;1.8\nLMATID=;7\n")
        report, notes = self.report(surfaces)
        expected = back_vertex_power(0.67 * 5 / 0.53, -0.67 * 7 / 0.53, 1.8, 1.67)
        self.assertAlmostEqual(report["back_vertex"]["sphere_D"], expected, delta=1e-9)
        self.assertIn("LMATID", notes)
        self.assertIn("no DIA; the diameter is taken as 70 mm", notes)
        self.assertEqual(report["diameter_mm"], 70)

    def test_heights_on_a_grid_that_is_not_square(self):
        """x^2/2/100 + y^2/2/80 at nodes 3 mm apart along x and 4 mm along y, from the top left one on; a thickness of the document."""
        columns, rows = 23, 17
        heights = [((3 * (i % columns - 11)) ** 2 / 200 + (4 * (i // columns - 8)) ** 2 / 160) for i in range(columns * rows)]
        back = ["  TYPE GRID_SAG", "  CURV 0", f"  GDAT {columns} {rows} 3 4", *(f"  GARR {i + 1} {height!r} 0 0 0" for i, height in enumerate(heights))]
        self.write("grid.zmx", zmx(120, back, 2.5))
        named = {"format": "sturm.spectacles/1", "lens_file": {"file": "grid.zmx", "center_thickness_mm": 4}}
        for document, thickness in (("grid.zmx", 2.5), (self.write("lens.json", named), 4)):
            report, _ = self.report(self.folder / document)
            xx, xy, yy = report["back_vertex"]["matrix_D"]
            self.assertAlmostEqual(xx, back_vertex_power(5, -6, thickness, 1.6), delta=1e-6)  # splines hold parabolas but for rounding
            self.assertAlmostEqual(xy, 0, delta=1e-6)
            self.assertAlmostEqual(yy, back_vertex_power(5, -7.5, thickness, 1.6), delta=1e-6)

    def test_jobs_and_configurations_are_not_mixed(self):
        job = "JOB=1\nDO=R\nSPH=-2\nCYL=0\nLIND=1.6\nCTHICK=2\nFRNT=4\nDIA=60\n"
        for name, text, options, word in (("two.oma", job + job.replace("JOB=1", "JOB=2").replace("-2", "-3"), (), "a second job, 2"),
                                          ("one.oma", job, ("--set", "/lens_file/eye=left"), "other eye")):
            process = sturm("lens", self.write(name, text), *STRAIGHT, *options)
            self.assertEqual(process.returncode, WRONG_INPUT, process.stdout)
            self.assertIn(word, process.stderr)
        report, notes = self.report(self.write("again.oma", job + job), "--set", "/lens_file/eye=right")
        self.assertAlmostEqual(report["back_vertex"]["sphere_D"], -2, delta=1e-9)
        self.assertIn("several records SPH", notes)
        several = zmx(120, ["  TYPE STANDARD", f"  CURV {1 / 80!r}"], "2,5") + "MNUM 2 1\nTHIC   1   0   2.5   0\nTHIC   1   0   9   0\n"  # a decimal comma
        report, notes = self.report(self.write("several.zmx", several))
        self.assertIn("2 configurations", notes)
        self.assertAlmostEqual(report["back_vertex"]["sphere_D"], back_vertex_power(600 / 120, -600 / 80, 2.5, 1.6), delta=1e-9)
        inches = zmx(120 / 25.4, ["  TYPE STANDARD", f"  CURV {25.4 / 80!r}"], 2.5 / 25.4).replace("UNIT MM", "UNIT IN").replace("DIAM 30", "DIAM 1.2").replace("DIAM 32", "DIAM 1.25")
        report, _ = self.report(self.write("inches.zmx", inches))
        self.assertAlmostEqual(report["back_vertex"]["sphere_D"], back_vertex_power(600 / 120, -600 / 80, 2.5, 1.6), delta=1e-9)
        self.assertAlmostEqual(report["diameter_mm"], 2 * 1.2 * 25.4, delta=1e-9)
        process = sturm("lens", self.write("mirror.zmx", zmx(120, ["  TYPE STANDARD", "  CURV 0", "  GLAS MIRROR 0 0"], 2.5)), *STRAIGHT)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("mirror", process.stderr)

    def test_an_eye_wears_a_file(self):
        self.write("lens.zmx", zmx(120, ["  TYPE STANDARD", f"  CURV {1 / 80!r}"], 2.5))
        query = {"format": "sturm.ellipse/1", "eye": {"prescription": "-2.25 DS", "pupil_diameter_mm": 4}, "spectacles": "lens.zmx",
                 "targets": [{"distance_m": 1}], "methods": ["conoid"]}
        process = sturm("ellipse", self.write("query.json", query))
        self.assertEqual(process.returncode, PASSED, process.stderr)
        query["spectacles"] = {"vertex_distance_mm": 12, "center_thickness_mm": 2.5, "refractive_index": 1.6, "diameter_mm": 60,
                               "front": {"type": "sphere", "radius_mm": 120}, "back": {"type": "sphere", "radius_mm": 80}}
        same = sturm("ellipse", self.write("query.json", query))
        a, b = (strict_json(p.stdout)["results"][0]["covariance_rad2"] for p in (process, same))
        for x, y in zip(a, b):
            self.assertAlmostEqual(x, y, delta=1e-18)

    def test_what_is_no_lens_is_refused(self):
        for name, text, word in (("a.zmx", "hello", "no SURF"), ("a.oma", "hello", "no records"), ("b.zmx", b"\x00" * 1000, "no SURF"), ("c.vca", b"\xff\xfe", "no records"),
                                 ("d.zmx", zmx(120, ["  TYPE EVENASPH", "  CURV 0.01", "  PARM 2 1e-6"], 2), "higher terms"),
                                 ("e.zmx", zmx(120, ["  TYPE STANDARD", "  CURV 0.01"], 2, "UNOBTAINIUM 0 0"), "UNOBTAINIUM")):
            process = sturm("lens", self.write(name, text))
            self.assertEqual(process.returncode, WRONG_INPUT, name)
            self.assertIn(word, process.stderr)
            self.assertIn(name, process.stderr)
        self.assertEqual(sturm("lens", self.folder / "missing.zmx").returncode, WRONG_INPUT)


if __name__ == "__main__":
    unittest.main()
