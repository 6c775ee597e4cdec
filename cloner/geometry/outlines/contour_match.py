"""Matching of a model's profile with a contour in a photo."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.geometry.meshes.surface import SurfacePoints
from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array


def contour_normals(contour: Array, *, reach: int = 4) -> Array:
    """Return (N, 2) unit normals of an ordered contour, from neighbours ``reach`` points away."""
    ahead, behind = np.roll(contour, -reach, axis=0), np.roll(contour, reach, axis=0)
    along = ahead - behind
    normal = np.column_stack([along[:, 1], -along[:, 0]])
    return unit(normal, 1e-12)


def foremost(points_px: Array, facing: int, *, step_px: float) -> NDArray[np.int64]:
    """Return the foremost points (image right for facing +1) at each level of ``step_px``."""
    level = np.floor(points_px[:, 1] / step_px).astype(np.int64)
    order = np.lexsort((-facing * points_px[:, 0], level))
    return order[np.unique(level[order], return_index=True)[1]]


def match_contour(
    points_px: Array, contour: Array, normals: Array, *, gate_px: float
) -> tuple[NDArray[np.int64], Array, Array]:
    """Return which points have a contour point within ``gate_px``, and that point and its normal."""
    distance, index = cKDTree(contour).query(points_px)
    kept = np.flatnonzero(distance < gate_px)
    return kept, contour[index[kept]], normals[index[kept]]


def occluding_points(vertices_m: Array, normals: Array, edges: NDArray[np.integer], eye_m: Array) -> SurfacePoints:
    """Return the occluding contour of a smooth surface: the points on its edges where it is seen edge-on.

    Parameters
    ----------
    vertices_m, normals : (V, 3)
    edges : (E, 2)
    eye_m : (3,)

    References
    ----------
    Hertzmann and Zorin 2000, section 4.1: the zero set of the normals' product with the direction of view.
    """
    towards = ((eye_m - vertices_m) * normals).sum(axis=1)
    first, second = towards[edges].T
    turned = np.flatnonzero(first * second < 0.0)
    share = first[turned] / (first[turned] - second[turned])
    ends = edges[turned]
    weights = np.column_stack([1.0 - share, share, np.zeros(len(share))])
    return SurfacePoints(np.column_stack([ends, ends[:, 1]]).astype(np.int32), weights)


def farthest_by_sector(points_px: Array, middle_px: Array, sector: float) -> NDArray[np.int64]:
    """Return the farthest point of each sector (radians) around a middle."""
    arm = points_px - middle_px
    where = np.floor(np.arctan2(arm[:, 1], arm[:, 0]) / sector).astype(np.int64)
    order = np.lexsort((-np.linalg.norm(arm, axis=1), where))
    return order[np.unique(where[order], return_index=True)[1]]
