"""The shipped views as the page draws them, against `sturm render` of the same view in the same mode, by `sturm compare`.

What is gated has no noise: every surface glows in its own colour and nothing is reflected, so that meshes, spheres, models, surroundings, the eye and the
display version are compared and a difference is one. Light is the matter of test_light.py. With VIEWER_LIT=PATHS in the environment all views are
drawn, and as they are too, by that many paths a pixel, beside what as many paths of the program come to: those are the figures of docs/viewer.md."""
import json
import os

from page_in_browser import PageTest, main
from sturm_process import PASSED, SOURCE, sturm

VIEWS = SOURCE / "configs/views"
NAMES = ("cornell", "desk", "street", "night_spectacles", "near_screen")
ALL_NAMES = (*NAMES, "chart", "night_astigmat")  # the same scenes again
LEAST_SSIM = 0.99
WIDTH, PASSES = 96, 64
LIT_WIDTH, LIT_PROGRAM_PATHS = 36, 2048
LIT_PATHS = int(os.environ.get("VIEWER_LIT", 0))


def with_addresses(document, folder):
    """A copy whose files are found from anywhere."""
    if isinstance(document, dict):
        return {key: str((folder / value).resolve()) if key == "file" else with_addresses(value, folder) for key, value in document.items()}
    return [with_addresses(value, folder) for value in document] if isinstance(document, list) else document


def view_of(name, width):
    """The view of a shipped file with its scene inside, and that many pixels across."""
    view = json.loads((VIEWS / f"{name}.json").read_text())
    view.pop("$schema", None)
    if isinstance(view["scene"], str):
        scene = (VIEWS / view["scene"]).resolve()
        view["scene"] = with_addresses(json.loads(scene.read_text()), scene.parent)
        view["scene"].pop("$schema", None)
    if "spectacles" in view:
        view["spectacles"] = str((VIEWS / view["spectacles"]).resolve())
    across, down = view["camera"]["resolution"]
    view["camera"]["resolution"] = [width, round(width * down / across)]
    return view


def glowing(scene):
    """Colours from 0.5 to 0.95: beside what is more than twice as bright the program makes more passes, as it does for lamps."""
    colours = {name: m["emission"] if "emission" in m else m.get("albedo", [0.5, 0.5, 0.5]) for name, m in scene["materials"].items()}
    return {**scene, "materials": {name: {"emission": [0.5 + 0.45 * min(1.0, value) for value in colour]} for name, colour in colours.items()}}


def by_paths(view, paths, seed, **more):
    method = {"type": "path_trace", "ray_model": view["method"]["ray_model"], "samples_per_pixel": paths, "max_bounces": view["method"]["max_bounces"], **more}
    return {**view, "method": method, "seed": seed}


def by_passes(view, passes):
    return {**view, "method": {"type": "predict", "prediction": "multipass", "passes": passes}}


def write_pfm(path, pixels, width):
    rows = [pixels[k:k + 3 * width] for k in range(0, len(pixels), 3 * width)]
    path.write_bytes(f"PF\n{width} {len(rows)}\n-1.0\n".encode() + b"".join(row.tobytes() for row in reversed(rows)))


class ShippedViews(PageTest):
    def ssim(self, pixels, reference, width):
        test, program = self.folder / "test.pfm", self.folder / "program.pfm"
        write_pfm(test, pixels, width)
        write_pfm(program, reference, width)
        process = sturm("compare", test, program, "--json", "-")
        self.assertEqual(process.returncode, PASSED, process.stderr)
        return json.loads(process.stdout)["metrics"]["ssim_display"]

    def test_glowing_views(self):
        for name in ALL_NAMES if LIT_PATHS else NAMES:
            view = view_of(name, WIDTH)
            view["scene"] = glowing(view["scene"])
            view = by_paths(view, PASSES, 1, max_bounces=0, guide_emitters=False)
            self.page_of(view)
            self.change(f"s.passes = {PASSES}")
            for mode, document in (("path", view), ("gather", by_passes(view, PASSES))):
                with self.subTest(view=name, mode=mode):
                    value = self.ssim(self.measured(f"picture('{mode}', {PASSES})"), self.rendered(document), WIDTH)
                    print(f"{name}, {mode}: SSIM {value:.5f}", flush=True)
                    self.assertGreaterEqual(value, LEAST_SSIM)

    def test_lit_views(self):
        paths = LIT_PATHS
        if paths == 0:
            self.skipTest("VIEWER_LIT is not set")
        for name in ALL_NAMES:
            view = view_of(name, LIT_WIDTH)
            self.page_of(by_paths(view, paths, 1))
            program, noisy = self.rendered(by_paths(view, LIT_PROGRAM_PATHS, 7)), self.rendered(by_paths(view, paths, 1))
            page = self.measured(f"picture('path', {paths})")
            print(f"{name}, lit, {paths} paths: SSIM {self.ssim(page, program, LIT_WIDTH):.4f}; the program's own {self.ssim(noisy, program, LIT_WIDTH):.4f}", flush=True)


if __name__ == "__main__":
    main()
