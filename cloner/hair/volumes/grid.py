"""The hair field's grid: where there may be hair, and what of it hangs together."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, label
from scipy.spatial import cKDTree

from cloner.frames import m_from_mm, mm_from_m
from cloner.hair.volumes.cap import Scalp
from cloner.hair.volumes.hanging import INNER_MM, LYING_MM, default_depth_m
from cloner.hair.volumes.pictures import FAR_MM
from cloner.hair.volumes.rows import agreed_mm
from cloner.hair.volumes.tail import Tail
from cloner.hair.volumes.views import HairView, visual_hull_mm
from cloner.records.arrays import Array

VOXEL_M = 0.004  # taste: side of a cell, finer than photos tell
COARSE = 4  # voxels a side of a trial cell
CLIP_MM = 15.0  # the field is cut off here, twice as far as neighbours lie, so that smoothing stays local
SMALLEST_LOCK_M3 = 4e-5  # taste: 40 ml, a thin lock


def voxels(low_m: Array, high_m: Array) -> tuple[Array, tuple[int, ...]]:
    """Return the points (N, 3) of a grid between two corners, `VOXEL_M` apart, and its shape."""
    shape = tuple(int(cells) for cells in np.ceil((high_m - low_m) / VOXEL_M))
    return low_m + VOXEL_M * np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), axis=-1).reshape(-1, 3), shape


def candidate_points(
    views: list[HairView], scalp: Scalp, lying_m: Array, tail: Tail | None, low_m: Array, high_m: Array
) -> tuple[Array, NDArray[np.int64], tuple[int, ...]]:
    """Return grid points near possible hair (N, 3), their flat indices, and the grid's shape.

    A coarse grid is tried first; nine tenths of the box hold nothing.
    """
    cells = np.ceil((high_m - low_m) / (COARSE * VOXEL_M)).astype(int)
    shape = tuple(int(n) for n in cells * COARSE)
    middle = [low_m[k] + (np.arange(cells[k]) * COARSE + 0.5 * (COARSE - 1)) * VOXEL_M for k in range(3)]
    coarse = np.stack(np.meshgrid(*middle, indexing="ij"), axis=-1).reshape(-1, 3)
    radius_mm = mm_from_m(COARSE * VOXEL_M)
    wanted = np.maximum(visual_hull_mm(views, coarse), agreed_mm(views, coarse, default_depth_m(scalp))[0]) > -radius_mm
    if tail is not None:
        wanted |= tail.inside_mm(coarse) > -radius_mm
    for skin_m, thick_mm in ((scalp.points_m[scalp.hairy > 0.0], float(scalp.thickness_mm.max())), (lying_m, LYING_MM)):
        if len(skin_m):
            reach = m_from_mm(thick_mm + INNER_MM + radius_mm)
            wanted |= cKDTree(skin_m).query(coarse, distance_upper_bound=reach)[0] < reach
    grid = binary_dilation(wanted.reshape(tuple(cells)))
    fine = np.argwhere(grid.repeat(COARSE, 0).repeat(COARSE, 1).repeat(COARSE, 2))
    rows = np.asarray(np.ravel_multi_index(tuple(fine.T), shape), np.int64)
    return low_m + fine * VOXEL_M, rows, shape


def near_hair(
    rows: NDArray[np.int64],
    shape: tuple[int, ...],
    fields: Callable[[NDArray[np.bool_]], tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]],
) -> tuple[NDArray[np.bool_], NDArray[np.float32]]:
    """Return which grid points (N,) lie near hair, and about how far from the skin they are, mm.

    Every other one along each axis is tried for its neighbours. ``fields`` gives for some of the points what grows,
    what hangs, and the distance to the skin.
    """
    place = np.stack(np.unravel_index(rows, shape))
    tried, block = (place % 2 == 0).all(axis=0), tuple(place // 2)
    near = np.zeros([-(-side // 2) for side in shape], np.bool_)
    skin = np.full(near.shape, np.float32(FAR_MM))
    own = tuple(axis[tried] for axis in block)
    grown, hanging, skin[own] = fields(tried)
    near[own] = np.maximum(grown, hanging) > -CLIP_MM
    return binary_dilation(near)[block], skin[block]


def attached_to(
    grown: NDArray[np.float32], hanging: NDArray[np.float32], rows: NDArray[np.int64], shape: tuple[int, ...]
) -> NDArray[np.bool_]:
    """Return which points (N,) beside growing hair are hair that hangs from it, without specks.

    Collars, shadows and bags that are labelled hair hang from nothing.
    """

    def pieces_of(flags: NDArray[np.bool_]) -> NDArray[np.int64]:
        grid = np.zeros(int(np.prod(shape)), bool)
        grid[rows] = flags
        return np.asarray(label(grid.reshape(shape))[0].ravel()[rows], np.int64)

    pieces, locks = pieces_of(np.maximum(grown, hanging) > 0.0), pieces_of((hanging > 0.0) & (grown <= 0.0))
    held = np.zeros(int(pieces.max(initial=0)) + 1, bool)
    held[pieces[grown > 0.0]] = True
    large = np.bincount(locks) >= SMALLEST_LOCK_M3 / VOXEL_M**3
    return np.asarray((locks > 0) & held[pieces] & large[locks], np.bool_)
