"""Heads from outside the generic's family (shared/foreign/ict; not ours to ship) and the visitors, as known heads."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Final

import numpy as np
import trimesh
from head_people import KnownHead
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.evaluate.surfaces import sample_surface
from cloner.evaluate.truth import TruthSurface
from cloner.frames import ViewId
from cloner.project.folder import load_photos
from cloner.records.photos import Person, PhotoSet
from cloner.records.views import Camera

Array = NDArray[np.float64]

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
    if not (folder / "truth.json").is_file():
        raise ClonerError("the foreign head is not on this machine", "Give its folder with --foreign", str(folder))
    told = json.loads((folder / "truth.json").read_text())
    mesh = trimesh.load_mesh(folder / told["truth_mesh"], process=False)
    vertices, triangles = np.asarray(mesh.vertices, dtype=np.float64), np.asarray(mesh.faces, dtype=np.int32)
    points, normals, _ = sample_surface(vertices, triangles, SURFACE_POINTS, rng=np.random.default_rng(0))
    marks = {ours: np.array(told["landmarks"][name], dtype=np.float64) for name, ours in NAMES.items()}
    truth = TruthSurface(
        points, normals, np.full(len(points), "bare"), {}, marks, np.zeros((0, 3)), np.zeros((0, 3), np.int32)
    )
    photos = load_photos(folder / photos_name)
    faces = PhotoSet({view: photo for view, photo in photos.photos.items() if not view.is_body})
    views = {ViewId(v): _camera(told["photos"][f"{photos_name}/{v}"]["camera"]) for v in ("face_front", "face_side")}
    name = f"{folder.name}_{photos_name}"
    return KnownHead(name, faces, Person(name, "", stature_m), truth, None, views, {"light": "foreign"})


def _camera(told: dict[str, Any]) -> Camera:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = np.array(told["R"]), np.array(told["t"])
    return Camera(int(told["width"]), int(told["height"]), float(told["fx"]), pose)
