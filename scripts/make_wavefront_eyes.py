#!/usr/bin/env python3
"""Writes the eyes of configs/eyes/ that are made from measured wavefronts, from the rows of configs/data/. Run it from anywhere; it changes
nothing if nothing has changed.

Piston and tilt are left out: an instrument measures them against its own axis."""
import csv
import json
import pathlib

CONFIGS = pathlib.Path(__file__).resolve().parent.parent / "configs"

# eye file: (data file, row, pupil [mm], what the eye is like)
EYES = {
    "hofer_5": ("hofer_9_subjects_6mm.csv", {"subject": "5"}, 6, "coma and trefoil, H. Hofer's measurement as in isetbio; its source has set the defocus to 0"),
    "jaeken_36_right": ("jaeken_artal2012_fovea.csv", {"subject": "36", "eye": "OD"}, 4, "oblique astigmatism, Jaeken and Artal 2012"),
    "jaeken_4_left": ("jaeken_artal2012_fovea.csv", {"subject": "4", "eye": "OS"}, 4, "oblique astigmatism with coma, Jaeken and Artal 2012"),
    "polans_5": ("polans2015_fovea.csv", {"subject": "5"}, 4, "myopia with astigmatism and coma, Polans et al. 2015; with the source's chromatic shift of -0.8 D"),
}


def row_of(file, wanted):
    with open(CONFIGS / "data" / file, encoding="utf-8") as lines:
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            if all(row[key] == value for key, value in wanted.items()):
                return row
    raise SystemExit(f"{file} has no row {wanted}")


def eye(file, wanted, pupil_mm, text):
    row = row_of(file, wanted)
    coefficients = {key[1:]: float(value) for key, value in row.items() if key[0] == "c" and int(key[1:]) >= 3 and float(value) != 0.0}
    wavefront = {"coefficients_um": coefficients, "pupil_diameter_mm": pupil_mm, "eye": "left" if row.get("eye") == "OS" else "right"}
    where = ", ".join(f"{key} {value}" for key, value in wanted.items())
    return {"$schema": "../schemas/eye.schema.json", "format": "sturm.eye/1", "source": f"{text}: configs/data/{file}, {where}",
            "wavefront": wavefront, "pupil_diameter_mm": pupil_mm, "accommodation": {"mode": "relaxed"}}


if __name__ == "__main__":
    for name, arguments in EYES.items():
        (CONFIGS / "eyes" / f"{name}.json").write_text(json.dumps(eye(*arguments), indent=1) + "\n", encoding="utf-8")
