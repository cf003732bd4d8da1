"""How long the page takes. Only ratios are held, since times are those of the machine and of what else it does; times are printed (docs/viewer.md says how to see them)."""
import json
import os
import pathlib

from page_in_browser import PageTest, main
from sturm_process import SOURCE

WIDTH, HEIGHT, PASSES = 640, 360, 16
TRACED = 1800
FIELD = 32  # directions each way
# In what as many lines of sight take when each is traced. Of a picture's a quarter is, and what the page does with all of them comes to it.
MOST_OF_FIELD, MOST_OF_SIGHTS = 2, 1
MOST_PASSES, MOST_OF_SLIDER = 20, 25  # in passes, of which there are 16
# Each is done several times, one after the other, and the shortest counts: what other programs take of the machine only makes times longer.
ROUNDS = 3
PREPARE = """
  const {app} = window.sturmViewer, {pictures, gpu} = app;
  app.held = true;
  app.change((s) => { s.passes = arguments[0]; s.modes = ['raster']; });
  app.prepare();
  const [panel] = app.panels;
  let axis = 0;
  const turn = () => { app.state.eyes.right.axis_deg = axis++ % 180; };
  window.measure = {
    drawn: (count) => { pictures.restart(panel); for (let k = 0; k < count; ++k) pictures.step(panel, 0); gpu.finish(panel.sum); },
    singly: (count) => { for (let k = 0; k < count; ++k) window.measure.drawn(1); },
    field: () => {
      turn();
      app.eye.wear(app.state, app.view);
      app.eye.optics.fieldAnalytic({nx: arguments[1], ny: arguments[1], nz: 256, tan_half_width: 0.7, tan_half_height: 0.5, near_vergence_D: 4, far_vergence_D: 0});
    },
    sights: () => { turn(); app.eye.wear(app.state, app.view); return app.eye.sights(app.state, pictures.pose); },
    // Of six by six none is between traced ones.
    traced: (count) => { for (let k = 0; k < count; k += 36) app.eye.optics.sights({gaze: 'foveal', first_x: -0.5, first_y: -0.3, step_x: 0.2, step_y: 0.12, columns: 6, rows: 6}); },
    slider: (count) => { turn(); app.prepare(); window.measure.drawn(count); pictures.show(app.panels, app.canvas, 1); },
    wear: (kind) => { app.change((s) => { s.glasses.right.kind = kind; }); app.prepare(); },
  };
  return app.scene.triangleCount;"""

TICKS = os.sysconf("SC_CLK_TCK")


def processor_seconds(ancestor):
    """Of a process and all that come from it."""
    parents, seconds = {}, {}
    for file in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = file.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        parents[int(file.parent.name)], seconds[int(file.parent.name)] = int(fields[1]), (int(fields[11]) + int(fields[12])) / TICKS
    total = 0.0
    for process in seconds:
        at = process
        while at not in (0, ancestor):
            at = parents.get(at, 0)
        total += seconds[process] if at == ancestor else 0.0
    return total


class Speed(PageTest):
    def work(self, lens, kinds):
        """Of each kind the least that the browser's processes took together [s]; prints that and the shortest time."""
        times, seconds = {name: [] for name in kinds}, {name: [] for name in kinds}
        for _ in range(ROUNDS):
            for name, work in kinds.items():
                before = processor_seconds(self.browser.process)
                times[name].append(self.browser.run(f"const start = performance.now(); window.measure.{work}; return performance.now() - start;"))
                seconds[name].append(processor_seconds(self.browser.process) - before)
        for name in kinds:
            print(f"{name}, lens {lens}: {min(times[name]):.0f} ms, {min(seconds[name]):.2f} s of work", flush=True)
        return [min(seconds[name]) for name in kinds]

    def shortest(self, name, work):
        """Of ten, one after the other, for the sake of clocks of whole milliseconds [ms]."""
        timed = f"const start = performance.now(); for (let k = 0; k < 10; ++k) window.measure.{work}; return (performance.now() - start) / 10;"
        value = min(self.browser.run(timed) for _ in range(10))
        print(f"{name}: {value:.1f} ms", flush=True)
        return value

    def test_speed(self):
        view = json.loads((SOURCE / "configs/views/desk.json").read_text())
        view.pop("$schema")
        view["scene"] = str(SOURCE / "configs/scenes/desk.json")
        view["camera"]["resolution"] = [WIDTH, HEIGHT]
        self.page_of(view)
        self.wait("window.sturmViewer.app.firstPicture_ms")
        first = self.browser.run("return window.sturmViewer.app.firstPicture_ms")
        print(f"{self.browser.run(PREPARE, PASSES, FIELD)} triangles; first picture after {first / 1000:.2f} s", flush=True)
        for lens in ("none", "single"):
            self.browser.run("window.measure.wear(arguments[0])", lens)
            # As many pictures of one pass, so that both are measured alike.
            singly, all_passes, slider = self.work(lens, {f"{PASSES} pictures of one pass": f"singly({PASSES})", f"{PASSES} passes": f"drawn({PASSES})", "slider to frame": f"slider({PASSES})"})
            one = singly / PASSES
            # A pass costs what a pass costs: nothing is done again for each.
            self.assertLessEqual(all_passes, MOST_PASSES * one, lens)
            # What a slider moves costs little beside the picture that it changes.
            self.assertLessEqual(slider, MOST_OF_SLIDER * one, lens)
            field = self.shortest(f"field of {FIELD} by {FIELD} directions, lens {lens}", "field()")
            sights = self.shortest(f"lines of sight of the picture, lens {lens}", "sights()")
            traced = self.shortest(f"{TRACED} lines of sight traced, lens {lens}", f"traced({TRACED})") / TRACED
            self.assertLessEqual(field, MOST_OF_FIELD * FIELD**2 * traced, lens)
            columns, rows = self.browser.run("const {grid} = window.measure.sights(); return [grid.columns, grid.rows];")
            if lens != "none":  # a naked eye has so few that it is not they that take the time
                self.assertLessEqual(sights, MOST_OF_SIGHTS * columns * rows * traced, lens)


if __name__ == "__main__":
    main()
