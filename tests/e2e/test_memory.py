"""A large scene at a usual size of picture stays well below the memory of a small machine."""
import math
import resource
import unittest

import documents
from documents import changed
from sturm_process import FolderTest, strict_json

SIDE = 708  # quadrilaterals along each side of the height field: 2 × 708² = 1.0026 million triangles
LIMIT_BYTES = 1.5e9


def height_field():
    """An OBJ of hills 3 m ahead, wider than the view."""
    lines = []
    for row in range(SIDE + 1):
        for column in range(SIDE + 1):
            depth = 3 + 0.3 * math.sin(0.05 * column) * math.cos(0.07 * row)
            lines.append(f"v {4 * column / SIDE - 2:.5f} {2.4 * row / SIDE - 1.2:.5f} {-depth:.5f}")
    for row in range(SIDE):
        for column in range(SIDE):
            a = row * (SIDE + 1) + column + 1
            c = a + SIDE + 2
            lines.append(f"f {a} {a + 1} {c}\nf {a} {c} {c - 1}")
    return "\n".join(lines) + "\n"


class Memory(FolderTest):
    def test_a_million_triangles_with_all_layers(self):
        self.write("hills.obj", height_field())
        view = changed(documents.view(), "/scene", {"models": [{"file": "hills.obj"}], "environment": {"radiance": [1, 1, 1]}})
        view["camera"] = {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [1280, 720]}
        view["method"].update(samples_per_pixel=1, max_bounces=2)
        path = self.write("view.json", view)
        self.succeed("render", path, "-o", self.folder / "hills.exr", "--quiet", timeout=600)
        manifest = strict_json((self.folder / "hills.manifest.json").read_text())
        self.assertEqual(manifest["counters"]["triangles"], 2 * SIDE * SIDE)
        # The largest child of this test is that run; the operating system and the manifest tell the same, but for what comes after the manifest:
        # the exit of a hundred megabytes of shared libraries for image formats reads pages of theirs that nothing needed before (7 MB).
        measured = 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLess(measured, LIMIT_BYTES)
        stated = manifest["provenance"]["peak_memory_bytes"]
        self.assertLessEqual(stated, measured)
        self.assertGreater(stated, measured - 12e6)
        # It can be measured at all: the picture's 13 channels alone are 48 MB.
        self.assertGreater(measured, 1280 * 720 * 13 * 4)
        print(f"peak memory: {measured / 1e6:.0f} MB")


if __name__ == "__main__":
    unittest.main()
