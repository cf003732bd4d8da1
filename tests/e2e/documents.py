"""Small valid documents; each test changes what it is about."""
import copy
import json

from sturm_process import CORNELL_BOX

_QUERY = {
    "format": "sturm.ellipse/1",
    "eye": {
        "prescription": {"sphere_D": -2.0, "cylinder_D": -1.5, "axis_deg": 30, "vertex_distance_mm": 0},
        "pupil_diameter_mm": 4.0,
        "accommodation": {"mode": "relaxed"},
    },
    "targets": [{"gaze_deg": [0, 0], "distance_m": 1.0}],
    "methods": ["conoid"],
}

_SPECTACLES = {
    "vertex_distance_mm": 12, "center_thickness_mm": 2, "refractive_index": 1.5, "diameter_mm": 70,
    "front": {"type": "conic", "radius_mm": 250, "conic_constant": -1.2},
    "back": {"type": "torus", "sweep_radius_mm": 125, "generator_radius_mm": 91, "sweep_meridian_deg": 30},
}

_CAMERA = {
    "position_m": [0.278, 0.273, -0.8],
    "look_at_m": [0.278, 0.273, 0.0],
    "up": [0, 1, 0],
    "vfov_deg": 39.3077,
    "resolution": [48, 48],
}

_VIEW = {
    "format": "sturm.render/1",
    "scene": str(CORNELL_BOX),
    "camera": _CAMERA,
    "eye": {
        "prescription": {"sphere_D": -1.5, "cylinder_D": -4, "axis_deg": 55, "vertex_distance_mm": 12},
        "pupil_diameter_mm": 6,
        "accommodation": {"mode": "relaxed"},
    },
    "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": 16, "max_bounces": 4},
    "seed": 1,
}

# Two triangles in front of a camera at the origin, lit by a lamp: for tests that need a scene but no picture.
_TWO_TRIANGLES = {
    "format": "sturm.scene/1",
    "materials": {"grey": {"albedo": [0.5, 0.5, 0.5]}},
    "meshes": [{"material": "grey", "positions_m": [[-1, -1, -2], [1, -1, -2], [1, 1, -2], [-1, 1, -2]], "faces": [[0, 1, 2, 3]]}],
    "lights": [{"type": "point", "position_m": [0, 0, 0], "intensity": [1, 1, 1]}],
}

_EXPERIMENT = {
    "format": "sturm.experiment/1",
    "title": "Two eyes",
    "seed": 1,
    "ellipses": {
        "prescriptions": [
            {"id": "oblique", "sphere_D": -2.5, "cylinder_D": -3.25, "axis_deg": 35, "vertex_distance_mm": 12},
            {"id": "myope", "sphere_D": -3, "vertex_distance_mm": 12},
        ],
        "distances_m": [1, "inf"],
        "pupil_diameters_mm": [4],
        "accommodation": {"mode": "relaxed"},
        "ray_models": ["thin_lens", "metalstigmatism", "sin2_radial", "power_matrix"],
        "rays": {"count": 1024, "replicates": 16},
    },
    "psfs": [
        {"id": "spot", "prescription": "oblique", "distance_m": 1.0, "pupil_diameter_mm": 4, "ray_models": ["power_matrix", "sin2_radial"],
         "resolution": 24, "samples_per_pixel": 64}
    ],
    "images": [
        {"id": "box", "scene": str(CORNELL_BOX), "camera": {**_CAMERA, "resolution": [32, 32]}, "prescription": "oblique",
         "pupil_diameter_mm": 4, "ray_models": ["power_matrix"], "samples_per_pixel": 16, "replicates": 2}
    ],
    "gates": "gates.json",
}

_GATES = {
    "format": "sturm.gates/1",
    "gates": [
        {"id": "matrix_equals_conoid", "title": "Rays have the conoid's ellipse", "statistic": "matrix_vs_conoid_max_relative",
         "comparison": "at_most", "bound": 0.005, "reason": "16 x 1024 independent points would scatter by 0.8 %; scrambled Sobol points scatter far less"},
        {"id": "sin2_differs", "title": "sin2 is told apart", "statistic": "sin2_vs_conoid_min_z", "comparison": "differs", "bound": 6,
         "unit": "σ", "reason": "as in the shipped gates"},
    ],
}


def json_text(document):
    return json.dumps(document, indent=1)


def query():
    return copy.deepcopy(_QUERY)


def spectacles():
    return copy.deepcopy(_SPECTACLES)


def view():
    return copy.deepcopy(_VIEW)


def two_triangles():
    return copy.deepcopy(_TWO_TRIANGLES)


def experiment():
    return copy.deepcopy(_EXPERIMENT)


def gates():
    return copy.deepcopy(_GATES)


def _parent_and_key(document, pointer):
    *path, last = pointer.strip("/").split("/")
    for token in path:
        document = document[int(token) if isinstance(document, list) else token]
    return document, int(last) if isinstance(document, list) else last


def changed(document, pointer, value):
    """A copy of the document with one member (JSON pointer) set; a missing last key is made."""
    document = copy.deepcopy(document)
    place, key = _parent_and_key(document, pointer)
    place[key] = value
    return document


def without(document, pointer):
    """A copy of the document with one member (JSON pointer) removed."""
    document = copy.deepcopy(document)
    place, key = _parent_and_key(document, pointer)
    del place[key]
    return document
