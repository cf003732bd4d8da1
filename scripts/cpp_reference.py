"""The reference of the C++ library: what Doxygen reads in the public headers, as Markdown."""
import collections
import functools
import pathlib
import re
import subprocess
import tempfile
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
SETTINGS = """
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
QUIET = YES
WARNINGS = NO
WARN_IF_UNDOCUMENTED = NO
MARKDOWN_SUPPORT = NO
"""
USE = """Lengths are metres and angles are radians unless a name says otherwise; frames are those of [the theory](../theory.md#1-frames-signs-units).
How to use the library: [Sturm as a library](../library.md)."""
KINDS_OF_PARTS = ("variable", "value")  # members that stand in a table

Entry = collections.namedtuple("Entry", "header line column kind name declaration value text entries")


def public_headers():
    lines = (ROOT / "cmake/public_headers.txt").read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def rooms():
    """The rooms that have public headers, in the order of the list."""
    return list(dict.fromkeys(header.split("/")[0] for header in public_headers()))


def one_line(element):
    return "" if element is None else re.sub(r"\s+", " ", "".join(element.itertext())).strip()


def markdown_of(element):
    """A docstring: its paragraphs, with names of the code as code."""
    if element.tag == "computeroutput":
        return "`" + one_line(element) + "`"
    parts = [element.text or ""]
    for child in element:
        parts += [markdown_of(child), child.tail or ""]
    text = "".join(parts)
    return re.sub(r"\s+", " ", text).strip() + "\n\n" if element.tag == "para" else text


def linked(text):
    """Text outside of code: no tags, and links to the documents that it names."""
    def linked_prose(prose):
        return re.sub(r"\bdocs/([\w/]+\.md(?:#[\w-]*\w)?)", r"[docs/\1](../\1)", prose.replace("<", "&lt;"))

    return "".join(part if part.startswith("`") else linked_prose(part) for part in re.split(r"(`[^`]*`)", text))


def docstring(element):
    parts = (markdown_of(element.find(part)).strip() for part in ("briefdescription", "detaileddescription"))
    return linked("\n\n".join(filter(None, parts)))


def place(element):
    location = element.find("location")
    return location.get("file"), int(location.get("line")), int(location.get("column"))


def as_written(code):
    """Code of Doxygen as this project writes it."""
    code = re.sub(r"([<(]) | (?=[>)])", r"\1", code.replace("sturm::", "").replace("= typedef ", "= "))
    code = re.sub(r"^(constexpr )?static (?=constexpr)|^constexpr static ", "static constexpr ", code)
    code = re.sub(r"^(static )?constexpr constexpr |^static constexpr constexpr ", "static constexpr ", code)
    return re.sub(r" ([&*]+) ?", r"\1 ", re.sub(r"(?<=\w)=(?=[\w{\"-])", " = ", code)).rstrip()


def declaration(member):
    """The declaration without the names of the scopes that it stands in."""
    name = one_line(member.find("name"))
    written = re.sub(r"(?:\w+::)+(?=" + re.escape(name) + r"$)", "", one_line(member.find("definition")))
    written += one_line(member.find("argsstring"))
    parameters = member.find("templateparamlist")
    if parameters is not None:
        written = "template <" + ", ".join(" ".join(filter(None, (one_line(p.find("type")), one_line(p.find("declname"))))) for p in parameters) + "> " + written
    return ("friend " if member.get("kind") == "friend" and not written.startswith("friend") else "") + as_written(written)


def stands_in_one_line(member):
    location = member.find("location")
    return location.get("bodystart") == location.get("bodyend")


def entry_of(member):
    kind, name = member.get("kind"), one_line(member.find("name"))
    values = [Entry(*place(member), "value", one_line(v.find("name")), one_line(v.find("name")), "", docstring(v), []) for v in member.findall("enumvalue")]
    written = "enum class " + name if kind == "enum" else declaration(member)
    if values and stands_in_one_line(member) and not any(v.text for v in values):  # its docstring tells of all
        values, written = [], written + " { " + ", ".join(v.name for v in values) + " }"
    value = as_written(one_line(member.find("initializer"))) if kind == "variable" else ""
    return Entry(*place(member), kind, name, written, value, docstring(member), values)


def members_of(compound):
    return [entry_of(member) for member in compound.iter("memberdef") if member.get("prot") == "public"]


def type_of(compound):
    kind, name = compound.get("kind"), one_line(compound.find("compoundname")).removeprefix("sturm::")
    bases = [f"{base.get('prot')} {one_line(base)}" for base in compound.findall("basecompoundref")]
    members = sharing_docstrings(sorted(members_of(compound), key=lambda member: member[1:3]))
    written = f"{kind} {name}" + (" : " + ", ".join(bases) if bases else "")
    return Entry(*place(compound), kind, name, written, "", docstring(compound), members)


def sharing_docstrings(entries):
    """Members that one line declares share the docstring behind it, and a function that of the one before it, if that has the same name."""
    texts = {(entry.header, entry.line): entry.text for entry in entries if entry.kind == "variable" and entry.text}
    shared = []
    for entry in entries:
        text = entry.text
        if entry.kind == "variable":
            text = text or texts.get((entry.header, entry.line), "")
        elif shared and (shared[-1].kind, shared[-1].name) == ("function", entry.name):
            text = text or shared[-1].text
        shared.append(entry._replace(text=text))
    return shared


@functools.lru_cache
def entries():
    """All public names of the library in the order of the headers, each with its docstring and its members."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        settings = f"{SETTINGS}\nINPUT = {' '.join(public_headers())}\nOUTPUT_DIRECTORY = {folder}\nSTRIP_FROM_PATH = {ROOT}\n"
        subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, cwd=ROOT)
        for path in sorted(pathlib.Path(folder, "xml").glob("*.xml")):
            for compound in xml.etree.ElementTree.parse(path).getroot().findall("compounddef"):
                if one_line(compound.find("compoundname")) == "sturm":
                    found += members_of(compound)
                elif compound.get("kind") in ("struct", "class") and compound.get("prot") == "public":
                    found.append(type_of(compound))
    order = {header: number for number, header in enumerate(public_headers())}
    return sharing_docstrings(sorted(found, key=lambda entry: (order[entry.header], *entry[1:3])))


def says_all_itself(owner, member):
    """A constructor without parameters does what it does everywhere."""
    return member.declaration.startswith(owner.name + "()")


def undocumented():
    """"HEADER:LINE: NAME" of every public name without a docstring."""
    for entry in entries():
        if not entry.text:
            yield f"{entry.header}:{entry.line}: {entry.name}"
        for member in entry.entries:
            if not member.text and not says_all_itself(entry, member):
                yield f"{member.header}:{member.line}: {entry.name}::{member.name}"


def code(entry):
    value = entry.value.replace("{ {", "{{")
    return (entry.declaration + ("" if value.startswith("{") else " ") + value).strip()


def block(entry):
    return f"```cpp\n{code(entry)};\n```"


def cell(text):
    return text.replace("|", "\\|").replace("\n\n", "<br>")


def section(entry):
    """A name with its declaration, its docstring, and a table of what it consists of."""
    rows = [member for member in entry.entries if member.kind in KINDS_OF_PARTS]
    parts = [f"### {entry.name}", block(entry), entry.text]
    if rows:
        head = "| value | what it means |" if entry.kind == "enum" else "| member | what it is |"
        parts.append("\n".join([head, "|---|---|", *(f"| `{cell(code(member))}` | {cell(member.text)} |" for member in rows)]))
    for member in entry.entries:
        if member not in rows:
            parts += [block(member), member.text]
    return "\n\n".join(filter(None, parts))


def page(room):
    """What a room's public headers declare."""
    parts = [f"# {room}: reference of the library", f"What the public headers of `sturm::{room}` declare, as they say it themselves.", USE]
    for header in public_headers():
        if header.startswith(room + "/"):
            declared = [section(entry) for entry in entries() if entry.header == header]
            parts += [f"## {header}", f"    #include <sturm/{header}>", *declared]
    return "\n\n".join(parts) + "\n"
