"""Consistent bone lengths: a joint that stretches its bone in one photo gets a larger sigma there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.records.points import PhotoState, StateKind, ViewPoints, confidence_of, expected_error

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.bone_checks")

#: Bones by the joints at their ends, from the trunk outwards.
BONES: Final = {
    "upper arm": ("shoulder", "elbow"),
    "forearm": ("elbow", "wrist"),
    "thigh": ("hip", "knee"),
    "shank": ("knee", "ankle"),
}
#: Bones on both sides of a joint that can be moved out of place: the joint itself is then at fault.
SHARED: Final = {"elbow": ("upper arm", "forearm"), "knee": ("thigh", "shank")}
LONGEST: Final = _CALIBRATED.number("longest", "factor")
SHORTEST: Final = _CALIBRATED.number("shortest", "factor")


def check_bones(body: Mapping[ViewId, ViewPoints], height_px: Mapping[ViewId, float]) -> dict[ViewId, ViewPoints]:
    """Return the points with less confidence in joints that contradict the other photos, and with states that say so.

    Parameters
    ----------
    body : view -> points of the body photos
    height_px : view -> height of the figure, px
    """
    lengths = {
        (view, side, bone): length
        for view, points in body.items()
        for side in ("left", "right")
        for bone in BONES
        if (length := _length(points, side, bone, height_px[view])) is not None
    }
    checked = dict(body)
    for view in body:
        for side in ("left", "right"):
            for joint, away in _joints_at_fault(lengths, view, side).items():
                checked[view] = _with_added_error(checked[view], side, joint, away)
    return checked


def _length(points: ViewPoints, side: str, bone: str, height_px: float) -> float | None:
    """Return a bone's length in figure heights, None where a joint is missing."""
    start, end = (points.get(f"{side[0]}_{joint}") for joint in BONES[bone])
    if start is None or end is None or not np.isfinite(height_px):
        return None
    return float(np.linalg.norm(end - start)) / height_px


def _joints_at_fault(lengths: Mapping[tuple[ViewId, str, str], float], view: ViewId, side: str) -> dict[str, float]:
    """Return the inconsistent joints of one photo and their possible error, figure heights."""
    away: dict[str, float] = {}
    for bone in BONES:
        own = lengths.get((view, side, bone))
        others = [value for (at, who, name), value in lengths.items() if name == bone and (at, who) != (view, side)]
        if own is None or len(others) < 2:
            continue
        usual = float(np.median(others))
        if not SHORTEST * usual <= own <= LONGEST * usual:
            away[bone] = abs(own - usual)
    faults: dict[str, float] = {}
    for joint, bones in SHARED.items():
        wrong = [away[bone] for bone in bones if bone in away]
        if len(wrong) == len(bones):
            faults[joint] = max(wrong)
        elif wrong:
            bone = next(bone for bone in bones if bone in away)
            for end in BONES[bone]:
                if end != joint or bone == bones[0]:
                    faults[end] = wrong[0]
    return faults


def _with_added_error(points: ViewPoints, side: str, joint: str, away: float) -> ViewPoints:
    """Return the points with an error added to a joint and to the outline points beside it."""
    confidence, name = points.confidence.copy(), f"{side[0]}_{joint}"
    beside = {f"{joint}_{where}_{side}" for where in ("outer", "inner", "front", "back")}
    for row, own in enumerate(points.names):
        if (own == name or own in beside) and not points.corrected[row]:
            confidence[row] = confidence_of(float(expected_error(confidence[row : row + 1])[0]) + away)
    sentence = f"the {side} {joint} lies where its bones do not reach in the other photos; it counts little"
    state = PhotoState(StateKind.REFUSED, side, sentence)
    return replace(points, confidence=confidence, states=(*points.states, state))
