"""Where the tape lies on the generic human's topology."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.girth_prior import load_girth_prior
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.measures import Girth, TapeRules
from cloner.geometry.under_clothes import girths_under_clothes

#: Body vertices (their mirror twins are added) whose mean height is the level. Chosen where both sample
#: visitors' ruler loops pass: there they meet the true girths within 2.3 mm on the true bodies.
_LEVELS: Final = {"neck": (791, 857), "chest": (8441,), "underbust": (10749,), "waist": (10780,)}
_LEFT_THIGH: Final = (11073, 11105, 11064)


@functools.cache
def load_tape_rules() -> TapeRules:
    """Return the tape rules of the shipped generic human."""
    return tape_rules(load_generic())


def body_girths(shown_mm: Mapping[str, float], stature_m: float) -> dict[str, Girth]:
    """Return the girths of the body under the clothes of a photographed person, with one standard deviation each.

    Parameters
    ----------
    shown_mm : mapping of str to float
        :func:`girths_mm` of the clone's skin, which has the outline of the clothes.
    stature_m : float
    """
    return girths_under_clothes(shown_mm, stature_m, load_girth_prior())


def tape_rules(generic: GenericHuman) -> TapeRules:
    """Return the tape rules of a generic human; only its skin counts, not eyes and teeth."""
    triangles, _ = generic.triangles()
    skin = triangles[(generic.vertex_part[triangles] == generic.part_names.index("body")).all(axis=1)]

    def touching(*names: str) -> NDArray[np.bool_]:
        wanted = [generic.segment_names.index(name) for name in names]
        return np.asarray(np.isin(generic.vertex_segment[skin], wanted).any(axis=1))

    arms = touching(*(name for name in generic.segment_names if "arm" in name or "hand" in name))
    joints = {
        pair: np.array([[generic.joint(f"{side}_{name}") for name in pair] for side in "lr"])
        for pair in (("shoulder", "elbow"), ("knee", "ankle"))
    }
    right_thigh = tuple(int(generic.mirror[vertex]) for vertex in _LEFT_THIGH)
    return TapeRules(
        torso=skin[~arms],
        left_leg=skin[touching("left_thigh", "left_calf")],
        right_leg=skin[touching("right_thigh", "right_calf")],
        left_arm=skin[touching("left_upper_arm")],
        right_arm=skin[touching("right_upper_arm")],
        level_vertices={
            name: tuple({*rows, *(int(generic.mirror[row]) for row in rows)}) for name, rows in _LEVELS.items()
        },
        thigh_vertices=(_LEFT_THIGH, right_thigh),
        crotch=generic.feature("crotch"),
        arm_joints=joints["shoulder", "elbow"],
        leg_joints=joints["knee", "ankle"],
    )
