"""Extraction of a hair field's surface as a mesh."""

from __future__ import annotations

import numpy as np
from fast_simplification import simplify
from numpy.typing import NDArray
from scipy.ndimage import label, map_coordinates
from skimage.measure import marching_cubes

from cloner.hair.volumes.grid import VOXEL_M
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

LOOK_PX = 4  # of the lowest hair, a margin is added
HIDDEN_MM = 3.0  # this deep in the head nothing is seen


def extract_mesh(
    field: NDArray[np.float32], skin_mm: NDArray[np.float32], low_m: Array, triangles: int, smallest_piece: float
) -> tuple[Array, NDArray[np.int32]] | None:
    """Return vertices (N, 3) and triangles (T, 3) of a hair's outer surface, None when empty.

    Parameters
    ----------
    field, skin_mm : (X, Y, Z) float32
        Positive inside the hair, and outside the body, mm, `VOXEL_M` apart.
    low_m : (3,) the grid's first point, metres
    triangles : int
        Most of what shows.
    smallest_piece : float
        Pieces below this share of the largest are dropped.
    """
    pieces, count = label(field > 0.0)
    if count == 0:
        return None
    volume = np.bincount(pieces.ravel())
    volume[0] = 0
    field = np.where((volume >= smallest_piece * volume.max())[pieces] | (field <= 0.0), field, -1.0)
    field = np.pad(field, 1, constant_values=-1.0)
    points, faces, _, _ = marching_cubes(field, 0.0, gradient_direction="ascent")
    hidden = (map_coordinates(skin_mm, (points - 1.0).T, order=1, mode="nearest") < -HIDDEN_MM)[faces].all(axis=1)
    # The wall inside the head goes after the reduction: an open rim would fray in it.
    target = int(triangles / max(1.0 - hidden.mean(), 0.1))
    if len(faces) > target:
        points, faces = simplify(points.astype(np.float64), faces.astype(np.int32), target_count=target)
    depth = map_coordinates(skin_mm, (points - 1.0).T, order=1, mode="nearest")
    outer = faces[(depth[faces] > -HIDDEN_MM).any(axis=1)]
    used, outer = np.unique(outer, return_inverse=True)
    vertices = low_m + (points[used].astype(np.float64) - 1.0) * VOXEL_M
    return vertices, outer.reshape(-1, 3).astype(np.int32)


def lowest_hair_m(views: list[HairView]) -> float:
    """Return the height of the lowest hair in any photo, rest frame, metres; infinite where no photo shows any."""
    lowest = np.inf
    for view in views:
        rows, columns = np.nonzero(view.hair[::LOOK_PX, ::LOOK_PX])
        if view.flip_m is None and rows.size:
            last = int(rows.argmax())
            pixel = np.array([[columns[last], rows[last]]], np.float64) * LOOK_PX
            head = view.transforms[view.hanger.joints[0], :3, 3][None]
            lowest = min(lowest, float(view.to_rest(view.posed.camera.back_project(pixel, head))[0, 1]))
    return lowest
