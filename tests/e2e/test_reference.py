"""The reference pages of the library and of the Python package: every public name is on them, with its declaration and a docstring."""
import ast
import re
import shutil
import sys
import unittest

from sturm_process import SOURCE

sys.path.insert(0, str(SOURCE / "scripts"))
import cpp_reference  # noqa: E402
import python_reference  # noqa: E402

TYPE = re.compile(r"^(?:struct|class|enum class|using) (\w+)(?: : [\w: ]+)? [{=]", re.MULTILINE)
FUNCTION = re.compile(r"^(?!using|namespace|template|struct|class|enum|inline constexpr|#|//)\w[\w:<>*& ]*[ &*](\w+)\(", re.MULTILINE)


@unittest.skipUnless(shutil.which("doxygen"), "Doxygen is not installed (scripts/site installs it)")
class Library(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.names = {(entry.header, entry.name) for entry in cpp_reference.entries()}
        cls.pages = "".join(cpp_reference.page(room) for room in cpp_reference.rooms())

    def test_every_public_name_has_a_docstring(self):
        self.assertEqual(list(cpp_reference.undocumented()), [])

    def test_a_name_without_a_docstring_is_noticed(self):
        """A type, a member and a value each. Members that one line declares share what stands behind it, functions of one name what stands before the first."""
        entry, bare = cpp_reference.Entry, ("a.h", 1, 1)
        values = [entry(*bare, "value", "documented", "documented", "", "text", []), entry(*bare, "value", "bare", "bare", "", "", [])]
        given = [("a.h", 2, 1, "variable", "x", ""), ("a.h", 2, 2, "variable", "y", "both"), ("a.h", 3, 1, "function", "at", "text"), ("a.h", 4, 1, "function", "at", ""),
                 ("a.h", 5, 1, "function", "of", "")]
        members = cpp_reference.sharing_docstrings([entry(*place, name, "", "", text, []) for *place, name, text in given])
        members += [entry("a.h", 6, 1, "function", "T", "T()", "", "", []), entry("a.h", 7, 1, "function", "U", "U(int n)", "", "", [])]
        made = [entry(*bare, "enum", "E", "", "", "text", values), entry(*bare, "struct", "T", "struct T", "", "", members)]
        kept, cpp_reference.entries = cpp_reference.entries, lambda: made
        self.addCleanup(setattr, cpp_reference, "entries", kept)
        self.assertEqual(list(cpp_reference.undocumented()), ["a.h:1: E::bare", "a.h:1: T", "a.h:5: T::of", "a.h:7: T::U"])

    def test_what_the_headers_declare_is_on_the_pages(self):
        """Types and functions at the beginning of a line, found without Doxygen."""
        for header in cpp_reference.public_headers():
            text = (SOURCE / header).read_text(encoding="utf-8")
            names = TYPE.findall(text) + FUNCTION.findall(text)
            self.assertTrue(names, header)
            for name in names:
                self.assertIn((header, name), self.names)
                self.assertIn(f"\n### {name}\n", self.pages)

    def test_declarations_stand_as_they_are_written(self):
        for written in ("using Accommodation = std::variant<RelaxedAccommodation, FixedAccommodation, BestAccommodation>;",
                        "std::optional<double> stated_focus_distance_m(const Accommodation& accommodation);", "class InputError : public std::runtime_error;",
                        "inline constexpr double radians_per_degree = std::numbers::pi / 180.0;".removeprefix("inline "), "enum class EyeSide { right, left };",
                        "template <class Visit> void for_each(double vergence_D, const Visit& visit) const;", "| `double pupil_radius_m = 2e-3` | a ≥ 0; 0 is a pinhole |",
                        "friend PowerMatrix operator+(const PowerMatrix& a, const PowerMatrix& b);", "static PowerMatrix from(const Prescription& rx);"):
            self.assertIn(written, self.pages)
        for fault in ("typedef", "sturm::std", "constexpr constexpr", "< double", " >;"):
            self.assertNotIn(fault, self.pages)

    def test_documents_that_docstrings_name_are_links(self):
        self.assertEqual(cpp_reference.linked("see docs/theory.md#3-the-eye. `a < b` < c"), "see [docs/theory.md#3-the-eye](../theory.md#3-the-eye). `a < b` &lt; c")


class PythonPackage(unittest.TestCase):
    def test_every_public_name_is_on_the_page_with_a_docstring(self):
        self.assertEqual(list(python_reference.undocumented()), [])
        page = python_reference.page()
        listed = next(node for node in python_reference.parse(SOURCE / "python/sturm/__init__.py") if isinstance(node, ast.Assign))
        for name in ast.literal_eval(listed.value):
            self.assertIn(f"\n### {name}\n", page)

    def test_signatures_and_docstrings_of_both_sources(self):
        """A class of the package that extends one of the bindings has the members of both; a function of the bindings its stub's types."""
        page = python_reference.page()
        for written in ("Eye(document: Document | None=None, *, file: str='', **members: Any)", "| `wavefront: Wavefront | None` | The wavefront over the pupil",
                        "| `pupil_diameter_mm: float` | Diameter of the pupil [mm]. |", "schema(name: str) -> dict[str, Any]\n```\n\nThe JSON Schema of a format",
                        "class RuntimeFailure(RuntimeError)"):
            self.assertIn(written, page)

    def test_literals_of_the_bindings_are_read(self):
        """In a row they are one; a bracket or a comma inside of one is text; a call without a docstring has none."""
        source = 'module.def("f", [](int a) { return g(a, "(,"); }, "a"_a, "Says (so), "\n  "and \\"so\\".");\nmodule.def("g", &g); // "no"\n'
        self.assertEqual([(name, text) for _, name, text in python_reference.calls_in(python_reference.tokens_of(source))], [("f", 'Says (so), and "so".'), ("g", None)])


if __name__ == "__main__":
    unittest.main()
