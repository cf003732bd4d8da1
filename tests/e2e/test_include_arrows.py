"""The arrows between the rooms: who may include whom. The two predictors never see each other."""
import pathlib
import re
import tempfile
import unittest

from sturm_process import SOURCE

# Which rooms a room may include besides itself.
ARROWS = {
    "lensmodel": set(),
    "io": {"lensmodel"},
    "pathtrace": {"lensmodel", "io"},
    "conoid": {"lensmodel", "io"},
    "wavefront": {"lensmodel", "io"},
    "compare": {"lensmodel", "io"},
    "reports": {"lensmodel", "io", "compare"},
    "stages": {"lensmodel", "io", "pathtrace", "conoid", "wavefront", "compare"},
    "experiments": {"lensmodel", "io", "pathtrace", "conoid", "wavefront", "compare", "reports", "stages"},
    "server": {"lensmodel", "io", "compare", "reports", "stages"},
    "app": {"lensmodel", "io", "pathtrace", "conoid", "wavefront", "compare", "reports", "stages", "experiments", "server"},
    "python": {"lensmodel", "io", "pathtrace", "conoid", "wavefront", "compare", "stages"},
    "viewer": {"lensmodel", "io", "pathtrace", "conoid", "stages"},
}

# The subfolders of a room from the ground up: each may include itself and those before it; those on one line do not see each other.
# "" is the room's own folder. What a subfolder has below itself belongs to it.
FLOORS = {
    "lensmodel": [[""]],
    "io": [["files"], ["json"], ["images"], ["specs"]],
    "pathtrace": [["sampling"], ["materials"], ["lights"], ["scene"], ["cameras"], ["plan"], ["integrator"], ["guide"], ["film"]],
    "conoid": [["threads"], ["tracing"], ["blur_field"], ["pictures"]],
    "wavefront": [["fft"], ["fitting", "psf"], ["layers"]],
    "compare": [["statistics"], ["metrics"], ["ellipses", "images", "psf"], ["gates"], ["studies"], ["findings"]],
    "reports": [["markup"], ["plots", "viewer"], ["text", "sections"], ["page"]],
    "stages": [["plan", "page"], [""]],
    "experiments": [["run"], ["figures"], ["standard", "lens_study", "sin2_study", "design_study", "samplings", "depth_psf", "bench", "stress"], [""]],
    "server": [[""]],
    "app": [[""]],
    "python": [[""]],
    "viewer": [["core"]],
}
# Libraries that one room alone may include.
OWN_LIBRARIES = {
    "embree3": {"pathtrace"},
    "assimp": {"pathtrace"},
    "OpenEXR": {"io"},
    "OpenImageIO": {"io"},
    "opencv2": {"io", "compare", "reports", "wavefront"},
    "openssl": {"io"},
    "png.h": {"io"},
    "valijson": {"io"},
    "CLI": {"app"},
    "httplib.h": {"server"},
    "pybind11": {"python"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)
SUFFIXES = {".h", ".hpp", ".cpp", ".cc", ".inl"}


def sources_of(root, room):
    return sorted(path for path in (root / room).rglob("*") if path.suffix in SUFFIXES)


def floor_of(path):
    """(room, subfolder, floor) of a path from the root; the floor is None where the subfolder is unknown."""
    room, *inside = pathlib.PurePosixPath(path).parts
    subfolder = inside[0] if len(inside) > 1 else ""
    floors = [i for i, names in enumerate(FLOORS[room]) if subfolder in names]
    return room, subfolder, floors[0] if floors else None


def allowed(path, target):
    folder, _, inside = target.partition("/")
    if folder in {"..", ".", "tests"}:
        return False
    room, subfolder, floor = floor_of(path)
    if folder in OWN_LIBRARIES:
        return room in OWN_LIBRARIES[folder]
    if not inside or folder not in ARROWS:
        return True  # <compare> is the standard library's
    if folder != room:
        return folder in ARROWS[room]
    _, target_subfolder, target_floor = floor_of(target)
    if floor is None or target_floor is None:
        return False
    return target_subfolder == subfolder or target_floor < floor


def violations(root):
    """"FILE includes TARGET" for every include that the arrows do not allow, or that leaves the source tree."""
    return [
        f"{path.relative_to(root)} includes {target}"
        for room in ARROWS
        for path in sources_of(root, room)
        for target in INCLUDE.findall(path.read_text(encoding="utf-8"))
        if not allowed(path.relative_to(root), target)
    ]


class IncludeArrows(unittest.TestCase):
    def test_every_room_has_sources_and_keeps_the_arrows(self):
        for room in ARROWS:
            self.assertTrue(sources_of(SOURCE, room), room)
        self.assertEqual(violations(SOURCE), [])

    def test_there_is_no_room_or_subfolder_without_arrows(self):
        found = {path.parent.name for path in SOURCE.glob("*/CMakeLists.txt")} - {"tests", "examples"}
        self.assertEqual(found, set(ARROWS))
        for room in ARROWS:
            subfolders = {floor_of(path.relative_to(SOURCE))[1] for path in sources_of(SOURCE, room)}
            self.assertEqual(subfolders, {name for names in FLOORS[room] for name in names}, room)

    def test_no_arrow_leads_up_and_back(self):
        for room, below in ARROWS.items():
            for other in below:
                self.assertNotIn(room, ARROWS[other], f"{room} and {other} include each other")

    def test_every_room_says_what_lives_there(self):
        for room in ARROWS:
            lines = (SOURCE / room / "README.md").read_text(encoding="utf-8").splitlines()
            self.assertTrue(12 <= len(lines) <= 20, f"{room}/README.md has {len(lines)} lines")

    def scan(self, file, line):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / file
            path.parent.mkdir(parents=True)
            path.write_text(f"#pragma once\n{line}\n")
            return violations(pathlib.Path(folder))

    def test_forbidden_includes_are_seen(self):
        for file, line in [
            ("pathtrace/film/a.cpp", '#include "conoid/tracing/footprint.h"'),
            ("conoid/tracing/deep/a.h", '  #  include "pathtrace/scene/scene.h"'),
            ("compare/psf/a.h", "#include <pathtrace/scene/scene.h>"),
            ("lensmodel/a.h", '#include "io/json/json.h"'),
            ("io/specs/a.cpp", '#include "compare/gates/gates.h"'),
            ("conoid/pictures/a.cpp", '#include "app/commands.h"'),
            ("conoid/pictures/a.cpp", '#include "../pathtrace/scene/scene.h"'),
            ("stages/a.cpp", '#include "reports/plots/lens_map.h"'),
            ("reports/page/a.cpp", '#include "stages/ellipse_stage.h"'),
            # Within a room: up a floor, and from one door to the next.
            ("pathtrace/guide/a.cpp", '#include "pathtrace/film/render.h"'),
            ("pathtrace/sampling/a.h", '#include "pathtrace/cameras/eye_camera.h"'),
            ("compare/gates/a.h", '#include "compare/findings/gate_statistics.h"'),
            ("compare/psf/a.h", '#include "compare/ellipses/bundle_moments.h"'),
            ("experiments/run/a.cpp", '#include "experiments/runner.h"'),
            ("experiments/bench/a.cpp", '#include "experiments/stress/suite.h"'),
            ("stages/plan/a.cpp", '#include "stages/render_stage.h"'),
            ("io/json/a.cpp", '#include "io/specs/eye_spec.h"'),
            ("io/unknown/a.cpp", '#include "io/files/error.h"'),
            # Libraries of other rooms.
            ("reports/page/a.cpp", "#include <embree3/rtcore.h>"),
            ("conoid/pictures/a.h", "#include <embree3/rtcore.h>"),
            ("stages/a.cpp", "#include <CLI/CLI.hpp>"),
            ("app/a.cpp", "#include <pybind11/numpy.h>"),
            ("python/a.cpp", '#include "app/commands.h"'),
            ("conoid/pictures/a.cpp", "#include <opencv2/imgproc.hpp>"),
            ("experiments/run/a.cpp", "#include <openssl/evp.h>"),
        ]:
            with self.subTest(file=file, line=line):
                self.assertEqual(len(self.scan(file, line)), 1)

    def test_allowed_includes_pass(self):
        for file, line in [
            ("app/a.cpp", '#include "pathtrace/scene/scene.h"'),
            ("conoid/tracing/a.cpp", '#include "lensmodel/eye.h"'),
            ("conoid/pictures/a.cpp", '#include "conoid/tracing/footprint.h"'),
            ("compare/studies/sin2/a.cpp", '#include "compare/studies/bench/curve.h"'),
            ("compare/findings/a.cpp", '#include "compare/gates/gates.h"'),
            ("lensmodel/a.h", "#include <vector>"),
            ("lensmodel/a.h", "#include <compare>"),
            ("pathtrace/scene/a.h", "#include <embree3/rtcore.h>"),
            ("pathtrace/film/a.cpp", '// not #include "conoid/tracing/footprint.h"'),
        ]:
            with self.subTest(file=file, line=line):
                self.assertEqual(self.scan(file, line), [])


if __name__ == "__main__":
    unittest.main()
