"""Which vertices make the outline of a posed mesh, and its filled picture."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Triangles = NDArray[np.integer]

FIXED_BITS = 4
FIXED = 1 << FIXED_BITS  # parts of a pixel


def fill_triangles(points_px: Array, triangles: Triangles, size: tuple[int, int]) -> NDArray[np.uint8]:
    """Return the (H, W) picture, 255 inside, of the projected triangles that face as most do.

    Parameters
    ----------
    points_px : (V, 2) pixels of the picture
    triangles : (T, 3)
    size : (H, W)

    Notes
    -----
    What they cover is where the borders of their patches wind around: thousands of inner edges need no drawing.
    Every pixel that a border touches is filled, so the picture is about half a pixel too large on every side;
    1/16 px fixed point keeps it from being more.
    """
    fixed = np.round(np.clip(points_px, -8000, 8000) * FIXED).astype(np.int64)
    x, y = np.ascontiguousarray(fixed.T)
    a, b, c = np.ascontiguousarray(triangles.T)
    area = (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])
    positive, negative = area > 0, area < 0
    edges, turns = _border(triangles[positive if positive.sum() > negative.sum() else negative], len(fixed))
    ends = fixed[edges]
    picture = np.where(_windings(ends, turns, size) != 0, np.uint8(255), np.uint8(0))
    return np.asarray(
        cv2.polylines(picture, list(ends.astype(np.int32)), False, 255, 1, cv2.LINE_8, FIXED_BITS), np.uint8
    )


def _border(triangles: Triangles, count: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the edges (E, 2) that triangles of ``count`` vertices share with no other, and how often (E,).

    The number is negative for edges that the triangles walk from the second vertex to the first.
    """
    start = triangles.ravel().astype(np.int64)
    end = triangles[:, [1, 2, 0]].ravel().astype(np.int64)
    forth = start < end
    keys = 2 * np.where(forth, start * count + end, end * count + start) + forth
    keys.sort()
    edge = keys >> 1
    first = np.flatnonzero(np.diff(edge, prepend=-1))
    turns = np.add.reduceat(2 * (keys & 1) - 1, first) if first.size else keys
    left = turns != 0
    return np.column_stack(np.divmod(edge[first[left]], count)), turns[left]


def _windings(ends: NDArray[np.int64], turns: NDArray[np.int64], size: tuple[int, int]) -> Array:
    """Return (H, W) how often closed borders wind around each pixel's centre.

    Parameters
    ----------
    ends : (E, 2, 2) the edges' ends in 1/16 px
    turns : (E,) how often each edge is walked, backwards where negative
    """
    height, width = size
    rows = np.clip(-(-ends[:, :, 1] // FIXED), 0, height)  # the first pixel row at or below each end
    count = np.abs(rows[:, 1] - rows[:, 0])
    edge = np.repeat(np.arange(len(ends)), count)
    row = np.arange(edge.size) + np.repeat(rows.min(axis=1) - np.cumsum(count) + count, count)
    (x, y), (to_x, to_y) = ends[edge, 0].T, ends[edge, 1].T
    crossed = x + (FIXED * row - y) * (to_x - x) / (to_y - y)
    column = np.clip(np.ceil(crossed / FIXED), 0, width).astype(np.int64)
    steps = (np.sign(rows[:, 1] - rows[:, 0]) * turns)[edge]
    # A column more than the picture has: every row ends at no winding, so one sum runs over all.
    found = np.bincount(row * (width + 1) + column, steps, height * (width + 1))
    return np.asarray(np.cumsum(found).reshape(height, width + 1)[:, :width])


def borders_px(picture: NDArray[np.uint8]) -> tuple[Array, ...]:
    """Return the (M, 2) closed borders of a filled picture, in its pixels, without slivers of under 20 px."""
    chains, _ = cv2.findContours(picture, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    return tuple(chain[:, 0].astype(np.float64) for chain in chains if len(chain) >= 20)


def triangle_normals(vertices_m: Array, triangles: Triangles) -> Array:
    """Return (T, 3) area-weighted triangle normals."""
    corner = vertices_m[triangles]
    return np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])


def vertex_normals(vertices_m: Array, triangles: Triangles) -> Array:
    """Return (V, 3) unit vertex normals."""
    face = triangle_normals(vertices_m, triangles)
    normals = np.zeros_like(vertices_m)
    for column in range(3):
        for axis in range(3):
            normals[:, axis] += np.bincount(triangles[:, column], face[:, axis], len(vertices_m))
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12))


def rim_vertices(
    points_px: Array, posed_m: Array, triangles: Triangles, eye_m: Array, size: tuple[int, int], tolerance_px: float
) -> tuple[NDArray[np.int64], NDArray[np.uint8]]:
    """Return the vertices on the outline of the posed mesh, and its filled picture.

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
    """
    normals = triangle_normals(posed_m, triangles)
    towards = np.einsum("ta,ta->t", normals, eye_m - posed_m[triangles[:, 0]]) > 0
    faces_in = np.bincount(triangles[towards].ravel(), minlength=len(posed_m)) > 0
    faces_out = np.bincount(triangles[~towards].ravel(), minlength=len(posed_m)) > 0
    picture = fill_triangles(points_px, triangles, size)
    depth = cv2.distanceTransform(cv2.copyMakeBorder(picture, 1, 1, 1, 1, cv2.BORDER_CONSTANT), cv2.DIST_L2, 5)
    column = np.clip(np.round(points_px[:, 0]).astype(int), -1, size[1]) + 1
    row = np.clip(np.round(points_px[:, 1]).astype(int), -1, size[0]) + 1
    return np.flatnonzero(faces_in & faces_out & (depth[row, column] <= tolerance_px)), picture
