"""The reference of the Python package: its own docstrings, and those of the bindings' C++, under the signatures of the stubs, as Markdown."""
import ast
import collections
import functools
import inspect
import pathlib
import re

PYTHON = pathlib.Path(__file__).resolve().parent.parent / "python"
TOKEN = re.compile(r'//[^\n]*|R"\((?P<raw>.*?)\)"|"(?P<text>(?:[^"\\]|\\.)*)"|[(){},]|[^\s(){},"]+', re.S)

TYPES = ("Document", "Progress")  # of parameters

Entry = collections.namedtuple("Entry", "name signature text members")


def tokens_of(source):
    """(text, whether it is the inside of a literal) of C++; literals in a row are one."""
    joined = []
    for match in TOKEN.finditer(source):
        literal = match["raw"] if match["raw"] is not None else match["text"] and ast.literal_eval('"' + match["text"] + '"')
        if literal is None:
            joined += [] if match[0].startswith("//") else [(match[0], False)]
        elif joined and joined[-1][1]:
            joined[-1] = (joined[-1][0] + literal, True)
        else:
            joined.append((literal, True))
    return joined


def calls_in(tokens):
    """(name, docstring) of each call of pybind11 that gives a name to something: its first literal, and its last argument if that is another."""
    for start, (token, literal) in enumerate(tokens):
        if literal or not re.search(r"(\.def\w*|py::class_<.*>)$", token) or tokens[start + 1][0] != "(":
            continue
        depth, arguments = 0, [[]]
        for inner, is_text in tokens[start + 1:]:
            depth += 0 if is_text else (inner in "({") - (inner in ")}")
            if depth == 0:
                break
            if inner == "," and depth == 1 and not is_text:
                arguments.append([])
            else:
                arguments[-1].append((inner, is_text))
        arguments[0] = arguments[0][1:]  # without the bracket that opens the call
        texts = [argument[0][0] if len(argument) == 1 and argument[0][1] else None for argument in arguments]
        names = [text for text in texts[:2] if text is not None]
        yield token, names[0] if names else "__init__", texts[-1] if texts[-1] not in names[:1] else None


@functools.lru_cache
def bound_docstrings():
    """The docstrings of the bindings by "Eye", "Eye.notes", "validate"."""
    found = {}
    for path in sorted(PYTHON.glob("*.cpp")):
        owner = ""
        for call, name, text in calls_in(tokens_of(path.read_text(encoding="utf-8"))):
            if "class_" in call:
                owner = name
            place = name if "class_" in call or call.startswith("module") else f"{owner}.{name}"
            if text is not None:
                found[place] = text
    return found


def parse(path):
    return ast.parse(path.read_text(encoding="utf-8")).body


def signature_of(function):
    """One line, or one line for each parameter where it would be long; without `self`."""
    returns = f" -> {ast.unparse(function.returns)}" if function.returns is not None else ""
    given = re.sub(r"^self(, )?", "", ast.unparse(function.args))
    line = f"{function.name}({given}){returns}"
    return line.replace("_core.", "")


def is_property(function):
    return any(isinstance(d, ast.Name) and d.id == "property" for d in function.decorator_list)


def members_of(body, owner):
    """The public members of a class of the package or of the stubs; a field's docstring stands below it."""
    bound = bound_docstrings()
    for i, node in enumerate(body):
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            text = ast.get_docstring(node) or bound.get(f"{owner}.{node.name}", "")
            written = f"{node.name}: {ast.unparse(node.returns)}".replace("_core.", "") if is_property(node) else signature_of(node)
            yield Entry(node.name, written, text, [])
        elif isinstance(node, ast.AnnAssign):
            below = body[i + 1] if i + 1 < len(body) else None
            text = inspect.cleandoc(below.value.value) if isinstance(below, ast.Expr) else ""
            yield Entry(node.target.id, ast.unparse(node), text, [])


def constructor(body, name):
    for node in body:
        if isinstance(node, ast.FunctionDef) and node.name == "__init__":
            return re.sub(r"__init__(.*?)(?: -> None)?$", rf"{name}\1", signature_of(node))
    return ""


def definition(node, stubs):
    """What a class or function says; a class that extends the one of the stubs has its members too."""
    bound = bound_docstrings()
    if isinstance(node, ast.FunctionDef):
        return Entry(node.name, signature_of(node), ast.get_docstring(node) or bound.get(node.name, ""), [])
    members = list(members_of(node.body, node.name))
    bases = [ast.unparse(base).removeprefix("_core.") for base in node.bases]
    if node.name in bases:
        members += members_of(stubs[node.name].body, node.name)
    other = [base for base in bases if base != node.name]
    written = constructor(node.body, node.name) or f"class {node.name}" + (f"({', '.join(other)})" if other else "")
    return Entry(node.name, written, ast.get_docstring(node) or bound.get(node.name, ""), members)


@functools.lru_cache
def entries():
    """All public names of the package, and the types of their parameters."""
    stubs = {node.name: node for node in parse(PYTHON / "sturm/_core.pyi") if hasattr(node, "name")}
    found = {}
    for path in sorted((PYTHON / "sturm").glob("_[a-z]*.py")):
        body = parse(path)
        for i, node in enumerate(body):
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                found[node.name] = definition(node, stubs)
            elif isinstance(node, (ast.Assign, ast.AnnAssign)) and isinstance(body[min(i + 1, len(body) - 1)], ast.Expr):
                name = ast.unparse(node.targets[0] if isinstance(node, ast.Assign) else node.target)
                found[name] = Entry(name, ast.unparse(node) if name in TYPES else name, inspect.cleandoc(body[i + 1].value.value), [])
    public = list(TYPES) + next(ast.literal_eval(node.value) for node in parse(PYTHON / "sturm/__init__.py") if isinstance(node, ast.Assign))
    return [found.get(name) or (definition(stubs[name], stubs) if name in stubs else Entry(name, name, "", [])) for name in public]


def undocumented():
    """The public names without a docstring."""
    for entry in entries():
        if not entry.text:
            yield entry.name
        yield from (f"{entry.name}.{member.name}" for member in entry.members if not member.text)


def section(entry):
    parts = [f"### {entry.name}", f"```python\n{entry.signature}\n```", entry.text]
    if entry.members:
        rows = ("| `{}` | {} |".format(member.signature, member.text.replace("\n", " ")) for member in entry.members)
        parts.append("\n".join(["| member | what it is |", "|---|---|", *rows]))
    return "\n\n".join(parts)


def page():
    """The public names of `sturm`."""
    head = inspect.cleandoc(parse(PYTHON / "sturm/__init__.py")[0].value.value)
    return "\n\n".join(["# Reference of the Python package", head, "How to use it: [Sturm in Python](../python.md).", *map(section, entries())]) + "\n"
