"""Piecewise affine completion: all points of a face from a few key points (method §3)."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

from cloner.records.arrays import Array

Rows = NDArray[np.integer]

#: How far the frame of still points lies outside the generic points, shares of their extent (taste).
FRAME: Final = 0.5
#: Points within this share of all points' extent follow a moved key point; the rest stays (an eye's width of a face).
REACH: Final = 0.16


def fit_affine(source: Array, target: Array) -> Array:
    """Return the (3, 2) map of (x, y, 1) that best aligns points with others.

    One pair gives a shift, two or collinear ones a similarity, more an affine map by least squares.

    Parameters
    ----------
    source, target : (K, 2) float64, K >= 1
    """
    middle, aim = source.mean(axis=0), target.mean(axis=0)
    linear = np.eye(2)
    away = source - middle
    spread = np.linalg.svd(away, compute_uv=False) if len(source) > 1 else np.zeros(2)
    if len(source) > 2 and spread[1] > 1e-3 * spread[0]:
        linear = np.linalg.lstsq(away, target - aim, rcond=None)[0]
    elif spread[0] > 0.0:
        factor = np.conj(away @ [1, 1j]) @ ((target - aim) @ [1, 1j]) / (away**2).sum()
        linear = np.array([[factor.real, factor.imag], [-factor.imag, factor.real]])
    return np.vstack([linear, aim - middle @ linear])


def complete_points(generic: Array, keys: Rows, keys_px: Array) -> Array:
    """Return all points from the key points: one global affine map, and one for each triangle of key points.

    Parameters
    ----------
    generic : (N, 2) float64
        The points where they usually lie towards each other; any frame, the picture's handedness.
    keys : (K,) rows of the points that are known, K >= 1
    keys_px : (K, 2) float64
        Where they are.

    Returns
    -------
    (N, 2) float64
        In the frame of ``keys_px``; key points exactly where they are given. A point inside a triangle of key points
        moves by that triangle's affine map; outside all of them by the common one, which the triangles meet
        continuously on a frame around the points.

    Raises
    ------
    ValueError
        If there is no key point or two share a place.

    References
    ----------
    Lee, Gu, Magnenat-Thalmann 2000, section 2.1: "piecewise affine" from key points. The frame is ours: the paper does
    not say what lies outside the triangles.
    """
    if len(keys) == 0 or len(np.unique(generic[keys], axis=0)) < len(keys):
        raise ValueError("key points must be there and distinct")
    common = fit_affine(generic[keys], keys_px)
    moved = generic @ common[:2] + common[2]
    low, high = generic.min(axis=0), generic.max(axis=0)
    room = FRAME * np.maximum(high - low, 1e-9).max()
    x, y = np.meshgrid(*(np.linspace(a - room, b + room, 3) for a, b in zip(low, high, strict=True)))
    frame = np.stack([x.ravel(), y.ravel()], axis=1)[[0, 1, 2, 3, 5, 6, 7, 8]]
    away = np.vstack([keys_px - moved[keys], np.zeros((8, 2))])
    out = moved + interpolate(np.vstack([generic[keys], frame]), away, generic)
    out[keys] = keys_px
    return np.asarray(out)


def interpolate(corners: Array, values: Array, places: Array) -> Array:
    """Return values (N, 2) at points inside the Delaunay triangles of corners (K, 2), linear in each."""
    mesh = Delaunay(corners)
    found = np.maximum(mesh.find_simplex(places, tol=1e-9), 0)
    rest = np.einsum("nab,nb->na", mesh.transform[found, :2], places - mesh.transform[found, 2])
    shares = np.column_stack([rest, 1.0 - rest.sum(axis=1)])
    return np.asarray(np.einsum("nk,nka->na", shares, values[mesh.simplices[found]]))


def move_neighbours(
    points_px: Array, moved: NDArray[np.bool_], targets_px: Array, *, reach_px: float | None = None
) -> Array:
    """Return points after some were moved, their neighbours following.

    The moved points and all that lie out of their reach are key points; what lies between follows by completion.

    Parameters
    ----------
    points_px : (N, 2) float64
        Before.
    moved : (N,) bool
    targets_px : (M, 2) float64
        Where the moved ones went, in their order.
    reach_px : float, optional
        0.16 of all points' extent when not given.
    """
    if not moved.any() or moved.all():
        out = points_px.copy()
        out[moved] = targets_px
        return out
    reach = REACH * float(np.ptp(points_px, axis=0).max()) if reach_px is None else reach_px
    away = np.linalg.norm(points_px[:, None] - points_px[moved][None], axis=2).min(axis=1)
    still = away > reach
    goals = points_px.copy()
    goals[moved] = targets_px
    keys = np.flatnonzero(moved | still)
    _, first = np.unique(points_px[keys], axis=0, return_index=True)
    keys = keys[np.sort(first)] if len(first) < len(keys) else keys
    out = complete_points(points_px, keys, goals[keys])
    out[moved], out[still & ~moved] = targets_px, points_px[still & ~moved]
    return out
