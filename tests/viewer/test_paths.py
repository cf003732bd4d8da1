"""What the traced pictures do beside one perspective picture: the whole sphere, the filter against noise, pictures that grow and begin anew."""
from page_in_browser import PageTest, main
from picture_measures import rmse
from sturm_process import CORNELL_BOX

CAMERA = {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0.0]}
EYE = {"prescription": {"sphere_D": -3, "cylinder_D": -2, "axis_deg": 55, "vertex_distance_mm": 12}, "pupil_diameter_mm": 6, "accommodation": {"mode": "relaxed"}}


def view_of(camera, samples, **more):
    return {"format": "sturm.render/1", "scene": str(CORNELL_BOX), "camera": {**CAMERA, **camera}, "eye": EYE,
            "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": samples, "max_bounces": 4}, "seed": 2, **more}


def displayed(pixels):
    return [min(max(v, 0.0), 1.0) for v in pixels]


class Paths(PageTest):
    def test_the_whole_sphere(self):
        # The eye stands within the box, so that there is something in every direction.
        size = {"position_m": [0.2, 0.3, 0.1], "look_at_m": [0.35, 0.25, 0.4], "resolution": [48, 24]}
        self.page_of(view_of({**size, "vfov_deg": 50}, 64))
        self.change("s.modes = ['sphere'];")
        page = displayed(self.measured("picture('sphere', 24)"))
        sphere = {**size, "projection": "equirectangular"}
        program, again = (displayed(self.rendered(view_of(sphere, 64, seed=seed))) for seed in (2, 3))
        saved = self.browser.run("return JSON.parse(window.sturmViewer.measured.document()).camera")
        self.assertEqual((saved["projection"], "vfov_deg" in saved), ("equirectangular", False))
        # Noise of 24 paths against that of 64 twice over; a sphere that is turned or mirrored is apart by 0.1 and more.
        self.assertLess(rmse(page, program), 2.5 * rmse(program, again) + 0.01)
        mirrored = [program[3 * (y * 48 + 47 - x) + c] for y in range(24) for x in range(48) for c in range(3)]
        self.assertGreater(rmse(page, mirrored), 3 * rmse(page, program))

    def test_the_filter_takes_noise_and_leaves_the_picture(self):
        view = view_of({"vfov_deg": 39.3, "resolution": [48, 48]}, 512)
        self.page_of(view)
        program = displayed(self.rendered(view))
        few, filtered, many, many_filtered = (displayed(self.measured(f"picture('path', {n}, {f})")) for n in (4, 64) for f in ("false", "true"))
        # Below the lamp: its rim is noise of where rays go, which is no noise of light.
        below = 3 * 48 * 10
        errors = [rmse(picture[below:], program[below:]) for picture in (few, filtered, many, many_filtered)]
        print("RMSE of 4 paths, filtered, of 64, filtered: " + ", ".join(f"{e:.4f}" for e in errors))
        self.assertLess(errors[1], 0.6 * errors[0])
        # With more paths there is less to take, and nothing is lost that was there.
        self.assertLess(errors[3], 1.05 * errors[2])

    def test_pictures_grow_and_begin_anew(self):
        self.page_of(view_of({"vfov_deg": 39.3, "resolution": [32, 32]}, 4))
        self.change("s.modes = ['path', 'gather']; s.passes = 4;")
        passes = "window.sturmViewer.app.panels.map((p) => p.passes)"
        self.wait("window.sturmViewer.app.panels.length === 2 && window.sturmViewer.app.panels.every((p) => p.passes > 8)")
        # Change the eye, and look before the next frame has drawn.
        restarted = self.browser.run(f"const {{app}} = window.sturmViewer, before = {passes}; app.held = true; app.change((s) => {{ s.eyes.right.sphere_D = 1; }}); app.prepare(); return [before, {passes}];")
        self.assertGreater(min(restarted[0]), 8)
        self.assertEqual(restarted[1], [0, 0])
        self.browser.run("window.sturmViewer.app.held = false")
        self.wait("window.sturmViewer.app.panels.every((p) => p.passes > 8)")
        # What is laid over pictures, and how brightly they are shown, leaves them as they are.
        kept, darker = self.browser.run(f"""const {{app}} = window.sturmViewer, {{gpu: {{gl}}, canvas}} = app, before = {passes}, pixels = new Uint8Array(4 * canvas.width * canvas.height);
          const light = () => {{
            gl.bindFramebuffer(gl.FRAMEBUFFER, null);
            gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
            return pixels.reduce((sum, x, k) => (k % 4 < 3 ? sum + x : sum), 0);
          }};
          app.held = true;
          const first = light();
          app.change((s) => {{ s.exposure = 0.25; s.fieldOverlay = s.rimOverlay = s.lensMap = true; }});
          app.prepare();
          return [[before, {passes}], light() < 0.8 * first];""")
        self.assertEqual(kept[0], kept[1])
        self.assertTrue(darker)
        self.browser.run("window.sturmViewer.app.held = false")
        self.wait("window.sturmViewer.app.panels.every((p) => p.passes > 8)")

    def test_the_filter_waits_for_whole_passes(self):
        self.page_of(view_of({"vfov_deg": 39.3, "resolution": [32, 64]}, 4))
        self.browser.run("""const {app} = window.sturmViewer, {filtered} = app.pictures;
          window.filtered = [];
          app.pictures.filtered = (panel) => { window.filtered.push([panel.passes, panel.rows]); return filtered.call(app.pictures, panel); };""")
        self.change("s.modes = ['path']; s.filter = true;")
        self.wait("window.filtered.length > 2")
        asked = self.browser.run("return window.filtered")
        self.assertEqual([rows for _, rows in asked], [0] * len(asked))
        self.assertEqual(len({passes for passes, _ in asked}), len(asked))  # once for each


if __name__ == "__main__":
    main()
