#!/usr/bin/env python3
"""Sturm and Cycles (Blender) side by side: sample rate, noise and agreement in two rooms through a lens of 20 mm radius.

Both render tests/bench/peer/*.json with the same samples, bounces, filter and threads, in turn, with everything biased in Cycles switched
off. Sturm's seconds are those of its path tracing; of Cycles' those of a whole render call count, less a call with one sample. Run it on an
otherwise idle machine. Exit status 1 if --require is given and a bar is missed. Started by scripts/bench --peer cycles."""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = {"plain": "scene_plain", "bulbs": "scene_bulbs"}  # picture of reference of each

# What is asked of Sturm: at least (least) or at most (most), both of ratios to Cycles in the same run.
BARS = {
    ("plain", "rate_ratio"): ("least", 2.3),
    ("plain", "cost_ratio"): ("most", 1 / 3),
    ("bulbs", "cost_ratio"): ("most", 1 / 15),
}
PATH_BAR = 0.65


def run(command, what):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"error: {what} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def render_with_sturm(options, scene, seed, out):
    spec = os.path.join(SOURCE, "tests/bench/peer", scene + ".json")
    run(
        [options.sturm, "render", spec, "-o", out, "--threads", str(options.threads), "--set", f"/seed={seed}",
         "--set", f"/method/samples_per_pixel={options.samples}"],
        "sturm render",
    )
    with open(os.path.splitext(out)[0] + ".manifest.json") as file:
        return json.load(file)["provenance"]


def render_with_cycles(options, scene, seed, out, folder):
    with open(os.path.join(SOURCE, "tests/bench/peer", scene + ".json")) as file:
        spec = json.load(file)
    model = os.path.join(SOURCE, "tests/bench/peer", spec["scene"]["models"][0]["file"])
    job = {
        "scene": os.path.normpath(model),
        "camera": spec["camera"],
        "aperture_radius_m": spec["eye"]["pupil_diameter_mm"] / 2000,
        "focus_distance_m": spec["eye"]["accommodation"]["focus_distance_m"],
        "max_bounces": spec["method"]["max_bounces"],
        "threads": options.threads,
        "renders": [
            {"samples": 1, "seed": seed, "out": os.path.join(folder, "warm.exr")},
            {"samples": 1, "seed": seed, "out": os.path.join(folder, "warm.exr")},
            {"samples": options.samples, "seed": seed, "out": out},
        ],
    }
    path = os.path.join(folder, "job.json")
    with open(path, "w") as file:
        json.dump(job, file)
    said = run([options.blender, "-b", "--factory-startup", "--python", os.path.join(SOURCE, "scripts/cycles_render.py"), "--", path], "Blender")
    lines = [json.loads(line[len("CYCLES "):]) for line in said.splitlines() if line.startswith("CYCLES ")]
    if len(lines) != len(job["renders"]) or not os.path.exists(out):
        sys.exit(f"error: Blender rendered nothing:\n{said[-2000:]}")
    return lines[2]["seconds"] - lines[1]["seconds"], lines[2]["version"]


def compare(options, scene, folder):
    ours, theirs, our_seconds, their_seconds = [], [], [], []
    provenance, version = None, None
    for i in range(options.repetitions):
        ours.append(os.path.join(folder, f"{scene}_sturm_{i}.exr"))
        theirs.append(os.path.join(folder, f"{scene}_cycles_{i}.exr"))
        provenance = render_with_sturm(options, scene, 101 + i, ours[-1])
        our_seconds.append(provenance["seconds"]["path_tracing"])
        seconds, version = render_with_cycles(options, scene, 201 + i, theirs[-1], folder)
        their_seconds.append(seconds)
        print(f"{scene} {i + 1}/{options.repetitions}: Sturm {our_seconds[-1]:.2f} s, Cycles {seconds:.2f} s", file=sys.stderr)
    reference = os.path.join(SOURCE, "tests/reference", SCENES[scene], "reference_dof20.exr")
    figures = json.loads(run([options.pictures, reference, "--ours", *ours, "--theirs", *theirs], "peer_pictures"))
    samples = 256 * 256 * options.samples

    def side(seconds, errors):
        median, error = statistics.median(seconds), statistics.mean(errors)
        return {"seconds": seconds, "samples_per_second": samples / median, "trimmed_relative_mse": error, "cost": error * median}

    errors = figures["trimmed_relative_mse"]
    sturm, cycles = side(our_seconds, errors["ours"]), side(their_seconds, errors["theirs"])
    return {
        "scene": scene,
        "sturm": sturm,
        "cycles": cycles,
        "rate_ratio": sturm["samples_per_second"] / cycles["samples_per_second"],
        "error_ratio": sturm["trimmed_relative_mse"] / cycles["trimmed_relative_mse"],
        "cost_ratio": sturm["cost"] / cycles["cost"],
        "agreement": figures.get("agreement"),
        "versions": {"sturm": provenance["version"], "commit": provenance["commit"], "cycles": version, "cpu": provenance["cpu"]},
    }


def path_against_ceiling(options):
    """Samples per second of the plain room over the rate at which bare Embree traces the very same rays."""
    done = subprocess.run(
        [options.bench_rays, "--json", "--threads", str(options.threads), "--repetitions", "7"], capture_output=True, text=True
    )
    rows = json.loads(done.stdout)["results"]
    return next(row for row in rows if row["name"].startswith("path"))


def bar_of(result, key):
    kind, bound = BARS.get((result["scene"], key), (None, None))
    if kind is None:
        return "", True
    passed = result[key] >= bound if kind == "least" else result[key] <= bound
    return f" ({'≥' if kind == 'least' else '≤'} {bound:.3g}{'' if passed else ', MISSED'})", passed


def print_scene(result):
    passed = True
    print(f"\n{result['scene']}: lens of 20 mm radius, {result['samples_per_pixel']} samples per pixel")
    print(f"  {'':34}{'Sturm':>12}{'Cycles':>12}{'ratio':>9}")
    for name, key, ratio, scale, digits in (
        ("Msamples/s", "samples_per_second", "rate_ratio", 1e-6, 2),
        ("trimmed relative MSE", "trimmed_relative_mse", "error_ratio", 1, 6),
        ("trimmed relative MSE × seconds", "cost", "cost_ratio", 1, 5),
    ):
        bar, ok = bar_of(result, ratio)
        passed &= ok
        print(f"  {name:34}{scale * result['sturm'][key]:12.{digits}f}{scale * result['cycles'][key]:12.{digits}f}{result[ratio]:9.4f}{bar}")
    agreement = result["agreement"]
    if agreement:
        means = ", ".join(f"{100 * (m - 1):+.3f} ± {100 * e:.3f} %" for m, e in zip(agreement["mean_ratio"], agreement["mean_ratio_standard_error"]))
        print(f"  means of R, G, B against Cycles: {means}")
        print(f"  {agreement['blocks']} block means: rms z {agreement['rms_z']:.2f} (noise: 1), largest {agreement['largest_z']:.2f} "
              f"(1 % of noise exceeds {agreement['largest_z_expected_0_01']:.2f})")
    return passed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    build = os.path.join(SOURCE, "build/release/bin")
    parser.add_argument("--sturm", default=os.path.join(build, "sturm"))
    parser.add_argument("--bench-rays", default=os.path.join(build, "bench_rays"))
    parser.add_argument("--pictures", default=os.path.join(build, "peer_pictures"))
    parser.add_argument("--blender", default="blender")
    parser.add_argument("--scenes", nargs="+", choices=list(SCENES), default=list(SCENES))
    parser.add_argument("--samples", type=int, default=256, help="per pixel")
    parser.add_argument("--repetitions", type=int, default=3, help="of each render, with other seeds; the median of times counts")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--no-ceiling", action="store_true", help="leave bench_rays out")
    parser.add_argument("--json", metavar="FILE", help="write the figures there too")
    parser.add_argument("--require", action="store_true", help="exit status 1 if a bar is missed")
    options = parser.parse_args()
    passed, report = True, {"samples_per_pixel": options.samples, "repetitions": options.repetitions, "threads": options.threads, "scenes": []}
    with tempfile.TemporaryDirectory() as folder:
        for scene in options.scenes:
            result = compare(options, scene, folder)
            result["samples_per_pixel"] = options.samples
            report["scenes"].append(result)
            passed &= print_scene(result)
    if not options.no_ceiling:
        row = path_against_ceiling(options)
        report["path_against_bare_embree"] = row
        ok = row["ratio"] >= PATH_BAR
        passed &= ok
        print(f"\nplain room against bare Embree on the same rays: {row['ours']:.2f} of {row['bare']:.2f} Msamples/s, "
              f"{row['ratio']:.3f} (≥ {PATH_BAR}{'' if ok else ', MISSED'})")
    versions = report["scenes"][0]["versions"]
    print(f"\nSturm {versions['sturm']} ({versions['commit']}), Cycles {versions['cycles']}, {versions['cpu']}, {options.threads} threads, "
          f"{options.repetitions} repetitions")
    if options.json:
        with open(options.json, "w") as file:
            json.dump(report, file, indent=2)
            file.write("\n")
    return 0 if passed or not options.require else 1


if __name__ == "__main__":
    sys.exit(main())
