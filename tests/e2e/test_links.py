"""Dead links: in the Markdown documents (files and #anchors), and in comments of the code that name a document."""
import ast
import io
import pathlib
import re
import sys
import tempfile
import tokenize
import unittest
import urllib.parse

from sturm_process import SOURCE

sys.path.insert(0, str(SOURCE / "scripts"))
from github_anchor import anchor as github_anchor  # noqa: E402

OUTPUT = re.compile(r"(^|/)(build|node_modules|\.git|\.cache|__pycache__|reports/runs/[^/]+)/")  # folders that hold no source
C_SUFFIXES = {".h", ".hpp", ".cpp", ".cc", ".inl"}

FENCE = re.compile(r"^ {0,3}(```|~~~).*?(?:^ {0,3}\1[`~]*[ \t]*$|\Z)", re.MULTILINE | re.DOTALL)
INDENTED = re.compile(r"(?:(?<=\n\n)|\A)(?! *(?:[-*+]|\d+\.) )(?:(?: {4}|\t).*(?:\n|\Z)|[ \t]*\n)+")  # a list item is none
CODE_SPAN = re.compile(r"(`+)(?!`).+?(?<!`)\1(?!`)", re.DOTALL)
HEADING = re.compile(r"^ {0,3}#{1,6}[ \t]+(.*?)[ \t]*#*$", re.MULTILINE)
INLINE_LINK = re.compile(r"\]\(\s*<?([^()\s<>]*(?:\([^()\s]*\)[^()\s<>]*)*)>?(?:\s+[\"'][^\"']*[\"'])?\s*\)")
REFERENCE = re.compile(r"^ {0,3}\[[^\]]+\]:\s*<?([^\s>]+)", re.MULTILINE)
HTML_LINK = re.compile(r"<(?:a|img)\b[^>]*?\b(?:href|src)\s*=\s*[\"']([^\"']*)[\"']", re.IGNORECASE)
HTML_ANCHOR = re.compile(r"<\w+\b[^>]*?\b(?:id|name)\s*=\s*[\"']([^\"']+)[\"']", re.IGNORECASE)

C_TOKEN = re.compile(
    r'R"(?P<raw>[^\s()\\]{0,16})\(.*?\)(?P=raw)"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])*\'|(?P<comment>//[^\n]*|/\*.*?\*/)', re.DOTALL
)
CMAKE_TOKEN = re.compile(r'\[(?P<raw>=*)\[.*?\](?P=raw)\]|"(?:\\.|[^"\\])*"|(?P<comment>#[^\n]*)', re.DOTALL)
DOCUMENT = re.compile(r"(?<![\w/.-])([\w./-]+\.md)\b(?:#([\w-]+))?")


def anchors(markdown):
    """Every anchor of a document; headings of one text are told apart by -1, -2, …"""
    text = FENCE.sub("", markdown)
    found, times = set(HTML_ANCHOR.findall(text)), {}
    for heading in HEADING.findall(text):
        name = github_anchor(heading)
        count = times.get(name, 0)
        times[name] = count + 1
        found.add(f"{name}-{count}" if count else name)
    return found


def targets(markdown):
    """Where the links of a document point; code is not text."""
    text = CODE_SPAN.sub("", INDENTED.sub("\n", FENCE.sub("", markdown)))
    return INLINE_LINK.findall(text) + REFERENCE.findall(text) + HTML_LINK.findall(text)


def fault_of(place, anchor):
    """What is wrong with a link to this file, or None."""
    if not place.exists():
        return "no such file"
    if anchor and (place.suffix != ".md" or anchor not in anchors(place.read_text(encoding="utf-8"))):
        return "no such anchor"
    return None


def files_of(root, wanted):
    for path in sorted(root.rglob("*")):
        if path.is_file() and wanted(path) and not OUTPUT.search(path.relative_to(root).as_posix()):
            yield path


def dead_links(root):
    """"DOCUMENT: LINK (fault)" for every relative link of a Markdown document that leads nowhere, or out of the source tree."""
    found = []
    for path in files_of(root, lambda p: p.suffix == ".md"):
        for target in targets(path.read_text(encoding="utf-8")):
            if re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:", target):
                continue  # the web's
            file, _, anchor = target.partition("#")
            place = (path.parent / urllib.parse.unquote(file)).resolve() if file else path
            fault = fault_of(place, urllib.parse.unquote(anchor)) if place.is_relative_to(root.resolve()) or not file else "outside"
            if fault:
                found.append(f"{path.relative_to(root)}: {target} ({fault})")
    return found


def python_comments(text):
    comments = [t.string for t in tokenize.generate_tokens(io.StringIO(text).readline) if t.type == tokenize.COMMENT]
    places = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    docstrings = [ast.get_docstring(node) for node in ast.walk(ast.parse(text)) if isinstance(node, places)]
    return comments + [d for d in docstrings if d]


def comments_of(path):
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        return python_comments(text)
    token = C_TOKEN if path.suffix in C_SUFFIXES else CMAKE_TOKEN
    return [match["comment"] for match in token.finditer(text) if match["comment"]]


def is_code(path):
    return path.suffix in C_SUFFIXES | {".py", ".cmake"} or path.name == "CMakeLists.txt"


def dead_mentions(root):
    """"FILE: DOCUMENT (fault)" for every comment that names a document that is neither there from the top nor beside the file."""
    found = []
    for path in files_of(root, is_code):
        for comment in comments_of(path):
            for file, anchor in DOCUMENT.findall(comment):
                beside = path.parent / file
                fault = fault_of(beside if beside.exists() else root / file, anchor)
                if fault:
                    found.append(f"{path.relative_to(root)}: {file}{'#' + anchor if anchor else ''} ({fault})")
    return found


class Links(unittest.TestCase):
    def test_documents_have_no_dead_links(self):
        self.assertGreater(len(list(files_of(SOURCE, lambda p: p.suffix == ".md"))), 10)
        self.assertEqual(dead_links(SOURCE), [])

    def test_comments_name_documents_that_are_there(self):
        self.assertGreater(len(list(files_of(SOURCE, is_code))), 100)
        self.assertEqual(dead_mentions(SOURCE), [])

    def tree(self, files):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        root = pathlib.Path(folder.name)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return root

    def test_dead_links_are_seen(self):
        for text in [
            "[gone](gone.md)",
            "![picture](images/gone.png)",
            "[no such section](other.md#nowhere)",
            "[nor here](#nowhere)",
            "[an anchor of a picture](images/a.png#top)",
            "[up and out](../../etc)",
            "text\n[ref]: gone.md",
            '<a href="gone.md">gone</a>, <img src="gone.png">',
            "`code` and [then](gone.md) `code`",
            "- item\n\n  [in a list](gone.md)",
            "- item\n\n    - [in a list of a list](gone.md)",
            '[with a title](gone.md "title")',
            "[second of two](other.md#twice-2)",
        ]:
            with self.subTest(text=text):
                root = self.tree({"docs/a.md": text, "docs/other.md": "# Twice\n\n# Twice\n", "docs/images/a.png": ""})
                self.assertGreater(len(dead_links(root)), 0)

    def test_living_links_pass(self):
        for text in [
            "[other](other.md), [section](other.md#8-how--why), [first](other.md#twice), [second](other.md#twice-1)",
            "[anchor by hand](other.md#old-name) [folder](images) [picture](images/a%20b.png)",
            "# Here\n[here](#here) [top](../README.md#top)",
            "[web](https://example.org/gone.md) [mail](mailto:a@b.c)",
            "`[code](gone.md)` and ``[more `code`](gone.md)``",
            "```\n[fenced](gone.md)\n```",
            "text\n\n    [indented](gone.md)\n",
        ]:
            with self.subTest(text=text):
                other = '# 8. How — why?\n# Twice\n# Twice\n<a id="old-name"></a>\n'
                root = self.tree({"docs/a.md": text, "docs/other.md": other, "docs/images/a b.png": "", "README.md": "## Top"})
                self.assertEqual(dead_links(root), [])

    def test_output_is_not_read(self):
        root = self.tree({"build/a.md": "[gone](gone.md)", "reports/runs/x/summary.md": "[gone](gone.md)"})
        self.assertEqual(dead_links(root), [])

    def test_anchors_are_those_of_github(self):
        for heading, anchor in [
            ("1. Frames, signs, units", "1-frames-signs-units"),
            ("Eye (`sturm.eye/1`)", "eye-sturmeye1"),
            ("`lens_study`", "lens_study"),
            ("What does sin² do?", "what-does-sin-do"),
            ("A [link](b.md) — and *more*", "a-link--and-more"),
            ("Über-Größe", "über-größe"),
            ("report.html", "reporthtml"),
        ]:
            with self.subTest(heading=heading):
                self.assertEqual(github_anchor(heading), anchor)
        self.assertEqual(anchors("# One\n```\n# not a heading\n```\n## One ##\n"), {"one", "one-1"})

    def test_dead_mentions_are_seen(self):
        for file, text in [
            ("a.h", "/// Thin-lens eye (physics.md §3)."),
            ("deep/a.cpp", 'int a;  // see docs/gone.md, "Frames"'),
            ("a.cpp", "/* docs/theory.md#nowhere */"),
            ("a.cpp", '"a string"; // docs/gone.md'),
            ("a.cpp", "n = 16'384;  // it's docs/gone.md"),
            ("a.py", '"""From physics.md alone."""'),
            ("a.py", "def f():\n    '''physics.md 2'''\n"),
            ("a.py", "x = 1  # docs/theory.md#nowhere"),
            ("a.cmake", "set(a 1)  # see gone.md"),
            ("CMakeLists.txt", "# docs/gone.md"),
        ]:
            with self.subTest(text=text):
                root = self.tree({file: text, "docs/theory.md": "# Frames\n"})
                self.assertEqual(len(dead_mentions(root)), 1)

    def test_living_mentions_pass(self):
        for file, text in [
            ("a.h", "/// Frames: docs/theory.md#frames, and docs/theory.md."),
            ("deep/a.h", "// the table in README.md, beside this file"),
            ("a.cpp", 'write("summary.md");'),
            ("a.cpp", 'write(R"(// gone.md)");'),
            ("a.py", 'name = "summary.md"'),
            ("a.cmake", 'set(name "gone.md")'),
            ("notes.txt", "# gone.md"),
        ]:
            with self.subTest(text=text):
                root = self.tree({file: text, "docs/theory.md": "# Frames\n", "deep/README.md": ""})
                self.assertEqual(dead_mentions(root), [])


if __name__ == "__main__":
    unittest.main()
