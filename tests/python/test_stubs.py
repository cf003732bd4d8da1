"""The stubs say what the module has, and everything public says what it does."""
import ast
import inspect
import pathlib
import re
import sys
import unittest

import sturm
from sturm import _core

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import python_reference  # noqa: E402

STUBS = ast.parse(pathlib.Path(sturm.__file__).with_name("_core.pyi").read_text(encoding="utf-8"))


def stub_parameters(function):
    """Names of the parameters, and which of them have a default."""
    arguments = function.args.posonlyargs + function.args.args
    optional = len(arguments) - len(function.args.defaults)
    return [(argument.arg, i >= optional) for i, argument in enumerate(arguments)]


def real_parameters(function):
    """The same of a function of pybind11, whose docstring starts with its signature."""
    signature = re.match(r"\w+\((.*)\)(?: -> .*)?\n?", function.__doc__.splitlines()[0]).group(1)
    parts = re.split(r", (?=\w+(?::| =|$|,))", signature) if signature else []
    return [(part.split(":")[0].strip(), " = " in part) for part in parts]


class Stubs(unittest.TestCase):
    def assert_functions_agree(self, stubs, owner):
        for stub in stubs:
            if isinstance(stub, ast.FunctionDef):
                real = inspect.getattr_static(owner, stub.name)
                with self.subTest(f"{owner.__name__}.{stub.name}"):
                    if any(isinstance(d, ast.Name) and d.id == "property" for d in stub.decorator_list):
                        self.assertIsInstance(real, property)
                        self.assertTrue(real.__doc__)
                    else:
                        self.assertEqual(real_parameters(getattr(owner, stub.name)), stub_parameters(stub))

    def test_functions(self):
        self.assert_functions_agree(STUBS.body, _core)

    def test_classes(self):
        for stub in STUBS.body:
            if isinstance(stub, ast.ClassDef):
                self.assert_functions_agree(stub.body, getattr(_core, stub.name))

    def names_in(self, body):
        return {s.name for s in body if isinstance(s, (ast.FunctionDef, ast.ClassDef))} | {s.target.id for s in body if isinstance(s, ast.AnnAssign)}

    def test_nothing_is_left_out(self):
        real = {name for name in vars(_core) if not name.startswith("_") or name in ("__version__", "__commit__")}
        self.assertEqual(self.names_in(STUBS.body), real)
        for stub in STUBS.body:
            if isinstance(stub, ast.ClassDef):
                members = {name for name in vars(getattr(_core, stub.name)) if not name.startswith("_")} | {"__init__"}
                self.assertEqual(self.names_in(stub.body), members, stub.name)


class Docstrings(unittest.TestCase):
    def test_the_reference_page_has_those_of_the_module(self):
        """It reads them in the sources of the bindings, where the module has them from; pybind11 puts signatures before those of functions."""
        bound = python_reference.bound_docstrings()
        for name, text in bound.items():
            owner, _, member = name.rpartition(".")
            real = inspect.getattr_static(getattr(_core, owner), member) if owner else getattr(_core, name)
            self.assertEqual(inspect.cleandoc(real.__doc__.split("\n\n", 1)[-1] if callable(real) and not inspect.isclass(real) else real.__doc__), inspect.cleandoc(text), name)
        public = {f"{name}.{member}" for name, thing in vars(_core).items() if inspect.isclass(thing) for member in vars(thing) if not member.startswith("_")}
        self.assertEqual({name for name in public - bound.keys()}, set())

    def test_everything_public_has_one(self):
        for name in sturm.__all__:
            thing = getattr(sturm, name)
            if callable(thing):
                self.assertTrue(inspect.getdoc(thing), name)

    def test_all_of_the_package_is_annotated(self):
        for name in sturm.__all__:
            function = getattr(sturm, name)
            if inspect.isfunction(function):
                missing = [p for p in inspect.signature(function).parameters.values() if p.annotation is p.empty]
                self.assertEqual((name, missing), (name, []))

    def test_units_of_names_are_in_their_docstrings(self):
        """What has a unit in its name says it, or names the parameter, where a reader looks for it."""
        unit = re.compile(r"_(m|mm|um|nm|D|deg|rad|px|arcmin)$")
        for name in [*sturm.__all__, *(n for n in vars(_core) if inspect.isclass(getattr(_core, n)))]:
            thing = getattr(sturm, name, None) or getattr(_core, name)
            members = vars(thing) if inspect.isclass(thing) else {}
            for member, value in members.items():
                if not member.startswith("_") and (found := unit.search(member)):
                    self.assertIn(f"[{found[1]}]", inspect.getdoc(value), f"{name}.{member}")
            for parameter in inspect.signature(thing).parameters if inspect.isfunction(thing) else ():
                if found := unit.search(parameter):
                    self.assertIn(f"[{found[1]}]", inspect.getdoc(thing), f"{name}({parameter})")

    def test_fields_of_ellipses_are_in_their_docstring(self):
        rows = sturm.ellipses(sturm.Eye(prescription="-1.00", pupil_diameter_mm=3), 1.0)
        self.assertEqual([field for field in rows.dtype.names if field not in sturm.ellipses.__doc__], [])

    def test_lengths_angles_and_powers_have_a_unit_in_their_name(self):
        for name, parameter in [(n, p) for n in sturm.__all__ if inspect.isfunction(getattr(sturm, n)) for p in inspect.signature(getattr(sturm, n)).parameters]:
            if re.search(r"distance|depth|diameter|azimuth|elevation|fov|vergence|power", parameter):
                self.assertRegex(parameter, r"_(m|mm|deg|D|um)$", f"{name}({parameter})")


if __name__ == "__main__":
    unittest.main()
