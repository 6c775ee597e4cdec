"""Bring a clone into the pose of a body whose joints nobody knows, by rotations and a rigid motion alone."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.spatial import cKDTree

from cloner.evaluate.figures.skins import skin_triangles
from cloner.evaluate.truths.truth import TruthSurface
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.poses import SIGMAS, pose_matrix
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning, rotation_matrices
from cloner.records.clones import Clone

Array = NDArray[np.float64]

VERTICES: Final = 1500  # of the clone, drawn at random, that feel the surface
TURNS: Final = 10
#: How far a clone's surface may lie from the truth's and still steer, metres: the error that is to be measured.
_SURFACE_SIGMA_M: Final = 0.01
_REACH_M: Final = 0.12


def rotations_by_surface(clone: Clone, generic: GenericHuman, truth: TruthSurface, start: Array) -> tuple[Array, Array]:
    """Return the (94, 3) rotations and the rigid (4, 4) motion that lay a clone on a surface.

    Parameters
    ----------
    clone, generic
    truth : TruthSurface
        Facing +Z with y up, as the clone does.
    start : (94, 3) float64
        Rotations to begin from and to stay near.
    """
    rng = np.random.default_rng(0)
    chosen = rng.choice(np.unique(skin_triangles(generic)), VERTICES, replace=False)
    spread, parents = pose_matrix(generic.joint_names), generic.joint_parents.astype(np.int32)
    joints, weights = generic.skin_joints[chosen], generic.skin_weights[chosen].astype(np.float64)
    tree = cKDTree(truth.points_m)
    begun = linear_blend_skinning(
        clone.vertices_m[chosen], joint_transforms(clone.joints_m, parents, start), joints, weights
    )
    truth_from_clone = np.eye(4)
    truth_from_clone[:3, 3] = (np.ptp(truth.points_m, axis=0) - np.ptp(begun, axis=0)) / 2.0  # boxes' middles meet
    truth_from_clone[:3, 3] += truth.points_m.min(axis=0) - begun.min(axis=0)

    def moved(values: Array) -> Array:
        rotations = start + (spread @ values[6:]).reshape(-1, 3)
        posed = linear_blend_skinning(
            clone.vertices_m[chosen], joint_transforms(clone.joints_m, parents, rotations), joints, weights
        )
        posed = posed @ truth_from_clone[:3, :3].T + truth_from_clone[:3, 3]
        return np.asarray(posed @ rotation_matrices(values[None, :3])[0].T + values[3:6])

    best = np.zeros(6 + len(SIGMAS))
    for _ in range(TURNS):
        distance, near = tree.query(moved(best))
        felt = np.flatnonzero(distance < _REACH_M)
        goals, normals = truth.points_m[near[felt]], truth.normals[near[felt]]

        def residual(
            values: Array, felt: NDArray[np.int64] = felt, goals: Array = goals, normals: Array = normals
        ) -> Array:
            away = np.einsum("na,na->n", moved(values)[felt] - goals, normals) / _SURFACE_SIGMA_M
            return np.concatenate([away / np.sqrt(1.0 + (away / 3.0) ** 2), 3.0 * values[6:] / SIGMAS])

        best = least_squares(residual, best, method="trf", max_nfev=4).x
    motion = np.eye(4)
    motion[:3, :3], motion[:3, 3] = rotation_matrices(best[None, :3])[0], best[3:6]
    return start + (spread @ best[6:]).reshape(-1, 3), motion @ truth_from_clone
