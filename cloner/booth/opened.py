"""A visitor read from its folder: everything that the window shows."""

from __future__ import annotations

import contextlib
import hashlib
import json
import logging
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.booth.handover.takeaway import has_result
from cloner.booth.photos.check_cache import read_checks
from cloner.booth.photos.photo_files import placed_photos, tray_photos
from cloner.booth.photos.photo_problems import PhotoCheck
from cloner.booth.visitors.cached_work import CLONE_FILE, RESULTS, cached_values, photo_digests, proposed_points
from cloner.booth.visitors.person_file import person_facts
from cloner.booth.visitors.repair import repair_visitor
from cloner.booth.visitors.versions import finish_swap
from cloner.errors import ClonerError
from cloner.frames import ViewId, cm_from_m
from cloner.project.clone_file import load_clone
from cloner.project.corrections import WHERE as CORRECTIONS_FILE
from cloner.project.corrections import check_against, no_corrections, to_json
from cloner.project.folder import read_corrections, read_person, safe_identifier
from cloner.project.results import RESULT_MARK, file_digest
from cloner.project.texts import read_text
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import Corrections
from cloner.vision.photographs.pictures import read_picture

log = logging.getLogger(__name__)

_STAMP: Final = "stamp"
#: Height of the small pictures, px: enough for a card on a screen of double density.
THUMBNAIL_PX: Final = 640


@dataclass(frozen=True, slots=True, eq=False)
class Cloned:
    """A finished clone in its folder.

    Attributes
    ----------
    folder : Path
        The result.
    values : mapping
        "clone" always; where they are kept, "photos", "joined", "obeyed", "silhouettes" and the other values of the
        run by which points can be moved.
    warnings : tuple of str
    corrections_digest : str
        sha256 of the corrections that were obeyed, as their file; "" where there were none.
    """

    folder: Path
    values: Mapping[str, Any]
    warnings: tuple[str, ...] = ()
    corrections_digest: str = ""

    def obeys(self, corrections: Corrections) -> bool:
        """Return whether it was made with exactly these corrections."""
        same = self.corrections_digest == corrections_digest(corrections)
        nothing = ("", corrections_digest(no_corrections()))
        return same or (self.corrections_digest in nothing and not any(corrections.points.values()))

    def has_height_of(self, height_cm: float | None) -> bool:
        """Return whether it was made with this height (None: unknown); True if it does not record one."""
        person = self.values.get("person")
        if person is None:
            return True
        made_cm = round(cm_from_m(person.stature_m), 1) if person.stature_is_known else None
        return bool(made_cm == height_cm)


@dataclass(frozen=True, slots=True, eq=False)
class TrayPhoto:
    """A photo that is not assigned to a view yet.

    Attributes
    ----------
    path : Path
    digest : str
    thumbnail : (h, w, 3) uint8
    """

    path: Path
    digest: str
    thumbnail: NDArray[np.uint8]


@dataclass(frozen=True, slots=True, eq=False)
class Opened:
    """A visitor's folder, as read.

    Attributes
    ----------
    folder : Path
    photos : PhotoSet
        Whichever there are, none included.
    person : Person
    height_cm : float or None
    consent : str
        As it is recorded; "" where it is not.
    corrections : Corrections
    warnings : tuple of str
    tray : tuple of TrayPhoto
        Photos that show no view yet.
    checks : mapping of str to PhotoCheck
        What was found of photos, by digest.
    thumbnails : mapping of ViewId to (h, w, 3) uint8
    proposed : mapping
        "body_points" and "face_points", where they are known for these photos.
    cloned : Cloned or None
        The clone of these very photos.
    """

    folder: Path
    photos: PhotoSet
    person: Person
    height_cm: float | None
    consent: str
    corrections: Corrections
    warnings: tuple[str, ...] = ()
    tray: tuple[TrayPhoto, ...] = ()
    checks: Mapping[str, PhotoCheck] = field(default_factory=dict)
    thumbnails: Mapping[ViewId, NDArray[np.uint8]] = field(default_factory=dict)
    proposed: Mapping[str, Any] = field(default_factory=dict)
    cloned: Cloned | None = None


def open_visitor(folder: Path) -> Opened:
    """Read a visitor's folder.

    Raises
    ------
    ClonerError
        If the folder is missing, or something in it cannot be read.
    """
    mended = _repaired_corrections(folder) if folder.is_dir() else ()
    photos = placed_photos(folder)
    corrections, warnings = _corrections(folder, photos)
    _, height_cm, consent = person_facts(folder)
    return Opened(
        folder,
        photos,
        read_person(folder),
        height_cm,
        consent,
        corrections,
        (*mended, *warnings),
        tuple(_tray(folder)),
        read_checks(folder),
        {view: thumbnail(photo.rgb) for view, photo in photos.photos.items()},
        proposed_points(folder, photos),
        read_cloned(folder, photos),
    )


def _tray(folder: Path) -> Iterator[TrayPhoto]:
    """Yield the photos of the tray; an unreadable one becomes an empty picture that can be removed."""
    for path in tray_photos(folder):
        try:
            picture = read_picture(path)
        except ClonerError:
            yield TrayPhoto(path, "", np.full((4, 3, 3), 127, np.uint8))
        else:
            yield TrayPhoto(path, picture.digest, thumbnail(picture.rgb))


def thumbnail(rgb: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a small (`THUMBNAIL_PX`, w, 3) uint8 copy of a photo."""
    share = THUMBNAIL_PX / rgb.shape[0]
    size = (max(1, round(rgb.shape[1] * share)), THUMBNAIL_PX)
    return np.ascontiguousarray(cv2.resize(np.asarray(rgb), size, interpolation=cv2.INTER_AREA))


def _corrections(folder: Path, photos: PhotoSet) -> tuple[Corrections, tuple[str, ...]]:
    """Return the corrections without those outside a retaken, smaller photo; the file keeps them."""
    corrections = read_corrections(folder)
    try:
        return corrections, check_against(corrections, photos)
    except ClonerError as error:
        return no_corrections(), (str(error),)


def _repaired_corrections(folder: Path) -> tuple[str, ...]:
    with contextlib.suppress(OSError):  # a clone that cannot be read is made again
        finish_swap(folder, safe_identifier(folder.resolve().name))
    return repair_visitor(folder)


def read_cloned(folder: Path, photos: PhotoSet) -> Cloned | None:
    """Return the finished clone if it was made of exactly these photos, else None."""
    result = folder / RESULTS / safe_identifier(folder.resolve().name)
    if not has_result(result):
        return None
    try:
        report = json.loads(read_text(result / RESULT_MARK))
        if report[_STAMP]["photos"] != photo_digests(photos):
            return None
        values = {**cached_values(folder, photos), "clone": load_clone(result / CLONE_FILE)}
        return Cloned(result, values, tuple(report["warnings"]), _obeyed_digest(folder, report[_STAMP]))
    except (ClonerError, OSError, ValueError, KeyError, TypeError):
        log.warning("%s: its clone cannot be read and has to be made again", folder.name)
        return None


def corrections_digest(corrections: Corrections) -> str:
    """Return the sha256 of the corrections' file content."""
    return hashlib.sha256(to_json(corrections).encode()).hexdigest()


def _obeyed_digest(folder: Path, stamp: Mapping[str, Any]) -> str:
    """Return `Cloned.corrections_digest`; a file written by hand is normalised first."""
    made_with = str(stamp.get("beside", {}).get(CORRECTIONS_FILE, ""))
    path = folder / CORRECTIONS_FILE
    if made_with and path.is_file() and file_digest(path) == made_with:
        return corrections_digest(read_corrections(folder))
    return made_with
