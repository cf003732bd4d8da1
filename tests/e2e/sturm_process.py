"""The program under test as a child process, and the folders that it works in.

STURM is the program, STURM_SOURCE the root of the source tree (both are set by CTest; by hand they default to build/release).
"""
import hashlib
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("STURM_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
STURM = pathlib.Path(os.environ.get("STURM", SOURCE / "build/release/bin/sturm"))
CORNELL_BOX = SOURCE / "configs/scenes/cornell_box.json"

PASSED, FAILED, WRONG_INPUT, RUNTIME_FAILURE = 0, 1, 2, 3


def sturm(*arguments, stdin=None, cwd=None, timeout=120):
    """Runs the program; returns the finished process with stdout and stderr as text (messages may quote bytes that are not UTF-8)."""
    return subprocess.run([str(STURM), *map(str, arguments)], input=stdin, cwd=cwd, timeout=timeout, capture_output=True,
                          encoding="utf-8", errors="replace")


def strict_json(text):
    """Parses JSON as RFC 8259 has it: Python's own parser lets NaN and Infinity through."""
    def refuse(token):
        raise ValueError(f"{token} is not JSON")

    return json.loads(text, parse_constant=refuse)


def snapshot(folder):
    """Every file below a folder with the hash of its bytes, and every folder."""
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "folder"
        for path in sorted(pathlib.Path(folder).rglob("*"))
    }


class FolderTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="sturm_e2e_")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, name, content):
        """Writes text as it is, bytes as they are, anything else as JSON."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content, indent=1))
        return path

    def succeed(self, *arguments, **options):
        """Runs the program, which must exit with 0."""
        process = sturm(*arguments, **options)
        self.assertEqual(process.returncode, PASSED, process.stderr)
        return process
