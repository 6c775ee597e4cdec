"""What all portraits of one family of heads share: triangles, masks of what is painted, soft shade in hollows.

Two families are painted alike (``painted_portraits.py``): the generic's own heads, and those of a scan-based family
(``scan_heads.py``; its file lies outside this project).
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from painted_heads import Head
from scan_portraits import scan_head
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.geometry.outlines.silhouette import vertex_normals

Array = NDArray[np.float64]

MARKS = (
    "glabella", "nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front", "chin_bottom",
    *(f"{name}_{side}" for side in "LR" for name in (
        "eye_inner", "eye_outer", "eye_upper", "eye_lower", "pupil", "ala", "mouth_corner",
        "ear_top", "ear_lobe", "ear_back", "ear_outer",
    )),
)  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Canvas:
    """What all portraits of a family share.

    Attributes
    ----------
    head : Head
    shade : (V',) float64
        How much of all light hollows keep off, 0..1.
    hair_m : (V',) float64
        How far inside the hair a place lies on the mean head, metres.
    ears, beard : (V',) float64
        Shares of ears, and of where stubble grows.
    corner_m : (V',) float64
        The way to the nearer corner of the mouth, metres.
    lips : (V',) bool
    rows : dict of str to int
        The marks' vertices in the generic.
    """

    head: Head
    shade: Array
    hair_m: Array
    ears: Array
    beard: Array
    corner_m: Array
    lips: NDArray[np.bool_]
    rows: dict[str, int]


@functools.cache
def canvas() -> Canvas:
    """Return what portraits of the generic's own family share."""
    head = Head(load_generic(), splits=1, below_m=0.14)
    return _canvas(head, head.mean, np.asarray(head.matrix @ _on_ears()))


@functools.cache
def scan_canvas(path: Path) -> Canvas:
    """Return what portraits of the scan-based family share: masks are found by each place's twin on the generic."""
    generic, head = load_generic(), scan_head(path)
    body = generic.part("body")
    _, near = cKDTree(generic.vertices_m[body]).query(head.mean)
    return _canvas(head, head.shape, np.where(head.skin, _on_ears()[body[near]], 0.0))


def _on_ears() -> Array:
    generic = load_generic()
    return np.asarray((generic.region("ear_left") | generic.region("ear_right")).astype(np.float64))


def _canvas(head: Head, shape_m: Array, ears: Array) -> Canvas:
    """Return a canvas; ``shape_m`` (V', 3) is the family's mean head, ``head.mean`` the same places on the generic."""
    generic = load_generic()
    normals = vertex_normals(shape_m, head.fine)
    shade = np.mean([hidden_from(shape_m, normals, way) for way in _sphere(90)], axis=0)
    scalp = head.masks["scalp"] > 0.5
    inside, _ = cKDTree(head.mean[~scalp]).query(head.mean)
    outside, _ = cKDTree(head.mean[scalp]).query(head.mean)
    place = {n: generic.vertices_m[generic.feature(n)].astype(np.float64) for n in ("subnasale", "ear_lobe_L")}
    low = np.clip((place["subnasale"][1] - 0.004 - head.mean[:, 1]) / 0.02, 0.0, 1.0)
    beard = low * np.clip((head.mean[:, 2] - place["ear_lobe_L"][2]) / 0.02, 0.0, 1.0)
    beard *= (1.0 - head.masks["lips"]) * (1.0 - ears)
    rows = {name: generic.feature(name) for name in MARKS}
    corners = generic.vertices_m[[rows[f"mouth_corner_{side}"] for side in "LR"]].astype(np.float64)
    corner, _ = cKDTree(corners).query(head.mean)
    hair = np.where(scalp, inside, -outside)
    return Canvas(head, shade, hair, ears, beard, corner, head.masks["lips"] > 0.9, rows)


def _sphere(count: int) -> Array:
    """Return (count, 3) directions spread evenly over the sphere."""
    up = 1.0 - 2.0 * (np.arange(count) + 0.5) / count
    turn = np.pi * (1.0 + np.sqrt(5.0)) * np.arange(count)
    flat = np.sqrt(1.0 - up**2)
    return np.column_stack([flat * np.cos(turn), up, flat * np.sin(turn)])


def hidden_from(vertices_m: Array, normals: Array, towards: Array, cell_m: float = 0.003) -> Array:
    """Return (N,) 0..1 how much of a far light other parts of a surface keep from its vertices.

    Parameters
    ----------
    vertices_m : (N, 3) float64
    normals : (N, 3) float64
    towards : (3,) unit direction of the light
    cell_m : float
        Cells of the shadow map, metres.
    """
    towards = towards / np.linalg.norm(towards)
    across = np.cross(towards, [0.0, 1.0, 0.0] if abs(towards[1]) < 0.9 else [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    cells = np.floor(vertices_m @ np.stack([across, np.cross(towards, across)], axis=1) / cell_m).astype(int)
    cells -= cells.min(axis=0) - 1
    depth = vertices_m @ towards
    nearest = np.full(cells.max(axis=0) + 2, -np.inf)
    np.maximum.at(nearest, tuple(cells.T), depth)
    covered = np.mean([nearest[tuple((cells + step).T)] > depth + 0.007 for step in
                       ([0, 0], [1, 0], [-1, 0], [0, 1], [0, -1])], axis=0)  # fmt: skip
    return np.asarray(np.maximum(covered, normals @ towards < 0.0))
