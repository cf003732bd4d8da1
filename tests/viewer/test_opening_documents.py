"""Documents that are opened in the page and saved by it: the command line's readers, measured eyes, links, other people's glasses."""
import json
import math
import re

from opening_page import OpeningTest
from page_in_browser import main
from sturm_process import PASSED, SOURCE, WRONG_INPUT, sturm
from test_page import hash_of

EYE = {"format": "sturm.eye/1", "prescription": {"sphere_D": -2.25, "cylinder_D": -1.5, "axis_deg": 30, "vertex_distance_mm": 12}, "pupil_diameter_mm": 5,
       "accommodation": {"mode": "best", "amplitude_D": 3}, "rotation_center_mm": 14}
# Horizontal coma alone (OSA j = 8), 0.2 um over 6 mm.
COMA = {"format": "sturm.eye/1", "wavefront": {"coefficients_um": {"8": 0.2}, "pupil_diameter_mm": 6, "eye": "left"}, "pupil_diameter_mm": 6}


class Documents(OpeningTest):
    def state(self):
        return self.app("app.state")

    def test_messages_are_the_command_lines(self):
        wrong = (
            {**EYE, "prescription": {"sphere_D": -2, "cilinder_D": 1}}, {**EYE, "pupil_diameter_mm": -4}, {**EYE, "accommodation": {"mode": "fixed"}},
            {**COMA, "pupil_diameter_mm": 7}, {"format": "sturm.spectacles/1", "single_vision": {"refractive_index": 0.5}}, "{\"format\": ")
        for document in wrong:
            path = self.write("wrong.json", document)
            process = sturm("validate", path, cwd=self.folder)
            self.assertEqual(process.returncode, WRONG_INPUT)
            said = self.open(path)
            self.assertTrue(self.is_problem())
            self.assertEqual(said, re.sub(r"^error: \S*wrong\.json", "wrong.json", process.stderr.strip().splitlines()[0]))
        self.assertIn("wrong.json: /format", self.open(self.write("wrong.json", {"format": "sturm.psf/1"})))

    def test_an_eye(self):
        self.assertEqual(self.open(self.write("eye.json", EYE)), "The right eye is that of eye.json.")
        eye = self.state()["eyes"]["right"]
        self.assertEqual((eye["sphere_D"], eye["cylinder_D"], eye["axis_deg"], eye["vertex_mm"], eye["pupil_mm"], eye["accommodation"], eye["amplitude_D"]),
                         (-2.25, -1.5, 30, 12, 5, "best", 3))
        self.assertEqual(self.saved()["eye"]["rotation_center_mm"], 14)

    def test_a_measured_eye_is_traced_by_its_wavefront(self):
        self.assertEqual(self.open(self.write("coma.json", COMA)), "The left eye is that of coma.json, traced by its wavefront.")
        state = self.state()
        self.assertEqual((state["side"], state["rayModel"], state["modes"], state["eyes"]["left"]["pupil_mm"]), ("left", "zernike", ["path"], 6))
        rows = self.measured("slopes(200)")
        # W = 0.2 um sqrt(8) (3 r^3 - 2 r) cos t over 3 mm, and the examiner's x is the wearer's -x.
        scale, radius = 0.2e-6 * math.sqrt(8), 3e-3
        for k in range(0, len(rows), 6):
            x, y = -rows[k] / radius, rows[k + 1] / radius
            by_x, by_y = scale / radius * (9 * x * x + 3 * y * y - 2), scale / radius * 6 * x * y
            for seen, right in ((rows[k + 2], by_x), (rows[k + 3], -by_y)):
                self.assertAlmostEqual(seen, right, delta=2e-6 * 7 * scale / radius)  # single precision, as in test_ray_models.py
        # What is saved is the same wavefront, and the program draws it.
        saved = self.saved()
        self.assertEqual(saved["method"]["ray_model"], "zernike")
        self.assertEqual([round(c, 12) for c in saved["eye"]["wavefront"]["coefficients_um"]], [0] * 8 + [0.2])
        saved["method"]["samples_per_pixel"] = 1
        self.rendered(saved, "coma_render")
        # A link holds it.
        link = hash_of(state)
        self.browser.run("const { app } = window.sturmViewer; app.show(...window.first); app.held = true; location.hash = arguments[0]", link)
        self.wait("window.sturmViewer.app.state.eyes.left.wavefront")
        self.assertEqual(self.state(), state)
        self.browser.run("history.replaceState(null, '', location.pathname)")

    def test_measured_eyes_of_the_list(self):
        measured = json.loads((SOURCE / "configs/eyes/jaeken_4_left.json").read_text())
        self.browser.run("""const list = [...document.querySelectorAll('select')].find((s) => s.querySelector('[value="jaeken_4_left.json"]'));
          list.value = 'jaeken_4_left.json'; list.dispatchEvent(new Event('change'))""")
        self.wait("window.sturmViewer.app.state.eyes.left.wavefront")
        coefficients = self.state()["eyes"]["left"]["wavefront"]["coefficients_m"]
        self.assertEqual({j: round(1e6 * c, 9) for j, c in enumerate(coefficients) if c}, {int(j): c for j, c in measured["wavefront"]["coefficients_um"].items()})
        self.browser.run("const { app } = window.sturmViewer; app.held = false")
        self.wait("""[...document.querySelectorAll('select')].find((s) => s.querySelector('[value="jaeken_4_left.json"]')).value === 'jaeken_4_left.json'""")

    def test_spectacles_and_the_wrong_glasses(self):
        lens = {"format": "sturm.spectacles/1", "single_vision": {"prescription": {"sphere_D": 2, "cylinder_D": -1, "axis_deg": 60}, "center_thickness_mm": 4, "refractive_index": 1.5, "vertex_distance_mm": 14}}
        self.open(self.write("eye.json", EYE))
        self.assertEqual(self.open(self.write("lens.json", lens)), "The right eye wears the spectacles of lens.json.")
        saved = self.saved()
        self.assertEqual(saved["spectacles"]["single_vision"]["prescription"]["sphere_D"], 2)
        self.assert_numbers_are_the_programs(saved)
        # The link cannot hold them.
        state = self.state()
        self.browser.run("const { app } = window.sturmViewer; app.show(...window.first); location.hash = arguments[0]", hash_of(state))
        self.wait("/wears spectacles of a file/.test(document.getElementById('message').textContent)")
        self.browser.run("history.replaceState(null, '', location.pathname)")
        # By the controls, on either eye.
        for side in ("right", "left"):
            with self.subTest(side=side):
                self.change(f"s.side = '{side}'; Object.assign(s.eyes.{side}, {{sphere_D: -3, cylinder_D: -0.75, axis_deg: 20, vertex_mm: 12}}); "
                            f"Object.assign(s.glasses.{side}, {{kind: 'single', fitted: false, sphere_D: 1.5, cylinder_D: -2, axis_deg: 110}});")
                self.assert_numbers_are_the_programs(self.saved())

    def assert_numbers_are_the_programs(self, saved):
        """What the core answers for the state is what `sturm ellipse` says of the saved eye and spectacles."""
        query = {"format": "sturm.ellipse/1", "eye": saved["eye"], "spectacles": saved["spectacles"], "targets": [{"gaze_deg": [10, -15], "distance_m": 0.8}], "methods": ["conoid"]}
        process = sturm("ellipse", self.write("query.json", query))
        self.assertEqual(process.returncode, PASSED, process.stderr)
        right = json.loads(process.stdout)["results"][0]
        self.assertTrue(self.browser.run("return window.sturmViewer.app.prepare()"))
        seen = self.app(f"app.eye.optics.ellipse({math.radians(10)}, {math.radians(-15)}, 0.8)")
        for a, b in zip((*seen["semi_axes_rad"], seen["orientation_deg"]), (*right["semi_axes_rad"], right["orientation_deg"])):
            self.assertAlmostEqual(a / b, 1, delta=1e-11)  # lengths in the document have 12 digits

    def test_a_saved_view_is_opened_again(self):
        self.change("s.camera.position_m = [0.1, 0.2, 0.3]; s.camera.turn_deg = 20; s.camera.tilt_deg = -5; s.eyes.right.sphere_D = -1.25; s.modes = ['gather']; s.passes = 16; s.glasses.right.kind = 'single';")
        saved = self.saved()
        path = self.write("again.json", saved)
        self.browser.run("const { app } = window.sturmViewer; app.show(...window.first)")
        self.assertEqual(self.open(path), "This is the view again.json.")
        again = self.saved()
        for key in ("position_m", "look_at_m"):
            for a, b in zip(again["camera"].pop(key), saved["camera"].pop(key)):
                self.assertAlmostEqual(a, b, delta=1e-12)
        self.assertEqual(again["camera"].pop("vfov_deg"), self.approximately(saved["camera"].pop("vfov_deg")))
        for key in ("eye", "camera", "method", "scene", "seed"):
            self.assertEqual(again[key], saved[key], key)
        other = {**saved, "scene": "elsewhere.obj", "camera": {**saved["camera"], "position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 30}}
        self.assertIn("Its scene is not in this page", self.open(self.write("other.json", other)))

    @staticmethod
    def approximately(value):
        return type("Near", (float,), {"__eq__": lambda self, other: abs(float(self) - other) < 1e-9, "__hash__": float.__hash__})(value)

    def test_prescriptions_as_text(self):
        self.open(self.write("rx.txt", "OD -2.00 -1.50 x 30\nOS +1.25 -0.50 x 100 add 2.00\n"))
        state = self.state()
        self.assertEqual([(state["eyes"][s]["sphere_D"], state["eyes"][s]["axis_deg"]) for s in ("right", "left")], [(-2, 30), (1.25, 100)])
        self.assertEqual(state["glasses"]["left"]["addition_D"], 2)
        self.assertIn("rx.txt: ", self.open(self.write("rx.txt", "-2.00 -1.50 x 300")))

    def test_saving_names_the_files_that_the_document_needs(self):
        self.open(self.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"))
        self.browser.run("window.sturmViewer.app.saveView()")
        self.assertEqual(self.message(), "view.json is saved. It names one.obj and is rendered where these names lead to the files.")
        saved = self.saved()
        saved["camera"]["resolution"] = [16, 16]
        self.assertGreater(sum(self.rendered(saved, "one")), 0)

    def test_keys_move_the_head(self):
        self.browser.run("const { app } = window.sturmViewer; app.change((s) => { s.camera.turn_deg = 90; s.camera.tilt_deg = 0; s.camera.position_m = [0, 0, 0]; })")
        self.browser.type("#picture", "w\ue013\ue012")  # ahead is +x; up; left
        camera = self.state()["camera"]
        for a, b in zip((*camera["position_m"], camera["turn_deg"], camera["tilt_deg"]), (0.1, 0, 0, 88, 2)):
            self.assertAlmostEqual(a, b, delta=1e-9)


if __name__ == "__main__":
    main()
