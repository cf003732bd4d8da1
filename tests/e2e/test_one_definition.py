"""No two types share a name in one namespace: C++ forbids it, and neither compiler nor linker has to say so."""
import collections
import pathlib
import re
import tempfile
import unittest

from sturm_process import SOURCE

ROOMS = ("lensmodel", "io", "pathtrace", "conoid", "wavefront", "compare", "reports", "stages", "experiments", "app", "python")
SUFFIXES = {".h", ".hpp", ".cpp", ".cc", ".inl"}

# Comments, strings and preprocessor lines are passed over; of the rest words, numbers and signs matter.
TOKEN = re.compile(
    r"""(?P<skip>//(?:\\\n|[^\n])*|/\*.*?\*/|^[ \t]*\#(?:\\\n|[^\n])*
        |(?:u8|[uUL])?R"(?P<raw>[^\s()\\]{0,16})\(.*?\)(?P=raw)"|(?:u8|[uUL])?"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+')
        |(?P<token>\w+(?:'\w+)*|::|[^\w\s])""",
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)
INSIDE = object()  # a scope whose types belong to something else: an anonymous namespace, a function, another type


def tokens_of(text):
    for match in TOKEN.finditer(text):
        if match["token"]:
            yield match["token"], text.count("\n", 0, match.start()) + 1


def without_brackets(words):
    """Without template parameters, attributes and alignas(...): `template <class T> struct [[x]] A` is `template struct A`."""
    kept, depth = [], 0
    for word in words:
        if word in "<[(":
            depth += 1
        if depth == 0:
            kept.append(word)
        if word in ">])":
            depth -= 1
    return kept


def defined_type(head):
    """The name that the words before a brace define as a type, with template arguments of a specialisation; "" for none."""
    words = without_brackets(head)
    places = [i for i, word in enumerate(words) if word in ("struct", "class", "union", "enum")]
    if not places or "=" in words[: places[0]] or "friend" in words:
        return ""
    name = words[places[0] + 1 :]
    while name and name[0] in ("struct", "class", "alignas"):
        del name[0]
    name = name[: name.index(":")] if ":" in name else name
    name = [word for word in name if word != "final"]
    if not name or len(name) % 2 == 0 or any(word != "::" for word in name[1::2]):
        return ""  # `struct A f() {`, or a type without a name
    rest = head[len(head) - head[::-1].index(name[-1]) :]
    if rest[:1] == ["<"] and set(rest) - set("<,>") <= set(head[: len(head) - len(rest)]) - {"class", "typename"}:
        return ""  # arguments that are the template's own parameters: constraints tell such specialisations apart
    return "".join(name) + ("".join(rest[: rest.index(":")] if ":" in rest else rest) if rest[:1] == ["<"] else "")


def types_in(text):
    """(qualified name, line) of every type that is defined in a namespace with a name, or in none."""
    scopes, head = [], []
    for word, line in tokens_of(text):
        if word == "}":
            if scopes:
                scopes.pop()
            head = []
        elif word == ";":
            head = []
        elif word != "{":
            head.append(word)
        elif "namespace" in head:
            name = "".join(head[head.index("namespace") + 1 :])
            scopes.append(name if name and INSIDE not in scopes else INSIDE)
            head = []
        else:
            name = defined_type(head)
            if name and INSIDE not in scopes:
                yield "::".join([*scopes, name]), line
            scopes.append(INSIDE)
            head = []


def clashes(root, folders=ROOMS):
    places = collections.defaultdict(list)
    for folder in folders:
        for path in sorted(path for path in (root / folder).rglob("*") if path.suffix in SUFFIXES):
            for name, line in types_in(path.read_text(encoding="utf-8")):
                places[name].append(f"{path.relative_to(root)}:{line}")
    return {name: found for name, found in places.items() if len(found) > 1}


class OneDefinition(unittest.TestCase):
    def test_every_type_has_a_name_of_its_own(self):
        self.assertEqual(clashes(SOURCE), {})

    def test_types_are_found(self):
        names = {name for path in (SOURCE / "lensmodel").glob("*.h") for name, _ in types_in(path.read_text(encoding="utf-8"))}
        self.assertLessEqual({"sturm::Eye", "sturm::RayModel", "sturm::TorusSurface", "sturm::Words"}, names)

    def found(self, text):
        return [name for name, _ in types_in(text)]

    def test_what_defines_a_type(self):
        for text, names in [
            ("namespace s { struct A { int a; }; enum class B : int { c }; }", ["s::A", "s::B"]),
            ("namespace s::t {\nclass A final : public B<C> {\n  struct D {};\n};\n}", ["s::t::A"]),
            ("template <class T, int n = 1>\nstruct alignas(8) [[nodiscard]] A { T t{n}; };", ["A"]),
            ("template <> struct A<int> {}; template <class T> struct A<T*> : B {};", ["A<int>", "A<T*>"]),
            ("namespace s { struct A::B { int c; }; union C { int i; }; }", ["s::A::B", "s::C"]),
            ('const char* a = R"(struct A { };)"; struct B { char c = \'"\'; int n = 1\'000; }; // struct C {};\nstruct D {};', ["B", "D"]),
            ("#define X struct A { \\\n };\nstruct B {};", ["B"]),
            ("inline namespace s { struct A {}; }", ["s::A"]),
        ]:
            self.assertEqual(self.found(text), names, text)

    def test_what_defines_none(self):
        for text in [
            "struct A; enum class B : int; template <class T> class C;",
            "namespace { struct A {}; namespace s { struct B {}; } }",
            "namespace s { void f() { struct A { int a; }; } }",
            "struct A f() { return {}; }\nstruct A g(struct B b) { return {}; }",
            "struct { int a; } x; A a = {struct_b, 1}; const A b{};",
            "enum { a, b };",
            "template <class T> int f() { return 0; }",
            "auto f = [](struct A a) { return a; };",
        ]:
            self.assertEqual(self.found(text), [], text)

    def test_a_planted_clash_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "io" / "specs").mkdir(parents=True)
            (root / "app").mkdir()
            (root / "io/specs/gate.h").write_text("namespace sturm {\nenum class Comparison { at_most };\n}\n")
            (root / "app/comparison.h").write_text("namespace sturm {\nnamespace {\nstruct Own {};\n}\nstruct Comparison {};\n}\n")
            (root / "app/other.cpp").write_text("namespace sturm {\nnamespace {\nstruct Own {};\n}\n}\nnamespace other { class Comparison {}; }\n")
            self.assertEqual(clashes(root), {"sturm::Comparison": ["io/specs/gate.h:2", "app/comparison.h:5"]})


if __name__ == "__main__":
    unittest.main()
