"""Properties of triangle meshes: areas, edges, neighbours."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

Index = NDArray[np.integer]
Ints = NDArray[np.int64]


def areas(points: NDArray[np.floating[Any]], triangles: Index) -> Array:
    """Return areas (T,) of triangles (T, 3) over points (N, 2) or (N, 3), in the points' unit squared."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    first, second = b - a, c - a
    if points.shape[1] == 2:
        return np.asarray(0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]))
    return np.asarray(0.5 * np.linalg.norm(np.cross(first, second), axis=1))


def edges_of(triangles: Index) -> tuple[Ints, Ints]:
    """Return all edges (E, 2) of triangles (T, 3), each once with the lower vertex first, and their triangles (E,)."""
    low = np.sort(triangle_sides(triangles).astype(np.int64), axis=1)
    span = int(low.max(initial=0)) + 1
    # One number an edge sorts ten times as fast as two.
    edges, count = np.unique(low[:, 0] * span + low[:, 1], return_counts=True)
    return np.stack(np.divmod(edges, span), axis=1), count.astype(np.int64)


def paired_edges(triangles: Index) -> tuple[Ints, Ints, Ints]:
    """Return edges that two triangles share, the two triangles, and their corners opposite the edge, (E, 2) each."""
    corners = np.asarray(triangles, dtype=np.int64)
    across = np.concatenate([corners[:, 2], corners[:, 0], corners[:, 1]])
    owner = np.tile(np.arange(len(corners)), 3)
    low: Ints = np.sort(triangle_sides(corners), axis=1).astype(np.int64)
    order = np.lexsort((low[:, 1], low[:, 0]))
    same = np.flatnonzero((low[order[1:]] == low[order[:-1]]).all(axis=1))
    pairs = np.stack([order[same], order[same + 1]], axis=1)
    return low[pairs[:, 0]], owner[pairs], across[pairs]


def triangle_sides(triangles: NDArray[Any]) -> NDArray[Any]:
    """Return the sides (3 T, 2) of triangles, first all first ones."""
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def longest_sides(points_m: Array, triangles: Index) -> Array:
    """Return the longest side (N,) of the triangles (T, 3) around each vertex (N, 3), zero where there are none."""
    long = np.linalg.norm(points_m[triangles] - points_m[np.roll(triangles, 1, axis=1)], axis=2).max(axis=1)
    longest = np.zeros(len(points_m))
    np.maximum.at(longest, triangles, long[:, None])
    return longest
