"""A visitor's files in chosen formats with report and pictures, as a folder or one zip file."""

from __future__ import annotations

import os
import shutil
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from cloner.booth.handover.copying import copy_verified, remove_leftovers
from cloner.errors import ClonerError
from cloner.exporters.table import EXPORTERS, check_formats
from cloner.pipeline import Progress
from cloner.project.clone_file import CLONE_FILE, load_clone

#: Files of a result that go along whatever formats are chosen.
_BESIDE: Final = ("report.html", "viewer.html", "previews")
#: Where files are made before they go to the stick: beside the clone, so that they go with the visitor's data.
_ROOM: Final = ".take-away.partial-"
#: Share of the whole that making the files takes, the rest copies them and reads them back (taste).
_MADE: Final = 0.5


def hand_over(result: Path, target: Path, formats: Sequence[str], progress: Progress) -> Path:
    """Write a visitor's files to a new folder, or to a zip file if ``target`` ends so; completely or not at all.

    They are made beside the clone first, then copied and read back (`cloner.booth.handover.copying`).

    Parameters
    ----------
    result : Path
        The clone's folder.
    target : Path
        ``.../name`` or ``.../name.zip``; must not exist.
    formats : sequence of str
        Names of exporters.
    progress : callable
        May raise Cancelled.

    Raises
    ------
    ClonerError
        If there is no clone, the target exists or cannot be written.
    """
    check_formats(formats)
    if target.exists():
        raise ClonerError("this is there already", "Choose another name or place", target.name)
    clone = load_clone(result / CLONE_FILE)
    room = result.parent / f"{_ROOM}{os.getpid()}"
    try:
        _remove_temporary_files(result)
        inside = room / target.stem
        inside.mkdir(parents=True)
        for number, name in enumerate(formats):
            progress("export", _MADE * number / (1 + len(formats)))
            EXPORTERS.get(name)(clone, inside)
        progress("report", _MADE * len(formats) / (1 + len(formats)))
        _copy_beside(result, inside)
        whole = _packed(inside) if target.suffix.lower() == ".zip" else inside
        copy_verified(whole, target, lambda step, done: progress(step, _MADE + (1.0 - _MADE) * done))
    except OSError as error:
        raise ClonerError("it cannot be written there", "Is the stick full or write-protected?", target.name) from error
    finally:
        shutil.rmtree(room, ignore_errors=True)
    return target


def clean_up(result: Path, target: Path) -> None:
    """Remove what an interrupted process left beside the clone and the target."""
    _remove_temporary_files(result)
    remove_leftovers(target)


def _remove_temporary_files(result: Path) -> None:
    """Remove the temporary files of killed processes."""
    for rest in result.parent.glob(f"{_ROOM}*"):
        shutil.rmtree(rest, ignore_errors=True)


def _copy_beside(result: Path, inside: Path) -> None:
    for name in _BESIDE:
        source = result / name
        if source.is_dir():
            shutil.copytree(source, inside / name)
        elif source.is_file():
            shutil.copy2(source, inside / name)


def _packed(inside: Path) -> Path:
    """Return a zip file of a finished folder, beside it."""
    packed = inside.with_suffix(".packed")
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(inside.rglob("*")):
            if path.is_file():
                archive.write(path, f"{inside.name}/{path.relative_to(inside).as_posix()}")
    return packed
