#!/usr/bin/env python3
"""Runs the notebooks of docs/notebooks (Python in percent format) and writes each as Markdown with what its cells printed.

    PYTHONPATH=build/release/python /usr/bin/python3 scripts/render_notebooks.py [--output FOLDER] [NAME...]

Pictures that a notebook writes lie beside its Markdown.
"""
import argparse
import contextlib
import io
import os
import pathlib
import re

NOTEBOOKS = pathlib.Path(__file__).resolve().parents[1] / "docs/notebooks"
CELL = re.compile(r"^# %%(.*)$", re.MULTILINE)


def cells(text):
    """(is Markdown, text) of each cell."""
    parts = CELL.split(text)[1:]
    for kind, body in zip(parts[::2], parts[1::2]):
        is_markdown = kind.strip() == "[markdown]"
        yield is_markdown, re.sub(r"^# ?", "", body, flags=re.MULTILINE).strip() if is_markdown else body.strip()


def rendered(notebook):
    """The notebook's Markdown; its cells run in the working directory."""
    blocks, names = [], {}
    for is_markdown, text in cells(notebook.read_text(encoding="utf-8")):
        if is_markdown:
            blocks.append(text)
            continue
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(text, notebook.name, "exec"), names)
        blocks.append(f"```python\n{text}\n```")
        if printed.getvalue():
            blocks.append(f"```text\n{printed.getvalue().rstrip()}\n```")
    return "\n\n".join(blocks) + f"\n\nThis page was made from [{notebook.name}]({notebook.name}) by `scripts/render_notebooks.py`.\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=NOTEBOOKS)
    parser.add_argument("names", nargs="*", default=[])
    options = parser.parse_args()
    output = options.output.resolve()
    os.chdir(output)
    for notebook in sorted(NOTEBOOKS.glob("*.py")):
        if not options.names or notebook.stem in options.names:
            (output / f"{notebook.stem}.md").write_text(rendered(notebook), encoding="utf-8")


if __name__ == "__main__":
    main()
