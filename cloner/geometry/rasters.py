"""Triangles to pixels: which triangle covers a pixel, and how deep the nearest surface is."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

CHUNK_CANDIDATES = (
    100_000  # pixels tested at once: tables stay in the cache, a third faster than 1.5 million (measured)
)


def fragments(
    points_px: Array, triangles: NDArray[np.int32], width_px: int, height_px: int
) -> Iterator[tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float32]]]:
    """Yield the pixels whose centre lies in a triangle, chunk by chunk.

    Parameters
    ----------
    points_px : (P, 2) float, pixel frame, (0, 0) = centre of the top-left pixel
    triangles : (T, 3) int, indices into ``points_px``, any winding
    width_px, height_px : int
        Pixels outside the picture are left out.

    Yields
    ------
    pixel : (N,) int64, ``row * width + column``
    triangle : (N,) int64
    barycentric : (N, 3) float32, weights of the three corners
    """
    corners = points_px[triangles]
    low = np.ceil(np.clip(corners.min(axis=1), 0, None) - 1e-6).astype(np.int64)
    limit = np.array([width_px - 1, height_px - 1])
    high = np.floor(np.minimum(corners.max(axis=1), limit) + 1e-6).astype(np.int64)
    span = np.clip(high - low + 1, 0, None)
    count = span[:, 0] * span[:, 1]
    area = _cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    count[np.abs(area) < 1e-12] = 0
    kept = np.flatnonzero(count)
    ends = np.cumsum(count[kept])
    start = 0
    while start < kept.size:
        done = ends[start - 1] if start else 0
        stop = max(start + 1, int(np.searchsorted(ends, done + CHUNK_CANDIDATES, side="right")))
        yield _fill(corners, area, low, span, count, kept[start:stop], width_px)
        start = stop


def _cross(a: Array, b: Array) -> Array:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _fill(
    corners: Array,
    area: Array,
    low: NDArray[np.int64],
    span: NDArray[np.int64],
    count: NDArray[np.int64],
    which: NDArray[np.int64],
    width_px: int,
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float32]]:
    """Test every pixel of the bounding boxes of some triangles."""
    triangle = np.repeat(which, count[which])
    first = np.repeat(np.cumsum(count[which]) - count[which], count[which])
    within = np.arange(triangle.size) - first
    row = low[triangle, 1] + within // span[triangle, 0]
    column = low[triangle, 0] + within % span[triangle, 0]
    a, b, c = (corners[which, k] for k in range(3))
    # Barycentric weights are affine in the pixel: one plane a triangle, then two multiply-adds a pixel.
    planes = []
    for p, q in ((b, c), (c, a)):
        edge = q - p
        planes.append(np.stack([-edge[:, 1], edge[:, 0], edge[:, 1] * p[:, 0] - edge[:, 0] * p[:, 1]], 1))
    plane = np.repeat(np.concatenate(planes, 1) / area[which, None], count[which], axis=0)
    first_weight = plane[:, 0] * column + plane[:, 1] * row + plane[:, 2]
    second_weight = plane[:, 3] * column + plane[:, 4] * row + plane[:, 5]
    third_weight = 1.0 - first_weight - second_weight
    inside = np.minimum(np.minimum(first_weight, second_weight), third_weight) >= -1e-9
    weights = np.stack([first_weight[inside], second_weight[inside], third_weight[inside]], 1)
    return row[inside] * width_px + column[inside], triangle[inside], weights.astype(np.float32)


def nearest_depth(
    points_px: Array, depth_m: Array, triangles: NDArray[np.int32], width_px: int, height_px: int
) -> NDArray[np.float32]:
    """Return the depth of the nearest surface at every pixel, metres, inf where there is none.

    Parameters
    ----------
    points_px : (P, 2) projected vertices, pixel frame
    depth_m : (P,) distance along the camera's axis; triangles with a corner nearer than 1 cm are left out
    triangles : (T, 3) int
    width_px, height_px : int

    Returns
    -------
    (height, width) float32
        Depth is interpolated as its reciprocal, which is affine in a perspective picture.
    """
    ahead = (depth_m[triangles] > 0.01).all(axis=1)
    triangles = triangles[ahead]
    reciprocal = (1.0 / np.maximum(depth_m, 0.01)).astype(np.float32)
    nearest = np.zeros(width_px * height_px, dtype=np.float32)
    for pixel, triangle, weights in fragments(points_px, triangles, width_px, height_px):
        value = np.einsum("nk,nk->n", reciprocal[triangles[triangle]], weights)
        np.maximum.at(nearest, pixel, value)
    with np.errstate(divide="ignore"):
        return (np.float32(1.0) / nearest).reshape(height_px, width_px)
