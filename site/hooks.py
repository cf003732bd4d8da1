"""What MkDocs does not do by itself: documents from beside docs/, references made of docstrings, the anchors of GitHub, links that leave the documents, a
search without a server."""
import json
import pathlib
import posixpath
import re
import shutil
import sys
import tempfile

from mkdocs.structure.files import File

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
import cpp_reference  # noqa: E402
import python_reference  # noqa: E402
from github_anchor import anchor  # noqa: E402

JQUERY = pathlib.Path("/usr/share/javascript/jquery/jquery.min.js")  # Debian's theme names it without bringing it
BESIDE = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]  # documents of the site that do not lie in docs/
MADE = tempfile.TemporaryDirectory(prefix="sturm_reference_")  # pages that stand nowhere else, so that none can be out of date
LINK = re.compile(r"(!?\[[^\]]*\])\(([^()\s]+)\)")


def on_config(config):
    config["mdx_configs"]["toc"] = {"slugify": lambda text, separator: anchor(text), "permalink": False}
    return config


def on_files(files, config):
    pages = {f"reference/{room}.md": cpp_reference.page(room) for room in cpp_reference.rooms()}
    pages["reference/python.md"] = python_reference.page()
    (pathlib.Path(MADE.name) / "reference").mkdir(exist_ok=True)
    for name, text in pages.items():
        (pathlib.Path(MADE.name) / name).write_text(text, encoding="utf-8")
    for name, folder in [*((name, ROOT) for name in BESIDE), *((name, MADE.name) for name in pages)]:
        files.append(File(name, str(folder), config["site_dir"], config["use_directory_urls"]))
    return files


def reference_of(source):
    """Where the site tells of a public header, of the folder of a room, or of the Python package; "" of other sources."""
    if source == "python/sturm":
        return "reference/python.md"
    room = source.split("/")[0]
    if room not in cpp_reference.rooms() or source not in [room, *cpp_reference.public_headers()]:
        return ""
    return f"reference/{room}.md" + ("#" + anchor(source) if source != room else "")


def on_page_markdown(markdown, page, config, files):
    """Links are written as from the repository: those to other documents become links of the site, those to sources ones to the reference or text."""
    place = page.file.src_uri if page.file.src_uri in BESIDE else "docs/" + page.file.src_uri

    def mended(match):
        text, target = match.groups()
        path, hash_sign, fragment = target.partition("#")
        if not path or re.match(r"[a-z]+:", target):
            return match[0]
        source = posixpath.normpath(posixpath.join(posixpath.dirname(place), path))
        inside = reference_of(source) or source.removeprefix("docs/")
        if inside == source and source not in BESIDE:
            return f"{text[1:-1]} (`{source}`)"
        return f"{text}({posixpath.relpath(inside, posixpath.dirname(page.file.src_uri) or '.')}{hash_sign}{fragment})"

    return LINK.sub(mended, markdown)


def on_post_build(config):
    """A page that was opened as a file may not fetch the index, but may load it as a script."""
    folder = pathlib.Path(config["site_dir"]) / "search"
    index = json.loads((folder / "search_index.json").read_text(encoding="utf-8"))
    shutil.copyfile(JQUERY, folder.parent / "js" / "jquery-3.6.0.min.js")
    (folder / "search_index.js").write_text("window.search_index = " + json.dumps(index["docs"]) + ";\n", encoding="utf-8")
