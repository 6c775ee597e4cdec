"""Derivatives of posed points by small rotations of joints."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cloner.geometry.meshes.vectors import cross
from cloner.records.arrays import Array


def is_below(parents: NDArray[np.integer], joint: int) -> NDArray[np.bool_]:
    """Return whether a joint is ``joint`` itself or a descendant, (J,); parents come before children."""
    hangs = np.zeros(len(parents), dtype=bool)
    hangs[joint] = True
    for row in range(joint + 1, len(parents)):
        hangs[row] = parents[row] >= 0 and hangs[parents[row]]
    return hangs


def subtree_weights(
    parents: NDArray[np.integer], joint: int, skin_joints: NDArray[np.integer], skin_weights: Array
) -> Array:
    """Return the summed skinning weight (V,) of a joint and all its descendants on each vertex."""
    return np.asarray((skin_weights * is_below(parents, joint)[skin_joints]).sum(axis=1))


def rotation_jacobian(posed_m: Array, pivot_m: Array, axes: Array, share: Array) -> Array:
    """Return the derivatives (V, 3, A) of posed points by a joint's rotation about each axis, per radian.

    Parameters
    ----------
    posed_m : (V, 3) posed points
    pivot_m : (3,) posed joint
    axes : (A, 3) unit axes, posed frame
    share : (V,) from :func:`subtree_weights`

    Notes
    -----
    First order, and exact for points that the joint carries whole; linear blend
    skinning bends the others by nearly their share.
    """
    arm = (posed_m - pivot_m) * share[:, None]
    return np.asarray(np.stack([cross(axis, arm) for axis in axes], axis=2))


def compose_rotations(rotation: Array, turn: Array) -> Array:
    """Return the rotation vector (3,) of ``rotation`` followed by ``turn``, both in the parent's axes."""
    return np.asarray((Rotation.from_rotvec(turn) * Rotation.from_rotvec(rotation)).as_rotvec())
