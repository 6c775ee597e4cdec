"""Silhouette vertices of a posed mesh, and its filled silhouette."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.geometry.meshes.vectors import cross, unit
from cloner.records.arrays import Array

Triangles = NDArray[np.integer]


def fill_triangles(
    points_px: Array, triangles: Triangles, size: tuple[int, int], box: NDArray[np.int64] | None = None
) -> NDArray[np.uint8]:
    """Return the picture (H, W), 255 inside, of projected triangles.

    Parameters
    ----------
    points_px : (V, 2) pixels of the picture
    triangles : (T, 3)
    size : (H, W)
    box : (2, 2), optional
        First and last column and row of the part that is wanted, all by default.

    Notes
    -----
    Every pixel whose centre lies in a triangle or on its border's line: about half a
    pixel too large on every side. Inner edges cancel, so only the contour of what faces
    the viewer is filled, by its winding number, instead of triangle after triangle.
    """
    fixed = np.round(np.clip(points_px, -8000, 8000) * 16).astype(np.int32)
    (x, y), (a, b, c) = fixed.T.astype(np.int64), triangles.T
    ax, ay = x.take(a), y.take(a)
    area = (x.take(b) - ax) * (y.take(c) - ay) - (y.take(b) - ay) * (x.take(c) - ax)
    drawn = area > 0 if np.count_nonzero(area > 0) > np.count_nonzero(area < 0) else area < 0
    beyond = _beyond(fixed, np.array([[0, 0], size[::-1]]) if box is None else box)[triangles]
    drawn &= (beyond[:, 0] & beyond[:, 1] & beyond[:, 2]) == 0
    starts, ends, times = _unpaired_edges(triangles[drawn])
    inside = _winding_numbers(fixed[starts] / 16, fixed[ends] / 16, times, size) != 0
    picture: NDArray[np.uint8] = 255 * inside.astype(np.uint8)
    cv2.polylines(picture, list(np.stack([fixed[starts], fixed[ends]], axis=1)), False, 255, 1, cv2.LINE_8, 4)
    return picture


def _unpaired_edges(triangles: Triangles) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Return the edges that do not cancel between neighbours of equal orientation: first and last vertices, counts."""
    tail, head = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    count = int(triangles.max(initial=0)) + 1
    edges = np.minimum(tail, head).astype(np.int64) * count + np.maximum(tail, head)
    both = np.sort(2 * edges + (tail < head))  # the last bit tells which way an edge is gone
    first = np.flatnonzero(np.diff(both >> 1, prepend=-1))
    ways = np.concatenate([[0], np.cumsum(2 * (both & 1) - 1)])
    times = ways[np.append(first[1:], len(both))] - ways[first] if len(first) else first
    key, kept = both[first] >> 1, times != 0
    return key[kept] // count, key[kept] % count, times[kept]


def _winding_numbers(starts: Array, ends: Array, times: NDArray[np.int64], size: tuple[int, int]) -> NDArray[np.int32]:
    """Return the winding number (H, W) of directed edges, (E, 2) pixels each, around every pixel's centre."""
    height, width = size
    upper, lower = np.ceil(np.minimum(starts[:, 1], ends[:, 1])), np.ceil(np.maximum(starts[:, 1], ends[:, 1]))
    first, last = np.clip(upper, 0, height).astype(np.int64), np.clip(lower, 0, height).astype(np.int64)
    rows_of = last - first
    edge = np.repeat(np.arange(len(starts)), rows_of)
    row = np.arange(len(edge)) - np.repeat(np.cumsum(rows_of) - rows_of - first, rows_of)
    slope = np.diff(np.stack([starts, ends], axis=1), axis=1)[edge, 0]
    column = np.ceil(starts[edge, 0] + (row - starts[edge, 1]) * slope[:, 0] / slope[:, 1])
    turn = np.where(slope[:, 1] > 0, times[edge], -times[edge])
    steps = np.zeros((height, width + 1), dtype=np.int32)
    np.add.at(steps, (row, np.clip(column, 0, width).astype(np.int64)), turn)
    return np.asarray(np.cumsum(steps[:, :width], axis=1, dtype=np.int32))


def _beyond(fixed: NDArray[np.int32], box: NDArray[np.int64]) -> NDArray[np.uint8]:
    """Return as bits (V,) on which sides points in 1/16 px lie more than a pixel beyond a box."""
    (left, top), (right, bottom) = 16 * box + np.array([[-16], [16]])
    sides = (fixed[:, 0] < left, fixed[:, 0] > right, fixed[:, 1] < top, fixed[:, 1] > bottom)
    return np.asarray(np.sum([np.uint8(1 << bit) * side for bit, side in enumerate(sides)], axis=0), np.uint8)


def borders_px(picture: NDArray[np.uint8]) -> tuple[Array, ...]:
    """Return the closed borders (M, 2) of a filled picture, px, without slivers of under 20 px."""
    chains, _ = cv2.findContours(picture, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    return tuple(chain[:, 0].astype(np.float64) for chain in chains if len(chain) >= 20)


def triangle_normals(vertices_m: Array, triangles: Triangles) -> Array:
    """Return (T, 3) area-weighted triangle normals."""
    a, b, c = (vertices_m.take(triangles[:, corner], axis=0) for corner in range(3))
    return cross(b - a, c - a)


def vertex_normals(vertices_m: Array, triangles: Triangles) -> Array:
    """Return (V, 3) unit vertex normals."""
    face = triangle_normals(vertices_m, triangles)
    normals = np.zeros_like(vertices_m)
    for column in triangles.T.astype(np.intp):
        for axis in range(3):
            normals[:, axis] += np.bincount(column, face[:, axis], len(vertices_m))
    return unit(normals, 1e-12)


def silhouette_vertices(
    points_px: Array,
    posed_m: Array,
    triangles: Triangles,
    eye_m: Array,
    size: tuple[int, int],
    tolerance_px: float,
    among: NDArray[np.bool_] | None = None,
) -> tuple[NDArray[np.int64], NDArray[np.uint8]]:
    """Return the silhouette vertices of the posed mesh, and its filled picture.

    A vertex is on the rim when triangles around it face both towards and away
    from the camera and it projects next to the border of the filled picture.

    Parameters
    ----------
    points_px : (V, 2) projected vertices in a picture of ``size``
    posed_m : (V, 3) posed vertices, metres
    triangles : (T, 3)
    eye_m : (3,) camera centre in the same frame as ``posed_m``
    size : (H, W) of the picture
    tolerance_px : float
        How far from the picture's border a rim vertex may lie.
    among : (V,) bool, optional
        Only these vertices are looked at; the picture is then filled around them only.
    """
    box, near = None, triangles
    if among is not None:
        air = int(tolerance_px) + 3
        ends = np.clip([points_px[among].min(axis=0), points_px[among].max(axis=0)], -air, [size[::-1]] * 2)
        box = np.array([np.floor(ends[0]) - air, np.ceil(ends[1]) + air], dtype=np.int64)
        near = triangles[among[triangles].any(axis=1)]
    normals = triangle_normals(posed_m, near)
    towards = np.einsum("ta,ta->t", normals, eye_m - posed_m[near[:, 0]]) > 0
    faces_in = np.bincount(near[towards].ravel(), minlength=len(posed_m)) > 0
    faces_out = np.bincount(near[~towards].ravel(), minlength=len(posed_m)) > 0
    picture = fill_triangles(points_px, triangles, size, box)
    depth = cv2.distanceTransform(cv2.copyMakeBorder(picture, 1, 1, 1, 1, cv2.BORDER_CONSTANT), cv2.DIST_L2, 5)
    column = np.clip(np.round(points_px[:, 0]).astype(int), -1, size[1]) + 1
    row = np.clip(np.round(points_px[:, 1]).astype(int), -1, size[0]) + 1
    on_rim = faces_in & faces_out & (depth[row, column] <= tolerance_px)
    return np.flatnonzero(on_rim if among is None else on_rim & among), picture
