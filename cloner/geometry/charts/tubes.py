"""Cloth as a tube around an axis: radii by height and angle, cut into two charts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from cloner.records.arrays import Array

#: Texels between the charts of front and back, and around them.
MARGIN_TEXELS = 6


def ring_angles(count: int) -> Array:
    """Return (count,) angles around the vertical axis, radians: 0 front (+Z), growing towards +X (the person's left).

    They begin at -90 degrees, so that the first half of them is the front.

    Raises
    ------
    ValueError
        If ``count`` is odd: front and back would differ.
    """
    if count % 2:
        raise ValueError("front and back need the same number of columns")
    return np.asarray(-0.5 * np.pi + 2.0 * np.pi * np.arange(count) / count)


def directions(angles: Array) -> Array:
    """Return (A, 2) unit x, z of angles."""
    return np.stack([np.sin(angles), np.cos(angles)], axis=1)


def convex_hull_radii(points_m: Array, centre_m: Array, angles: Array) -> Array:
    """Return distances (A,) from a centre to the convex hull of points, zero where it lies outside the hull.

    Parameters
    ----------
    points_m : (N, 2) x, z
    centre_m : (2,) x, z
    angles : (A,) radians, as in :func:`ring_angles`
    """
    if len(points_m) < 3:
        return np.zeros(len(angles))
    try:
        walls = ConvexHull(points_m).equations
    except QhullError:  # all on one line
        return np.zeros(len(angles))
    room = -(walls[:, :2] @ centre_m + walls[:, 2])
    if (room < 0.0).any():
        return np.zeros(len(angles))
    rise = directions(angles) @ walls[:, :2].T
    reach = np.where(rise > 1e-9, room / np.maximum(rise, 1e-9), np.inf)
    return np.asarray(reach.min(axis=1))


@dataclass(frozen=True, slots=True, eq=False)
class Tube:
    """A tube's mesh; front and back are separate charts.

    Attributes
    ----------
    vertices_m : (N, 3) float64
    triangles : (T, 3) int32, normals outwards
    uv : (N, 2) float64 in 0..1, v downwards
    ring, column : (N,) int32
        Where in the table of radii every vertex stands.
    """

    vertices_m: Array
    triangles: NDArray[np.int32]
    uv: Array
    ring: NDArray[np.int32]
    column: NDArray[np.int32]


def tube_points(centres_m: Array, heights_m: Array, radii_m: Array) -> Array:
    """Return the (K, A, 3) points of a tube.

    Parameters
    ----------
    centres_m : (K, 2) x, z of the axis at every ring
    heights_m : (K, A) heights, rings ordered downwards
    radii_m : (K, A) over :func:`ring_angles`
    """
    way = directions(ring_angles(radii_m.shape[1]))
    flat = centres_m[:, None, :] + radii_m[..., None] * way
    return np.stack([flat[..., 0], heights_m, flat[..., 1]], axis=-1)


def tube_mesh(points_m: Array, size: int) -> Tube:
    """Return the mesh of a tube's points, open above and below.

    Parameters
    ----------
    points_m : (K, A, 3) from :func:`tube_points`; A even
    size : int
        Side of the texture, texels; for the margins.
    """
    rings, columns = points_m.shape[:2]
    half = columns // 2
    ring, place = np.divmod(np.arange(2 * rings * (half + 1)), half + 1)
    back = ring >= rings
    ring = np.where(back, ring - rings, ring)
    column = (place + np.where(back, half, 0)) % columns
    corner = (np.arange(rings - 1)[:, None] * (half + 1) + np.arange(half)).ravel()
    corner = np.concatenate([corner, corner + rings * (half + 1)])
    below = corner + half + 1
    # columns grow towards the person's left, which is +X: seen from outside, counter-clockwise
    triangles = np.concatenate(
        [np.stack([corner, below, corner + 1], axis=1), np.stack([corner + 1, below, below + 1], axis=1)]
    )
    vertices = points_m[ring, column]
    return Tube(
        vertices,
        triangles.astype(np.int32),
        _charts(points_m, ring, place, back, size),
        ring.astype(np.int32),
        column.astype(np.int32),
    )


def _charts(
    points_m: Array, ring: NDArray[np.int64], place: NDArray[np.int64], back: NDArray[np.bool_], size: int
) -> Array:
    """Return (N, 2) uv: the front's rectangle beside the back's, or above it when the tube is wider than high."""
    rings, columns = points_m.shape[:2]
    along = np.stack([place / (columns // 2), ring / max(rings - 1, 1)], axis=1)
    margin = MARGIN_TEXELS / size
    around = float(np.linalg.norm(np.diff(points_m, axis=1), axis=-1).sum(axis=1).mean()) / 2.0
    down = float(np.linalg.norm(np.diff(points_m, axis=0), axis=-1).sum(axis=0).mean())
    split = 0 if down > around else 1
    room = np.array([1.0, 1.0]) - 2.0 * margin
    room[split] = 0.5 - 2.0 * margin
    uv = margin + along * room
    uv[:, split] += np.where(back, 0.5, 0.0)
    return np.asarray(uv)
