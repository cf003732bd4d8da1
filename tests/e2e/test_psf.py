"""`sturm psf`: point spreads of eyes by rays and waves against other programs' numbers; pictures; what is refused."""
import csv
import io
import json
import math
import unittest

from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, strict_json, sturm

REFERENCE = SOURCE / "tests/reference"


def hofer(subject):
    for line in (SOURCE / "configs/data/hofer_9_subjects_6mm.csv").read_text().splitlines():
        if line.startswith(f"{subject},"):
            return [float(c) for c in line.split(",")[1:]]
    raise KeyError(subject)


def eye(coefficients, measured_mm, pupil_mm, rho=0):
    return {"wavefront": {"coefficients_um": coefficients, "pupil_diameter_mm": measured_mm}, "pupil_diameter_mm": pupil_mm, "stiles_crawford_per_mm2": rho}


def document(an_eye, **more):
    return dict({"format": "sturm.psf/1", "eye": an_eye, "lights": [{"wavelength_nm": 555}], "models": ["waves"], "frame": "examiner"}, **more)


class Psf(FolderTest):
    def result(self, spec, *options):
        return strict_json(self.succeed("psf", self.write("psf.json", spec), *options).stdout)

    def refuse(self, spec, says, *options):
        file = self.write("psf.json", spec)
        before = snapshot(self.folder)
        process = sturm("psf", file, "-o", self.folder / "no.json", "--images", self.folder / "no.exr", *options)
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
        self.assertIn(says, process.stderr)
        self.assertEqual(snapshot(self.folder), before)

    def test_waves_at_550_nm(self):
        for case in json.loads((REFERENCE / "wave_psf.json").read_text())["cases"][::4]:
            inputs, outputs = case["inputs"], case["outputs"]
            [got] = self.result(document(eye(inputs["zernike_osa_um"] or {"0": 0}, inputs["pupil_mm"], inputs["pupil_mm"]), lights=[{"wavelength_nm": 550}],
                                         in_focus_nm=550, mtf={"frequencies_cpd": [3, 6, 12, 18, 24, 30]}))["results"]
            self.assertAlmostEqual(got["strehl"], outputs["strehl"], delta=1e-3)
            for row, name in zip(got["mtf"], ("x", "diag45", "y", "diag135")):
                for value, wanted in zip(row, outputs["mtf"][name]):
                    self.assertAlmostEqual(value, wanted, delta=1e-3)
            for entry, key in zip(got["energy"], ("r50_arcmin", "r80_arcmin")):
                self.assertAlmostEqual(entry["radius_about_chief_ray_arcmin"] / outputs["ee_radius_arcmin"][key], 1, delta=0.01)

    def test_a_real_eye_through_focus_in_both_lights(self):
        cases = [c for c in json.loads((REFERENCE / "wavefronts/focus.json").read_text())["cases"]
                 if c["inputs"]["subject"] == 3 and c["inputs"]["pupil_mm"] == 3 and c["inputs"]["defocus_V_D"] in (0, 1)]
        for rho, pupil in ((0, "uniform"), (0.05, "stiles_crawford")):
            results = self.result(document(eye(hofer(3), 6, 3, rho), defocus_D=[c["inputs"]["defocus_V_D"] for c in cases],
                                           lights=[{"id": "mono", "wavelength_nm": 555}, {"id": "poly", "spectrum": "luminance"}]))["results"]
            self.assertEqual(len(results), 2 * len(cases))
            for got in results:
                expected = cases[got["target"]]["outputs"][f"{got['light']}_{pupil}"]
                self.assertAlmostEqual(got["strehl"], expected["strehl_origin"], delta=5e-4)
                for row, wanted in zip(got["mtf"], expected["mtf_dir_by_cpd"]):
                    for a, b in zip(row, wanted):
                        self.assertAlmostEqual(a, b, delta=5e-4)
                for entry, key in zip(got["energy"], ("ee50_radius_arcmin", "ee80_radius_arcmin")):
                    self.assertAlmostEqual(entry["radius_about_chief_ray_arcmin"] / expected[key], 1, delta=0.005)
                self.assertGreaterEqual(got["strehl_peak"], got["strehl"] - 1e-12)
                self.assertTrue(0 < got["visual_strehl"] < 1)

    def test_rays_and_their_distance_from_waves(self):
        case = next(c for c in json.loads((REFERENCE / "wavefronts/rays_vs_waves.json").read_text())["cases"] if c["id"] == "hofer3_3mm_1D")
        expected = case["outputs"]
        result = self.result(document(eye(hofer(3), 6, 3), models=["rays", "waves"], defocus_D=[1],
                                      lights=[{"wavelength_nm": 555}, {"spectrum": "luminance", "step_nm": 20}]))
        rays = result["results"][0]
        self.assertEqual(rays["model"], "rays")
        xx, xy, yy = expected["ray_covariance_arcmin2"]
        for got, wanted in zip(rays["covariance_arcmin2"], (xx, xy, yy)):
            self.assertAlmostEqual(got, wanted, delta=5e-6 * (xx + yy))
        for entry, key in zip(rays["energy"], ("ray_ee50_arcmin", "ray_ee80_arcmin")):
            self.assertAlmostEqual(entry["radius_about_chief_ray_arcmin"] / expected[key], 1, delta=0.01)
        for comparison, pair in zip(result["comparisons"], ("rays_wave555", "rayspoly_wavepoly")):
            for entry, cell in zip(comparison["total_variation"], ("0.5", "1", "2")):
                self.assertAlmostEqual(entry["value"], expected[f"tv_{pair}_cell{cell}"], delta=0.005)

    def test_frames_mirror(self):
        spec = document(eye({"8": 0.3, "3": 0.2}, 4, 4), models=["rays"], energy_shares=[])
        [examiner] = self.result(spec)["results"]
        [wearer] = self.result(dict(spec, frame="wearer"))["results"]
        self.assertAlmostEqual(examiner["centroid_arcmin"][0], -wearer["centroid_arcmin"][0], delta=1e-9)
        self.assertNotAlmostEqual(examiner["centroid_arcmin"][0], 0, delta=0.1)
        self.assertAlmostEqual(examiner["covariance_arcmin2"][1], -wearer["covariance_arcmin2"][1], delta=1e-9)
        for k in range(4):  # 45° and 135° change places
            self.assertAlmostEqual(examiner["mtf"][1][k], wearer["mtf"][3][k], delta=1e-3)

    def test_distances_and_prescriptions(self):
        myope = {"prescription": {"sphere_D": -2, "vertex_distance_mm": 0}, "pupil_diameter_mm": 4}
        spec = {"format": "sturm.psf/1", "eye": myope, "models": ["rays"], "distances_m": ["inf", 0.5, 0.25]}
        far, focus, near = self.result(spec)["results"]
        self.assertEqual((far["distance_m"], focus["distance_m"]), ("inf", 0.5))
        # Variance of a disc of radius a·ΔV: a² ΔV²/4 along each axis.
        blur = (2e-3 * 2 * 60 * 180 / math.pi) ** 2 / 4
        self.assertAlmostEqual(far["covariance_arcmin2"][0], blur, delta=1e-9 * blur)
        self.assertAlmostEqual(focus["covariance_arcmin2"][0], 0, delta=1e-12)
        self.assertAlmostEqual(near["covariance_arcmin2"][2], blur, delta=1e-9 * blur)
        accommodating = dict(myope, accommodation={"mode": "best", "amplitude_D": 3})
        near = self.result(dict(spec, eye=accommodating))["results"][2]
        self.assertAlmostEqual(near["accommodation_D"], 2, delta=1e-12)
        self.assertAlmostEqual(near["covariance_arcmin2"][0], 0, delta=1e-12)

    def test_the_wavelength_that_a_wavefront_is_stated_for(self):
        infrared = eye({"4": 0.0}, 6, 3)
        infrared["wavefront"]["wavelength_nm"] = 840
        spec = {"format": "sturm.psf/1", "eye": infrared, "models": ["waves"], "lights": [{"wavelength_nm": 555}]}
        shift = 633.46 * (1 / (840 - 214.102) - 1 / (555 - 214.102))
        [blurred] = self.result(spec)["results"]
        self.assertLess(blurred["strehl"], 0.1)
        [sharp] = self.result(dict(spec, defocus_D=[-shift]))["results"]
        self.assertAlmostEqual(sharp["strehl"], 1, delta=1e-9)

    def test_pictures(self):
        exr = self.folder / "psf.exr"
        spec = document(eye({"8": 0.4}, 4, 4), models=["rays", "waves"], defocus_D=[0, 1], picture={"size_px": 64})
        self.result(spec, "--images", exr)
        self.assertTrue(exr.read_bytes().startswith(b"\x76\x2f\x31\x01"))
        header = exr.with_suffix(".png").read_bytes()[:24]
        self.assertTrue(header.startswith(b"\x89PNG"))
        self.assertEqual(int.from_bytes(header[16:20], "big"), 2 * 65 + 2)  # two targets beside each other
        self.assertEqual(int.from_bytes(header[20:24], "big"), 2 * 65 + 2)

    def test_tables_have_the_numbers_of_the_result(self):
        line = ["psf", "--rx", "-1.00 -0.50 x 30", "--pupil", 3, "--distance", "1,inf"]
        results = strict_json(self.succeed(*line, "--json").stdout)["results"]
        header, *table = self.succeed(*line).stdout.splitlines()
        self.assertEqual(header.split("  ")[0], "distance [m]")
        rows = list(csv.DictReader(io.StringIO(self.succeed(*line, "--csv").stdout)))
        self.assertEqual((len(table), len(rows)), (len(results), len(results)))
        for shown, row, result in zip(table, rows, results):
            cells = shown.split()
            self.assertEqual(cells[:4], [str(result["distance_m"]).removesuffix(".0"), f"{result['defocus_D']:+.2f}", result["light"], result["model"]])
            waves = result["model"] == "waves"
            self.assertEqual(cells[4:6], [f"{result[key]:.4f}" if waves else "–" for key in ("strehl", "visual_strehl")])
            self.assertEqual(cells[6:8], [f"{entry['radius_about_chief_ray_arcmin']:.2f}" for entry in result["energy"]])
            for i, frequency in enumerate((5, 10, 20, 30)):
                mean = sum(direction[i] for direction in result["mtf"]) / 4
                self.assertAlmostEqual(float(cells[8 + i]), mean, delta=5.1e-4)  # three decimals
                self.assertAlmostEqual(float(row[f"mtf_{frequency}cpd"]), mean, delta=1e-12)
                for direction, angle in zip(result["mtf"], (0, 45, 90, 135)):
                    self.assertEqual(float(row[f"mtf_{frequency}cpd_{angle}deg"]), direction[i])
            self.assertEqual(float(row["distance_m"]), float(result["distance_m"]))
            self.assertEqual([row[key] == "" for key in ("strehl", "strehl_peak", "visual_strehl")], [not waves] * 3)
            self.assertEqual(float(row["radius_0.8_arcmin"]), result["energy"][1]["radius_about_chief_ray_arcmin"])

    def test_endings_choose_the_table(self):
        line = ["psf", "--rx", "-1", "--pupil", 3, "--set", '/models=["rays"]', "--set", "/rays/count=1024"]
        for name, option in (("a.txt", "--table"), ("a.csv", "--csv"), ("a.json", "--json")):
            self.succeed(*line, "-o", self.folder / name)
            self.assertEqual((self.folder / name).read_text(), self.succeed(*line, option).stdout)  # both with plain line ends

    def test_wrong_input_is_refused(self):
        good = document(eye({"4": 0.1}, 4, 4))
        without = {key: value for key, value in good.items() if key != "lights"}
        self.refuse(without, "lights")
        for change, says in (({"lights": []}, "/lights"), ({"lights": [{}]}, "/lights/0"), ({"lights": [{"wavelength_nm": 0}]}, "/lights/0/wavelength_nm"),
                             ({"lights": [{"wavelengths_nm": [500, 600], "weights": [1]}]}, "/lights/0/weights"),
                             ({"lights": [{"wavelength_nm": 555}, {"wavelength_nm": 555}]}, "/lights/1"),
                             ({"pupil_diameter_mm": 5}, "pupil_diameter_mm"), ({"defocus_D": [1], "distances_m": [1]}, "/defocus_D"),
                             ({"distances_m": [0]}, "/distances_m/0"), ({"waves": {"grid": 128}, "defocus_D": [3]}, "/waves/grid"),
                             ({"defocus_D": [90]}, "alias"), ({"models": ["beams"]}, "/models/0"), ({"eye": {"wavefront": good["eye"]["wavefront"]}}, "/eye"),
                             ({"eye": dict(good["eye"], pupil_diameter_mm=0)}, "pinhole")):
            self.refuse(dict(good, **change), says)
        self.refuse(good, "--images", "--images", self.folder / "no.png")


if __name__ == "__main__":
    unittest.main()
