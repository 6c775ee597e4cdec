"""The visitors of a batch: folders below a root, or rows of a CSV or TOML manifest."""

from __future__ import annotations

import csv
import logging
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.project.folder import holds_photos, safe_identifier
from cloner.project.results import is_result
from cloner.project.texts import read_text

log = logging.getLogger(__name__)

DEEPEST: Final = 3  # levels below the root that are searched for visitors: day / stand / visitor
MANIFESTS: Final = (".csv", ".toml")
_KEYS: Final = {"photos", "id", "height_cm"}


@dataclass(frozen=True, slots=True)
class Visitor:
    """One person of a batch.

    Attributes
    ----------
    identifier : str
        Safe as a path component.
    photos : Path
    height_cm : float or None
        Wins over the folder's own; None leaves it.
    """

    identifier: str
    photos: Path
    height_cm: float | None = None


def find_visitors(root: Path) -> tuple[Visitor, ...]:
    """Return the visitors of a folder or a manifest, by identifier.

    Parameters
    ----------
    root : Path
        A folder is searched `DEEPEST` levels deep; hidden folders, links and results are left out. A .csv has the
        columns photos, id and height_cm, a .toml tables [[visitor]] with these keys; photos are folders beside it.

    Raises
    ------
    ClonerError
        If there is nobody, two would share a name, or a manifest is broken or leaves its folder.
    """
    if root.suffix.lower() in MANIFESTS and root.is_file():
        visitors = _from_manifest(root)
    elif root.is_dir():
        visitors = [
            Visitor(safe_identifier("-".join(folder.relative_to(root).parts)), folder)
            for folder in photo_folders(root, DEEPEST)
        ]
    else:
        raise ClonerError("there is no such folder", "Give the folder that holds the visitors' folders", root.name)
    seen: set[str] = set()
    for visitor in visitors:
        if visitor.identifier in seen:
            message = f"two visitors would both be called {visitor.identifier}"
            raise ClonerError(message, "Rename one of them", visitor.photos.name)
        seen.add(visitor.identifier)
    if not visitors:
        hint = "Put each visitor's photos into a folder of its own below it"
        raise ClonerError("no folder below it holds photos named as views", hint, root.resolve().name)
    return tuple(sorted(visitors, key=lambda visitor: visitor.identifier))


def shard(visitors: tuple[Visitor, ...], text: str) -> tuple[Visitor, ...]:
    """Return the i-th of n equal parts for "i/n", i counting from 0; all for "".

    Raises
    ------
    ClonerError
        If the text is not that.
    """
    if not text:
        return visitors
    part, _, parts = text.partition("/")
    if not (part.isdigit() and parts.isdigit() and int(part) < int(parts)):
        raise ClonerError(f"{text!r} is no shard", "Write i/n with i from 0 to n-1, for example 0/4", "--shard")
    return visitors[int(part) :: int(parts)]


def photo_folders(folder: Path, depth: int) -> list[Path]:
    """Return the folders below one that hold photos; none below a folder that holds some itself."""
    if depth < 0 or is_result(folder):
        return []
    if holds_photos(folder):
        return [folder]
    try:
        inner = sorted(path for path in folder.iterdir() if path.is_dir() and not path.name.startswith("."))
    except OSError:
        log.warning("a folder cannot be read and is left out")
        return []
    linked = [path for path in inner if path.is_symlink()]  # they could lead to other people's photos, or in a circle
    if linked:
        log.warning("%d linked folder(s) are left out: only folders below the root are searched", len(linked))
        inner = [path for path in inner if path not in linked]
    return [found for path in inner for found in photo_folders(path, depth - 1)]


def _from_manifest(path: Path) -> list[Visitor]:
    try:
        text = read_text(path)
        rows = list(csv.DictReader(text.splitlines())) if path.suffix.lower() == ".csv" else _toml_rows(text)
    except (ValueError, RecursionError, csv.Error, TypeError) as error:
        raise ClonerError(f"the manifest cannot be read: {error}", "Save it as UTF-8 text", path.name) from error
    return [_visitor(row, number, path) for number, row in enumerate(rows, start=1)]


def _toml_rows(text: str) -> list[Mapping[str, Any]]:
    rows = tomllib.loads(text).get("visitor", [])
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise TypeError("[[visitor]] tables are missing")
    return rows


def _visitor(row: Mapping[Any, Any], number: int, path: Path) -> Visitor:
    where = f"{path.name}, row {number}"
    if None in row:  # so csv names the cells beyond the last column
        raise ClonerError("this row has more cells than columns", "Put texts with commas into quotes", where)
    unknown = {key for key in row if key not in _KEYS}
    if unknown:
        named = ", ".join(sorted(map(str, unknown)))
        raise ClonerError(f"unknown column {named}", f"The columns are {', '.join(sorted(_KEYS))}", where)
    photos = str(row.get("photos") or "").strip()
    base = path.parent.resolve()
    try:
        folder = (base / photos).resolve()
    except (OSError, ValueError) as error:
        raise ClonerError("the photos' folder has no usable name", "Rename it", where) from error
    if not photos or not folder.is_relative_to(base):
        raise ClonerError("the photos must lie beside or below the manifest", "Move them there", where)
    height = row.get("height_cm")
    try:
        height_cm = None if height in (None, "") else float(height)
    except (TypeError, ValueError, OverflowError) as error:
        raise ClonerError(f"{height!r} is no height", "Write centimetres, for example 172", where) from error
    return Visitor(safe_identifier(str(row.get("id") or folder.name)), folder, height_cm)
