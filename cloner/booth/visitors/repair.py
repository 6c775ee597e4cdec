"""Repair of an event's damaged files from what can be read; the damaged file is kept and reported.

A file of a newer version is not damaged: it is left as it is, and its error says so.
"""

from __future__ import annotations

import json
import logging
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, Final, TypeVar

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project import corrections as corrections_json
from cloner.project.atomic import write_text
from cloner.project.folder import (
    LARGEST_HEIGHT_CM,
    PERSON_FILE,
    SMALLEST_HEIGHT_CM,
    read_consent,
    read_corrections,
    read_person,
    write_corrections,
)
from cloner.project.texts import read_text
from cloner.records.points import Correction, Corrections
from cloner.records.terms import LICENCES

log = logging.getLogger(__name__)

Made = TypeVar("Made")
#: What an error about a file of a newer version begins with; see `cloner.project.texts.check_format`.
_NEWER: Final = "it was written by a newer version"


def move_damaged(path: Path) -> Path:
    """Rename a damaged file to ``NAME.damaged``, ``NAME.damaged-2`` and so on, and return the new path.

    Raises
    ------
    ClonerError
        If it cannot be moved.
    """
    names = (f"{path.name}.damaged{'' if number == 1 else f'-{number}'}" for number in range(1, 10_000))
    aside = next(path.with_name(name) for name in names if not path.with_name(name).exists())
    try:
        return path.rename(aside)
    except OSError as error:
        raise ClonerError(
            "the file cannot be written", "Check the folder's permissions and space", path.name
        ) from error


def repair_file(
    path: Path, read: Callable[[], object], salvage: Callable[[str], Made], write: Callable[[Made], object]
) -> str:
    """Repair a file if it cannot be read; return a message, "" if it was intact.

    Parameters
    ----------
    path : Path
        A link or another thing that is no file is moved aside like a damaged one.
    read : callable
        Raises ClonerError where the file is damaged.
    salvage : callable
        Takes the text, as far as it can be read, and returns what is left of it.
    write : callable
        Writes that.

    Raises
    ------
    ClonerError
        If it is of a newer version, or cannot be moved or written.
    """
    try:
        read()
    except ClonerError as error:
        if error.message.startswith(_NEWER):
            raise
        text = _text(path)
        aside = move_damaged(path)
        write(salvage(text))
        log.warning("%s was damaged (%s); it is kept as %s", path.name, error.message, aside.name)
        return f"{path.name} was damaged and is put right from what could be read; the damaged file is kept beside it"
    return ""


def repair_visitor(folder: Path) -> tuple[str, ...]:
    """Repair a visitor's small files, and return a message, "" if all were intact.

    Raises
    ------
    ClonerError
        As :func:`repair_file`.
    """
    messages = (
        repair_file(
            folder / corrections_json.WHERE,
            lambda: read_corrections(folder),
            salvage_corrections,
            lambda left: write_corrections(folder, left),
        ),
        repair_file(
            folder / PERSON_FILE,
            lambda: (read_person(folder), read_consent(folder)),
            lambda text: "\n".join(_whole_lines(text)) + "\n",
            lambda left: write_text(folder / PERSON_FILE, left),
        ),
    )
    return tuple(one for one in messages if one)


def salvage_corrections(text: str) -> Corrections:
    """Return the corrections that can still be read in a damaged file's text: whole points of known views."""
    points: dict[ViewId, dict[str, Correction]] = {}
    view: ViewId | None = None
    for found in re.finditer(r'"(\w+)"\s*:\s*(\{[^{}]*\}|\{)', text):
        name, body = found.groups()
        if name in set(ViewId):
            view = ViewId(name)
        elif view is not None and body != "{":
            entry = {name: _object(body)}
            try:
                one = corrections_json.from_json(json.dumps({"format": 1, "views": {view.value: entry}}))
            except ClonerError:
                continue
            points.setdefault(view, {}).update(one.points[view])
    return Corrections(points=points)


def _object(text: str) -> Any:
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return None


def _whole_lines(text: str) -> Iterator[str]:
    """Yield the lines of a damaged ``person.toml`` that can be read by themselves."""
    seen: set[str] = set()
    for line in text.splitlines():
        try:
            data = tomllib.loads(line)
        except (tomllib.TOMLDecodeError, RecursionError):
            continue
        if _fits(data) and not seen & data.keys():
            seen |= data.keys()
            yield line


def _fits(data: Mapping[str, Any]) -> bool:
    kinds = {"name": str, "notes": str, "consent": str, "event": str, "licence": str, "height_cm": (int, float)}
    fits = all(key in kinds and isinstance(value, kinds[key]) for key, value in data.items())  # type: ignore[arg-type]
    fits = fits and data.get("licence", LICENCES[0]) in LICENCES
    high = data.get("height_cm", SMALLEST_HEIGHT_CM)
    return bool(data) and fits and SMALLEST_HEIGHT_CM <= high <= LARGEST_HEIGHT_CM


def _text(path: Path) -> str:
    """Return the text of a file as far as it can be decoded."""
    try:
        return read_text(path)
    except ClonerError:
        try:
            return path.read_bytes().decode("utf-8", "replace") if path.is_file() and not path.is_symlink() else ""
        except OSError:
            return ""
