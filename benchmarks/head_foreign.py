"""Heads from outside the generic's family (shared/foreign/ict; not ours to ship) and the visitors, as known heads."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
from foreign import foreign_camera, foreign_surface, told_of
from head_people import KnownHead

from cloner.frames import ViewId
from cloner.project.folder import load_photos
from cloner.records.photos import Person, PhotoSet

SURFACE_POINTS: Final = 60_000
#: The foreign heads' landmark names and ours; their brows, jaw and ear points have no twin here.
NAMES: Final = {
    "r_eye_outer": "eye_outer_R", "r_eye_inner": "eye_inner_R", "l_eye_inner": "eye_inner_L",
    "l_eye_outer": "eye_outer_L", "mouth_r": "mouth_corner_R", "mouth_l": "mouth_corner_L", "lip_top": "lip_top",
    "lip_bottom": "lip_bottom", "chin": "chin_bottom", "sellion": "nasion", "nose_tip": "nose_tip",
    "r_alar": "ala_R", "l_alar": "ala_L", "l_ear_lateral": "ear_outer_L", "r_ear_lateral": "ear_outer_R",
}  # fmt: skip


def foreign_head(folder: Path, photos_name: str, stature_m: float = 1.75) -> KnownHead:
    """Return a foreign head.

    Parameters
    ----------
    folder : Path
        With ``truth.json``, ``truth_mesh.ply``, photos and masks (shared/foreign/README.md).
    photos_name : str
        "input" or "input_clutter".
    stature_m : float
        Told to the cloner; a head alone has none.

    Raises
    ------
    ClonerError
        If the folder is not there: it is not ours to ship.
    """
    told = told_of(folder, "head")
    marks = {ours: np.array(told["landmarks"][name], dtype=np.float64) for name, ours in NAMES.items()}
    truth = foreign_surface(folder, told, marks, SURFACE_POINTS)
    photos = load_photos(folder / photos_name)
    faces = PhotoSet({view: photo for view, photo in photos.photos.items() if not view.is_body})
    views = {
        ViewId(v): foreign_camera(told["photos"][f"{photos_name}/{v}"]["camera"]) for v in ("face_front", "face_side")
    }
    name = f"{folder.name}_{photos_name}"
    return KnownHead(name, faces, Person(name, "", stature_m), truth, None, views, {"light": "foreign"})
