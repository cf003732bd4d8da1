"""Questions to the core that runs in node, in a page and natively: as documents of sturm.ellipse/1, and as numbers of the core (core_answers.js)."""
import json
import math
import os
import pathlib
import subprocess

from sturm_process import PASSED, SOURCE, strict_json, sturm
from viewer_page import TEMPLATE, view_of

CORE = pathlib.Path(os.environ.get("VIEWER_BUILD", SOURCE / "build")) / "wasm/sturm_core.js"
SCRIPT = pathlib.Path(__file__).with_name("core_bits.cjs")
PRESCRIPTION_TARGETS = [{"gaze_deg": [20, -15], "distance_m": 0.4}, {"gaze_deg": [0, 0], "distance_m": "inf"}]
LENS_TARGETS = [{"gaze_deg": gaze, "distance_m": d} for gaze, d in
                [([0, 0], "inf"), ([25, 10], 2), ([-12, -28], 0.4), ([3, -20], 0.35), ([-35, 30], 1)]]


def core(*arguments, stdin=None):
    """What core_bits.cjs prints."""
    process = subprocess.run(["node", SCRIPT, CORE, *arguments], input=stdin, capture_output=True, text=True, timeout=120)
    if process.returncode:
        raise AssertionError(process.stderr)
    return strict_json(process.stdout)


def radians(targets):
    """Targets of a query as the core takes them."""
    return [[*(angle * (math.pi / 180.0) for angle in target["gaze_deg"]), target["distance_m"]] for target in targets]


def prescription_queries():
    """The 413 real prescriptions: documents, and the same for the core."""
    lines = (SOURCE / "configs/data/papila_prescriptions.csv").read_text().splitlines()[2:]
    accommodation = {"mode": "best", "amplitude_D": 1.5}
    documents, numbers = [], []
    for sphere, cylinder, axis in ([float(x) for x in line.split(",")[4:7]] for line in lines):
        written = {"sphere_D": sphere, "cylinder_D": cylinder, "axis_deg": axis}
        documents.append({"format": "sturm.ellipse/1", "targets": PRESCRIPTION_TARGETS, "methods": ["conoid"], "eye": {
            "prescription": {**written, "vertex_distance_mm": 12}, "pupil_diameter_mm": 4, "accommodation": accommodation}})
        numbers.append({"lens": None, "targets": radians(PRESCRIPTION_TARGETS), "eye": {
            "prescription": {**written, "vertex_distance_m": 12e-3, "prism_cm_per_m": 0, "prism_base_deg": 0}, "wavefront": None,
            "pupil_diameter_m": 4e-3, "rotation_center_m": 13.5e-3, "accommodation": accommodation}})
    return documents, numbers


def lens_queries(folder):
    """All shipped lenses in five gazes; the core's numbers are those that `sturm view` puts into a page. Writes into the folder."""
    eye = {"prescription": {"sphere_D": -2, "cylinder_D": -1.5, "axis_deg": 30}, "pupil_diameter_mm": 4,
           "accommodation": {"mode": "best", "amplitude_D": 1}}
    template, view, page = (folder / name for name in ("template.html", "lens_view.json", "lens_page.html"))
    template.write_text(TEMPLATE)
    scene = {"format": "sturm.scene/1", "materials": {"a": {}}, "spheres": [{"center_m": [0, 0, -2], "radius_m": 0.1, "material": "a"}]}
    camera = {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [8, 8], "gaze": "foveal"}
    documents, numbers = [], []
    for file in sorted((SOURCE / "configs/lenses").glob("*.json")):
        documents.append({"format": "sturm.ellipse/1", "eye": eye, "spectacles": str(file), "targets": LENS_TARGETS, "methods": ["conoid"]})
        view.write_text(json.dumps({"format": "sturm.render/1", "eye": eye, "spectacles": str(file), "scene": scene, "camera": camera,
                                    "method": {"type": "predict", "prediction": "multipass"}}))
        process = sturm("view", view, "-o", page, "--template", template)
        if process.returncode != PASSED:
            raise AssertionError(process.stderr)
        numbers.append({**view_of(page.read_text())["right"], "targets": radians(LENS_TARGETS)})
    return documents, numbers
