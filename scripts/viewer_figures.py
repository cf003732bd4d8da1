#!/usr/bin/env python3
"""The pictures of docs/viewer.md, of the page as a headless Chromium draws it without a graphics card.

    scripts/viewer_figures.py FOLDER [--sturm PROGRAM] [--template PAGE.html]

FOLDER gets viewer.png, the page of configs/views/desk.json with ellipses over the picture, and viewer_progressive.png, what it shows through
progressive spectacles. `scripts/viewer` builds the program and the page without data that are taken by default. Standard library only."""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/e2e"))
from webdriver import Browser  # noqa: E402

WINDOW = (1000, 640)
SOFTWARE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars")
PASSES, LIGHT = 16, 16  # of the pupil, and samples at each vertex: enough for a picture of this size
# Light first, in pieces that a browser lets a script take; then the picture as the page makes it.
GATHER = """
  const {app} = window.sturmViewer, {scene, pictures, gpu} = app;
  app.held = true;
  for (let k = 0; k < 2; ++k) scene.gatherLight(pictures.programs, 64, app.view.maxBounces);
  gpu.finish(app.panels[0].sum);
  app.held = scene.bakedSamples < arguments[0];
  return !app.held;"""
FIGURES = {
    "viewer": (None, "s.fieldOverlay = true;"),
    "viewer_progressive": ("#frame", """
      s.fieldOverlay = false;
      s.eyes.right = {...s.eyes.right, sphere_D: -2, cylinder_D: 0, accommodation: 'relaxed'};
      s.glasses.right = {...s.glasses.right, kind: 'progressive', addition_D: 2.5};
      Object.assign(s.camera, {gaze: 'foveal', field_deg: 60, tilt_deg: -16});"""),
}


def wait(browser, condition, seconds=600):
    end = time.monotonic() + seconds
    while not browser.run(f"return {condition}"):
        if time.monotonic() > end:
            raise SystemExit(f"the page did not come to {condition}")
        time.sleep(0.2)


def draw(browser, selector, edit):
    """A PNG file of a part of the page in a state; no selector: of the window."""
    browser.run(f"window.sturmViewer.app.change((s) => {{ s.passes = {PASSES}; {edit} }})")
    wait(browser, "!window.sturmViewer.app.changed && !window.sturmViewer.app.lenses.isMaking")
    wait(browser, f"window.sturmViewer.app.panels[0].passes >= {PASSES}")
    return browser.screenshot_of(selector) if selector else browser.screenshot()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--sturm", default=ROOT / "build/release/bin/sturm", type=pathlib.Path)
    parser.add_argument("--template", default=ROOT / "build/viewer/viewer.html", type=pathlib.Path)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as holder:
        page, profile = pathlib.Path(holder, "desk.html"), pathlib.Path(holder, "profile")
        subprocess.run([options.sturm, "view", ROOT / "configs/views/desk.json", "-o", page, "--template", options.template], check=True)
        browser = Browser(profile, *WINDOW, switches=SOFTWARE)
        try:
            browser.as_phone(*WINDOW)  # all of the window is the page's
            browser.allow_scripts(110)
            browser.open(page)
            wait(browser, "window.sturmViewer?.app.firstPicture_ms > 0")
            while not browser.run(GATHER, LIGHT):
                pass
            for name, (selector, edit) in FIGURES.items():
                (options.folder / f"{name}.png").write_bytes(draw(browser, selector, edit))
        finally:
            browser.close()


if __name__ == "__main__":
    main()
