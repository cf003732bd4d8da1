"""Spectacles on the page: progressive lenses from a worker, the map of a lens, its rim, and accommodation by age."""
from page_in_browser import PageTest, emissive_view, main

# The errors that the page's eye has, and those of the same eye and lens made on the spot.
BOTH = """
  const {app} = window.sturmViewer, gazes = [0, 0, 0.3, -0.4, -0.1, -0.5, -0.35, 0.2], again = new app.eye.constructor(app.core);
  again.wear(app.state, app.view);
  const errors = [app.eye, again].map((eye) => Array.from(eye.optics.errors(gazes, 0.4)));
  again.optics.delete();
  return errors;"""
# Whether the core sees a place of the picture through the lens, a little within the rim and a little beyond it.
SEEN = """
  const {app} = window.sturmViewer, {width, height, state} = app, {camera} = state;
  const numbers = {position_m: [0, 0, 0], look_at_m: [0, 0, -1], up: [0, 1, 0], vfov_rad: camera.field_deg * Math.PI / 180, width, height, gaze: camera.gaze};
  const corners = document.querySelector('#overlay .rim').points, seen = [];
  for (const {x, y} of corners) seen.push([0.98, 1.02].map((k) => app.eye.optics.pictureEllipse(numbers, width / 2 + k * (x - width / 2), height / 2 + k * (y - height / 2), 1) !== null));
  return seen;"""


class Spectacles(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = cls.write_page(cls(), emissive_view(64))

    def setUp(self):
        self.browser.open(self.page)
        self.wait("window.sturmViewer?.app.panels.length")

    def test_a_progressive_lens_is_made_in_a_worker(self):
        self.browser.run("""
          const {optics} = window.sturmViewer.app.eye, set = optics.setLens;
          window.given = [];
          optics.setLens = (lens) => { window.given.push(lens?.front ? 'made' : lens?.kind); set.call(optics, lens); };
          new MutationObserver(() => { window.told = true; }).observe(document.getElementById('making'), {attributes: true});""")
        self.change("Object.assign(s.eyes.right, {sphere_D: -2, cylinder_D: -1}); s.glasses.right.kind = 'progressive'; s.glasses.right.addition_D = 1.5; s.camera.gaze = 'foveal'")
        self.change("s.glasses.right.addition_D = 2.25")  # before the first is made
        self.wait("window.given.includes('made') && !window.sturmViewer.app.lenses.isMaking && document.getElementById('making').hidden")
        self.assertTrue(self.browser.run("return window.told"))
        self.assertNotIn("progressive", self.browser.run("return window.given"))
        page, on_the_spot = self.browser.run(BOTH)
        self.assertEqual(page, on_the_spot)
        self.assertEqual(page[3::4], [1] * 4)
        # At 0.4 m the far zone is off by 2.5 D, the near zone by a quarter.
        self.assertAlmostEqual(page[2], 2.5, delta=0.15)
        self.assertLess(page[10], 1.2)

    def test_what_cannot_be_made_is_said(self):
        self.change("s.glasses.right.kind = 'progressive'; s.eyes.right.sphere_D = -2; s.eyes.right.cylinder_D = 0")
        self.wait("window.sturmViewer.app.eye.lens")
        self.change("s.eyes.right.sphere_D = 20; s.glasses.right.addition_D = 4")
        self.wait("!document.getElementById('message').hidden && document.getElementById('making').hidden")
        self.change("s.eyes.right.sphere_D = 1; s.glasses.right.addition_D = 2")
        self.wait("document.getElementById('message').hidden && window.sturmViewer.app.eye.lens")

    def test_the_map_says_how_much_of_a_lens_is_clear(self):
        self.change("Object.assign(s.eyes.right, {sphere_D: -2, cylinder_D: 0}); s.glasses.right.kind = 'single'; s.lensMap = true; s.camera.gaze = 'foveal'")
        words = "document.getElementById('lens-map-words').textContent"
        self.wait(f"{words} && !document.getElementById('lens-map').hidden")
        self.assertIn("at 6.67 m is clear to ⅛ D through", self.browser.text("#lens-map-words"))
        clear = int(self.browser.run(f"return {words}.match(/through ([0-9]+) %/)[1]"))
        self.assertGreater(clear, 5)
        # A lens without power leaves the eye its 2 D: at 6.67 m an error of 1.85 D.
        self.change("s.glasses.right.fitted = false")
        self.wait(f"{words}.includes('through 0 %')")
        error = self.browser.run("return window.sturmViewer.app.eye.optics.errors([0, 0], 20 / 3)[2]")
        self.assertAlmostEqual(error, 1.85, delta=0.03)
        self.change("s.glasses.right.kind = 'none'")
        self.wait("document.getElementById('lens-map').hidden")

    def test_the_rim_is_where_the_core_loses_sight(self):
        for gaze in ("camera", "foveal"):
            # The rim of another gaze goes first: it is redrawn a frame after the change.
            self.change("s.rimOverlay = false")
            self.wait("!document.querySelector('#overlay .rim')")
            self.change(f"Object.assign(s.eyes.right, {{sphere_D: -6, cylinder_D: 0}}); s.glasses.right.kind = 'single'; s.rimOverlay = true; s.camera.gaze = '{gaze}'; s.camera.field_deg = 100")
            self.wait("window.sturmViewer.app.eye.lens && document.querySelector('#overlay .rim')")
            seen = self.browser.run(SEEN)
            self.assertEqual(len(seen), 48)
            self.assertEqual(seen, [[True, False]] * 48)

    def test_an_age_stands_for_an_amplitude(self):
        self.change("s.eyes.right.accommodation = 'best'; s.eyes.right.amplitude_D = 5")
        age = "[...document.querySelectorAll('.row:not([hidden])')].find((r) => r.textContent.startsWith('Usual at age'))"
        self.wait(age)
        self.assertIn("45 years", self.browser.run(f"return {age}.textContent"))  # Hofstetter: 18.5 − 0.3 · 45
        self.browser.run(f"const i = {age}.querySelector('input'); i.value = 30; i.dispatchEvent(new Event('input'))")
        self.assertAlmostEqual(self.browser.run("return window.sturmViewer.app.state.eyes.right.amplitude_D"), 9.5)


if __name__ == "__main__":
    main()
