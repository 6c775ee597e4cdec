"""Given heights and lengths: levels of trunk and legs move vertically, arms lengthen, shoulders widen."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from scipy.interpolate import PchipInterpolator

from cloner.bodies.carried import joint_shifts
from cloner.bodies.ruler import read
from cloner.easing import smoothstep
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.measurement.measures import TapeRules
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

#: Rounds in which lengths are brought to what was asked, and the gap at which they end, mm (taste).
ROUNDS: Final = 4
CLOSE_MM: Final = 0.3
#: Levels below this share of the stature are feet and stay.
FEET: Final = 0.06
HEIGHTS: Final = ("knee_height", "inside_leg_height", "waist_height", "back_neck_height")
SIDES: Final = ("left", "right")


def stretch_lengths(body: BodyMesh, rules: TapeRules, told_mm: Mapping[str, float]) -> BodyMesh:
    """Return the body with every given length met; the skull's top and the soles are fixed.

    Parameters
    ----------
    body : BodyMesh
        Soles on y = 0.
    rules : TapeRules
    told_mm : mapping of str to float
        Lengths by key.
    """
    vertices, joints = body.vertices_m, body.joints_m
    for _ in range(ROUNDS if told_mm else 0):
        shown = read(vertices, joints, rules, tuple(told_mm)).mm
        gap = {key: (value - shown[key]) / 1e3 for key, value in told_mm.items()}
        if max(abs(each) for each in gap.values()) < CLOSE_MM / 1e3:
            break
        step = _levels(vertices, joints, rules, {key: gap[key] for key in HEIGHTS if key in gap})
        if "shoulder_width" in gap:
            step += _apart(vertices, rules, gap["shoulder_width"] / 2.0)
        if "arm_length" in gap:
            step += _longer(joints, vertices, gap["arm_length"])
        vertices, joints = vertices + step, joints + joint_shifts(step)
    return BodyMesh(vertices, joints)


def _share(generic: GenericHuman, *names: str) -> Array:
    return np.asarray(np.clip(generic.share(*names), 0.0, 1.0))


def _levels(vertices: Array, joints: Array, rules: TapeRules, gap_m: Mapping[str, float]) -> Array:
    """Return vertical displacements (V, 3): the given ones at their heights, zero at feet and head."""
    generic, step = load_generic(), np.zeros_like(vertices)
    if not gap_m:
        return step
    places = {
        "knee_height": vertices[[rules.points["kneecap_left"], rules.points["kneecap_right"]], 1].mean(),
        "inside_leg_height": vertices[rules.crotch, 1],
        "waist_height": vertices[list(rules.level_vertices["natural_waist"]), 1].mean(),
        "back_neck_height": vertices[rules.points["nape"], 1],
    }
    top = float(vertices[generic.feature("head_top"), 1])
    knots = [(0.0, 0.0), (FEET * top, 0.0), *((float(places[key]), gap_m[key]) for key in HEIGHTS if key in gap_m)]
    end = float(places["back_neck_height"])
    if "back_neck_height" not in gap_m:
        knots.append((end, 0.0))
    knots += [(top, knots[-1][1]), (top + 1.0, knots[-1][1])]
    rise = PchipInterpolator(*np.array(knots).T, extrapolate=True)
    own = rise(np.maximum(vertices[:, 1], 0.0))
    for side in SIDES:
        arm = _share(generic, *(f"{side}_{part}" for part in ("upper_arm", "forearm", "hand")))
        own = (1.0 - arm) * own + arm * float(rise(joints[generic.joint(f"{side[0]}_shoulder"), 1]))
    step[:, 1] = (1.0 - generic.head_blend.astype(np.float64)) * own
    nape = rules.points["nape"]
    if "back_neck_height" in gap_m and abs(step[nape, 1]) > 1e-9:  # the nape stands where the head begins to blend
        fade = 1.0 - generic.head_blend.astype(np.float64)[nape]
        step[:, 1] = np.minimum(1.0, (1.0 - generic.head_blend.astype(np.float64)) / max(fade, 0.2)) * own
    return step


def _apart(vertices: Array, rules: TapeRules, by_m: float) -> Array:
    """Return displacements (V, 3) of shoulders and arms outward by ``by_m``, the trunk between in proportion."""
    generic, step = load_generic(), np.zeros_like(vertices)
    tip = vertices[rules.points["acromion_left"]]
    low = float(vertices[list(rules.level_vertices["underbust"]), 1].mean())
    high = smoothstep(vertices[:, 1], low, tip[1])
    arms = _share(generic, *(f"{side}_{part}" for side in SIDES for part in ("upper_arm", "forearm", "hand")))
    wide = np.clip(vertices[:, 0] / float(tip[0]), -1.0, 1.0)
    ours = (1.0 - generic.head_blend.astype(np.float64)) * high * wide
    step[:, 0] = by_m * ((1.0 - arms) * ours + arms * np.sign(vertices[:, 0]))
    return step


def _longer(joints: Array, vertices: Array, by_m: float) -> Array:
    """Return displacements (V, 3) of arms along their bones, in proportion to the bones' lengths; hands follow."""
    generic, step = load_generic(), np.zeros_like(vertices)
    for side in SIDES:
        chain = joints[[generic.joint(f"{side[0]}_{name}") for name in ("shoulder", "elbow", "wrist")]]
        bones = np.diff(chain, axis=0)
        grow = by_m * bones / np.linalg.norm(bones, axis=1).sum()
        upper, fore, hand = (_share(generic, f"{side}_{part}") for part in ("upper_arm", "forearm", "hand"))
        along = [
            np.clip((vertices - chain[k]) @ bones[k] / float(bones[k] @ bones[k]), 0.0, 1.0)[:, None] for k in (0, 1)
        ]
        step += upper[:, None] * along[0] * grow[0]
        step += fore[:, None] * (along[0].clip(1.0) * grow[0] + along[1] * grow[1])
        step += hand[:, None] * grow.sum(axis=0)
    return step
