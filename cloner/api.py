"""Cloner from Python: ``from cloner import clone``."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from cloner.errors import ClonerError
from cloner.frames import ViewId, cm_from_m
from cloner.making import DEFAULT_TEXTURE_SIZE, clone_photos
from cloner.pipeline import Progress, quiet
from cloner.project.corrections import no_corrections
from cloner.project.folder import checked_height_m, load_photos, read_corrections, read_person
from cloner.records.clones import Clone
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.vision.photographs.pictures import read_picture


def clone(
    photos: str | Path | Mapping[str, str | Path],
    height_m: float | None = None,
    *,
    seed: int = 0,
    texture_size: int = DEFAULT_TEXTURE_SIZE,
    progress: Progress = quiet,
) -> Clone:
    """Return the clone of the person in some photos; writes nothing.

    Parameters
    ----------
    photos : path or mapping of str to path
        A folder with body_front.jpg and so on (``person.toml`` and ``corrections.json`` beside them count), or files by
        view: body_front, body_side, body_back, face_front, face_side; one front photo is needed.
    height_m : float, optional
        Barefoot height in metres; wins over ``person.toml``. Without one 1.70 m is assumed.
    seed : int
        The same photos and seed give the same clone.
    texture_size : int
        Side of the texture: 512, 1024, 2048 or 4096 texels.
    progress : callable
        Called with a step's name and the fraction 0..1 of the whole; may raise :class:`cloner.errors.Cancelled`.

    Returns
    -------
    Clone
        ``cloner.exporters.table.EXPORTERS.get("glb")(clone, folder)`` writes it.

    Raises
    ------
    ClonerError
        If the photos or the height cannot be used; its message says what to do.
    """
    if isinstance(photos, str | Path):
        folder = Path(photos)
        loaded, corrections = load_photos(folder), read_corrections(folder)
        person = read_person(folder, None if height_m is None else cm_from_m(height_m))
    else:
        loaded, corrections, person = _loaded(photos), no_corrections(), _person(height_m)
    values, _ = clone_photos(loaded, person, corrections, seed=seed, texture_size=texture_size, progress=progress)
    made: Clone = values["clone"]
    return made


def _loaded(files: Mapping[str, str | Path]) -> PhotoSet:
    photos = {}
    for name, path in files.items():
        try:
            view = ViewId(name)
        except ValueError as error:
            raise ClonerError(f"{name!r} is no view", f"The views are {', '.join(ViewId)}", "photos") from error
        picture = read_picture(Path(path))
        photos[view] = Photo(view, picture.rgb, picture.focal_35mm, picture.digest, Path(path).name)
    if ViewId.BODY_FRONT not in photos and ViewId.FACE_FRONT not in photos:
        raise ClonerError("one front photo is needed", "Give body_front, face_front or both", "photos")
    return PhotoSet(photos)


def _person(height_m: float | None) -> Person:
    stature_m, known = checked_height_m(height_m)
    return Person(identifier="visitor", name="", stature_m=stature_m, stature_is_known=known, notes="", tape_mm=())
