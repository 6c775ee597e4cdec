"""A body from outside the generic's family (shared/foreign/stein_woman), scored with the same rulers."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import numpy as np
from body_people import commit, score_photos
from body_scores import HELD_OUT, KnownTruth
from foreign import foreign_camera, foreign_surface, told_of
from numpy.typing import NDArray

from cloner.evaluate.truths.truth import TruthView
from cloner.frames import ViewId
from cloner.project.folder import load_photos
from cloner.records.photos import Person, PhotoSet
from cloner.records.views import Camera
from cloner.vision.photographs.pictures import read_picture

SURFACE_POINTS: Final = 100_000
_HELD_FILE: Final = "body_45"


def score_foreign(folder: Path, photos_name: str) -> dict[str, Any]:
    """Return the figures of one foreign body.

    Parameters
    ----------
    folder : Path
        With ``truth.json``, ``truth_mesh.ply``, photos and masks (shared/foreign/README.md).
    photos_name : str
        "input" or "input_clutter".

    Raises
    ------
    ClonerError
        If the folder is not there: it is not ours to ship.
    """
    told = told_of(folder, "body")
    all_photos = load_photos(folder / photos_name)
    photos = PhotoSet({view: photo for view, photo in all_photos.photos.items() if view.is_body})
    truth = foreign_truth(folder, photos_name, told)
    found, _ = score_photos(photos, Person(folder.name, "", float(told["stature_m"])), truth, "painted on")
    background = "plain" if photos_name == "input" else "cluttered"
    name = f"{folder.name} {photos_name}"
    return {
        "name": name,
        "tightness": "painted on",
        "background": background,
        "foreign": True,
        "commit": commit(),
        **found,
    }


def foreign_truth(folder: Path, photos_name: str, told: dict[str, Any]) -> KnownTruth:
    """Return the truth of a foreign body; it has no joints and hardly any named points."""
    surface = foreign_surface(folder, told, {}, SURFACE_POINTS)
    held = photos_name.replace("input", "heldout")
    files = {view.value: f"{photos_name}/{view.value}" for view in ViewId if view.is_body} | {
        HELD_OUT: f"{held}/{_HELD_FILE}"
    }
    views = {name: foreign_view(folder, name, told["photos"][file]) for name, file in files.items()}
    chin = float(told["landmarks"]["chin"][1])
    heads = {name: _above(view.camera, view.mask, chin) for name, view in views.items()}
    girths = {name: 1e3 * _girth_m(value) for name, value in told["girths"].items()}
    return KnownTruth(float(told["stature_m"]), girths, girths, surface, views, heads, {name: {} for name in files}, {})


def _girth_m(value: Any) -> float:
    """Return a girth in metres, told as a number or with its level."""
    return float(value["girth_m"] if isinstance(value, dict) else value)


def foreign_view(folder: Path, name: str, told: dict[str, Any]) -> TruthView:
    """Return the truth of one photo."""
    mask = read_picture(folder / told["mask"]).rgb[..., 0] > 127
    return TruthView(name, foreign_camera(told["camera"]), {}, {}, {}, mask, read_picture(folder / told["file"]).rgb)


def _above(camera: Camera, mask: NDArray[np.bool_], height_m: float) -> NDArray[np.bool_]:
    """Return the pixels of a mask above a height at the person's axis."""
    row = float(camera.project(np.array([[0.0, height_m, 0.0]]))[0, 1])
    above = mask.copy()
    above[max(int(row), 0) :] = False
    return above
