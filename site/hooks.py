"""What MkDocs does not do by itself: documents from beside docs/, the anchors of GitHub, links that leave the documents, a search without a server."""
import json
import pathlib
import posixpath
import re
import shutil
import sys

from mkdocs.structure.files import File

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
from github_anchor import anchor  # noqa: E402

JQUERY = pathlib.Path("/usr/share/javascript/jquery/jquery.min.js")  # Debian's theme names it without bringing it
BESIDE = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]  # documents of the site that do not lie in docs/
LINK = re.compile(r"(!?\[[^\]]*\])\(([^()\s]+)\)")


def on_config(config):
    config["mdx_configs"]["toc"] = {"slugify": lambda text, separator: anchor(text), "permalink": False}
    return config


def on_files(files, config):
    for name in BESIDE:
        files.append(File(name, str(ROOT), config["site_dir"], config["use_directory_urls"]))
    return files


def on_page_markdown(markdown, page, config, files):
    """Links are written as from the repository: those to other documents become links of the site, those to sources their own text."""
    place = page.file.src_uri if page.file.src_uri in BESIDE else "docs/" + page.file.src_uri

    def mended(match):
        text, target = match.groups()
        path, hash_sign, fragment = target.partition("#")
        if not path or re.match(r"[a-z]+:", target):
            return match[0]
        source = posixpath.normpath(posixpath.join(posixpath.dirname(place), path))
        inside = source.removeprefix("docs/") if source.startswith("docs/") else source
        if not (source.startswith("docs/") or source in BESIDE):
            return f"{text[1:-1]} (`{source}`)"
        return f"{text}({posixpath.relpath(inside, posixpath.dirname(page.file.src_uri) or '.')}{hash_sign}{fragment})"

    return LINK.sub(mended, markdown)


def on_post_build(config):
    """A page that was opened as a file may not fetch the index, but may load it as a script."""
    folder = pathlib.Path(config["site_dir"]) / "search"
    index = json.loads((folder / "search_index.json").read_text(encoding="utf-8"))
    shutil.copyfile(JQUERY, folder.parent / "js" / "jquery-3.6.0.min.js")
    (folder / "search_index.js").write_text("window.search_index = " + json.dumps(index["docs"]) + ";\n", encoding="utf-8")
