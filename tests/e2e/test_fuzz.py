"""Mutated queries and views, always the same ones: the program answers, or says what is wrong; it never crashes, hangs or prints NaN."""
import concurrent.futures
import copy
import json
import pathlib
import random
import subprocess
import tempfile
import unittest

import documents
from documents import changed
from sturm_process import PASSED, STURM, WRONG_INPUT, strict_json

ELLIPSE_MUTATIONS, RENDER_MUTATIONS = 220, 80
SECONDS = 20  # for one process on a busy machine; each needs a fraction of a second

# No value makes much work: a mutated resolution or ray count is either small or out of range.
VALUES = [None, True, False, 0, 1, -1, 2, 7, 0.5, -0.0, 1e-320, 1e-9, 90, -90, 180, 360, 1e308, -1e308, 2**53 + 1, 2**63, -(2**63), 2**64, "", "inf",
          "-inf", "nan", "1", "relaxed", "best", "\0", "ä\u202e\U0001f441", "a" * 5000, "../../etc/passwd", "/dev/null", "/", ".", [], [[]], {}, [0, 0],
          [0, 0, 0], [1, 2, 3, 4], {"format": 1}, {"": None}]
SNIPPETS = [b"", b"{", b"}", b"[", b"]", b",", b":", b'"', b"\\", b"\\u0000", b"\\ud800", b"\xff", b"\x00", b"-", b"e", b"0", b".", b"NaN", b"1e999", b"//"]


def places(node, path=()):
    """Every member of a document: (path to its parent, key)."""
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else []
    for key, child in children:
        yield path, key
        yield from places(child, path + (key,))


def mutate_structure(document, rng):
    document = copy.deepcopy(document)
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        path, key = rng.choice(list(places(document)) or [((), None)])
        if key is None:
            break
        parent = document
        for step in path:
            parent = parent[step]
        action = rng.randrange(4)
        if action == 0:
            del parent[key]
        elif action == 1 and isinstance(parent, dict):
            parent[key + rng.choice("_s ~/")] = parent.pop(key)
        elif action == 2 and isinstance(parent, list):
            parent.extend([parent[key]] * rng.choice((1, 3)))
        else:
            parent[key] = rng.choice(VALUES)
    return json.dumps(document).encode()


def mutate_text(document, rng):
    text = bytearray(json.dumps(document).encode())
    for _ in range(rng.choice((1, 1, 2, 5))):
        at = rng.randrange(len(text))
        text[at:at + rng.choice((0, 1, 1, 8))] = rng.choice(SNIPPETS)
    return bytes(text[:rng.randrange(len(text))] if rng.random() < 0.1 else text)


def ellipse_seed_document():
    query = documents.query()
    query["methods"] = ["conoid", "conoid_published", "previous", "rays:sin2_radial", "rays:metalstigmatism", "rays:power_matrix"]
    query["targets"].append({"gaze_deg": [20, -10], "distance_m": "inf"})
    query["eye"]["accommodation"] = {"mode": "fixed", "focus_distance_m": 2}
    return {**query, "rays": {"count": 64, "replicates": 2, "sequence": "sobol"}, "seed": 1,
            "spectacles": documents.spectacles()}


def render_seed_document():
    view = changed(documents.view(), "/scene", {**documents.two_triangles(), "spheres": [{"center_m": [0, 0, -3], "radius_m": 0.5, "material": "grey"}]})
    view["camera"].update({"position_m": [0, 0, 0], "look_at_m": [0, 0, -2], "resolution": [4, 3]})
    view["method"]["samples_per_pixel"] = 1
    return view


class Fuzz(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="sturm_fuzz_")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def mutants(self, document, count, seed):
        rng = random.Random(seed)
        yield json.dumps(document).encode()
        for _ in range(count):
            yield rng.choice((mutate_structure, mutate_structure, mutate_text))(document, rng)

    def run_all(self, document, count, seed, arguments):
        """(text, process, its own folder) of each mutant."""
        def run(numbered):
            number, text = numbered
            folder = self.folder / str(number)
            folder.mkdir()
            (folder / "document.json").write_bytes(text)
            process = subprocess.run([STURM, *arguments], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS, check=False)
            return text, process, folder

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            return list(pool.map(run, enumerate(self.mutants(document, count, seed))))

    def check(self, text, process):
        shown = f"exit status {process.returncode}\n{text.decode('utf-8', 'replace')}\n{process.stderr.decode('utf-8', 'replace')}"
        # No status 3: the folder can be written and the program's modules are there.
        self.assertIn(process.returncode, (PASSED, WRONG_INPUT), shown)
        if process.returncode == WRONG_INPUT:
            self.assertRegex(process.stderr.decode("utf-8", "replace"), "(?m)^error: .", shown)
            self.assertEqual(process.stdout, b"", shown)
            self.assertNotIn(b"json.exception", process.stderr, shown)
        return shown

    def test_ellipse(self):
        accepted = 0
        for text, process, _ in self.run_all(ellipse_seed_document(), ELLIPSE_MUTATIONS, 1, ["ellipse", "document.json"]):
            with self.subTest():
                shown = self.check(text, process)
                if process.returncode == PASSED:
                    accepted += 1
                    self.assertTrue(strict_json(process.stdout)["results"], shown)
        # Harmless mutations exist, harmful ones are the rule.
        self.assertTrue(5 <= accepted <= ELLIPSE_MUTATIONS // 2, accepted)

    def test_render(self):
        accepted = 0
        for text, process, folder in self.run_all(render_seed_document(), RENDER_MUTATIONS, 2, ["render", "document.json", "-o", "a.exr", "--quiet"]):
            with self.subTest():
                shown = self.check(text, process)
                accepted += process.returncode == PASSED
                files = {path.name for path in folder.iterdir()}
                expected = {"document.json", "a.exr", "a.png", "a.manifest.json"} if process.returncode == PASSED else {"document.json"}
                self.assertEqual(files, expected, shown)
        self.assertTrue(5 <= accepted <= RENDER_MUTATIONS // 2, accepted)


if __name__ == "__main__":
    unittest.main()
