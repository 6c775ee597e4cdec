"""All measures of a mesh at once, with further slices that separate bodies from clothes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.measurement.lengths import lengths_mm
from cloner.geometry.measurement.measures import UP, Plane, TapeRules, girth_planes, mean_girth_mm
from cloner.records.arrays import Array
from cloner.records.measures import MEASURE_KEYS, MEASURES, Cover

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
#: What a skirt or a coat around the legs hides.
LOOSE_KEYS: Final = frozenset(
    (
        *("thigh_girth", "knee_girth", "hip_girth", "hip_height", "inside_leg_height", "total_crotch_length"),
        *(key for key in SLICE_KEYS if key.startswith(("thigh", "trunk_slice_85"))),
    )
)
#: Never called bare: a collar reaches the tape at the nape though the throat above it is bare. Measured on painted
#: people: the clone's neck is 1.5, 7 and 14 percent too thick in tight, regular and loose shirts.
COLLARED: Final = frozenset(("neck_girth",))
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
    planes = girth_planes(vertices_m, joints_m, rules)
    found = {key: mean_girth_mm(vertices_m, own) for key, own in planes.items()}
    levels = {name: float(planes[f"{name}_girth"][0].point_m[1]) for name in ("bust", "waist", "hip")}
    found |= lengths_mm(vertices_m, joints_m, rules, levels, floor_m)
    found |= {key: mean_girth_mm(vertices_m, own) for key, own in slice_planes(vertices_m, joints_m, rules).items()}
    return {key: found[key] for key in ALL_KEYS}


def _axes(joints_m: Array, pairs: NDArray[np.int32]) -> Array:
    return np.asarray(joints_m[pairs[:, 1]] - joints_m[pairs[:, 0]])


def slice_planes(vertices_m: Array, joints_m: Array, rules: TapeRules) -> dict[str, tuple[Plane, ...]]:
    """Return the planes of `SLICES` on a body in rest pose; limbs have two."""
    crotch, armpit = (float(vertices_m[rules.points[name], 1]) for name in ("crotch", "armpit_left"))
    heights = [armpit + place * (crotch - armpit) for place in TRUNK_SLICES]
    planes: list[tuple[Plane, ...]] = [
        (Plane(np.array([0.0, height, 0.0]), UP, rules.torso, ("torso", "pelvis")),) for height in heights
    ]
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
            both = zip(("left", "right"), triangles, joints, axes, strict=True)
            planes.append(tuple(Plane(joints_m[pair[0]] + place * axis, axis, own, (f"{side}_{limb}",))
                                for side, own, pair, axis in both))  # fmt: skip
    return dict(zip(SLICE_KEYS, planes, strict=True))


def bare_rows(covers: Mapping[str, Cover]) -> NDArray[np.bool_]:
    """Return which measures (K,) of `ALL_KEYS` lie on skin that photos show bare, on both sides.

    Parameters
    ----------
    covers : mapping of str to Cover
        By segment; what is missing counts as covered.
    """
    places = (*((kind.segment, kind.place) for kind in MEASURES), *SLICES)
    bare = [_is_bare(covers, segment, place) for segment, place in places]
    return np.array([is_bare and key not in COLLARED for key, is_bare in zip(ALL_KEYS, bare, strict=True)])


def _is_bare(covers: Mapping[str, Cover], segment: str, place: float) -> bool:
    names = [name for name in (segment, f"left_{segment}", f"right_{segment}") if name in covers]
    return bool(names) and all(covers[name].at(place) is False for name in names)
