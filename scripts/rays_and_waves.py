#!/usr/bin/env python3
"""Prints the tables of docs/rays_vs_waves.md.

    scripts/rays_and_waves.py map      where rays are good enough: an eye without aberration, pupil by defocus
    scripts/rays_and_waves.py eyes     what measured eyes have beyond SPH, CYL and AXIS

STURM names the program (build/release/bin/sturm)."""
import csv
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STURM = os.environ.get("STURM", str(ROOT / "build/release/bin/sturm"))

PUPILS_MM = (2, 3, 4, 5, 6)
DEFOCUS_D = (0, 0.25, 0.5, 1, 2, 3)
# file of configs/data/, pupil [mm]
EYES = {"Jaeken and Artal 2012": ("jaeken_artal2012_fovea.csv", 4), "Polans et al. 2015": ("polans2015_fovea.csv", 4), "H. Hofer": ("hofer_9_subjects_6mm.csv", 6)}
OF_SECOND_ORDER = 6  # OSA numbers below it are piston, tilt, defocus and astigmatism


def point_spreads(**document):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "psf.json"
        path.write_text(json.dumps({"format": "sturm.psf/1", **document}), encoding="utf-8")
        return json.loads(subprocess.run([STURM, "psf", str(path)], check=True, capture_output=True, text=True).stdout)


def half_radius(results, light, model, target):
    for entry in results:
        if (entry["light"], entry["model"], entry["target"]) == (light, model, target):
            return entry["energy"][0]["radius_about_chief_ray_arcmin"]
    raise SystemExit(f"no {model} of {light}")


def table(title, rows):
    print(f"\n{title}\n")
    print("| pupil | " + " | ".join(f"{d:g} D" for d in DEFOCUS_D) + " |")
    print("|---" * (len(DEFOCUS_D) + 1) + "|")
    for pupil, cells in rows.items():
        print(f"| {pupil} mm | " + " | ".join(cells) + " |")


def print_map():
    distance, radii = {"green": {}, "white": {}}, {"green": {}, "white": {}}
    for pupil in PUPILS_MM:
        found = point_spreads(eye={"prescription": {"sphere_D": 0}, "pupil_diameter_mm": pupil}, defocus_D=DEFOCUS_D,
                              lights=[{"id": "green", "wavelength_nm": 555}, {"id": "white", "spectrum": "luminance"}], comparison={"cells_arcmin": [1]})
        for light in distance:
            distance[light][pupil] = [f"{c['total_variation'][0]['value']:.3f}" for c in found["comparisons"] if c["light"] == light]
            pairs = [[half_radius(found["results"], light, model, i) for model in ("rays", "waves")] for i in range(len(DEFOCUS_D))]
            radii[light][pupil] = [f"{100 * (rays / waves - 1):+.0f} %" for rays, waves in pairs]
    table("Total variation between rays and waves, 555 nm alone, cells of 1′", distance["green"])
    table("The same in white light, with the chromatic eye in both", distance["white"])
    table("Radius of half of the energy, rays against waves, 555 nm alone", radii["green"])
    table("The same in white light", radii["white"])


def rows(file):
    """Coefficients by OSA number [µm]; rows with missing values are left out."""
    with open(ROOT / "configs/data" / file, encoding="utf-8") as lines:
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            eye = {int(key[1:]): float(value) for key, value in row.items() if key[0] == "c" and key[1:].isdigit()}
            if all(map(math.isfinite, eye.values())):
                yield eye


def quartiles(values):
    return "{1:.3g} ({0:.3g} … {2:.3g})".format(*statistics.quantiles(values, n=4))


def remaining_radius(coefficients, pupil_mm):
    """Of 80 % of the rays about the centroid ['], with the second order corrected."""
    beyond = {str(j): c for j, c in coefficients.items() if j >= OF_SECOND_ORDER}
    found = point_spreads(eye={"wavefront": {"coefficients_um": beyond, "pupil_diameter_mm": pupil_mm, "eye": "right"}, "pupil_diameter_mm": pupil_mm},
                          models=["rays"], rays={"count": 65536})
    return found["results"][0]["energy"][1]["radius_about_centroid_arcmin"]


def print_eyes():
    print("| eyes | number | pupil | root mean square beyond second order [µm] | the defocus with that root mean square [D] | 80 % of the rays lie within, second order corrected [′] | share above ¼ D |")
    print("|---" * 7 + "|")
    for name, (file, pupil) in EYES.items():
        eyes = list(rows(file))
        beyond = [math.sqrt(sum(c * c for j, c in eye.items() if j >= OF_SECOND_ORDER)) for eye in eyes]
        defocus = [4 * math.sqrt(3) * rms / (pupil / 2) ** 2 for rms in beyond]  # of Z4 alone: M = 4√3 c/r²
        share = sum(d > 0.25 for d in defocus) / len(defocus)
        remaining = [remaining_radius(eye, pupil) for eye in eyes]
        print(f"| {name} | {len(eyes)} | {pupil} mm | {quartiles(beyond)} | {quartiles(defocus)} | {quartiles(remaining)} | {100 * share:.0f} % |", flush=True)


if __name__ == "__main__":
    {"map": print_map, "eyes": print_eyes}[sys.argv[1]]()
