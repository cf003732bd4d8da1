"""The page's numbers: the core answers in a browser to the bit as in node, where tests/viewer/test_core.py holds it to `sturm ellipse`."""
import json
import pathlib

from core_queries import CORE, core, lens_queries, prescription_queries
from page_in_browser import PageTest, emissive_view, main
from viewer_page import skip

ANSWERS = pathlib.Path(__file__).with_name("core_answers.js").read_text()
# What the page computes of its controls, said as sturm ellipse says it: the same eye through state and form.
BY_CONTROLS = """
  const {app} = window.sturmViewer;
  return arguments[0].map(({eye, targets}) => {
    const state = structuredClone(app.state), worn = state.eyes[state.side], {sphere_D, cylinder_D, axis_deg, vertex_distance_m} = eye.prescription;
    Object.assign(worn, {sphere_D, cylinder_D, axis_deg, vertex_mm: 1e3 * vertex_distance_m, pupil_mm: 1e3 * eye.pupil_diameter_m,
                         accommodation: eye.accommodation.mode, amplitude_D: eye.accommodation.amplitude_D});
    app.eye.wear(state, app.view);
    return targets.map(([azimuth, elevation, distance]) => app.eye.optics.ellipse(azimuth, elevation, distance === 'inf' ? Infinity : distance));
  });"""


class Numbers(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls().page_of(emissive_view(64))

    def in_page(self, numbers):
        return self.browser.run(f"{ANSWERS}; return answers(window.sturmViewer.app.core, arguments[0])", numbers)

    def test_real_prescriptions(self):
        _, numbers = prescription_queries()
        self.assertEqual(len(numbers), 413)
        expected = core("answers", stdin=json.dumps(numbers))
        self.assertEqual(self.in_page(numbers), expected)
        self.assertEqual(self.browser.run(BY_CONTROLS, numbers), expected)

    def test_lenses_in_five_gazes(self):
        _, numbers = lens_queries(self.folder)
        self.assertGreaterEqual(sum(len(query["targets"]) for query in numbers), 50)
        self.assertEqual(self.in_page(numbers), core("answers", stdin=json.dumps(numbers)))


if __name__ == "__main__":
    if not CORE.exists():
        skip(f"{CORE} was not built (preset wasm)")
    main()
