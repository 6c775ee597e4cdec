"""All measures of a mesh at once, with further slices that tell bodies from clothes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.lengths import lengths_mm
from cloner.geometry.measures import UP, TapeRules, girth_mm, girths_mm, hip_level_m
from cloner.records.measures import MEASURE_KEYS

Array = NDArray[np.float64]

#: Names of the girths that the sample visitors' truth has, and the keys of the measures' table.
TRUTH_GIRTHS: Final = {
    "neck": "neck_girth",
    "chest": "bust_girth",
    "underbust": "underbust_girth",
    "waist": "navel_girth",
    "waist_min": "narrowest_waist_girth",
    "hip": "hip_girth",
    "thigh": "thigh_girth",
    "calf": "calf_girth",
    "upper_arm": "upper_arm_girth",
}
#: Slices between the named levels: clothes hide a body's hollows, and the more slices the better that shows.
TRUNK_SLICES: Final = (0.12, 0.25, 0.4, 0.55, 0.7, 0.85)
LIMB_SLICES: Final = {
    "upper_arm": (0.3, 0.7), "forearm": (0.15, 0.45, 0.75), "thigh": (0.4, 0.6, 0.8), "calf": (0.15, 0.55, 0.75)
}  # fmt: skip
#: Segment and place of every further slice, in order; the trunk's count from armpits (0) to crotch (1).
SLICES: Final = (
    *(("trunk", place) for place in TRUNK_SLICES),
    *((limb, place) for limb, places in LIMB_SLICES.items() for place in places),
)
SLICE_KEYS: Final = tuple(f"{segment}_slice_{100 * place:.0f}" for segment, place in SLICES)
#: Everything :func:`measures_mm` gives, in order.
ALL_KEYS: Final = (*MEASURE_KEYS, *SLICE_KEYS)


def measures_mm(vertices_m: Array, joints_m: Array, rules: TapeRules, floor_m: float = 0.0) -> dict[str, float]:
    """Return every measure and slice of a body in rest pose by the names of `ALL_KEYS`, mm.

    Parameters
    ----------
    vertices_m : (V, 3) model frame, metres
    joints_m : (94, 3) model frame, metres
    rules : TapeRules
    floor_m : float
        Height of the naked soles in this frame.
    """
    girths = girths_mm(vertices_m, joints_m, rules)
    found = {key: girths[name] for name, key in TRUTH_GIRTHS.items()}
    levels = {
        name: float(vertices_m[list(rules.level_vertices[row]), 1].mean())
        for name, row in (("bust", "chest"), ("waist", "natural_waist"), ("navel", "waist"))
    } | {"hip": hip_level_m(vertices_m, rules)}
    found["waist_girth"] = _level_mm(vertices_m, rules.torso, levels["waist"])
    found |= _small_girths_mm(vertices_m, joints_m, rules)
    found |= lengths_mm(vertices_m, joints_m, rules, levels, floor_m)
    found |= dict(zip(SLICE_KEYS, _slices_mm(vertices_m, joints_m, rules), strict=True))
    return {key: found[key] for key in ALL_KEYS}


def _level_mm(vertices_m: Array, triangles: NDArray[np.int32], height_m: float) -> float:
    return girth_mm(vertices_m, triangles, np.array([0.0, height_m, 0.0]), UP)


def _small_girths_mm(vertices_m: Array, joints_m: Array, rules: TapeRules) -> dict[str, float]:
    """Return the girths of head, knees, ankles and wrists; a plane crosses a limb at right angles."""
    brow = vertices_m[rules.points["glabella"]]
    skull = vertices_m[rules.skull]
    rear = skull[np.argmin(skull[:, 2])]
    legs, fores = (rules.left_leg, rules.right_leg), (rules.left_forearm, rules.right_forearm)
    knees = [
        _level_mm(vertices_m, leg, float(vertices_m[rules.points[f"kneecap_{side}"], 1]))
        for leg, side in zip(legs, ("left", "right"), strict=True)
    ]
    bones = {
        side: vertices_m[[rules.points[f"ankle_outer_{side}"], rules.points[f"ankle_inner_{side}"]]].mean(axis=0)
        for side in ("left", "right")
    }
    ankles = [
        girth_mm(vertices_m, leg, bones[side], axis)
        for leg, side, axis in zip(legs, ("left", "right"), _axes(joints_m, rules.leg_joints), strict=True)
    ]
    wrists = [
        girth_mm(vertices_m, fore, vertices_m[rules.points[f"wrist_{side}"]], axis)
        for fore, side, axis in zip(fores, ("left", "right"), _axes(joints_m, rules.forearm_joints), strict=True)
    ]
    return {
        "head_girth": girth_mm(vertices_m, rules.head, brow, np.cross([1.0, 0.0, 0.0], rear - brow)),
        "knee_girth": float(np.mean(knees)),
        "ankle_girth": float(np.mean(ankles)),
        "wrist_girth": float(np.mean(wrists)),
    }


def _axes(joints_m: Array, pairs: NDArray[np.int32]) -> Array:
    return np.asarray(joints_m[pairs[:, 1]] - joints_m[pairs[:, 0]])


def _slices_mm(vertices_m: Array, joints_m: Array, rules: TapeRules) -> Iterator[float]:
    """Yield the girths of `SLICES`; limbs are averaged over both sides."""
    crotch, armpit = (float(vertices_m[rules.points[name], 1]) for name in ("crotch", "armpit_left"))
    for place in TRUNK_SLICES:
        yield _level_mm(vertices_m, rules.torso, armpit + place * (crotch - armpit))
    parts = {
        "upper_arm": ((rules.left_arm, rules.right_arm), rules.arm_joints),
        "forearm": ((rules.left_forearm, rules.right_forearm), rules.forearm_joints),
        "thigh": ((rules.left_leg, rules.right_leg), rules.thigh_joints),
        "calf": ((rules.left_leg, rules.right_leg), rules.leg_joints),
    }
    for limb, places in LIMB_SLICES.items():
        triangles, joints = parts[limb]
        axes = _axes(joints_m, joints)
        for place in places:
            both = [
                girth_mm(vertices_m, own, joints_m[pair[0]] + place * axis, axis)
                for own, pair, axis in zip(triangles, joints, axes, strict=True)
            ]
            yield float(np.mean(both))
