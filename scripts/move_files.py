#!/usr/bin/env python3
"""Moves files within the repository and mends what names them: `scripts/move_files.py TABLE`.

TABLE has lines "OLD NEW" (paths from the root of the repository). Each file is moved with git, then every #include of ours and every
mention of a moved path in source, CMake, script and configuration files is rewritten. Documents (*.md) are left as they are.
Includes are resolved as the compiler does: from the root, from tests/, from the file's own folder.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^([ \t]*#[ \t]*include[ \t]*")([^"]+)(")', re.MULTILINE)
SOURCES = {".h", ".cpp"}
TEXTS = SOURCES | {".py", ".cmake", ".txt", ".in", ".sh", ".json", ".js", ".css", ""}


def tracked_files():
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True)
    return listed.stdout.split("\n")[:-1]


def resolved(including, target, files):
    """The file of the repository that an #include means, or None."""
    candidates = [target, f"tests/{target}", str(pathlib.PurePosixPath(including).parent / target)]
    return next((c for c in candidates if c in files), None)


def spelled(path):
    return path.removeprefix("tests/")


def rewritten_includes(path, text, files, moves):
    def mend(match):
        meant = resolved(path, match.group(2), files)
        if meant is None:
            return match.group(0)
        beside = "/" not in match.group(2) and pathlib.PurePosixPath(moves.get(path, path)).parent == pathlib.PurePosixPath(moves.get(meant, meant)).parent
        name = match.group(2) if beside and meant == moves.get(meant, meant) else spelled(moves.get(meant, meant))
        return match.group(1) + (pathlib.PurePosixPath(name).name if beside else name) + match.group(3)

    return INCLUDE.sub(mend, text)


def rewritten_mentions(text, moves):
    """Whole paths only: not within a longer word or path."""
    names = {old: new for old, new in moves.items()}
    for old, new in moves.items():  # a header is also named for its pair: "pathtrace/film" style mentions keep their ending
        names.setdefault(spelled(old), spelled(new))
    pattern = re.compile(r"(?<![\w/.-])(" + "|".join(re.escape(n) for n in sorted(names, key=len, reverse=True)) + r")(?![\w-])")
    return pattern.sub(lambda match: names[match.group(1)], text)


def main(table):
    moves = dict(line.split() for line in pathlib.Path(table).read_text().splitlines() if line.strip())
    files = set(tracked_files())
    missing = [old for old in moves if old not in files]
    if missing:
        sys.exit(f"not in the repository: {missing}")
    texts = {}
    for path in sorted(files):
        suffix = pathlib.PurePosixPath(path).suffix
        if suffix not in TEXTS or path in {"scripts/move_files.py", "LICENSE", ".gitignore"}:
            continue
        if suffix == ".json" and not path.startswith("configs/"):
            continue
        old = (ROOT / path).read_text(encoding="utf-8")
        new = rewritten_includes(path, old, files, moves) if suffix in SOURCES else old
        new = rewritten_mentions(new, moves)
        if new != old:
            texts[path] = new
    for old, new in moves.items():
        (ROOT / new).parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["git", "mv", old, new], cwd=ROOT, check=True)
    for path, text in texts.items():
        (ROOT / moves.get(path, path)).write_text(text, encoding="utf-8")
    print(f"{len(moves)} files moved, {len(texts)} files rewritten")


if __name__ == "__main__":
    main(sys.argv[1])
