"""What a visitor takes home: files in chosen formats with report and pictures, as a folder or one zip file."""

from __future__ import annotations

import os
import shutil
import tempfile
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from cloner.cloning import check_formats
from cloner.errors import ClonerError
from cloner.exporters.table import EXPORTERS
from cloner.pipeline import Progress
from cloner.project.clone_file import CLONE_FILE, load_clone

#: Files of a result that go along whatever formats are chosen.
_BESIDE: Final = ("report.html", "viewer.html", "previews")


def hand_over(result: Path, target: Path, formats: Sequence[str], progress: Progress) -> Path:
    """Write a visitor's files to a new folder, or a new zip file where ``target`` ends so; whole or not at all.

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
    try:
        with tempfile.TemporaryDirectory(prefix=f".{target.stem}.partial-{os.getpid()}-", dir=target.parent) as room:
            inside = Path(room) / target.stem
            inside.mkdir()
            for number, name in enumerate(formats):
                progress("export", number / (1 + len(formats)))
                EXPORTERS.get(name)(clone, inside)
            progress("report", len(formats) / (1 + len(formats)))
            _copy_beside(result, inside)
            _put(inside, target)
    except OSError as error:
        raise ClonerError("it cannot be written there", "Is the stick full or write-protected?", target.name) from error
    return target


def _copy_beside(result: Path, inside: Path) -> None:
    for name in _BESIDE:
        source = result / name
        if source.is_dir():
            shutil.copytree(source, inside / name)
        elif source.is_file():
            shutil.copy2(source, inside / name)


def _put(inside: Path, target: Path) -> None:
    """Move the finished folder, or its zip, into place."""
    if target.suffix.lower() != ".zip":
        inside.rename(target)
        return
    packed = inside.with_suffix(".packed")
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(inside.rglob("*")):
            if path.is_file():
                archive.write(path, f"{inside.name}/{path.relative_to(inside).as_posix()}")
    packed.rename(target)
