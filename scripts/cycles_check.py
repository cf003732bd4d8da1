#!/usr/bin/env python3
"""Renders a scene of `sturm validate-camera --write` with Cycles (Blender) into picture.exr beside it. Blender's camera is a thin lens, so the
scene must have been written for an eye without a cylinder."""
import argparse
import json
import os
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="of the scene")
    parser.add_argument("--blender", default="blender")
    parser.add_argument("--samples", type=int, default=1024, help="per pixel")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--pupil-factor", type=float, default=1.0, help="makes the aperture wrong on purpose")
    options = parser.parse_args()
    folder = os.path.abspath(options.folder)
    with open(os.path.join(folder, "camera.json")) as file:
        camera = json.load(file)
    lens = camera["thin_lens"]
    if lens is None:
        sys.exit("error: Blender has no camera with a cylinder, and none that is focused beyond infinity")
    job = {
        "scene": os.path.join(folder, "scene.obj"),
        "camera": camera,
        "aperture_radius_m": options.pupil_factor * lens["aperture_radius_m"],
        "focus_distance_m": lens["focus_distance_m"],
        "max_bounces": 1,
        "threads": options.threads,
        "renders": [{"samples": options.samples, "seed": 1, "out": os.path.join(folder, "picture.exr")}],
    }
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(job, file)
        file.flush()
        script = os.path.join(SOURCE, "scripts/cycles_render.py")
        done = subprocess.run([options.blender, "-b", "--factory-startup", "--python", script, "--", file.name], capture_output=True, text=True)
    if done.returncode != 0 or "CYCLES " not in done.stdout:
        sys.exit(f"error: Blender rendered nothing:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    print(next(line for line in done.stdout.splitlines() if line.startswith("CYCLES ")))
    return 0


if __name__ == "__main__":
    sys.exit(main())
