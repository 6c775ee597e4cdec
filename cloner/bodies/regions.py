"""Local fields for the girths that the family cannot reach, one per body region."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from cloner.bodies import sections
from cloner.bodies.carried import joint_shifts
from cloner.bodies.ruler import girth_slopes, level_slopes, tapes
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.measurement.measures import Plane, TapeRules, mean_girth_mm, slice_points
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

Planes = Mapping[str, tuple[Plane, ...]]

#: Good enough, mm, rounds, and the farthest that skin goes outward in one, metres.
CLOSE_MM: Final = 0.15
ROUNDS: Final = 10
FARTHEST_M: Final = 0.03
#: Half of what a field reaches to either side of its tape, metres; nearer tapes narrow it.
WIDE_M: Final = {
    "neck_girth": 0.030, "narrowest_waist_girth": 0.10, "waist_girth": 0.10, "navel_girth": 0.10,
    "underbust_girth": 0.06, "thigh_girth": 0.08, "knee_girth": 0.05, "calf_girth": 0.07, "ankle_girth": 0.03,
    "upper_arm_girth": 0.07, "wrist_girth": 0.03,
}  # fmt: skip
NARROWEST_M: Final = 0.015
#: Tapes whose levels end others' fields.
LEVELS: Final = ("underbust_girth", "waist_girth")
#: Skin between the legs stays this far from the middle, metres.
APART_M: Final = 0.0005


def meet_girths(body: BodyMesh, rules: TapeRules, told_mm: Mapping[str, float], sex: str, *, seat: bool) -> BodyMesh:
    """Return the body with every given girth met.

    Parameters
    ----------
    body : BodyMesh
        Soles on y = 0.
    rules : TapeRules
    told_mm : mapping of str to float
        Girths by key.
    sex : str
        Decides where a chest grows.
    seat : bool
        As for :func:`cloner.bodies.ruler.tapes`.
    """
    generic, vertices, joints = load_generic(), body.vertices_m, body.joints_m
    before = vertices
    for _ in range(ROUNDS if told_mm else 0):
        planes = tapes(vertices, joints, rules, (*told_mm, *LEVELS), seat=seat)
        gap = np.array([value - mean_girth_mm(vertices, planes[key]) for key, value in told_mm.items()])
        if float(np.abs(gap).max()) < CLOSE_MM:
            break
        own = np.array([_field(generic, vertices, key, planes, rules, tuple(told_mm), sex) for key in told_mm])
        slopes = np.array([girth_slopes(vertices, own, planes[key], level_slopes(own, rules, key)) for key in told_mm])
        damped = slopes.T @ slopes + 1.0 * np.eye(len(gap))
        share = np.clip(np.linalg.solve(damped, slopes.T @ gap), -FARTHEST_M, FARTHEST_M)
        step = np.tensordot(share, own, axes=1)
        vertices = _apart(generic, before, vertices + step)
        joints = joints + joint_shifts(step)
    return BodyMesh(vertices, joints)


def _field(
    generic: GenericHuman, vertices: Array, key: str, planes: Planes, rules: TapeRules, given: tuple[str, ...], sex: str
) -> Array:
    """Return (V, 3) the field of a girth's region, about a metre outward where it is strongest."""
    own = planes[key]
    if key in ("bust_girth", "underbust_girth", "narrowest_waist_girth", "waist_girth", "navel_girth", "hip_girth"):
        return _trunk_field(generic, vertices, key, planes, rules, given, sex)
    wide = _narrowed(key, planes, given)
    total = np.zeros_like(vertices)
    for plane in own:
        share = generic.share(*plane.segments) * generic.skin
        ring = slice_points(vertices, plane.triangles, plane.point_m, plane.normal)
        middle = (ring.min(axis=0) + ring.max(axis=0)) / 2.0
        total += np.clip(share, 0.0, 1.0)[:, None] * sections.limb(vertices, middle, plane.normal, wide)
    return total * (1.0 - generic.head_blend.astype(np.float64))[:, None]


def _trunk_field(
    generic: GenericHuman, vertices: Array, key: str, planes: Planes, rules: TapeRules, given: tuple[str, ...], sex: str
) -> Array:
    level = float(planes[key][0].point_m[1])
    ring = slice_points(vertices, rules.torso, planes[key][0].point_m, planes[key][0].normal)
    centre = (ring.min(axis=0) + ring.max(axis=0)) / 2.0
    names = ("torso", "pelvis", "left_thigh", "right_thigh") if key == "hip_girth" else ("torso", "pelvis")
    share = np.clip(generic.share(*names), 0.0, 1.0) * generic.skin
    share = share * (1.0 - generic.head_blend.astype(np.float64))
    heights = {name: float(planes[f"{name}_girth"][0].point_m[1]) for name in ("underbust", "waist")}
    if key == "bust_girth":
        top = float(vertices[rules.points["acromion_left"], 1])
        low = heights["underbust"] if "underbust_girth" in given else heights["underbust"] - 0.04
        found = sections.breast(vertices, centre, (low, top), level, sex)
    elif key == "hip_girth":
        low, high = ring.min(axis=0), ring.max(axis=0)
        ends = level - 0.22, max(heights["waist"], level + 0.10)
        box = np.r_[low[0], ends[0], low[2]], np.r_[high[0], ends[1], high[2]]
        found = sections.hips(vertices, box, (level - ends[0]) / (ends[1] - ends[0]))
        found = found * 0.15  # a metre at the lattice's corner is far more than a tape's
    else:
        found = sections.waist(vertices, centre, level, _narrowed(key, planes, given))
    return np.asarray(share[:, None] * found)


def _narrowed(key: str, planes: Planes, given: tuple[str, ...]) -> float:
    """Return half the range of a girth's field: no farther than the next given girth on the same part."""
    own = planes[key][0]
    axis = own.normal / np.linalg.norm(own.normal)
    away = [
        abs(float((planes[other][0].point_m - own.point_m) @ axis))
        for other in given
        if other != key and set(planes[other][0].segments) & set(own.segments)
    ]
    return float(np.clip(min((*away, 2.0 * WIDE_M[key])) / 2.0, NARROWEST_M, WIDE_M[key]))


def _apart(generic: GenericHuman, before: Array, after: Array) -> Array:
    """Return the vertices with each leg on its own side of the middle, as far as it was before."""
    out = after.copy()
    legs = np.array([name.split("_")[-1] in ("thigh", "calf") for name in generic.segment_names])
    own = legs[generic.vertex_segment]
    for sign in (1.0, -1.0):
        side = own & (sign * before[:, 0] > APART_M)
        out[side, 0] = sign * np.maximum(sign * out[side, 0], np.minimum(APART_M, sign * before[side, 0]))
    return out
