"""The person's mesh as it stood in a photo."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.geometry.skinning import joint_transforms, skin
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.heads import Shell

Array = NDArray[np.float64]


def body_triangles(generic: GenericHuman) -> NDArray[np.int32]:
    """Return the (T, 3) triangles of the skin, without eyes, teeth, tongue and lashes."""
    triangles = generic.triangles()[0]
    part = generic.vertex_part[triangles[:, 0]]
    return np.asarray(triangles[part == generic.part_names.index("body")], np.int32)


def parents_of(generic: GenericHuman) -> NDArray[np.int32]:
    """Return (94,) each joint's parent, -1 above the root."""
    return np.asarray(generic.joint_parents, np.int32)


def pose(generic: GenericHuman, joined: Joined, view: PosedView) -> Array:
    """Return the (V, 3) vertices as the person stood in one photo, metres."""
    transforms = joint_transforms(joined.joints_m, parents_of(generic), view.rotations)
    joints, weights = np.asarray(generic.skin_joints, np.int32), np.asarray(generic.skin_weights, np.float64)
    return skin(joined.vertices_m, transforms, joints, weights)


def pose_shell(generic: GenericHuman, joined: Joined, view: PosedView, shell: Shell) -> Array:
    """Return the (N, 3) vertices of a shell as in one photo, metres."""
    transforms = joint_transforms(joined.joints_m, parents_of(generic), view.rotations)
    return skin(shell.vertices_m, transforms, shell.skin_joints, shell.skin_weights)
