"""Planar charts for a closed mesh: by direction, in as many layers as overlap, packed into a square."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from cloner.geometry.meshes.rasters import fragments
from cloner.records.arrays import Array

LAYER_GRID_M = 0.0005  # triangles that overlap less than this overlap by less than a texel
#: Pixels nearer to a triangle's side than this share are nobody's; texels kept free around each island (taste).
INNER_WEIGHT = 1e-3
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
    layer = _add_layers(vertices_m, triangles, 2 * axis + positive)
    chart = _split_connected(triangles, layer)
    names = np.zeros(int(chart.max(initial=-1)) + 1, np.int64)
    names[chart] = layer
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
    """Return (T,) chart names: direction 0..5, plus 6 for every layer of triangles before them."""
    chart = direction.copy()
    for name in range(6):
        flat = _plane(vertices_m, name // 2)
        away = vertices_m[:, name // 2] * (-1.0 if name % 2 else 1.0)
        rows = np.flatnonzero(direction == name)
        while rows.size:
            rows = rows[_occluded(flat, away, triangles[rows])]
            chart[rows] += 6
    return chart


def _occluded(flat_m: Array, away_m: Array, triangles: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return which triangles (T,) others cover in part; the nearest of every stack is never one of them."""
    flat = (flat_m - flat_m[triangles].min(axis=(0, 1))) / LAYER_GRID_M
    width, height = (np.ceil(flat[triangles].max(axis=(0, 1))).astype(int) + 1).tolist()
    found = [
        (pixel[within], triangle[within])
        for pixel, triangle, weights in fragments(flat, triangles, width, height)
        for within in [weights.min(axis=1) > INNER_WEIGHT]  # a common side is nobody's
    ]
    pixel, triangle = (np.concatenate(part) for part in zip(*found, strict=True)) if found else np.zeros((2, 0), int)
    # By each triangle's own order, not pixel by pixel: triangles that cut each other must not both give way.
    order = np.argsort(away_m[triangles].mean(axis=1), kind="stable")
    rank = np.empty(len(order), np.int64)
    rank[order] = np.arange(len(order))
    first = np.full(width * height, len(order), np.int64)
    np.minimum.at(first, pixel, rank[triangle])
    hidden = np.zeros(len(order), np.bool_)
    hidden[triangle[first[pixel] < rank[triangle]]] = True
    return hidden


def _split_connected(triangles: NDArray[np.int32], chart: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return charts (T,) split into connected components: boxes around scattered triangles would waste space."""
    count = len(triangles)
    sides = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1).astype(np.int64)
    key = np.stack([np.repeat(chart, 3), sides[:, 0], sides[:, 1]])
    _, side = np.unique(key, axis=1, return_inverse=True)
    side = side.ravel()
    owner = np.repeat(np.arange(count), 3)
    size = int(side.max()) + 1
    link = coo_matrix((np.ones(3 * count), (owner, count + side)), shape=(count + size, count + size))
    _, piece = connected_components(link, directed=False)
    return np.asarray(piece[:count], np.int64)


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
