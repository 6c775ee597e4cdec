"""Clearance of hanging arms and legs, so that sleeves and trouser legs do not intersect."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman, load_generic
from cloner.records.arrays import Array

#: Least and most that an arm is held away, degrees: sleeves have thickness; with more it looks stiff (taste).
LEAST_DEG: Final = 9.0
MOST_DEG: Final = 15.0
#: Fingers of a relaxed hand are curled inwards by so much more than those of the straight hand at rest, metres.
CURLED_M: Final = 0.015
#: Above this share of the upper arm it is the armpit's skin that touches the trunk, as it does in everybody.
FREE_FROM: Final = 0.4
#: The same of a leg: from 10 degrees inwards, as slim people walk, to 6 outwards; and above this share of the thigh it
#: is the crotch that touches.
LEGS_DEG: Final = (-10.0, 6.0)
LEG_FREE_FROM: Final = 0.2
#: The trunk's half width is taken level by level, so far apart, metres.
LEVEL_M: Final = 0.01


def arm_clearance_rad(vertices_m: Array, joints_m: Array) -> float:
    """Return the angle from straight down at which both hanging arms are clear of trunk and thighs, radians.

    Parameters
    ----------
    vertices_m : (V, 3), joints_m : (94, 3)
        A person in rest pose, model frame, metres.
    """
    return max(_arm_out(vertices_m, joints_m, side) for side in "lr")


def leg_clearance_rad(vertices_m: Array, joints_m: Array) -> float:
    """Return the angle from straight down, positive outwards, from which straight legs do not touch, radians.

    Parameters
    ----------
    vertices_m : (V, 3), joints_m : (94, 3)
        A person in rest pose, model frame, metres.
    """
    return max(_leg_out(vertices_m, joints_m, side) for side in "lr")


def _leg_out(vertices_m: Array, joints_m: Array, side: str) -> float:
    generic, sign = load_generic(), 1.0 if side == "l" else -1.0
    long, hip = {"l": "left", "r": "right"}[side], joints_m[generic.joint(f"{side}_hip")]
    bone = joints_m[generic.joint(f"{side}_knee")] - hip
    across = np.cross(bone, [0.0, 0.0, 1.0]) * sign / np.linalg.norm(bone[:2])  # towards the other leg
    local = vertices_m[_rows(generic, (f"{long}_thigh",))] - hip
    along, inward = local @ bone / np.linalg.norm(bone), local @ across
    own = along > LEG_FREE_FROM * np.linalg.norm(bone)
    for angle in np.radians(np.arange(*LEGS_DEG)):
        if (sign * hip[0] + along[own] * np.sin(angle) - inward[own] * np.cos(angle) > 0.0).all():
            return float(angle)
    return float(np.radians(LEGS_DEG[1]))


def _arm_out(vertices_m: Array, joints_m: Array, side: str) -> float:
    generic, sign = load_generic(), 1.0 if side == "l" else -1.0
    along, inward = _arm(generic, vertices_m, joints_m, side)
    levels, widths = _half_widths(generic, vertices_m, joints_m, side)
    shoulder = joints_m[generic.joint(f"{side}_shoulder")]
    for angle in np.radians(np.arange(LEAST_DEG, MOST_DEG)):
        height = shoulder[1] - along * np.cos(angle) - inward * np.sin(angle)
        aside = sign * shoulder[0] + along * np.sin(angle) - inward * np.cos(angle)
        if (aside > np.interp(height, levels, widths)).all():
            return float(angle)
    return float(np.radians(MOST_DEG))


def _rows(generic: GenericHuman, names: tuple[str, ...]) -> NDArray[np.int64]:
    """Return the skin's vertices of some segments."""
    return np.flatnonzero(generic.segment(*names) & generic.skin)


def _arm(generic: GenericHuman, vertices_m: Array, joints_m: Array, side: str) -> tuple[Array, Array]:
    """Return positions along the straight arm of its vertices, and inwards from its axis, metres."""
    long = {"l": "left", "r": "right"}[side]
    chain = ("shoulder", "elbow", "wrist", "middle3")
    along, inward, start = [], [], 0.0
    for first, last, segment in zip(chain, chain[1:], ("upper_arm", "forearm", "hand"), strict=False):
        bone = joints_m[generic.joint(f"{side}_{last}")] - joints_m[generic.joint(f"{side}_{first}")]
        length = float(np.linalg.norm(bone))
        local = vertices_m[_rows(generic, (f"{long}_{segment}",))] - joints_m[generic.joint(f"{side}_{first}")]
        across = np.cross(bone, [0.0, 0.0, 1.0]) * (1.0 if side == "l" else -1.0)  # towards the trunk
        place = local @ bone / length
        own = place > FREE_FROM * length if segment == "upper_arm" else np.ones(len(place), dtype=np.bool_)
        along.append(start + place[own])
        curled = CURLED_M if segment == "hand" else 0.0
        inward.append((local @ across / np.linalg.norm(across))[own] + curled)
        start += length
    return np.concatenate(along), np.concatenate(inward)


def _half_widths(generic: GenericHuman, vertices_m: Array, joints_m: Array, side: str) -> tuple[Array, Array]:
    """Return levels (L,), increasing, and the lateral extent of trunk and hanging leg there, metres."""
    long, sign = {"l": "left", "r": "right"}[side], 1.0 if side == "l" else -1.0
    hip, knee = (joints_m[generic.joint(f"{side}_{name}")] for name in ("hip", "knee"))
    trunk, thigh = vertices_m[_rows(generic, ("torso", "pelvis"))], vertices_m[_rows(generic, (f"{long}_thigh",))]
    down = np.clip((hip[1] - thigh[:, 1]) / (hip[1] - knee[1]), 0.0, 1.0)
    heights = np.concatenate([trunk[:, 1], thigh[:, 1]])
    aside = sign * np.concatenate([trunk[:, 0], thigh[:, 0] - down * (knee - hip)[0]])
    step = np.round((heights - heights.min()) / LEVEL_M).astype(np.int64)
    widths = np.zeros(int(step.max()) + 1)
    np.maximum.at(widths, step, aside)
    levels = heights.min() + LEVEL_M * np.arange(len(widths))
    shoulder = joints_m[generic.joint(f"{side}_shoulder"), 1]
    return levels[levels < shoulder], widths[levels < shoulder]
