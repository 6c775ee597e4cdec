"""Smoothing over the mesh: thin-plate displacement along normals that moves a body's silhouette to the photos'
outlines.

Beyond the paper (method §7): takes up what slices cannot reach - shoulders, crotch,
feet, hands - with all photos at once.
"""

from __future__ import annotations

import functools

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray
from scipy.sparse.linalg import splu

from cloner.geometry.meshes.triangles import triangle_sides
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.silhouette import triangle_normals
from cloner.records.arrays import Array

#: How often observations are weighed anew (tried: two and four lay the same bodies within 2 mm).
DOUBTING_TURNS = 2
#: Rounds in which folds are sought again; each evens the motion half as often.
UNFOLDING_TURNS = 10
#: No fit of an outline turns skin farther than this; what does has run through a crease.
MOST_DEGREES = 60.0


@functools.lru_cache(maxsize=4)
def _averaging(triangles_bytes: bytes, count: int) -> sparse.csr_matrix:
    triangles = np.frombuffer(triangles_bytes, dtype=np.int32).reshape(-1, 3)
    rows = triangle_sides(triangles)
    rows = np.concatenate([rows, rows[:, ::-1]])
    links = sparse.coo_matrix((np.ones(len(rows)), (rows[:, 0], rows[:, 1])), shape=(count, count)).tocsr()
    links.data[:] = 1.0
    degree = np.maximum(np.asarray(links.sum(axis=1)).ravel(), 1.0)
    return (sparse.diags(1.0 / degree) @ links).tocsr()


@functools.lru_cache(maxsize=4)
def _bending(triangles_bytes: bytes, count: int) -> sparse.csc_matrix:
    laplacian = sparse.identity(count, format="csr") - _averaging(triangles_bytes, count)
    return (laplacian.T @ laplacian).tocsc()


def smoothed_directions(directions: Array, triangles: NDArray[np.int32], *, turns: int) -> Array:
    """Return unit directions (V, 3), each averaged with its neighbours ``turns`` times.

    In a crease (armpit, crotch) normals of both flanks meet; skin that moves along
    them runs through itself. Averaged, they point out of the crease together.
    """
    averaging = _averaging(np.ascontiguousarray(triangles, dtype=np.int32).tobytes(), len(directions))
    smooth = directions
    for _ in range(turns):
        smooth = 0.5 * smooth + 0.5 * (averaging @ smooth)
        smooth = unit(smooth)
    return np.asarray(smooth)


def bending_matrix(triangles: NDArray[np.int32], count: int) -> sparse.csc_matrix:
    """Return the energy matrix (V, V) of ``|L h|²`` for a field h on a mesh's vertices (uniform Laplacian)."""
    return _bending(np.ascontiguousarray(triangles, dtype=np.int32).tobytes(), count)


def settle(
    rows: NDArray[np.int64],
    slope: Array,
    gap: Array,
    weight: Array,
    bending: sparse.csc_matrix,
    *,
    stiffness: Array | float,
    anchor: Array,
    doubt_m: tuple[float, float],
) -> Array:
    """Return the heights h (V,) that minimise Σ w ρ(slope·h − gap) + stiffness |L h|² + Σ anchor h².

    ρ is Geman and McClure's: what stands beside somebody and counts as them contradicts the outlines of other photos
    or the skin around it, and is left out. That happens oftener than that somebody's part counts as the room, so of two
    that contradict each other the inner one is believed. Found from the squares' minimum by reweighting.

    Parameters
    ----------
    rows : (K,) vertex of each outline observation
    slope : (K,) change of the observed gap per metre of height
    gap : (K,) wanted change, same unit
    weight : (K,) weights of the squares
    bending : (V, V) from :func:`bending_matrix`
    stiffness : float
    anchor : (V,) pull towards zero
    doubt_m : (float, float)
        Of an observation that lies so far outside or inside only a quarter counts.
    """
    count = bending.shape[0]
    believed = weight
    heights = np.zeros(count)
    for turn in range(DOUBTING_TURNS + 1):
        if turn:
            away = gap - slope * heights[rows]
            believed = weight / (1.0 + (away / np.where(away * slope > 0.0, *doubt_m)) ** 2) ** 2
        data = np.bincount(rows, believed * slope * slope, count)
        right = np.bincount(rows, believed * slope * gap, count)
        matrix = (stiffness * bending + sparse.diags(data + anchor)).tocsc()
        factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", panel_size=4, options={"SymmetricMode": True})
        heights = np.asarray(factors.solve(right))
    return heights


def without_folds(before_m: Array, after_m: Array, triangles: NDArray[np.int32]) -> Array:
    """Return moved vertices without folds: where a triangle turned too far, the motion is smoothed.

    Parameters
    ----------
    before_m, after_m : (V, 3) vertices before and after the motion
    triangles : (T, 3)
    """
    averaging = _averaging(np.ascontiguousarray(triangles, dtype=np.int32).tobytes(), len(before_m))
    start, least = triangle_normals(before_m, triangles), np.cos(np.deg2rad(MOST_DEGREES))
    size = np.linalg.norm(start, axis=1)
    motion = after_m - before_m
    for _ in range(UNFOLDING_TURNS):
        now = triangle_normals(before_m + motion, triangles)
        turned = np.einsum("ta,ta->t", start, now) < least * size * np.linalg.norm(now, axis=1)
        if not turned.any():
            break
        near = np.zeros(len(before_m))
        near[triangles[turned].ravel()] = 1.0
        near = (averaging @ (averaging @ near) + near > 0.0) & (np.linalg.norm(motion, axis=1) > 0.0)
        for _ in range(UNFOLDING_TURNS // 2):
            motion[near] = (averaging @ motion)[near]
    return np.asarray(before_m + motion)
