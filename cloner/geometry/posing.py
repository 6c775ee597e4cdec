"""Chosen vertices and joints of the generic human as a function of shape and pose.

Built once per fit for the few vertices that matter, so that finite differences
over shape, pose and camera cost milliseconds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.skinning import joint_transforms, rotation_matrices, skin

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Chosen:
    """Some vertices of a linear shape model.

    Attributes
    ----------
    mean_m : (N, 3), basis_m : (C, 3 N)
        Vertices = mean + coefficients · basis, metres.
    joints_mean_m : (94, 3), joints_basis_m : (C, 282)
    parents : (94,)
    skin_joints, skin_weights : (N, 4)
    pose : (282, D) matrix from pose vector to stacked rotation vectors
    """

    mean_m: Array
    basis_m: Array
    joints_mean_m: Array
    joints_basis_m: Array
    parents: NDArray[np.integer]
    skin_joints: NDArray[np.integer]
    skin_weights: Array
    pose: Array

    def rotations(self, pose: Array) -> Array:
        """Return (94, 3) rotation vectors of a pose vector."""
        return (self.pose @ pose).reshape(-1, 3)

    def posed(self, shape: Array, pose: Array) -> tuple[Array, Array]:
        """Return posed (N, 3) vertices and (94, 3) joints, metres."""
        rest = self.mean_m + (shape @ self.basis_m[: len(shape)]).reshape(-1, 3)
        joints = self.joints_mean_m + (shape @ self.joints_basis_m[: len(shape)]).reshape(-1, 3)
        transforms = joint_transforms(joints, self.parents, self.rotations(pose))
        vertices = skin(rest, transforms, self.skin_joints, self.skin_weights)
        posed_joints = np.einsum("jab,jb->ja", transforms[:, :3, :3], joints) + transforms[:, :3, 3]
        return vertices, posed_joints


def moved_camera(camera_from_model: Array, motion: Array, pivot_m: Array) -> Array:
    """Return a rigid matrix moved by a small motion.

    Parameters
    ----------
    camera_from_model : (4, 4)
    motion : (6,)
        Rotation vector about the model's ``pivot_m`` in camera axes (radians), then
        translation in camera axes (metres).
    pivot_m : (3,) model point that the rotation leaves in place
    """
    turn = rotation_matrices(motion[None, :3])[0]
    rotation = turn @ camera_from_model[:3, :3]
    pivot = camera_from_model[:3, :3] @ pivot_m + camera_from_model[:3, 3]
    matrix = np.eye(4)
    matrix[:3, :3] = rotation
    matrix[:3, 3] = pivot - rotation @ pivot_m + motion[3:]
    return matrix
