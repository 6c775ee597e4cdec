"""Ray casting against the flat quads of a room, many rays from one origin at a time.

A ray from a place meets only quads that face it (solids are closed), and of those only what lies on its side of the
surface: of some hundred quads a few dozen remain, and planes, coordinates and distances are three matrix products.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array
from cloner.scenes.building.pieces import Quad

#: How far a ray may miss a quad's border and still be stopped, as a share of its side: no light between neighbours.
SLACK = 1e-5


class RayQuads:
    """Quads as arrays: corner, edges over their squared length, unit normals, all (Q, 3); corners (Q, 4, 3)."""

    def __init__(self, quads: Sequence[Quad]) -> None:
        self.corner = np.array([one.corner for one in quads]).reshape(-1, 3)
        along = np.array([one.along for one in quads]).reshape(-1, 3)
        up = np.array([one.up for one in quads]).reshape(-1, 3)
        self.normal = np.cross(along, up)
        self.normal /= np.maximum(np.linalg.norm(self.normal, axis=1, keepdims=True), 1e-12)
        self.corners = self.corner[:, None] + np.stack([np.zeros_like(along), along, up, along + up], axis=1)
        self.along = along / np.maximum((along**2).sum(axis=1, keepdims=True), 1e-12)
        self.up = up / np.maximum((up**2).sum(axis=1, keepdims=True), 1e-12)
        self.low, self.high = self.corners.min(axis=1), self.corners.max(axis=1)

    def first_hits(
        self, origin: Array, directions: Array, normal: Array | None = None
    ) -> tuple[NDArray[np.int64], Array, Array]:
        """Return the first hits of rays from one origin.

        Parameters
        ----------
        origin : (3,)
        directions : (R, 3) directions
        normal : (3,)
            Of the surface on which the place lies: what is behind it is left out.

        Returns
        -------
        (R,) quad, -1 where nothing; (R,) distance in lengths of the ways, inf where nothing; (R, 2) where in the
        quad, 0..1.
        """
        held = np.flatnonzero(self._facing(origin, normal))
        if not len(held):
            return np.full(len(directions), -1), np.full(len(directions), np.inf), np.zeros((len(directions), 2))
        away, a, b = self._intersect(origin, directions, held)
        nearest = away.argmin(axis=1)
        rows = np.arange(len(directions))
        t = away[rows, nearest]
        found = np.where(np.isfinite(t), held[nearest], -1)
        return found, t.astype(np.float64), np.stack([a[rows, nearest], b[rows, nearest]], axis=1).astype(np.float64)

    def _facing(self, origin: Array, normal: Array | None) -> NDArray[np.bool_]:
        front = ((origin - self.corner) * self.normal).sum(axis=1) > 1e-5
        if normal is not None:
            front &= ((self.corners - origin) @ normal).max(axis=1) > 1e-4
        return np.asarray(front)

    def _intersect(self, origin: Array, directions: Array, held: NDArray[np.int64]) -> tuple[Array, Array, Array]:
        """Return distances (inf for misses) and both coordinates, each (R, H)."""
        ways32 = directions.astype(np.float32)
        corner = self.corner[held] - origin
        height = (corner * self.normal[held]).sum(axis=1).astype(np.float32)
        falls = ways32 @ self.normal[held].T.astype(np.float32)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            away = height / falls
            a = away * (ways32 @ self.along[held].T.astype(np.float32))
            a -= (corner * self.along[held]).sum(axis=1).astype(np.float32)
            b = away * (ways32 @ self.up[held].T.astype(np.float32))
            b -= (corner * self.up[held]).sum(axis=1).astype(np.float32)
            hit = (falls < 0.0) & (np.abs(a - 0.5) <= 0.5 + SLACK) & (np.abs(b - 0.5) <= 0.5 + SLACK)
        away[~hit] = np.inf
        return away, a, b

    def visible_from(self, place: Array, targets: Array) -> NDArray[np.bool_]:
        """Return which of nearby (N, 3) targets are visible from a point."""
        low, high = np.minimum(targets.min(axis=0), place), np.maximum(targets.max(axis=0), place)
        near = ((self.low <= high + 1e-6) & (self.high >= low - 1e-6)).all(axis=1) & self._facing(place, None)
        held = np.flatnonzero(near)
        if not len(held):
            return np.ones(len(targets), bool)
        away, _, _ = self._intersect(place, targets - place, held)
        return np.asarray(away.min(axis=1) >= 1.0 - 1e-3)

    def unblocked_along(self, places: Array, direction: Array, across: Array) -> NDArray[np.bool_]:
        """Return which of nearby (N, 3) points are unblocked along a direction.

        Parameters
        ----------
        places : (N, 3)
        direction : (3,) unit, towards the sun
        across : (2, 3) unit, perpendicular to it and each other
        """
        flat, mine = self.corners @ across.T, places @ across.T
        near = (flat.min(axis=1) <= mine.max(axis=0)).all(axis=1) & (flat.max(axis=1) >= mine.min(axis=0)).all(axis=1)
        falls = self.normal @ direction
        held = np.flatnonzero(near & (falls > 1e-6))
        if not len(held):
            return np.ones(len(places), bool)
        base = places.mean(axis=0)
        own = (places - base).astype(np.float32)
        corner = self.corner[held] - base
        height = (corner * self.normal[held]).sum(axis=1)
        away = (height - own @ self.normal[held].T) / falls[held]
        a = own @ self.along[held].T + away * (self.along[held] @ direction) - (corner * self.along[held]).sum(axis=1)
        b = own @ self.up[held].T + away * (self.up[held] @ direction) - (corner * self.up[held]).sum(axis=1)
        hit = (away > 1e-3) & (np.abs(a - 0.5) <= 0.5 + SLACK) & (np.abs(b - 0.5) <= 0.5 + SLACK)
        return np.asarray(~hit.any(axis=1))


def hemisphere_directions(count: int) -> Array:
    """Return (count, 3) directions of equal cosine weight about +Z: a Fibonacci spiral on the disc, lifted."""
    k = np.arange(count) + 0.5
    radius, angle = np.sqrt(k / count), k * np.pi * (3.0 - np.sqrt(5.0))
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.sqrt(1.0 - radius**2)])


def sphere_directions(count: int) -> Array:
    """Return (count, 3) evenly distributed directions: a Fibonacci spiral."""
    k = np.arange(count) + 0.5
    z, angle = 1.0 - 2.0 * k / count, k * np.pi * (3.0 - np.sqrt(5.0))
    out = np.sqrt(1.0 - z * z)
    return np.column_stack([out * np.cos(angle), z, out * np.sin(angle)])
