"""A visitor's photo files: five named places and a tray for the rest. Nothing is ever overwritten.

A photo is stored in the tray before anybody looks at it, and its name says so: ``photo_003.new.jpg`` waits to find its
place, ``photo_004.face_side.jpg`` for the place it is meant for. Whatever ends the program, the photo is there.
"""

from __future__ import annotations

import io
import threading
import weakref
from pathlib import Path
from typing import Final

from PIL import ExifTags, Image, ImageOps

from cloner.booth.visitors.person_file import check_consent
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.atomic import atomic_path
from cloner.project.folder import SUFFIXES, load_photo, view_files
from cloner.records.photos import Photo, PhotoSet

TRAY: Final = "unsorted"
NEW: Final = "new"
#: Two threads never look for a free place at once.
_TURN = threading.Lock()
#: EXIF orientation after a quarter turn to the right, of the upright ones; mirrored ones are made upright first.
_TURNED_RIGHT: Final = {1: 6, 6: 3, 3: 8, 8: 1}
#: Photos that are held by somebody just now.
_DECODED: Final[weakref.WeakValueDictionary[tuple[object, ...], Photo]] = weakref.WeakValueDictionary()
_HEADER_MARKERS: Final = (*range(0xE0, 0xF0), 0xFE)  # application segments and comments of a JPEG file
_WRITE_HINT: Final = "Check the folder's permissions and space"


def store_photo(folder: Path, data: bytes, suffix: str, meant: ViewId | None = None) -> Path:
    """Store a new photo in a visitor's tray, to be checked, and return its path.

    Parameters
    ----------
    folder : Path
        The visitor's.
    data : bytes
        The file as the camera wrote it.
    suffix : str
        With the dot.
    meant : ViewId or None
        The view that it is brought for; None lets it find its place.

    Raises
    ------
    ClonerError
        If the visitor has not agreed, the kind of file is unknown, or the folder cannot be written.
    """
    check_consent(folder)
    if suffix.lower() not in SUFFIXES:
        raise ClonerError("this is no photo", f"Use one of {', '.join(SUFFIXES)}", suffix or "file")
    tray = folder / TRAY
    try:
        tray.mkdir(exist_ok=True)
        with _TURN:
            path = _free_place(tray, f".{meant or NEW}{suffix.lower()}")
            with atomic_path(path) as temporary:
                temporary.write_bytes(data)
    except OSError as error:
        raise ClonerError("the photo cannot be stored", _WRITE_HINT, folder.name) from error
    return path


def new_photos(folder: Path) -> tuple[Path, ...]:
    """Return the tray's photos that were not checked yet, the oldest first."""
    return tuple(path for path in tray_photos(folder) if path.stem.partition(".")[2])


def intended_view(path: Path) -> ViewId | None:
    """Return the view for which a photo of the tray was taken; None for any."""
    mark = path.stem.partition(".")[2]
    return ViewId(mark) if mark in set(ViewId) else None


def _free_place(tray: Path, suffix: str) -> Path:
    taken = {path.stem.partition(".")[0] for path in tray.iterdir()}
    number = next(number for number in range(1, len(taken) + 2) if f"photo_{number:03d}" not in taken)
    return tray / f"photo_{number:03d}{suffix}"


def tray_photos(folder: Path) -> tuple[Path, ...]:
    """Return the photos that are not assigned to a view yet, the oldest first."""
    tray = folder / TRAY
    found = sorted(tray.iterdir()) if tray.is_dir() else []
    return tuple(path for path in found if path.suffix.lower() in SUFFIXES and not path.name.startswith("."))


def placed_photos(folder: Path) -> PhotoSet:
    """Return the decoded photos of a visitor's views, those that exist.

    Raises
    ------
    ClonerError
        If one cannot be read.
    """
    return PhotoSet({view: decode_photo(path, view) for view, path in view_files(folder).items()})


def decode_photo(path: Path, view: ViewId) -> Photo:
    """Return a decoded photo; an unchanged file is not decoded again while the result is in use.

    A visitor is read anew after every photo that comes: without this the first of five is decoded fifteen times.

    Raises
    ------
    ClonerError
        If it cannot be read.
    """
    try:
        found = path.stat()
    except OSError:
        return load_photo(path, view)  # which tells it
    key = (path, view, found.st_ino, found.st_size, found.st_mtime_ns, found.st_ctime_ns)
    known = _DECODED.get(key)
    if known is None:
        known = _DECODED[key] = load_photo(path, view)
    return known


def photo_of(folder: Path, view: ViewId) -> Path | None:
    """Return a view's photo."""
    return view_files(folder).get(view)


def assign_view(folder: Path, path: Path, view: ViewId) -> Path:
    """Assign a visitor's photo to a view and return its new path; the previous one moves to the tray.

    Raises
    ------
    ClonerError
        If files cannot be moved; each lies in its old or new place then.
    """
    before = photo_of(folder, view)
    if before == path:
        return path
    if before is not None:
        move_to_tray(folder, before)
    return _moved(path, folder / f"{view}{path.suffix.lower()}")


def place_new(folder: Path, path: Path, view: ViewId | None) -> Path:
    """Give a new photo from the tray its place and return it: the newest photo of a view counts, for who retakes one
    means to replace it; a photo of no view stays in the tray and is no longer new.
    """
    if view is not None:
        return assign_view(folder, path, view)
    plain = path.with_name(path.stem.partition(".")[0] + path.suffix)
    return path if plain == path else _moved(path, plain)


def view_of_name(name: str) -> ViewId | None:
    """Return the view that a file's name gives."""
    stem = Path(name).stem.lower()
    return ViewId(stem) if stem in set(ViewId) else None


def swap_views(folder: Path, one: ViewId, other: ViewId) -> None:
    """Exchange the photos of two views; either may be missing."""
    first, second = photo_of(folder, one), photo_of(folder, other)
    aside = None if first is None else move_to_tray(folder, first)
    if second is not None:
        assign_view(folder, second, one)
    if aside is not None:
        assign_view(folder, aside, other)


def move_to_tray(folder: Path, path: Path) -> Path:
    """Move a view's photo to the tray."""
    tray = folder / TRAY
    tray.mkdir(exist_ok=True)
    with _TURN:
        return _moved(path, _free_place(tray, path.suffix.lower()))


def _moved(path: Path, to: Path) -> Path:
    try:
        return path.rename(to)
    except OSError as error:
        raise ClonerError("the photo cannot be moved", _WRITE_HINT, path.name) from error


def remove(path: Path) -> None:
    """Delete a photo."""
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise ClonerError("the photo cannot be deleted", _WRITE_HINT, path.name) from error


def rotate_right(path: Path) -> None:
    """Rotate a photo clockwise by a quarter; of JPEG files only the EXIF orientation changes.

    Raises
    ------
    ClonerError
        If the file cannot be read or written.
    """
    stream = io.BytesIO()
    try:
        with Image.open(path) as image:
            kind, exif = image.format or "PNG", image.getexif()
            before = exif.get(ExifTags.Base.Orientation, 1)
            if kind == "JPEG" and before in _TURNED_RIGHT:
                exif[ExifTags.Base.Orientation] = _TURNED_RIGHT[before]
                stream.write(_with_exif(path.read_bytes(), exif.tobytes()))
            else:
                upright = ImageOps.exif_transpose(image)
                upright.transpose(Image.Transpose.ROTATE_270).save(stream, "PNG" if kind == "MPO" else kind)
        with atomic_path(path) as temporary:
            temporary.write_bytes(stream.getvalue())
    except (OSError, ValueError, SyntaxError) as error:
        raise ClonerError("the photo cannot be turned", "Turn it with another program", path.name) from error


def photos_in(path: Path) -> tuple[Path, ...]:
    """Return a file itself, or the photos of a folder."""
    if not path.is_dir():
        return (path,)
    return tuple(one for one in sorted(path.iterdir()) if one.suffix.lower() in SUFFIXES and one.is_file())


def _with_exif(jpeg: bytes, exif: bytes) -> bytes:
    """Return a JPEG file with another EXIF segment (ISO/IEC 10918-1, annex B: marker, length, content)."""
    at, others = 2, b""
    while jpeg[at : at + 1] == b"\xff" and jpeg[at + 1] in _HEADER_MARKERS:
        end = at + 2 + int.from_bytes(jpeg[at + 2 : at + 4], "big")
        if not jpeg[at + 4 : end].startswith(b"Exif\x00"):
            others += jpeg[at:end]
        at = end
    return jpeg[:2] + b"\xff\xe1" + (len(exif) + 2).to_bytes(2, "big") + exif + others + jpeg[at:]
