"""The arrows between the modules: who may include whom. The two predictors never see each other."""
import pathlib
import re
import tempfile
import unittest

from sturm_process import SOURCE

ARROWS = {
    "lensmodel": set(),
    "io": {"lensmodel"},
    "pathtrace": {"lensmodel", "io"},
    "conoid": {"lensmodel", "io"},
    "compare": {"lensmodel", "io"},
    "reports": {"lensmodel", "io", "compare"},
    "stages": {"lensmodel", "io", "pathtrace", "conoid", "compare"},
    "experiments": {"lensmodel", "io", "pathtrace", "conoid", "compare", "reports", "stages"},
    "app": {"lensmodel", "io", "pathtrace", "conoid", "compare", "reports", "stages", "experiments"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)
SUFFIXES = {".h", ".hpp", ".cpp", ".cc", ".inl"}


def sources_of(root, module):
    return sorted(path for path in (root / module).rglob("*") if path.suffix in SUFFIXES)


def violations(root):
    """"FILE includes TARGET" for every include of a folder of ours that the arrows do not allow, or that leaves the source tree."""
    found = []
    for module, allowed in ARROWS.items():
        for path in sources_of(root, module):
            for target in INCLUDE.findall(path.read_text(encoding="utf-8")):
                folder, _, inside = target.partition("/")
                if not inside and folder in ARROWS:
                    continue  # <compare> is the standard library's
                forbidden_module = folder in ARROWS and folder != module and folder not in allowed
                if forbidden_module or folder in {"..", ".", "tests"}:
                    found.append(f"{path.relative_to(root)} includes {target}")
    return found


class IncludeArrows(unittest.TestCase):
    def test_every_module_has_sources_and_keeps_the_arrows(self):
        for module in ARROWS:
            self.assertTrue(sources_of(SOURCE, module), module)
        self.assertEqual(violations(SOURCE), [])

    def test_there_is_no_module_without_arrows(self):
        found = {path.parent.name for path in SOURCE.glob("*/CMakeLists.txt")} - {"tests"}
        self.assertEqual(found, set(ARROWS))

    def scan(self, file, line):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / file
            path.parent.mkdir(parents=True)
            path.write_text(f"#pragma once\n{line}\n")
            return violations(pathlib.Path(folder))

    def test_forbidden_includes_are_seen(self):
        for file, line in [
            ("pathtrace/a.cpp", '#include "conoid/tracing/footprint.h"'),
            ("conoid/deep/a.h", '  #  include "pathtrace/scene/scene.h"'),
            ("compare/a.h", "#include <pathtrace/scene/scene.h>"),
            ("lensmodel/a.h", '#include "io/json/json.h"'),
            ("io/a.cpp", '#include "compare/gates/gates.h"'),
            ("conoid/a.cpp", '#include "app/commands.h"'),
            ("conoid/a.cpp", '#include "../pathtrace/scene.h"'),
        ]:
            with self.subTest(line=line):
                self.assertEqual(len(self.scan(file, line)), 1)

    def test_allowed_includes_pass(self):
        for file, line in [
            ("app/a.cpp", '#include "pathtrace/scene/scene.h"'),
            ("conoid/a.cpp", '#include "lensmodel/eye.h"'),
            ("conoid/a.cpp", '#include "conoid/tracing/footprint.h"'),
            ("lensmodel/a.h", "#include <vector>"),
            ("pathtrace/a.cpp", '// not #include "conoid/tracing/footprint.h"'),
        ]:
            with self.subTest(line=line):
                self.assertEqual(self.scan(file, line), [])


if __name__ == "__main__":
    unittest.main()
