"""A person's folder: photos, personal facts, and corrections."""

from __future__ import annotations

import logging
import os
import re
import unicodedata
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.frames import ViewId, cm_from_m, m_from_cm
from cloner.project import corrections as corrections_json
from cloner.project.atomic import write_text
from cloner.project.person_table import person_table, sex_and_age_of, tape_mm_of, terms_of, text_of
from cloner.project.texts import check_own, read_text
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.points import Corrections
from cloner.records.terms import Terms
from cloner.vision.photographs.pictures import read_picture

log = logging.getLogger(__name__)
SUFFIXES: Final = (".jpg", ".jpeg", ".png", ".webp", ".tif", ".tiff", ".heic", ".heif")
LARGEST_TOLD: Final = 1e9  # whole numbers in TOML may have more digits than a float holds
DEFAULT_HEIGHT_CM: Final = 170.0  # taste: near the mean adult; lengths are then marked as unscaled
SMALLEST_HEIGHT_CM: Final = 60.0  # below the smallest adult ever measured (55 cm), above any typing slip in metres
LARGEST_HEIGHT_CM: Final = 250.0  # living people stay below; catches millimetres and inches
LONGEST_IDENTIFIER: Final = 60  # file systems allow 255 bytes; leaves room for our own suffixes
FEW: Final = 5  # names in a sentence; taste
PERSON_FILE: Final = "person.toml"


def find_photos(folder: Path) -> dict[ViewId, Path]:
    """Return the photo files of a folder by the view their name says.

    Parameters
    ----------
    folder : Path
        Holds ``body_front.jpg`` and so on, in any case, with a suffix of
        `SUFFIXES`; other files are left alone.

    Raises
    ------
    ClonerError
        If the folder is missing, one view has two files, a photo is a link out of the folder, or neither
        body_front nor face_front is there.
    """
    found = view_files(folder)
    if ViewId.BODY_FRONT not in found and ViewId.FACE_FRONT not in found:
        have = f"only {', '.join(found)}" if found else "no photo"
        message = f"{have} with a usable name is here, and one front photo is needed"
        raise ClonerError(message, _naming_hint(folder), folder.resolve().name)
    return found


def view_files(folder: Path) -> dict[ViewId, Path]:
    """Return the photo files of a folder by view, as :func:`find_photos` does, whichever there are.

    Raises
    ------
    ClonerError
        If the folder is missing, one view has two files, or a photo is a link out of the folder.
    """
    if not _is_folder(folder):
        raise ClonerError("there is no such folder of photos", "Give the folder that holds the photos", folder.name)
    found: dict[ViewId, Path] = {}
    for path in sorted(_entries(folder)):
        view = _view_of(path)
        if view is None:
            continue
        if view in found:
            message = f"there are two photos for {view}: {found[view].name} and {path.name}"
            raise ClonerError(message, "Keep one of them", folder.name)
        check_own(path)
        if not path.is_file():
            if not os.path.lexists(path):
                continue  # moved away while the folder was read
            sentence = "this is no photo but a folder, a pipe or the like"
            raise ClonerError(sentence, "Put the photo itself there", path.name)
        found[view] = path
    return {view: found[view] for view in ViewId if view in found}


def _naming_hint(folder: Path) -> str:
    """Return a hint for a folder without photos: use the one inside it that has them, or rename."""
    inner = [path.name for path in sorted(folder.iterdir()) if holds_photos(path)]
    if inner:
        more = ", ..." if len(inner) > FEW else ""
        named = f"{', '.join(inner[:FEW])}{more}"
        return f"Give the folder inside it that holds the photos ({named}), or use cloner batch for all"
    expected = ", ".join(f"{view}.jpg" for view in ViewId)
    return f"Name the photos {expected} (png, webp, tiff and heic work too)"


def holds_photos(folder: Path) -> bool:
    """Return whether a folder holds at least one file named as a view."""
    return folder.is_dir() and any(_view_of(path) is not None for path in _entries(folder))


def load_photos(folder: Path) -> PhotoSet:
    """Return the decoded photos of a folder.

    Raises
    ------
    ClonerError
        As :func:`find_photos` and :func:`cloner.vision.photographs.pictures.read_picture`.
    """
    return PhotoSet({view: load_photo(path, view) for view, path in find_photos(folder).items()})


def load_photo(path: Path, view: ViewId) -> Photo:
    """Return one decoded photo of a view.

    Raises
    ------
    ClonerError
        As :func:`cloner.vision.photographs.pictures.read_picture`.
    """
    picture = read_picture(path)
    return Photo(view=view, rgb=picture.rgb, focal_35mm=picture.focal_35mm, digest=picture.digest, name=path.name)


def read_person(folder: Path, height_cm: float | None = None, identifier: str | None = None) -> Person:
    """Return the known facts about the person besides the photos.

    Parameters
    ----------
    folder : Path
        May hold ``person.toml`` with name, height_cm, sex, age, notes, consent, event, licence and a table
        measures (cm).
    height_cm : float or None
        Barefoot height from the command line; wins over the file.
    identifier : str or None
        Name of the result; None derives it from the folder's name.

    Returns
    -------
    Person
        ``stature_is_known`` is False when neither source gave a height.

    Raises
    ------
    ClonerError
        If the file is malformed, has unknown keys, or the height or a measure is absurd.
    """
    data = person_table(folder / PERSON_FILE)
    name = text_of(data, "name")
    notes = text_of(data, "notes")
    source = "person.toml, height_cm" if height_cm is None else "--height-cm"
    height = height_cm if height_cm is not None else data.get("height_cm")
    known = height is not None
    stature_m = m_from_cm(_checked_height(height, source) if known else DEFAULT_HEIGHT_CM)
    terms_of(data)
    sex, age_years = sex_and_age_of(data)
    return Person(
        identifier=safe_identifier(identifier if identifier is not None else folder.resolve().name),
        name=name,
        stature_m=stature_m,
        stature_is_known=known,
        notes=notes,
        tape_mm=tape_mm_of(data, stature_m),
        sex=sex,
        age_years=age_years,
    )


def read_consent(folder: Path) -> str:
    """Return the consent in ``person.toml``: to what, and when; "" where there is none.

    Raises
    ------
    ClonerError
        If the file is malformed.
    """
    return text_of(person_table(folder / PERSON_FILE), "consent")


def read_terms(folder: Path) -> Terms:
    """Return the terms in ``person.toml``; none where it records no consent.

    Raises
    ------
    ClonerError
        If the file is malformed or names an unknown licence.
    """
    return terms_of(person_table(folder / PERSON_FILE))


def checked_height_m(height_m: float | None) -> tuple[float, bool]:
    """Return a barefoot height, metres, and whether it is known; None gives the height that is assumed.

    Raises
    ------
    ClonerError
        If the height is absurd.
    """
    if height_m is None:
        return m_from_cm(DEFAULT_HEIGHT_CM), False
    return m_from_cm(_checked_height(cm_from_m(height_m), "height_m")), True


def person_warnings(person: Person) -> tuple[str, ...]:
    """Return warnings about the person's data, in plain words."""
    if person.stature_is_known:
        return ()
    return (
        f"No height was given: {DEFAULT_HEIGHT_CM:.0f} cm is assumed, so every length is unscaled; "
        "give --height-cm or height_cm in person.toml",
    )


def photo_warnings(photos: PhotoSet) -> tuple[str, ...]:
    """Return warnings about missing body photos; the head stage warns about the face's."""
    if not photos.body_views:
        return ("There is no body photo: the body is the generic one of a matching build, its colours a guess",)
    data = {
        ViewId.BODY_FRONT: "There is no front photo of the body: its front is seen by the face photo alone",
        ViewId.BODY_SIDE: "There is no side photo of the body: its depths are those of a usual body of this shape",
        ViewId.BODY_BACK: "There is no back photo of the body: its back is coloured from what the other photos show",
    }
    return tuple(text for view, text in data.items() if view not in photos.photos)


def read_corrections(folder: Path) -> Corrections:
    """Return the corrections of ``corrections.json``, or none when there is no such file.

    Raises
    ------
    ClonerError
        If the file cannot be read or is malformed.
    """
    path = folder / corrections_json.WHERE
    return corrections_json.from_json(read_text(path)) if path.exists() else corrections_json.no_corrections()


def write_corrections(folder: Path, corrections: Corrections) -> None:
    """Write ``corrections.json`` in one step, so that a crash leaves the old file.

    Raises
    ------
    ClonerError
        If the folder cannot be written.
    """
    write_text(folder / corrections_json.WHERE, corrections_json.to_json(corrections))


def safe_identifier(name: str) -> str:
    """Return a name that is one harmless path component on every file system.

    Letters and digits of any script stay; everything else becomes "-".  Names
    that would vanish or hide (dots only, nothing left) become "visitor".
    """
    composed = unicodedata.normalize("NFC", name)
    kept = re.sub(r"[^\w.-]+", "-", composed, flags=re.UNICODE)
    kept = re.sub(r"\.{2,}", ".", kept).strip("-._ ")
    while len(kept.encode()) > LONGEST_IDENTIFIER:
        kept = kept[:-1].rstrip("-._ ")
    reserved = re.fullmatch(r"(?i)(con|prn|aux|nul|com\d|lpt\d)(\..*)?", kept)
    return f"visitor-{kept}" if reserved else kept or "visitor"


def _is_folder(path: Path) -> bool:
    try:
        return path.is_dir()
    except (OSError, ValueError):  # a name that no file system takes
        return False


def _entries(folder: Path) -> list[Path]:
    try:
        return list(folder.iterdir())
    except OSError as error:
        raise ClonerError("the folder cannot be read", "Check its permissions", folder.name) from error


def _view_of(path: Path) -> ViewId | None:
    stem = path.stem.lower()
    if path.suffix.lower() not in SUFFIXES or stem not in set(ViewId):
        return None
    return ViewId(stem)


def _checked_height(value: Any, where: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ClonerError("the height must be a number of centimetres", "Write height_cm = 172", where)
    if not SMALLEST_HEIGHT_CM <= value <= LARGEST_HEIGHT_CM:  # also refuses nan
        shown = f"{value:g}" if not abs(value) >= LARGEST_TOLD else "ever so many"
        message = f"a height of {shown} cm is outside {SMALLEST_HEIGHT_CM:.0f} to {LARGEST_HEIGHT_CM:.0f} cm"
        raise ClonerError(message, "Give the barefoot height in centimetres", where)
    return float(value)
