"""New photos in a tethered camera's folder, told from half-written ones and from those that lay there before."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from cloner.project.folder import SUFFIXES

Sizes = Mapping[Path, int]


def sizes(folder: Path) -> dict[Path, int]:
    """Return the photos of a folder with their sizes; nothing where it cannot be read (a pulled cable)."""
    try:
        inside = [path for path in sorted(folder.iterdir()) if path.suffix.lower() in SUFFIXES]
        return {path: path.stat().st_size for path in inside if path.is_file() and not path.name.startswith(".")}
    except OSError:
        return {}


def arrived(known: Sizes, last: Sizes, now: Sizes) -> tuple[Path, ...]:
    """Return the photos that are new and whole.

    Parameters
    ----------
    known : mapping of Path to int
        What was there when watching began, or was taken since.
    last, now : mapping of Path to int
        Two looks, a moment apart: a photo whose size stands still is whole.
    """
    return tuple(path for path, size in now.items() if size > 0 and last.get(path) == size and known.get(path) != size)
