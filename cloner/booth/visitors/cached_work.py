"""Earlier results for a visitor, reused while the photos are unchanged."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

from cloner.project.clone_file import CLONE_FILE as CLONE_FILE
from cloner.project.values_file import load_values
from cloner.records.photos import PhotoSet

WORK: Final = "work"
PROPOSED_FILE: Final = "proposed.npz"
VALUES_FILE: Final = "values.npz"
RESULTS: Final = "clones"


def cached_values(folder: Path, photos: PhotoSet) -> dict[str, Any]:
    """Return the cached stage values of a visitor, if they were computed from the same photos.

    Either all values of the last clone, the photos with them, or the proposals alone; nothing where photos changed.
    """
    for name in (VALUES_FILE, PROPOSED_FILE):
        values = load_values(folder / WORK / name)
        if values and values.pop("digests", None) == photo_digests(photos):
            kept_values = values if name == VALUES_FILE else {"proposals": values["proposals"]}
            return {**kept_values, "photos": photos}
    return {}


def proposed_points(folder: Path, photos: PhotoSet) -> dict[str, Any]:
    """Return "body_points" and "face_points" as proposed for the same photos; empty otherwise."""
    values = load_values(folder / WORK / PROPOSED_FILE)
    return values if values and values.pop("digests", None) == photo_digests(photos) else {}


def photo_digests(photos: PhotoSet) -> dict[str, str]:
    """Return the digests of photos by view."""
    return {str(view): photo.digest for view, photo in photos.photos.items()}
