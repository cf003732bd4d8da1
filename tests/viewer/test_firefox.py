"""The page in Firefox on a screen in memory, by Mesa's software rasteriser: the tests of Chromium, in one window."""
import pathlib
import shutil
import tempfile
import unittest

import test_numbers
import test_page
import test_pictures
import test_ray_models
from marionette import Firefox, firefox
from page_in_browser import main
from viewer_page import skip


def setUpModule():
    global WINDOW
    holder = tempfile.TemporaryDirectory(prefix="sturm_firefox_", ignore_cleanup_errors=True)
    unittest.addModuleCleanup(holder.cleanup)
    WINDOW = Firefox(pathlib.Path(holder.name) / "profile", screen=True)
    unittest.addModuleCleanup(WINDOW.close)


class InFirefox:
    @classmethod
    def start(cls):
        return WINDOW


class Numbers(InFirefox, test_numbers.Numbers):
    pass


class Page(InFirefox, test_page.Page):
    def become_phone(self):  # as narrow as its windows are
        self.browser.resize(500, 900)
        self.addCleanup(self.browser.resize, 1280, 1000)


class Pictures(InFirefox, test_pictures.Pictures):
    RASTER_RMSE = 1e-3  # edges on 1/256 of a pixel


class RayModels(InFirefox, test_ray_models.RayModels):
    pass


# Of pictures and rays one of each kind: the others would ask the same shaders again.
CHOSEN = {Pictures: ["test_traced_passes_are_the_programs", "test_displaced_vertices_make_nearly_the_same_picture"],
          RayModels: ["test_every_ray_is_the_cores"]}


def load_tests(loader, _tests, _pattern):
    return unittest.TestSuite([loader.loadTestsFromTestCase(Numbers), loader.loadTestsFromTestCase(Page),
                               *(case(name) for case, names in CHOSEN.items() for name in names)])


if __name__ == "__main__":
    if not firefox():
        skip("Firefox is not installed (Debian's package firefox-esr)")
    if not shutil.which("Xvfb"):
        skip("Xvfb is not installed (Debian's package xvfb)")
    main()
