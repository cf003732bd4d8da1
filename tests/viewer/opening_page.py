"""A page in which files are opened, as the tests of opening and saving have it."""
import json
import math

from page_in_browser import PageTest, emissive_view


class OpeningTest(PageTest):
    """One page for all tests of a class; each begins with the view that the page came with, and a scene that is the program's own."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls().page_of(emissive_view(64))
        cls.browser.run("const { app } = window.sturmViewer; window.first = [app.view, app.data, structuredClone(app.state)]")

    def setUp(self):
        self.browser.run("const { app } = window.sturmViewer; app.show(...window.first); app.held = true; app.say('')")

    def open(self, *files):
        """What the page says of files that were chosen together."""
        self.browser.run("window.sturmViewer.app.say('')")
        self.browser.type("input[type=file]", "\n".join(map(str, files)))
        self.wait("!/^(Opening|$)/.test(document.getElementById('message').textContent)")
        return self.message()

    def write(self, name, content):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def message(self):
        return self.browser.run("return document.getElementById('message').textContent")

    def is_problem(self):
        return self.browser.run("return document.getElementById('message').classList.contains('problem')")

    def app(self, expression):
        return self.browser.run(f"const {{ app }} = window.sturmViewer; return {expression}")

    def saved(self):
        """The document that "save view.json" saves."""
        return json.loads(self.browser.run("return window.sturmViewer.measured.document()"))

    def difference(self):
        """RMSE, and the share of numbers that differ by more than 1e-6, between the page's traced passes through a pinhole and the program's picture
        of the saved view."""
        self.change("s.modes = ['gather']; s.passes = 16; s.eyes.right.pupil_mm = 0;")
        shown = self.measured("picture('gather', 0)")
        right = self.rendered(self.saved(), "saved")
        errors = [abs(a - b) for a, b in zip(shown, right)]
        return math.sqrt(sum(e * e for e in errors) / len(errors)), sum(e > 1e-6 for e in errors) / len(errors)
