"""Documents that are shipped with Sturm, and how arguments name them."""
from __future__ import annotations

import os
import pathlib
from typing import Any, Mapping, Union

from . import _core

Document = Union[Mapping[str, Any], str, "os.PathLike[str]"]
"""A document of Sturm: its members as a dictionary, or the path of a JSON file."""

_SHIPPED = pathlib.Path(__file__).with_name("configs")


def shipped(name: str = "") -> pathlib.Path:
    """The path of a shipped file or folder: shipped("views/desk.json"), shipped("lenses")."""
    path = _SHIPPED / name
    if not path.exists():
        raise FileNotFoundError(f"{path}: no such shipped file")
    return path


def load(document: Document) -> dict[str, Any]:
    """A JSON document as a dictionary, read as strictly as the command line does. Relative paths in it start at its folder."""
    return _core.load(document)


def named(document: Any, folder: str) -> Any:
    """The path of the shipped document of that name, unless there is a file of the name; other documents as they are."""
    if isinstance(document, str) and not os.path.exists(document):
        path = _SHIPPED / folder / f"{document}.json"
        if path.is_file():
            return str(path)
    return document
