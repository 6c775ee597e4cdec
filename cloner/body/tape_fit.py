"""A body no slimmer than tape measures that an operator took (last step of the fine stage).

Beyond the paper. Where the outline shows more than the tape it shows cloth, and
stays. Where the mesh shows less, its slices grow: first their corners, which neither
the front nor the side photo sees, then their depth, then all of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import TapeRules, girth_planes
from cloner.geometry.measurement.stretching import CLOSE_MM, Loop, grow_to_tapes, stretch_fields, zone_width_m
from cloner.records.bodies import BodyMesh

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.tape_fit")


MOST_WITH_SIDE: Final = _CALIBRATED.triple("most_with_side", "factor")
MOST_WITHOUT_SIDE: Final = _CALIBRATED.triple("most_without_side", "factor")
#: A slice's level may move as it grows (the widest hip); then it is found again.
ROUNDS: Final = 3
FRONTAL: Final = np.array([0.0, 0.0, 1.0])


def fit_tape_measures(body: BodyMesh, tape_mm: Mapping[str, float], *, side_seen: bool) -> BodyMesh:
    """Return the body with every taped girth at least as long as the tape measure; lengths are unchanged.

    Parameters
    ----------
    body : BodyMesh
        Rest pose, naked soles on y = 0.
    tape_mm : mapping of str to float
        By key of the measures' table.
    side_seen : bool
        Whether a side photo showed the depths.
    """
    generic, rules = load_generic(), load_tape_rules()
    vertices = body.vertices_m
    for kind, most in enumerate(MOST_WITH_SIDE if side_seen else MOST_WITHOUT_SIDE):
        for _ in range(ROUNDS):
            loops = _loops(generic, rules, BodyMesh(vertices, body.joints_m), tape_mm)
            if all(loop.girth_mm(vertices) > loop.wanted_mm - CLOSE_MM for loop in loops):
                return BodyMesh(vertices, body.joints_m)
            own = [stretch_fields(vertices, loop, FRONTAL)[kind] for loop in loops]
            vertices = vertices + grow_to_tapes(vertices, loops, own, most / ROUNDS)
    return BodyMesh(vertices, body.joints_m)


def _loops(generic: GenericHuman, rules: TapeRules, body: BodyMesh, tape_mm: Mapping[str, float]) -> list[Loop]:
    """Return the loops of the taped girths, on both sides for limbs."""
    own = girth_planes(body.vertices_m, body.joints_m, rules) if tape_mm else {}
    planes = [(plane, float(tape_mm[key])) for key, both in own.items() if key in tape_mm for plane in both]
    loops = []
    for plane, wanted in planes:
        axis = plane.normal / np.linalg.norm(plane.normal)
        away = [
            float((other.point_m - plane.point_m) @ axis)
            for other, _ in planes
            if other is not plane and other.segments[0] == plane.segments[0]
        ]
        weight = np.where(generic.skin, np.clip(generic.share(*plane.segments), 0.0, 1.0), 0.0)
        loops.append(Loop(plane.point_m, plane.normal, plane.triangles, weight, wanted, zone_width_m(away)))
    return loops
