"""Local affine maps between two shapes of one mesh (deformation gradients)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.records.arrays import Array

#: Vertices of a neighbourhood, and anchors that a vertex listens to.
_NEAR, _LISTENS = 300, 6
#: Weight of the common similarity, share of a neighbourhood's extent: it decides across flat neighbourhoods.
_STIFFNESS = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class LocalMaps:
    """Precomputed solver of the maps to any second shape.

    Attributes
    ----------
    before : (V, 3) float64, metres
    near : (A, M) int64
        Vertices around every anchor.
    solver : (A, M, 3) float64
        Displacements weighted with it and summed give the anchor's map.
    anchors : (V, B) int64, share : (V, B) float64
        Anchors that every vertex listens to; shares sum to one.
    """

    before: Array
    near: NDArray[np.int64]
    solver: Array
    anchors: NDArray[np.int64]
    share: Array

    def maps(self, after: Array) -> Array:
        """Return the maps (V, 3, 3) from displacements before to displacements after, for moved vertices (V, 3)."""
        scale, rotation, _ = similarity_alignment(self.before, after)
        common = scale * rotation
        own = np.einsum("amk,amc->akc", (after - self.before @ common.T)[self.near], self.solver)
        return np.asarray(common + np.einsum("vb,vbkc->vkc", self.share, own[self.anchors]))


def local_maps(before: Array, *, reach_m: float, anchors: int) -> LocalMaps:
    """Return the solver of local affine maps around a shape.

    Parameters
    ----------
    before : (V, 3) metres
    reach_m : float
        One standard deviation of the neighbourhood that a map is fitted to.
    anchors : int
        Number of maps; vertices between take a mixture.

    References
    ----------
    Sumner and Popovic 2004, "Deformation transfer for triangle meshes", section 3. Departure: one map a neighbourhood
    by weighted least squares, not one a triangle: both faces share one mesh, and smooth maps keep folds apart.
    """
    chosen = _farthest_point_sampling(before, anchors)
    distance, near = cKDTree(before).query(before[chosen], k=min(len(before), _NEAR))
    weight = np.exp(-0.5 * (distance / reach_m) ** 2)
    weight /= weight.sum(axis=1, keepdims=True)
    local = before[near] - np.einsum("am,amc->ac", weight, before[near])[:, None]
    spread = np.einsum("am,amc,amd->acd", weight, local, local)
    stiff = _STIFFNESS * np.trace(spread, axis1=1, axis2=2)[:, None, None] * np.eye(3)
    solver = weight[..., None] * np.einsum("amc,acd->amd", local, np.linalg.inv(spread + stiff))
    away, anchor_of = cKDTree(before[chosen]).query(before, k=_LISTENS)
    share = np.exp(-0.5 * (away / (0.7 * reach_m)) ** 2) + 1e-12
    return LocalMaps(before, near, solver, anchor_of, share / share.sum(axis=1, keepdims=True))


def _farthest_point_sampling(points: Array, count: int) -> NDArray[np.int64]:
    """Return the rows of well spread points, each the farthest from those before it."""
    chosen = [0]
    away = np.linalg.norm(points - points[0], axis=1)
    while len(chosen) < min(count, len(points)):
        chosen.append(int(away.argmax()))
        away = np.minimum(away, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return np.array(chosen, dtype=np.int64)
