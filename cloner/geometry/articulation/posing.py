"""Points of the generic human as a function of shape and pose, with exact derivatives.

Built once per fit for the few vertices and joints that matter.

References
----------
"Beyond": not in the paper. Linear blend skinning moves a point by a weighted sum of
rigid joint motions; turning a joint by a small angle about an axis through it moves
every share that hangs below by the cross product of axis and lever arm.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.articulation.skinning import joint_transforms, posed_joints, rotation_axes
from cloner.geometry.meshes.vectors import cross
from cloner.records.arrays import Array


@dataclass(frozen=True, slots=True, eq=False)
class PosedPoints:
    """Posed points with their derivatives.

    Attributes
    ----------
    points_m : (N, 3) metres
    by_shape : (N, 3, C) metres per unit of a shape coefficient
    by_pose : (N, 3, D) metres per radian of the pose vector
    """

    points_m: Array
    by_shape: Array
    by_pose: Array


@dataclass(frozen=True, slots=True, eq=False)
class PointModel:
    """Some points of a linear shape model; a joint is a point that depends on itself alone.

    Attributes
    ----------
    mean_m : (N, 3), basis_m : (N, 3, C)
        Points = mean + basis · coefficients, metres.
    joints_mean_m : (J, 3), joints_basis_m : (J, 3, C)
    parents : (J,) parents before children, -1 for the root
    skin_joints, skin_weights : (N, K)
    pose : (3 J, D) matrix from pose vector to stacked rotation vectors
    start : float or (3 J,)
        Rotation vectors of the pose vector 0, stacked.
    """

    mean_m: Array
    basis_m: Array
    joints_mean_m: Array
    joints_basis_m: Array
    parents: NDArray[np.integer]
    skin_joints: NDArray[np.integer]
    skin_weights: Array
    pose: Array
    start: Array | float = 0.0

    def rotations(self, pose: Array) -> Array:
        """Return the rotation vectors (J, 3) of a pose vector."""
        return np.asarray(self.start + self.pose @ pose).reshape(-1, 3)

    def part(self, rows: slice | NDArray[np.integer]) -> PointModel:
        """Return the model of some of the points."""
        return PointModel(
            self.mean_m[rows],
            self.basis_m[rows],
            self.joints_mean_m,
            self.joints_basis_m,
            self.parents,
            self.skin_joints[rows],
            self.skin_weights[rows],
            self.pose,
            self.start,
        )

    def posed(self, shape: Array, pose: Array) -> Array:
        """Return posed points (N, 3), metres; missing coefficients are zero."""
        return np.asarray(np.einsum("nk,nka->na", self.skin_weights, self._shares(shape, pose)[0]))

    def _shares(self, shape: Array, pose: Array) -> tuple[Array, Array, Array]:
        """Return the points (N, K, 3) as each joint alone would place them, transforms (J, 4, 4) and joints (J, 3)."""
        count = len(shape)
        rest = self.mean_m + self.basis_m[..., :count] @ shape
        joints = self.joints_mean_m + self.joints_basis_m[..., :count] @ shape
        transforms = joint_transforms(joints, self.parents, self.rotations(pose))
        own = transforms[self.skin_joints]
        shares = (own[..., :3, :3] @ rest[:, None, :, None])[..., 0] + own[..., :3, 3]
        return shares, transforms, posed_joints(transforms, joints)

    def moved(self, shape: Array, pose: Array) -> PosedPoints:
        """Return the posed points with their derivatives by shape and pose."""
        shares, transforms, joints = self._shares(shape, pose)
        points = np.einsum("nk,nka->na", self.skin_weights, shares)
        below = descendants(self.parents)
        turns = transforms[:, :3, :3]
        return PosedPoints(
            points,
            self._by_shape(turns, below, len(shape)),
            self._by_pose(turns, below, shares, joints, self.rotations(pose)),
        )

    def _by_shape(self, turns: Array, below: Array, count: int) -> Array:
        """Return the derivatives (N, 3, C): the point moves in its joint's frame, and with the joints above it."""
        parent_turns = np.where((self.parents >= 0)[:, None, None], turns[self.parents], np.eye(3))
        basis = self.joints_basis_m[..., :count]
        slip = below.T @ ((parent_turns - turns) @ basis).reshape(len(turns), -1)
        slip = slip.reshape(len(turns), 3, count)
        blended = np.einsum("nk,nkab->nab", self.skin_weights, turns[self.skin_joints])
        moved = blended @ self.basis_m[..., :count]
        for column in range(self.skin_joints.shape[1]):
            moved += self.skin_weights[:, column, None, None] * slip[self.skin_joints[:, column]]
        return np.asarray(moved)

    def _by_pose(self, turns: Array, below: Array, shares: Array, joints: Array, rotations: Array) -> Array:
        """Return the derivatives (N, 3, D): cross products of rotation axes and lever arms."""
        rows = np.flatnonzero(self.pose.any(axis=1))
        axes = _world_rotation_axes(turns, self.parents, rotations).transpose(0, 2, 1).reshape(-1, 3)[rows]
        used, at = np.unique(rows // 3, return_inverse=True)
        hangs = below[used][:, self.skin_joints] * self.skin_weights  # (U, N, K)
        arms = np.einsum("unk,nka->una", hangs, shares) - hangs.sum(axis=2)[..., None] * joints[used, None]
        by_row = cross(axes[:, None], arms[at])
        return np.asarray(np.einsum("rna,rd->nad", by_row, self.pose[rows], optimize=True))


def descendants(parents: NDArray[np.integer]) -> Array:
    """Return (J, J) float64: 1 where the column's joint is the row's or hangs below it."""
    below = np.eye(len(parents))
    for joint, parent in enumerate(parents):
        if parent >= 0:
            below[:, joint] += below[:, parent]
    return below


def _world_rotation_axes(turns: Array, parents: NDArray[np.integer], rotations: Array) -> Array:
    """Return (J, 3, 3), columns: rotation axes of a joint for each component of its rotation vector."""
    above = np.where((parents >= 0)[:, None, None], turns[parents], np.eye(3))
    return np.asarray(above @ rotation_axes(rotations))
