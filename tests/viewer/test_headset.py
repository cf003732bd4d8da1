"""A session in an emulated headset: two eyes, each with its own place and prescription, and back to the page."""
from page_in_browser import PageTest, emissive_view, main
from sturm_process import SOURCE

EMULATOR = SOURCE / "viewer/node_modules/iwer/build/iwer.min.js"
ENTER = "[...document.querySelectorAll('button')].find((b) => b.textContent === 'Enter the headset')"
EYES = """
  const {headset, gpu} = window.sturmViewer.app, seen = {};
  for (const side of ['right', 'left']) {
    const {panel, pose} = headset.eyes[side], {width, height} = panel.sum, sums = gpu.read(panel.sum);
    let edges = 0, light = 0;
    for (let y = 0; y < height; ++y) for (let x = 1; x < width; ++x) {
      const at = 4 * (y * width + x);
      edges += ((sums[at] - sums[at - 4]) / sums[at + 3]) ** 2;
      light += sums[at] / sums[at + 3];
    }
    seen[side] = {position: pose.position, center: pose.center, width, height, edges, light: light / width / height};
  }
  return seen;"""


class HeadsetTest(PageTest):
    def setUp(self):
        if not EMULATOR.exists():
            self.skipTest("iwer is not installed")
        self.page_of(emissive_view(64))
        self.assertTrue(self.browser.run(f"return {ENTER}.hidden"))
        # The page was opened before there was a headset; it hears of one.
        self.browser.run(EMULATOR.read_text() + """
          ; const device = new IWER.XRDevice(IWER.metaQuest3);
          Object.assign(device, {ipd: 0.063, stereoEnabled: true});
          device.installRuntime({forceInstall: true});
          window.emulated = device;
          return true;""")
        self.change("s.eyes.left.sphere_D = -6; s.eyes.left.cylinder_D = -3; s.eyes.right.sphere_D = 0; s.eyes.right.cylinder_D = 0;")

    def test_two_eyes(self):
        self.browser.run("return window.sturmViewer.app.enterHeadset()")
        self.wait("window.sturmViewer.app.headset?.frames > 3")
        eyes = self.browser.run(EYES)
        apart = [a - b for a, b in zip(eyes["right"]["position"], eyes["left"]["position"])]
        self.assertAlmostEqual(sum(x * x for x in apart) ** 0.5, 0.063, places=6)
        self.assertGreater(apart[0], 0.06)  # the right eye is on the right
        # The same rectangles, sharp for the right eye and blurred over degrees for the left: a difference of neighbours is an edge.
        self.assertGreater(eyes["right"]["edges"], 3 * eyes["left"]["edges"])
        self.assertAlmostEqual(eyes["right"]["light"] / eyes["left"]["light"], 1, delta=0.05)
        self.browser.run("window.sturmViewer.app.headset.leave()")
        self.wait("!window.sturmViewer.app.headset && !window.sturmViewer.app.held")
        self.wait("window.sturmViewer.app.panels[0]?.passes > 0")


if __name__ == "__main__":
    main()
