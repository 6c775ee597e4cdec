"""Read the subjects from outside the generic's family (shared/foreign; not ours to ship)."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from cloner.errors import ClonerError
from cloner.evaluate.measures.surfaces import sample_surface
from cloner.evaluate.truths.truth import TruthSurface
from cloner.records.views import Camera

Array = NDArray[np.float64]


def told_of(folder: Path, what: str) -> dict[str, Any]:
    """Return what ``truth.json`` says of a foreign subject.

    Raises
    ------
    ClonerError
        If the folder is not there: it is not ours to ship.
    """
    if not (folder / "truth.json").is_file():
        raise ClonerError(f"the foreign {what} is not on this machine", "Give its folder with --foreign", str(folder))
    return dict(json.loads((folder / "truth.json").read_text()))


def foreign_surface(folder: Path, told: Mapping[str, Any], marks: Mapping[str, Array], points: int) -> TruthSurface:
    """Return so many points spread over a foreign subject's mesh with its named marks.

    The largest connected piece is bare skin, the others (eyeballs) are organs: they hide, and are no face.
    """
    mesh = trimesh.load_mesh(folder / told["truth_mesh"], process=False)
    vertices, triangles = np.asarray(mesh.vertices, dtype=np.float64), np.asarray(mesh.faces, dtype=np.int32)
    places, normals, which = sample_surface(vertices, triangles, points, rng=np.random.default_rng(0))
    edges = (np.ones(2 * len(triangles)), (triangles[:, [0, 1]].ravel("F"), triangles[:, [1, 2]].ravel("F")))
    _, piece = connected_components(coo_matrix(edges, shape=(len(vertices),) * 2), directed=False)
    kind = np.where(piece[triangles[which, 0]] == np.bincount(piece).argmax(), "bare", "organ")
    return TruthSurface(places, normals, kind, {}, marks, np.zeros((0, 3)), np.zeros((0, 3), np.int32))


def foreign_camera(told: Mapping[str, Any]) -> Camera:
    """Return the camera of one photo."""
    camera_from_model = np.eye(4)
    camera_from_model[:3, :3], camera_from_model[:3, 3] = np.array(told["R"]), np.array(told["t"])
    return Camera(int(told["width"]), int(told["height"]), float(told["fx"]), camera_from_model)
