"""A body with given measures: the family first, then lengths, then local girth fields."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

import numpy as np

from cloner.bodies.family import round_body, usual_body
from cloner.bodies.fitting import fit_measures
from cloner.bodies.lengths import stretch_lengths
from cloner.bodies.regions import meet_girths
from cloner.bodies.ruler import read
from cloner.bodies.telling import GIRTHS, LENGTHS, BodySpecification, refused, untold_mm
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import TapeRules
from cloner.geometry.outlines.settling import without_folds
from cloner.records.bodies import BodyMesh

#: What is given to nobody: farther than this from what was told, mm.
FAR_MM: Final = 5.0
ROUNDS: Final = 2
#: Untold measures lie within so many spreads of what is likeliest beside the told ones (2 are wanted), if told measures
#: stay this near: ankles of men lay up to 4 spreads off, since the family's men have thin ones. Limbs alone where the
#: trunk's would contradict what was told.
WITHIN: Final = 1.9
KEPT_MM: Final = 0.9  # told girths; lengths twice as far
LIMBS: Final = (
    "neck_girth", "thigh_girth", "knee_girth", "calf_girth", "ankle_girth", "upper_arm_girth", "wrist_girth"
)  # fmt: skip
#: Untold measures that the population tells the family; those the family knows as well follow by themselves.
LIKELY: Final = (
    "neck_girth", "bust_girth", "underbust_girth", "waist_girth", "navel_girth", "hip_girth", "thigh_girth",
    "upper_arm_girth", "wrist_girth", "inside_leg_height", "back_neck_height", "shoulder_width",
)  # fmt: skip


def measured_body(spec: BodySpecification) -> BodyMesh:
    """Return the most likely body with the given measures, soles on y = 0.

    Raises
    ------
    ClonerError
        If a measure cannot be met.
    """
    usual = untold_mm(spec)
    untold = {key: pair for key, pair in usual.items() if key in LIKELY}
    base = usual_body(spec.sex, spec.stature_m, spec.age_years)
    family = round_body(base, spec.stature_m)
    rules = load_tape_rules()
    first = fit_measures(family, rules, spec.mm, untold, seat=spec.seat)
    return _smooth(first, _likely(_meet_or_refuse(first, spec, rules), spec, usual, rules), rules)


def remeasured_body(body: BodyMesh, spec: BodySpecification) -> BodyMesh:
    """Return a body with new measures, changed as little as possible, soles on y = 0.

    Raises
    ------
    ClonerError
        If a measure cannot be met.
    """
    rules = load_tape_rules()
    first = fit_measures(round_body(body, spec.stature_m), rules, spec.mm, {}, seat=spec.seat)
    return _smooth(first, _meet_or_refuse(first, spec, rules), rules)


def _smooth(first: BodyMesh, body: BodyMesh, rules: TapeRules) -> BodyMesh:
    """Return the body without folds that regions made where they meet: two triangles at the crotch of a man of +3."""
    return replace(body, vertices_m=without_folds(first.vertices_m, body.vertices_m, rules.skin))


def _likely(
    body: BodyMesh, spec: BodySpecification, untold: Mapping[str, tuple[float, float]], rules: TapeRules
) -> BodyMesh:
    """Return the body with unlikely other measures brought closer to likely ones, as far as the given ones stay met."""
    usual = {key: pair for key, pair in untold.items() if key in (*GIRTHS, *LENGTHS)}
    shown = read(body.vertices_m, body.joints_m, rules, tuple(usual), seat=spec.seat).mm
    far = {
        key: mean + float(np.copysign(WITHIN, shown[key] - mean)) * spread
        for key, (mean, spread) in usual.items()
        if abs(shown[key] - mean) > WITHIN * spread
    }
    tried: dict[str, float] = {}
    for keys in ((*GIRTHS, *LENGTHS), GIRTHS, LIMBS):
        asked = {key: value for key, value in far.items() if key in keys}
        if not asked or asked == tried:
            continue
        tried = asked
        found = _meet_measures(body, {**spec.mm, **asked}, spec, rules)
        now = read(found.vertices_m, found.joints_m, rules, tuple(spec.mm), seat=spec.seat).mm
        if all(abs(now[key] - value) < KEPT_MM * (1 if key in GIRTHS else 2) for key, value in spec.mm.items()):
            return found
    return body


def _meet_or_refuse(body: BodyMesh, spec: BodySpecification, rules: TapeRules) -> BodyMesh:
    """Return the body with the given measures met, or refuse the worst of them."""
    body = _meet_measures(body, spec.mm, spec, rules)
    shown = read(body.vertices_m, body.joints_m, rules, tuple(spec.mm), seat=spec.seat).mm
    worst = max(spec.mm, key=lambda key: abs(shown[key] - spec.mm[key]), default="")
    if worst and abs(shown[worst] - spec.mm[worst]) > FAR_MM:
        raise refused(worst, shown[worst] - spec.mm[worst], spec.mm[worst])
    return body


def _meet_measures(body: BodyMesh, mm: Mapping[str, float], spec: BodySpecification, rules: TapeRules) -> BodyMesh:
    """Return the body with lengths and girths met, alternating, as each disturbs the other."""
    lengths = {key: value for key, value in mm.items() if key in LENGTHS}
    girths = {key: value for key, value in mm.items() if key in GIRTHS}
    for _ in range(ROUNDS if lengths else 1):
        body = meet_girths(stretch_lengths(body, rules, lengths), rules, girths, spec.sex, seat=spec.seat)
    return body
