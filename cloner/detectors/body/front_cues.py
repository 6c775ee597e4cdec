"""Levels along the body that pose and contour of a front or back photo suggest, for one side.

A level is a height over the lowest outline in figure heights: 0 at the soles, 1 at the top. Names that begin
with ``net_`` come from the pose net, with ``cue_`` from the contour.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.body.side_contours import SideContour, arm_strip
from cloner.detectors.nets import pose_rows as net
from cloner.records.arrays import Array
from cloner.vision.segmentation.outline_walk import SMOOTH, SoftMask, Strip, extreme, gap_top, smoothed

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.front_cues")


GAP: Final = _CALIBRATED.number("gap", "figure")
NECK_WIDER: Final = _CALIBRATED.number("neck_wider", "factor")
_WRIST_WINDOW: Final = _CALIBRATED.pair("wrist_window", "factor")


def level_of(figure: SoftMask, row: float) -> float:
    """Return the level of a picture row."""
    return float((figure.bottom_px[1] - row) / figure.height_px)


def row_of(figure: SoftMask, level: float) -> float:
    """Return the picture row of a level."""
    return float(figure.bottom_px[1] - level * figure.height_px)


def front_cues(figure: SoftMask, pose_px: Array, contour: SideContour) -> dict[str, float]:
    """Return levels by name, without those that cannot be seen."""
    side, other = contour.side, 1 - contour.side
    rows = {
        "net_ears": pose_px[list(net.EARS), 1].mean(),
        "net_shoulder": pose_px[net.SHOULDERS[side], 1],
        "net_other_shoulder": pose_px[net.SHOULDERS[other], 1],
        "net_hip": pose_px[net.HIPS[side], 1],
        "net_other_hip": pose_px[net.HIPS[other], 1],
        "net_knee": pose_px[net.KNEES[side], 1],
        "net_other_knee": pose_px[net.KNEES[other], 1],
        "net_ankle": pose_px[net.ANKLES[side], 1],
        "net_other_ankle": pose_px[net.ANKLES[other], 1],
        "net_heel": pose_px[net.HEELS[side], 1],
        "net_toe": pose_px[net.TOES[side], 1],
    }
    found = {name: float(row) for name, row in rows.items()}
    places = _gaps(figure, contour) | _trunk(figure, pose_px, contour) | _leg(figure, pose_px, contour)
    found |= {name: float(contour.rows[0] + place) for name, place in places.items() if place is not None}
    found["cue_sole"] = sole_row(figure, contour, float(pose_px[net.ANKLES[side], 1]))
    return {name: level_of(figure, row) for name, row in found.items()}


def _gaps(figure: SoftMask, contour: SideContour) -> dict[str, float | None]:
    """Return the entries at which the gaps below armpit and crotch open."""
    least = GAP * figure.height_px
    legs = np.where(np.isfinite(contour.strip.centres_px[:, 0]), contour.leg_gap, 0.0)
    return {
        "cue_armpit": gap_top(np.nan_to_num(contour.arm_gap), least),
        "cue_crotch": gap_top(legs, least),
    }


def _trunk(figure: SoftMask, pose_px: Array, contour: SideContour) -> dict[str, float | None]:
    """Return the entries of neck, waist and hip at the extremes of the half width."""
    blur = SMOOTH * figure.height_px
    half = smoothed(np.where(contour.arm_outline, np.nan, contour.half_width), blur)
    bare = np.where(contour.veiled, np.nan, half)
    shoulders, hips, knees = (
        contour.place(float(pose_px[list(pair), 1].mean())) for pair in (net.SHOULDERS, net.HIPS, net.KNEES)
    )
    narrow = extreme(bare, 0.1 * shoulders, 1.05 * shoulders, largest=False)
    found: dict[str, float | None] = {"cue_neck": narrow, "cue_neck_base": None}
    if narrow is not None:
        below = bare[round(narrow) : round(shoulders) + 1]
        wide = np.flatnonzero(below > NECK_WIDER * below[0])
        found["cue_neck_base"] = float(round(narrow) + wide[0]) if len(wide) else None
    trunk = hips - shoulders
    found["cue_waist"] = extreme(half, shoulders + 0.35 * trunk, hips, largest=False)
    start = found["cue_waist"] or shoulders + 0.7 * trunk
    found["cue_hip"] = extreme(half, start, hips + 0.6 * (knees - hips), largest=True)
    return found


def _leg(figure: SoftMask, pose_px: Array, contour: SideContour) -> dict[str, float | None]:
    """Return the entries of the leg's narrowest and widest places."""
    width = smoothed(np.where(contour.leg_gap > 0.0, contour.strip.width, np.nan), SMOOTH * figure.height_px)
    hip, knee, ankle = (
        contour.place(float(pose_px[pair[contour.side], 1])) for pair in (net.HIPS, net.KNEES, net.ANKLES)
    )
    shank = ankle - knee
    return {
        "cue_knee": extreme(width, knee - 0.3 * (knee - hip), knee + 0.35 * shank, largest=False),
        "cue_calf": extreme(width, knee, ankle - 0.3 * shank, largest=True),
        "cue_ankle": extreme(width, knee + 0.5 * shank, ankle + 0.25 * shank, largest=False),
        "cue_foot": extreme(width, ankle - 0.1 * shank, float(len(width) - 1), largest=True),
    }


def sole_row(figure: SoftMask, contour: SideContour, ankle_row: float) -> float:
    """Return the picture row of the lowest outline under one ankle."""
    start = round(contour.place(ankle_row))
    inside = np.isfinite(contour.strip.far[max(start, 0) :])
    below = np.flatnonzero(~inside)
    last = (below[0] - 1) if len(below) else len(inside) - 1
    return float(contour.rows[0] + max(start, 0) + max(last, 0)) if len(inside) else float(figure.bottom_px[1])


def arm_cues(figure: SoftMask, pose_px: Array, side: int) -> tuple[dict[str, float], Strip, Array]:
    """Return places along one arm as shares of its length, its strip, and the share (T,) at every entry."""
    strip, along = arm_strip(figure, pose_px, side)
    shoulder, elbow, wrist = (pose_px[pair[side]] for pair in (net.SHOULDERS, net.ELBOWS, net.WRISTS))
    upper, fore = float(np.linalg.norm(elbow - shoulder)), float(np.linalg.norm(wrist - elbow))
    share = along / max(upper + fore, 1e-6)
    width = smoothed(strip.width, SMOOTH * figure.height_px)
    entries = len(share) / max(float(share[-1]), 1e-6)
    place = extreme(width, *(entries * at for at in _WRIST_WINDOW), largest=False)
    found = {"net_elbow": upper / max(upper + fore, 1e-6), "net_length": (upper + fore) / figure.height_px}
    if place is not None:
        found["cue_wrist"] = float(np.interp(place, np.arange(len(share)), share))
    return found, strip, share
