"""How posed points move when joints turn a little."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from cloner.geometry.meshes.vectors import cross
from cloner.records.arrays import Array


def below(parents: NDArray[np.integer], joint: int) -> NDArray[np.bool_]:
    """Return (J,) whether a joint is ``joint`` itself or hangs on it; parents come before children."""
    hangs = np.zeros(len(parents), dtype=bool)
    hangs[joint] = True
    for row in range(joint + 1, len(parents)):
        hangs[row] = parents[row] >= 0 and hangs[parents[row]]
    return hangs


def carried_share(
    parents: NDArray[np.integer], joint: int, skin_joints: NDArray[np.integer], skin_weights: Array
) -> Array:
    """Return (V,) the share of each vertex that a joint and all joints below it carry."""
    return np.asarray((skin_weights * below(parents, joint)[skin_joints]).sum(axis=1))


def turned_motion(posed_m: Array, pivot_m: Array, axes: Array, share: Array) -> Array:
    """Return (V, 3, A) motion of posed points per radian of a joint's turn about each axis.

    Parameters
    ----------
    posed_m : (V, 3) posed points
    pivot_m : (3,) posed joint
    axes : (A, 3) unit axes, posed frame
    share : (V,) from :func:`carried_share`

    Notes
    -----
    First order, and exact for points that the joint carries whole; linear blend
    skinning bends the others by nearly their share.
    """
    arm = (posed_m - pivot_m) * share[:, None]
    return np.asarray(np.stack([cross(axis, arm) for axis in axes], axis=2))


def turned_rotation(rotation: Array, turn: Array) -> Array:
    """Return the (3,) rotation vector of ``rotation`` followed by ``turn``, both in the parent's axes."""
    return np.asarray((Rotation.from_rotvec(turn) * Rotation.from_rotvec(rotation)).as_rotvec())
