#!/usr/bin/env python3
"""What several eyes see of a room and of a photograph: the pictures of docs/seen_by_eyes.md.

    scripts/see_figures.py FOLDER [--sturm PROGRAM] [--width 816] [--samples 64] [--stretch 8]

Renders the project's desk through a pinhole, 46° wide, and lets every eye of EYES see it with `sturm see`; `sturm psf` gives the numbers. Then
one eye looks from far to near in five frames. If Debian's python3-skimage is installed, its Middlebury motorcycle is seen, too: as it is, and
with its depth stretched, which the labels say. FOLDER gets all pictures, `eyes/` with the eyes, `small/` with the pictures of the document,
`numbers.json`, and `sheet.svg`, on which all of them stand with labels. Standard library only."""
import argparse
import base64
import csv
import json
import math
import pathlib
import struct
import subprocess
import zipfile

import png_rows

ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = ROOT / "configs/data"
FIELD_DEG, PUPIL_MM, CARD_M, CHART_M = 46, 5.7, 0.3, 6
MOTORCYCLE = pathlib.Path("/usr/lib/python3/dist-packages/skimage/data")
CALIBRATION = {"--focal-px": 994.978, "--baseline-m": 0.193001, "--doffs-px": 31.086}  # skimage.data.stereo_motorcycle
ORTHOK = ("2-2", "20", "22", "3-3", "3-1", "31", "33", "4-4", "4-2", "40", "42", "44")  # columns C…, OSA order from j = 3 on


def rows_of(file, wanted):
    with open(DATA / file, encoding="utf-8") as lines:
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            if all(row[key] == value for key, value in wanted.items()):
                return row
    raise SystemExit(f"{file} has no row {wanted}")


def wave_eye(coefficients_um, source, **wavefront):
    return {"format": "sturm.eye/1", "source": source, "pupil_diameter_mm": PUPIL_MM,
            "wavefront": {"coefficients_um": coefficients_um, "pupil_diameter_mm": 6, **wavefront}}


def measured(file, **wanted):
    row = rows_of(file, wanted)
    coefficients = {key[1:]: float(value) for key, value in row.items() if key[0] == "c" and int(key[1:]) >= 3 and float(value) != 0}
    return wave_eye(coefficients, f"configs/data/{file}, {wanted}")


def constructed_orthok(when, patient, eye):
    """The table has the magnitudes of coefficients that are not normalised. Defocus of a myope is positive; all other signs are lost, and are
    taken as positive, too: one eye of the many that have these magnitudes."""
    row = rows_of("orthok_prepost_6mm.csv", {"patient": patient, "eye": eye})
    return wave_eye({str(3 + i): float(row[f"{when}_C{name}"]) for i, name in enumerate(ORTHOK)},
                    f"constructed from the magnitudes of configs/data/orthok_prepost_6mm.csv, {patient} {eye}, {when}; the signs are lost", normalised=False)


def prescribed(sphere, cylinder=0, axis=180, source="constructed"):
    return {"format": "sturm.eye/1", "source": source, "pupil_diameter_mm": PUPIL_MM,
            "prescription": {"sphere_D": sphere, "cylinder_D": cylinder, "axis_deg": axis}}


EYES = {  # name: (label, eye)
    "ideal": ("Ideal eye", prescribed(0)),
    "measured": ("A measured eye without refractive error (Hofer 5)", measured("hofer_9_subjects_6mm.csv", subject="5")),
    "astigmat": ("Astigmat −0.25 −2.00 × 120 (PAPILA P045, prescription alone)",
                 prescribed(-0.25, -2, 120, "configs/data/papila_prescriptions.csv, P045 OS")),
    "myope_before": ("Myope of −4.00 before reshaping (constructed from measured magnitudes)", constructed_orthok("pre", "P2", "OS")),
    "myope_after": ("The same eye 12 months later (constructed from measured magnitudes)", constructed_orthok("post", "P2", "OS")),
    "weak_myope_before": ("Myope of −1.25 before reshaping (constructed from measured magnitudes)", constructed_orthok("pre", "P3", "OD")),
    "weak_myope_after": ("The same eye 12 months later (constructed from measured magnitudes)", constructed_orthok("post", "P3", "OD")),
    # Vertical coma leads in keratoconus, then other coma, trefoil and secondary astigmatism; a cone below the middle has c7 < 0.
    "keratoconus": ("Keratoconus (constructed, no person's eye)",
                    wave_eye({"3": 0.5, "5": -0.6, "6": -0.25, "7": -1.5, "8": 0.3, "9": 0.2, "11": 0.15, "12": -0.35, "13": 0.3},
                             "constructed: no person's eye")),
}


class Figures:
    def __init__(self, options):
        self.options, self.folder, self.sheet, self.numbers = options, options.folder, [], {}
        for name in ("", "eyes", "small", "psf"):
            (self.folder / name).mkdir(parents=True, exist_ok=True)

    def sturm(self, *arguments):
        subprocess.run([str(self.options.sturm), *map(str, arguments)], check=True, cwd=ROOT, stdout=subprocess.DEVNULL)

    def keep(self, name, label, shrink):
        """Notes a picture for the sheet and makes its small version."""
        picture = (self.folder / f"{name}.png").read_bytes()
        (self.folder / f"small/{name}.png").write_bytes(png_rows.encode(shrunk(png_rows.decode(picture), shrink)))
        self.sheet.append((name, label))
        print(name, label, flush=True)

    def room(self):
        """The desk through a pinhole. Its eye does not matter."""
        width, height = self.options.width, self.options.width * 3 // 4
        vfov = math.degrees(2 * math.atan(math.tan(math.radians(FIELD_DEG / 2)) * height / width))
        view = json.loads((ROOT / "configs/views/desk.json").read_text(encoding="utf-8"))
        view["scene"] = str(ROOT / "configs/scenes/desk.json")
        view["camera"].update(vfov_deg=vfov, resolution=[width, height])
        view["eye"] = {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 0}
        view["method"]["samples_per_pixel"] = self.options.samples
        (self.folder / "room.json").write_text(json.dumps(view, indent=1), encoding="utf-8")
        if not (self.folder / "room.exr").exists():
            self.sturm("render", self.folder / "room.json", "-o", self.folder / "room.exr")
        self.keep("room", "All in focus", 2)

    def eye_file(self, name):
        path = self.folder / f"eyes/{name}.json"
        path.write_text(json.dumps(EYES[name][1], indent=1), encoding="utf-8")
        return path

    def spreads(self, name):
        """Numbers in white light at the chart and at the card."""
        spec = {"format": "sturm.psf/1", "eye": str(self.eye_file(name)), "lights": [{"spectrum": "luminance", "step_nm": 20}], "distances_m": [CHART_M, CARD_M],
                "comparison": {"cells_arcmin": [1], "field_arcmin": 97}, "picture": {"size_px": 129, "pixel_arcmin": 0.75}}
        document, result = self.folder / f"psf/{name}.json", self.folder / f"psf/{name}_result.json"
        document.write_text(json.dumps(spec, indent=1), encoding="utf-8")
        self.sturm("psf", document, "-o", result, "--images", self.folder / f"psf/{name}.exr")
        waves = [entry for entry in json.loads(result.read_text(encoding="utf-8"))["results"] if entry["model"] == "waves"]
        return [{"distance_m": entry["distance_m"], "strehl": entry["strehl_peak"], "visual_strehl": entry["visual_strehl"],
                 "r50_arcmin": next(e["radius_about_centroid_arcmin"] for e in entry["energy"] if e["share"] == 0.5)} for entry in waves]

    def eyes(self):
        for name, (label, _) in EYES.items():
            chart, card = self.numbers[name] = self.spreads(name)
            self.sturm("see", self.folder / "room.exr", "--eye", self.eye_file(name), "--parts", 4, "-o", self.folder / f"{name}.png")
            self.keep(name, f"{label}; chart: Strehl {chart['strehl']:.2g}, half of the light within {radius(chart)}; card: {card['strehl']:.2g}, {radius(card)}", 2)

    def rack(self, frames=5):
        farthest, nearest = 1 / CHART_M, 1 / CARD_M
        self.sturm("see", self.folder / "room.exr", "--eye", self.eye_file("measured"), "--rack-focus-D", farthest, nearest, "--frames", frames,
                   "--parts", 4, "-o", self.folder / "rack.png")
        for i in range(frames):
            focus = farthest + (nearest - farthest) * i / (frames - 1)
            self.keep(f"rack_{i + 1:04d}", f"Rack focus, Hofer 5 accommodating to {1 / focus:.2g} m", 4)

    def motorcycle(self):
        data = self.options.skimage
        if not (data / "motorcycle_disp.npz").exists():
            print(f"no motorcycle in {data}: install python3-skimage to see it")
            return
        disparities, width = disparity_map(data / "motorcycle_disp.npz")
        depths = stretched(disparities, self.options.stretch)
        (self.folder / "motorcycle_disparity.pfm").write_bytes(pfm(disparities, width))
        (self.folder / "motorcycle_stretched.pfm").write_bytes(pfm(depths, width))
        hfov = math.degrees(2 * math.atan(width / 2 / CALIBRATION["--focal-px"]))
        calibration = [word for pair in CALIBRATION.items() for word in pair]
        near = 1 / min(depth for depth in depths if depth > 0)
        cases = [("motorcycle_true", "motorcycle_disparity.pfm", ["--disparity", *calibration], 0.47, "its own depth, 2.1 to 5 m; focus on the front"),
                 ("motorcycle_far", "motorcycle_stretched.pfm", [], 0.2, f"depth stretched {self.options.stretch:g} times, not the scene's own; focus on the wall"),
                 ("motorcycle_near", "motorcycle_stretched.pfm", [], near, f"depth stretched {self.options.stretch:g} times, not the scene's own; focus on the front")]
        for name, depth, options, focus, label in cases:
            self.sturm("see", data / "motorcycle_left.png", "--depth", self.folder / depth, *options, "--hfov-deg", hfov, "--eye", self.eye_file("ideal"),
                       "--focus-D", focus, "-o", self.folder / f"{name}.png")
            self.keep(name, f"Motorcycle (Middlebury 2014): {label}", 2)

    def write_sheet(self, columns=3, cell=460, line=18):
        cells = []
        for i, (name, label) in enumerate(self.sheet):
            small = (self.folder / f"small/{name}.png").read_bytes()
            width, height = png_rows.size(small)
            x, y = i % columns * cell + 5, i // columns * 410 + 5
            text = "".join(f'<tspan x="{x}" dy="{line}">{part}</tspan>' for part in wrapped(label, 66))
            cells.append(f'<image x="{x}" y="{y}" width="{min(cell - 10, 2 * width)}" height="{min(cell - 10, 2 * width) * height // width}" '
                         f'href="data:image/png;base64,{base64.b64encode(small).decode()}"/><text x="{x}" y="{y + 340}">{text}</text>')
        rows = (len(self.sheet) + columns - 1) // columns
        (self.folder / "sheet.svg").write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{columns * cell}" height="{rows * 410}" font-family="sans-serif" font-size="13">'
            f'<rect width="100%" height="100%" fill="white"/>{"".join(cells)}</svg>\n', encoding="utf-8")
        (self.folder / "numbers.json").write_text(json.dumps(self.numbers, indent=1) + "\n", encoding="utf-8")


def radius(spread):
    return "—" if spread["r50_arcmin"] is None else f"{spread['r50_arcmin']:.3g}′"


def wrapped(text, most):
    lines = [""]
    for word in text.split():
        if len(lines[-1]) + len(word) >= most:
            lines.append("")
        lines[-1] = f"{lines[-1]} {word}".strip()
    return lines


def linear(byte):
    v = byte / 255
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


def shrunk(rows, factor):
    """The mean light of factor × factor pixels."""
    light = [linear(byte) for byte in range(256)]

    def encoded(value):
        return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))

    small = []
    for y in range(0, len(rows) - factor + 1, factor):
        block = rows[y:y + factor]
        small.append([tuple(encoded(sum(light[row[x + i][c]] for row in block for i in range(factor)) / factor ** 2) for c in range(3))
                      for x in range(0, len(rows[0]) - factor + 1, factor)])
    return small


def disparity_map(file):
    """Numbers from the top, and how many there are in a row: one array of little-endian floats in NumPy's format 1."""
    with zipfile.ZipFile(file) as archive:
        content = archive.read(archive.namelist()[0])
    start = 10 + struct.unpack_from("<H", content, 8)[0]
    header = content[10:start].decode("latin-1")
    if "'<f4'" not in header or "False" not in header:
        raise SystemExit(f"{file}: another kind of array: {header}")
    width = int(header.split("(")[1].split(")")[0].split(",")[1])
    return struct.unpack(f"<{(len(content) - start) // 4}f", content[start:]), width


def stretched(disparities, factor):
    """Distances [m] whose vergences are `factor` times as far from that of the farthest place; 0 where there is none."""
    strength = CALIBRATION["--focal-px"] * CALIBRATION["--baseline-m"]
    vergences = [(d + CALIBRATION["--doffs-px"]) / strength if math.isfinite(d) else None for d in disparities]
    farthest = min(v for v in vergences if v is not None)
    return [0.0 if v is None else 1 / (farthest + factor * (v - farthest)) for v in vergences]


def pfm(numbers, width):
    lines = [numbers[i:i + width] for i in range(0, len(numbers), width)]
    return f"Pf\n{width} {len(lines)}\n-1.0\n".encode() + b"".join(struct.pack(f"<{width}f", *line) for line in reversed(lines))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--sturm", type=lambda name: pathlib.Path(name).resolve(), default=ROOT / "build/release/bin/sturm")
    parser.add_argument("--width", type=int, default=816, help="of the room's pictures [px]; with 816 there are 11 planes")
    parser.add_argument("--samples", type=int, default=64, help="paths for each pixel of the room")
    parser.add_argument("--skimage", type=pathlib.Path, default=MOTORCYCLE, help="folder of skimage's pictures")
    parser.add_argument("--stretch", type=float, default=8, help="factor of the motorcycle's range of depth in dioptres")
    figures = Figures(parser.parse_args())
    figures.room()
    figures.eyes()
    figures.rack()
    figures.motorcycle()
    figures.write_sheet()
