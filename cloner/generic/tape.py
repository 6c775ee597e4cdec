"""Tape rules on the generic human's topology."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.measure_prior import load_measure_prior
from cloner.geometry.measurement.lengths import FINGER
from cloner.geometry.measurement.measures import TRUTH_GIRTHS, Measure, TapeRules
from cloner.geometry.measurement.measuring import ALL_KEYS
from cloner.geometry.measurement.under_clothes import OutlineMeasures, estimate_body

#: Body vertices (their mirror twins are added) whose mean height is the level. Chosen where both sample
#: visitors' ruler loops pass: there they meet the true girths within 2.3 mm on the true bodies.
#: The natural waist is halfway between the lowest rib (2nd lumbar vertebra) and the hip bone (4th): at the 3rd.
_LEVELS: Final = {
    "neck": (791, 857),
    "chest": (8441,),
    "underbust": (10749,),
    "waist": (10780,),
    "natural_waist": (4060, 4106),
}
_LEFT_THIGH: Final = (11073, 11105, 11064)
#: Tip of the seventh neck vertebra under the skin: 0.86 of the stature (H-Anim's site cervicale: 0.87).
_NAPE: Final = 857
#: Middle of the natural waist, front and back.
_WAIST: Final = (4106, 4060)


@functools.cache
def load_tape_rules() -> TapeRules:
    """Return the tape rules of the shipped generic human."""
    return tape_rules(load_generic())


def body_girths(shown_mm: Mapping[str, float], stature_m: float) -> dict[str, Measure]:
    """Return the girths of the body under the clothes of a photographed person, by the truth's names.

    Parameters
    ----------
    shown_mm : mapping of str to float
        :func:`girths_mm` of the clone's skin, or more of what :func:`measures_mm` gives; what is missing is unknown.
    stature_m : float
    """
    keyed = {TRUTH_GIRTHS.get(name, name): value for name, value in shown_mm.items()}
    shown = np.array([keyed.get(key, np.nan) for key in ALL_KEYS])
    prior = load_measure_prior()
    found = estimate_body(OutlineMeasures(shown, stature_m, np.zeros(len(ALL_KEYS), dtype=bool)), prior)
    rows = {name: ALL_KEYS.index(key) for name, key in TRUTH_GIRTHS.items()}
    half = prior.spread * found.deviation_mm
    return {name: Measure(float(found.mm[row]), float(half[row])) for name, row in rows.items()}


def tape_rules(generic: GenericHuman) -> TapeRules:
    """Return the tape rules of a generic human; only its skin counts, not eyes and teeth."""
    triangles, _ = generic.triangles()
    skin = np.asarray(triangles[generic.skin[triangles].all(axis=1)], np.int32)

    def touching(*names: str) -> NDArray[np.bool_]:
        return np.asarray(generic.segment(*names)[skin].any(axis=1))

    arms = touching(*(name for name in generic.segment_names if "arm" in name or "hand" in name))
    right_thigh = tuple(int(generic.mirror[vertex]) for vertex in _LEFT_THIGH)
    return TapeRules(
        skin=skin,
        torso=skin[~arms],
        left_leg=skin[touching("left_thigh", "left_calf", "left_foot")],
        right_leg=skin[touching("right_thigh", "right_calf", "right_foot")],
        left_arm=skin[touching("left_upper_arm")],
        right_arm=skin[touching("right_upper_arm")],
        left_forearm=skin[touching("left_forearm")],
        right_forearm=skin[touching("right_forearm")],
        head=skin[touching("head")],
        left_foot=_members(generic, "left_foot"),
        right_foot=_members(generic, "right_foot"),
        skull=_skull(generic),
        level_vertices={
            name: tuple({*rows, *(int(generic.mirror[row]) for row in rows)}) for name, rows in _LEVELS.items()
        },
        thigh_vertices=(_LEFT_THIGH, right_thigh),
        points=_points(generic),
        crotch=generic.feature("crotch"),
        arm_joints=_joints(generic, "shoulder", "elbow"),
        forearm_joints=_joints(generic, "elbow", "wrist"),
        thigh_joints=_joints(generic, "hip", "knee"),
        leg_joints=_joints(generic, "knee", "ankle"),
        finger_joints=_joints(generic, *FINGER),
    )


def _joints(generic: GenericHuman, *names: str) -> NDArray[np.int32]:
    """Return the rows of joints on both sides, (2, N)."""
    return np.array([[generic.joint(f"{side}_{name}") for name in names] for side in "lr"], dtype=np.int32)


def _members(generic: GenericHuman, segment: str) -> NDArray[np.int32]:
    return np.flatnonzero(generic.segment(segment) & generic.skin).astype(np.int32)


def _skull(generic: GenericHuman) -> NDArray[np.int32]:
    """Return the head's vertices without ears and face's lower half: where a tape and calipers touch the skull."""
    rows = _members(generic, "head")
    ears = generic.region("ear_left") | generic.region("ear_right")
    high = generic.vertices_m[rows, 1] > generic.vertices_m[generic.feature("ear_lobe_L"), 1]
    return np.asarray(rows[high & ~ears[rows]])


def _points(generic: GenericHuman) -> dict[str, int]:
    """Return the vertices between which lengths are measured."""
    named = {
        "glabella": "glabella", "nasion": "nasion", "chin": "chin_bottom", "crotch": "crotch",
        "ear_left": "ear_top_L", "ear_right": "ear_top_R",
    }  # fmt: skip
    for side in ("left", "right"):
        own = {"acromion": "shoulder_end", "kneecap": "knee_front", "wrist": "wrist_outer"}
        own |= {name: name for name in ("heel", "toe", "fingertip", "ankle_outer", "ankle_inner", "armpit")}
        named |= {f"{ours}_{side}": f"{feature}_{side}" for ours, feature in own.items()}
    elbow = _olecranon(generic)
    fixed = {"nape": _NAPE, "waist_front": _WAIST[0], "waist_back": _WAIST[1], "elbow_left": elbow}
    fixed["elbow_right"] = int(generic.mirror[elbow])
    return {ours: generic.feature(feature) for ours, feature in named.items()} | fixed


def _olecranon(generic: GenericHuman) -> int:
    """Return the left elbow's tip: the vertex that stands out farthest where the arm bends."""
    shoulder, elbow, wrist = (generic.joints_m[generic.joint(f"l_{name}")] for name in ("shoulder", "elbow", "wrist"))
    outward = 2.0 * elbow - shoulder - wrist
    near = np.flatnonzero(np.linalg.norm(generic.vertices_m - elbow, axis=1) < 0.07)
    return int(near[np.argmax((generic.vertices_m[near] - elbow) @ outward)])
