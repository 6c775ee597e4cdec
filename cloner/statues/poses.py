"""Stances of statues: straight legs and flat feet, so that they can step down and walk."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import numpy as np

from cloner.errors import ClonerError
from cloner.motion.flesh.rest import hanging_pose, in_pose
from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.limbs.twist import shared_twist
from cloner.motion.moves.gait import aim_limb, follow
from cloner.records.arrays import Array
from cloner.records.clones import Clone

#: As the clone was photographed to stand: arms aside.
REST: Final = "rest"
#: Degrees that upper arm and forearm are lifted forwards from hanging, left and right; taste. "guard" holds a spear.
ARMS: Final[Mapping[str, Mapping[str, tuple[float, float]]]] = MappingProxyType({
    "standing": {"l": (0.0, 0.0), "r": (0.0, 0.0)},
    "guard": {"l": (4.0, 12.0), "r": (12.0, 88.0)},
    "hail": {"l": (0.0, 6.0), "r": (78.0, 118.0)},
})  # fmt: skip
POSES: Final = (REST, *ARMS)


def standing(clone: Clone, pose: str) -> Clone:
    """Return the clone with a pose as its rest pose; all motions still apply.

    Raises
    ------
    ClonerError
        If the pose is not known.
    """
    check_pose(pose)
    return clone if pose == REST else in_pose(clone, _rotations(body_of(centre_joints(clone)), ARMS[pose]))


def check_pose(pose: str) -> None:
    """Raise a ClonerError if the pose is not known."""
    if pose not in POSES:
        raise ClonerError(f"the pose {pose!r} is not known", f"Give --pose one of {', '.join(POSES)}", "--pose")


def _rotations(body: Body, arms: Mapping[str, tuple[float, float]]) -> Array:
    """Return (94, 3) rotation vectors of a body that hangs its arms but for what is lifted, radians."""
    world = turns.world_from_local(hanging_pose(body)[None], body.parents)
    for side in SIDES:
        if any(arms[side]):
            out = turns.rotations_about(2, np.array([body.arm_aside(side)]))
            for name, degrees in zip(("shoulder", "elbow"), arms[side], strict=True):
                aim_limb(body, world, side, name, turns.rotations_about(0, np.array([-np.radians(degrees)])) @ out)
            follow(body, world, side)
    return np.asarray(shared_twist(body, turns.local_from_world(world, body.parents))[0])
