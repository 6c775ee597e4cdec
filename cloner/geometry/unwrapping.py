"""Planar charts for a closed blob: by direction, in two layers, packed into a square."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.rasters import nearest_depth

Array = NDArray[np.float64]

LAYER_GRID_M = 0.002
LAYER_TOLERANCE_M = 0.006  # a triangle deeper than this below the first surface goes to the second layer
MARGIN_TEXELS = 4


@dataclass(frozen=True, slots=True, eq=False)
class Unwrapped:
    """A mesh cut into charts.

    Attributes
    ----------
    vertex : (W,) int32
        Original vertex of every new vertex.
    triangles : (T, 3) int32 into the new vertices, in the order given
    uv : (W, 2) float64 in 0..1, v downwards
    """

    vertex: NDArray[np.int32]
    triangles: NDArray[np.int32]
    uv: Array


def unwrap(vertices_m: Array, triangles: NDArray[np.int32], size: int) -> Unwrapped:
    """Cut a mesh into planar charts and pack them.

    Parameters
    ----------
    vertices_m : (V, 3) metres
    triangles : (T, 3) int32
    size : int
        Texels of the texture, for the margins.
    """
    corner = vertices_m[triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    axis = np.abs(normal).argmax(axis=1)
    positive = normal[np.arange(len(normal)), axis] > 0
    chart = _add_layers(vertices_m, triangles, 2 * axis + positive)
    names, chart = np.unique(chart, return_inverse=True)
    key, inverse = np.unique(chart[:, None] * len(vertices_m) + triangles, return_inverse=True)
    vertex, owner = (key % len(vertices_m)).astype(np.int32), key // len(vertices_m)
    flat = np.empty((len(vertex), 2))
    for number, name in enumerate(names):
        rows = owner == number
        flat[rows] = _plane(vertices_m[vertex[rows]], (int(name) % 6) // 2)
    uv = _pack(flat, owner, len(names), size)
    return Unwrapped(vertex, inverse.reshape(-1, 3).astype(np.int32), uv)


def _plane(points_m: Array, axis: int) -> Array:
    """Return (N, 2) points seen along an axis: across, then down."""
    across, up = {0: (2, 1), 1: (0, 2), 2: (0, 1)}[axis]
    return np.column_stack([points_m[:, across], -points_m[:, up]])


def _add_layers(vertices_m: Array, triangles: NDArray[np.int32], direction: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return (T,) chart names: direction 0..5, plus 6 for triangles behind others of their direction."""
    chart = direction.copy()
    for name in range(6):
        rows = np.flatnonzero(direction == name)
        if rows.size == 0:
            continue
        flat = _plane(vertices_m, name // 2)
        flat = (flat - flat.min(axis=0)) / LAYER_GRID_M
        width, height = (np.ceil(flat.max(axis=0)).astype(int) + 2).tolist()
        away = vertices_m[:, name // 2] * (-1.0 if name % 2 else 1.0)
        away = away - away.min() + 1.0
        front = nearest_depth(flat, away, triangles[rows], width, height)
        middle = flat[triangles[rows]].mean(axis=1)
        column, row = np.rint(middle).astype(int).T
        behind = away[triangles[rows]].mean(axis=1) > front[row, column] + LAYER_TOLERANCE_M
        chart[rows[behind]] += 6
    return chart


def _pack(flat: Array, owner: NDArray[np.int64], count: int, size: int) -> Array:
    """Return uv (W, 2): chart rectangles on shelves at the largest scale that fits."""
    low = np.stack([flat[owner == k].min(axis=0) for k in range(count)])
    extent = np.stack([flat[owner == k].max(axis=0) for k in range(count)]) - low
    scale = 1.0 / max(float(np.sqrt(extent.prod(axis=1).sum())), float(extent.max()), 1e-9)
    margin = 2.0 * MARGIN_TEXELS / size
    while (place := _shelves(extent * scale + margin)) is None:
        scale *= 0.97
    return np.asarray((flat - low[owner]) * scale + place[owner] + margin / 2.0, np.float64)


def _shelves(boxes: Array) -> Array | None:
    """Return (K, 2) corners of boxes laid on shelves in the unit square, tallest first, or None."""
    place = np.zeros_like(boxes)
    x = y = shelf = 0.0
    for k in np.argsort(-boxes[:, 1]):
        if x + boxes[k, 0] > 1.0:
            x, y, shelf = 0.0, y + shelf, 0.0
        if x + boxes[k, 0] > 1.0 or y + boxes[k, 1] > 1.0:
            return None
        place[k] = x, y
        x, shelf = x + boxes[k, 0], max(shelf, boxes[k, 1])
    return place
