"""Forearm twist shared by elbow and wrist: twisted at one joint alone, a limb collapses like a candy wrapper."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.motion.limbs import turns
from cloner.motion.limbs.body import SIDES, Body
from cloner.records.arrays import Array

#: The part that the elbow takes of a hand's turn against its upper arm: both joints then close by 8 % at a quarter
#: turn, where the wrist alone closed by 29 % (linear blend skinning, cosine of half the angle).
FOREARM_PART: Final = 0.5


def shared_twist(body: Body, rotations: Array) -> Array:
    """Return the rotations with a hand's twist about its forearm shared by elbow and wrist; hands are unchanged.

    Parameters
    ----------
    body : Body
    rotations : (F, 94, 3)
        Rotation vectors against the parents, model axes, radians.

    References
    ----------
    Swing and twist of a quaternion: its part along the axis is the twist.
    """
    shared = rotations.copy()
    for side in SIDES:
        elbow, wrist = body.joint(f"{side}_elbow"), body.joint(f"{side}_wrist")
        axis = body.joints_m[wrist] - body.joints_m[elbow]
        axis /= np.linalg.norm(axis)
        own, hand = (twist_about(axis, rotations[:, joint]) for joint in (elbow, wrist))
        turn = turns.matrices((FOREARM_PART * (own + hand) - own)[:, None] * axis)
        shared[:, elbow] = turns.vectors(turns.matrices(rotations[:, elbow]) @ turn)
        shared[:, wrist] = turns.vectors(np.swapaxes(turn, -1, -2) @ turns.matrices(rotations[:, wrist]))
    return shared


def twist_about(axis: Array, rotations: Array) -> Array:
    """Return the twist (F,) of rotation vectors (F, 3) about a unit axis, radians in -pi..pi."""
    angle = np.linalg.norm(rotations, axis=1)
    along = rotations @ axis / np.maximum(angle, 1e-12)
    twist = 2.0 * np.arctan2(np.sin(angle / 2.0) * along, np.cos(angle / 2.0))
    return np.asarray((twist + np.pi) % (2.0 * np.pi) - np.pi)
