"""The degrees of freedom of a standing person, as one short vector."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.articulation.skinning import rotation_matrices
from cloner.records.arrays import Array

#: Axes.
X, Y, Z = 0, 1, 2


@dataclass(frozen=True, slots=True)
class PoseFreedom:
    """One angle of the pose vector.

    Attributes
    ----------
    name : str
    joints : tuple of str
        H-Anim joints that share the angle in equal parts.
    axis : int
        Model axis 0, 1, 2 of the rotation vector.
    sigma : float
        Prior spread around the rest pose, radians (taste, after watching visitors stand).
    """

    name: str
    joints: tuple[str, ...]
    axis: int
    sigma: float


def _sided(name: str, joint: str, axis: int, degrees: float) -> list[PoseFreedom]:
    return [PoseFreedom(f"{side}_{name}", (f"{side}_{joint}",), axis, math.radians(degrees)) for side in "lr"]


_SPINE = ("vl5", "vl3", "vl1", "vt10", "vt6", "vt3")
_NECK = ("vc7", "vc4", "skullbase")

#: Spreads in degrees are taste, after watching visitors stand.
FREEDOMS: tuple[PoseFreedom, ...] = (
    *(
        f
        for axis, sigma in ((X, 9.0), (Y, 9.0), (Z, 20.0))
        for f in _sided(f"shoulder_{'xyz'[axis]}", "shoulder", axis, sigma)
    ),
    *_sided("clavicle_raise", "sternoclavicular", Z, 4.0),
    *(f for axis in (X, Y, Z) for f in _sided(f"elbow_{'xyz'[axis]}", "elbow", axis, 10.0)),
    *(f for axis in (X, Y, Z) for f in _sided(f"wrist_{'xyz'[axis]}", "wrist", axis, 12.0)),
    *(f for axis, sigma in ((X, 6.0), (Y, 4.0), (Z, 8.0)) for f in _sided(f"hip_{'xyz'[axis]}", "hip", axis, sigma)),
    *_sided("knee_bend", "knee", X, 6.0),
    *_sided("ankle_bend", "ankle", X, 5.0),
    *_sided("ankle_turn", "ankle", Y, 6.0),
    *_sided("ankle_roll", "ankle", Z, 5.0),
    *(PoseFreedom(f"spine_{'xyz'[a]}", _SPINE, a, math.radians(d)) for a, d in ((X, 6.0), (Y, 2.5), (Z, 3.0))),
    *(PoseFreedom(f"neck_{'xyz'[a]}", _NECK, a, math.radians(d)) for a, d in ((X, 10.0), (Y, 8.0), (Z, 6.0))),
)

SIGMAS: Array = np.array([freedom.sigma for freedom in FREEDOMS])


@functools.cache
def mirrored_freedoms() -> tuple[NDArray[np.int64], NDArray[np.int64], Array]:
    """Return the columns of left limbs' angles (N,), of the right ones' (N,), and the sign (N,) that mirrors them."""
    column = {freedom.name: place for place, freedom in enumerate(FREEDOMS)}
    left = np.array([place for name, place in column.items() if name.startswith("l_")], dtype=np.int64)
    right = np.array([column[f"r_{FREEDOMS[place].name[2:]}"] for place in left], dtype=np.int64)
    return left, right, np.where([FREEDOMS[place].axis == X for place in left], 1.0, -1.0)


def pose_matrix(joint_names: Sequence[str]) -> Array:
    """Return the (94 * 3, D) matrix from a pose vector to all joints' rotation vectors.

    Raises
    ------
    ValueError
        If a joint of the table is missing from ``joint_names``.
    """
    index = {name: row for row, name in enumerate(joint_names)}
    matrix = np.zeros((len(joint_names) * 3, len(FREEDOMS)))
    for column, freedom in enumerate(FREEDOMS):
        for joint in freedom.joints:
            if joint not in index:
                raise ValueError(f"the skeleton has no joint {joint}")
            matrix[index[joint] * 3 + freedom.axis, column] = 1.0 / len(freedom.joints)
    return matrix


def _rotation_between(start: Array, end: Array) -> Array:
    """Return the shortest rotation vector from one direction to another."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    axis = np.cross(start, end)
    sine = float(np.linalg.norm(axis))
    return axis / max(sine, 1e-12) * math.atan2(sine, float(start @ end))


def standing_pose(joint_names: Sequence[str], joints_m: Array) -> Array:
    """Return the pose vector of a person who stands with arms slightly abducted.

    Parameters
    ----------
    joint_names : sequence of str
    joints_m : (94, 3) rest joints, metres

    Notes
    -----
    Upper arms 30° from the vertical, forearms 24° and 8° forward: halfway between
    hanging arms and the A-pose that operators ask for (taste).
    """
    index = {name: row for row, name in enumerate(joint_names)}
    column = {freedom.name: place for place, freedom in enumerate(FREEDOMS)}
    pose = np.zeros(len(FREEDOMS))
    for side, sign in (("l", 1.0), ("r", -1.0)):
        shoulder, elbow, wrist = (joints_m[index[f"{side}_{name}"]] for name in ("shoulder", "elbow", "wrist"))
        upper = _rotation_between(elbow - shoulder, np.array([sign * 0.50, -0.866, 0.0]))
        raised = rotation_matrices(upper[None])[0]
        fore = _rotation_between(wrist - elbow, raised.T @ np.array([sign * 0.40, -0.90, 0.14]))
        for axis in range(3):
            pose[column[f"{side}_shoulder_{'xyz'[axis]}"]] = upper[axis]
            pose[column[f"{side}_elbow_{'xyz'[axis]}"]] = fore[axis]
    return pose
