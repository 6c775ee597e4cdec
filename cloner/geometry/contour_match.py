"""Match a model's profile with a contour in a photo."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]


def contour_normals(contour: Array, *, reach: int = 4) -> Array:
    """Return (N, 2) unit normals of an ordered contour, from neighbours ``reach`` points away."""
    ahead, behind = np.roll(contour, -reach, axis=0), np.roll(contour, reach, axis=0)
    along = ahead - behind
    normal = np.column_stack([along[:, 1], -along[:, 0]])
    return np.asarray(normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12))


def foremost(points_px: Array, facing: int, *, step_px: float) -> NDArray[np.int64]:
    """Return the points that lie foremost (image right for facing +1) at each level of ``step_px``."""
    level = np.floor(points_px[:, 1] / step_px).astype(np.int64)
    order = np.lexsort((-facing * points_px[:, 0], level))
    return order[np.unique(level[order], return_index=True)[1]]


def match(
    points_px: Array, contour: Array, normals: Array, *, gate_px: float
) -> tuple[NDArray[np.int64], Array, Array]:
    """Return which points have a contour point within ``gate_px``, and that point and its normal."""
    distance, index = cKDTree(contour).query(points_px)
    kept = np.flatnonzero(distance < gate_px)
    return kept, contour[index[kept]], normals[index[kept]]
