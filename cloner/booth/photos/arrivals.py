"""New photos in a tethered camera's folder, told apart from incomplete and earlier ones."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Final

from cloner.project.atomic import write_text
from cloner.project.folder import SUFFIXES
from cloner.project.texts import LARGEST_BYTES
from cloner.untrusted import read_untrusted

Sizes = Mapping[Path, int]
#: In the event's folder while a camera's folder is watched; a window that is closed properly removes it.
NOTE_FILE: Final = ".camera.json"


def photo_sizes(folder: Path) -> dict[Path, int]:
    """Return the sizes of a folder's photos; empty if it cannot be read (a pulled cable)."""
    try:
        inside = [path for path in sorted(folder.iterdir()) if path.suffix.lower() in SUFFIXES]
        return {path: path.stat().st_size for path in inside if path.is_file() and not path.name.startswith(".")}
    except OSError:
        return {}


def complete_photos(known: Sizes, last: Sizes, now: Sizes) -> tuple[Path, ...]:
    """Return the photos that are new and completely written.

    Parameters
    ----------
    known : mapping of Path to int
        What was there when watching began, or was taken since.
    last, now : mapping of Path to int
        Two looks, a moment apart: a photo whose size stands still is whole.
    """
    return tuple(path for path, size in now.items() if size > 0 and last.get(path) == size and known.get(path) != size)


def write_note(root: Path, camera: Path, known: Sizes) -> None:
    """Record which of a camera's photos were already taken over, so that after a crash only the others are.

    Raises
    ------
    ClonerError
        If the event's folder cannot be written.
    """
    names = {path.name: size for path, size in known.items()}
    write_text(root / NOTE_FILE, json.dumps({"folder": str(camera), "known": names}) + "\n")


def read_note(root: Path, camera: Path) -> dict[Path, int] | None:
    """Return the record left by a window that crashed; None if there is none for this folder."""
    try:
        data = json.loads(read_untrusted(root / NOTE_FILE, LARGEST_BYTES))
        if data["folder"] != str(camera):
            return None
        return {camera / name: int(size) for name, size in data["known"].items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError):
        return None


def drop_note(root: Path) -> None:
    """Remove the record: photos in the camera's folder at its next use belong to somebody else."""
    (root / NOTE_FILE).unlink(missing_ok=True)
