#!/usr/bin/env python3
"""Error times seconds of plain and of guided path tracing of one view, by interleaved renders in one run.

    STURM=build/release/bin/sturm scripts/guide_gain.py configs/views/night_spectacles.json REFERENCE.exr [--pairs 5] [sturm render options ...]

REFERENCE.exr: the same picture with many guided samples and another seed than 11, 12, … Further options go to every `sturm render`, e.g. --set /camera/resolution=[240,160].
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import tempfile

STURM = os.environ.get("STURM", "build/release/bin/sturm")


def render(view, out, guided, seed, options):
    command = [STURM, "render", view, "-o", str(out), "--quiet", "--set", f"/seed={seed}", "--set", f"/method/guide_emitters={str(guided).lower()}", *options]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return json.loads(out.with_suffix(".manifest.json").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("view")
    parser.add_argument("reference")
    parser.add_argument("--pairs", type=int, default=5)
    arguments, options = parser.parse_known_args()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        rows = {"plain": [], "guided": []}
        for pair in range(arguments.pairs):
            for name in ("plain", "guided"):
                manifest = render(arguments.view, folder / "picture.exr", name == "guided", 11 + pair, options)
                subprocess.run([STURM, "compare", folder / "picture.exr", arguments.reference, "--json", folder / "metrics.json"], check=True, stdout=subprocess.DEVNULL)
                metrics = json.loads((folder / "metrics.json").read_text())["metrics"]
                rows[name].append((metrics["relative_mse"], metrics["rmse_linear"] ** 2, manifest["provenance"]["seconds"]["path_tracing"]))
                if name == "guided":
                    print({k: v for k, v in manifest["counters"].items() if k.startswith("guide")})
    print(f"{'':8}{'relative MSE':>14}{'MSE':>14}{'seconds':>10}   (medians of {arguments.pairs})")
    medians = {name: [statistics.median(column) for column in zip(*values)] for name, values in rows.items()}
    for name, (relative, square, seconds) in medians.items():
        print(f"{name:8}{relative:14.6g}{square:14.6g}{seconds:10.3f}")
    plain, guided = medians["plain"], medians["guided"]
    print(f"plain / guided of error × seconds: relative MSE {plain[0] * plain[2] / (guided[0] * guided[2]):.2f}, MSE {plain[1] * plain[2] / (guided[1] * guided[2]):.2f}")


if __name__ == "__main__":
    main()
