"""The page in Firefox on a screen in memory, by Mesa's software rasteriser: the tests of Chromium, in one window. README.md says which are not here."""
import pathlib
import shutil
import tempfile
import unittest

import test_displacement
import test_light
import test_lobes
import test_mutants
import test_native_button
import test_numbers
import test_opening_documents
import test_opening_models
import test_page
import test_paths
import test_pictures
import test_ray_models
import test_readout
import test_shipped_views
import test_spectacles
import test_speed
from core_queries import CORE
from marionette import Firefox, firefox
from page_in_browser import PageTest, main
from viewer_page import skip

FILES = (test_displacement, test_light, test_lobes, test_mutants, test_native_button, test_numbers, test_opening_documents, test_opening_models, test_page, test_paths, test_pictures,
         test_ray_models, test_readout, test_shipped_views, test_spectacles, test_speed)
# Less to draw where a bound is a share, a ratio or a multiple of the noise, and so is the same for it.
SMALLER = {test_light: {"PROGRAM_SAMPLES": 32}, test_mutants: {"PASSES": 16}, test_pictures: {"SIZE": 64}, test_speed: {"WIDTH": 320, "HEIGHT": 180}}
# What edges on 1/256 of a pixel allow.
TIGHTER = {case: {"RASTER_RMSE": 1e-3} for case in (test_pictures.Pictures, test_displacement.Displacement)}


def setUpModule():
    global WINDOW
    holder = tempfile.TemporaryDirectory(prefix="sturm_firefox_", ignore_cleanup_errors=True)
    unittest.addModuleCleanup(holder.cleanup)
    WINDOW = Firefox(pathlib.Path(holder.name) / "profile", screen=True)
    unittest.addModuleCleanup(WINDOW.close)


def start(_case):
    return WINDOW


def load_tests(loader, _tests, _pattern):
    suite = unittest.TestSuite()
    for file in FILES:
        vars(file).update(SMALLER.get(file, {}))
        cases = [case for case in vars(file).values() if isinstance(case, type) and issubclass(case, PageTest) and case.__module__ == file.__name__]
        # In this module, for the sake of setUpModule.
        suite.addTests(loader.loadTestsFromTestCase(type(case.__name__, (case,), {"__module__": __name__, "start": classmethod(start), **TIGHTER.get(case, {})})) for case in cases)
    return suite


if __name__ == "__main__":
    if not firefox():
        skip("Firefox is not installed (Debian's package firefox-esr)")
    if not shutil.which("Xvfb"):
        skip("Xvfb is not installed (Debian's package xvfb)")
    if not CORE.exists():
        skip(f"{CORE} was not built (preset wasm)")
    main()
