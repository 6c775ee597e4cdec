"""The contour of a side photo before and behind the body's axis, and the levels that it suggests."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.body.front_cues import level_of
from cloner.detectors.body.side_contours import ARM_HALF, REACH, SLACK, arm_polyline, polyline_columns
from cloner.detectors.nets import pose_rows as net
from cloner.records.arrays import Array
from cloner.vision.segmentation.outline_walk import SMOOTH, SoftMask, Strip, extreme, sample, smoothed, walk_strip

Bools = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class BodyProfile:
    """A person seen from the side, one entry per picture row.

    Attributes
    ----------
    near : int
        The side that is seen, 0 the person's left, 1 the right.
    forwards : float
        1 where the person looks towards the image's right, else -1.
    rows : (T,) float64
        Picture rows from the ears to the lowest row of the person.
    strip : Strip
        Across the axis ear, shoulder, hip, knee, ankle; ``far`` is the front border, ``near`` the back one.
    front, back : (T,) float64
        Borders relative to the straight line from shoulders to ankle, forwards positive, px.
    front_arm, back_arm : (T,) bool
        Whether the border may be the arm's or the hand's.
    back_veiled : (T,) bool
        Whether hair makes the back border.
    """

    near: int
    forwards: float
    rows: Array
    strip: Strip
    front: Array
    back: Array
    front_arm: Bools
    back_arm: Bools
    back_veiled: Bools

    def place(self, row: float) -> float:
        """Return the entry of a picture row."""
        return float(row - self.rows[0])


def body_axis(pose_px: Array, near: int) -> Array:
    """Return (5, 2) ear, shoulders, hips, knee and ankle of a side photo, px."""
    middles = [pose_px[list(pair)].mean(axis=0) for pair in (net.EARS, net.SHOULDERS, net.HIPS)]
    return np.array([*middles, pose_px[net.KNEES[near]], pose_px[net.ANKLES[near]]])


def find_body_profile(figure: SoftMask, pose_px: Array, near: int, forwards: float, hair: Bools) -> BodyProfile:
    """Return the contour before and behind the body.

    Parameters
    ----------
    figure : Figure
    pose_px : (33, 2) float64
    near : int
    forwards : float
    hair : (H, W) bool
    """
    axis = body_axis(pose_px, near)
    rows = np.arange(np.floor(axis[0, 1]), np.ceil(figure.bottom_px[1]) + 1.0)
    centres = np.stack([polyline_columns(rows, axis), rows], axis=1)
    across = np.tile([forwards, 0.0], (len(rows), 1))
    strip = walk_strip(figure, centres, across, REACH * figure.height_px, slack_px=SLACK * figure.height_px)
    straight = axis[[1, 4]]
    slope = (straight[1, 0] - straight[0, 0]) / max(straight[1, 1] - straight[0, 1], 1.0)
    line = straight[0, 0] + slope * (rows - straight[0, 1])
    columns = [centres[:, 0] + forwards * border for border in (strip.far, strip.near)]
    arm = arm_polyline(pose_px, near)
    beside = (rows >= arm[1:3, 1].min()) & (rows <= arm[:, 1].max())
    arm_column = np.where(beside, polyline_columns(rows, arm), np.inf)
    close = [np.abs(column - arm_column) < 0.8 * ARM_HALF * figure.height_px for column in columns]
    within = np.stack([columns[1] + forwards * 0.005 * figure.height_px, rows], axis=1)
    veiled = sample(hair.astype(np.float32), np.nan_to_num(within)) > 0.5
    front, back = ((column - line) * forwards for column in columns)
    return BodyProfile(near, forwards, rows, strip, front, back, close[0], close[1], veiled)


def side_cues(figure: SoftMask, pose_px: Array, profile: BodyProfile) -> dict[str, float]:
    """Return levels by name; what cannot be seen is absent (names as in ``front_cues``)."""
    near = profile.near
    rows = {
        "net_ears": pose_px[list(net.EARS), 1].mean(),
        "net_mouth": pose_px[list(net.MOUTH), 1].mean(),
        "net_shoulder": pose_px[list(net.SHOULDERS), 1].mean(),
        "net_hip": pose_px[list(net.HIPS), 1].mean(),
        "net_knee": pose_px[net.KNEES[near], 1],
        "net_ankle": pose_px[net.ANKLES[near], 1],
        "net_heel": pose_px[net.HEELS[near], 1],
        "net_toe": pose_px[net.TOES[near], 1],
    }
    found = {name: float(row) for name, row in rows.items()}
    places = _upper(figure, pose_px, profile) | _lower(figure, pose_px, profile)
    found |= {name: float(profile.rows[0] + place) for name, place in places.items() if place is not None}
    return {name: level_of(figure, row) for name, row in found.items()}


def _borders(figure: SoftMask, profile: BodyProfile) -> tuple[Array, Array]:
    """Return the front and the back contour, smoothed, NaN where the arm may make them."""
    blur = SMOOTH * figure.height_px
    front = smoothed(np.where(profile.front_arm, np.nan, profile.front), blur)
    return front, smoothed(np.where(profile.back_arm, np.nan, profile.back), blur)


def _upper(figure: SoftMask, pose_px: Array, profile: BodyProfile) -> dict[str, float | None]:
    """Return the entries of neck and trunk at the extremes of the contours."""
    front, back = _borders(figure, profile)
    bare = np.where(profile.back_veiled, np.nan, back)
    mouth, shoulders, hips = (
        profile.place(float(pose_px[list(pair), 1].mean())) for pair in (net.MOUTH, net.SHOULDERS, net.HIPS)
    )
    knee = profile.place(float(pose_px[net.KNEES[profile.near], 1]))
    trunk, thigh = hips - shoulders, knee - hips
    lumbar = extreme(back, shoulders + 0.3 * trunk, hips, largest=True)
    waist = lumbar if lumbar is not None else shoulders + 0.65 * trunk
    return {
        "cue_throat": extreme(front, mouth, shoulders + 0.1 * trunk, largest=False),
        "cue_nape": extreme(bare, 0.0, shoulders, largest=True),
        "cue_chest": extreme(front, shoulders, shoulders + 0.6 * trunk, largest=True),
        "cue_belly": extreme(front, shoulders + 0.5 * trunk, hips + 0.3 * thigh, largest=True),
        "cue_back": extreme(back, shoulders - 0.1 * trunk, waist, largest=False),
        "cue_lumbar": lumbar,
        "cue_buttock": extreme(back, waist, hips + 0.5 * thigh, largest=False),
        "cue_groin": extreme(front, hips - 0.1 * trunk, hips + 0.5 * thigh, largest=False),
    }


def _lower(figure: SoftMask, pose_px: Array, profile: BodyProfile) -> dict[str, float | None]:
    """Return the entries of knee, calf, ankle and foot at the extremes of the contours."""
    front, back = _borders(figure, profile)
    hips = profile.place(float(pose_px[list(net.HIPS), 1].mean()))
    knee, ankle = (profile.place(float(pose_px[pair[profile.near], 1])) for pair in (net.KNEES, net.ANKLES))
    thigh, shank, end = knee - hips, ankle - knee, float(len(profile.rows) - 1)
    hollow = extreme(back, knee - 0.45 * thigh, knee + 0.3 * shank, largest=True)
    toe, heel = foot_ends(figure, profile)
    return {
        "cue_knee_front": extreme(front, knee - 0.35 * thigh, knee + 0.25 * shank, largest=True),
        "cue_knee_back": hollow,
        "cue_calf": extreme(back, hollow if hollow is not None else knee, ankle - 0.3 * shank, largest=False),
        "cue_ankle_back": extreme(back, knee + 0.55 * shank, ankle + 0.3 * shank, largest=True),
        "cue_ankle_front": extreme(front, knee + 0.5 * shank, end, largest=False),
        "cue_toe": None if toe is None else profile.place(float(toe[1])),
        "cue_heel": None if heel is None else profile.place(float(heel[1])),
    }


def foot_ends(figure: SoftMask, profile: BodyProfile) -> tuple[Array | None, Array | None]:
    """Return the foremost and rearmost contour point (2,) of the near foot, which is the lowest."""
    low = profile.rows > figure.bottom_px[1] - 0.035 * figure.height_px
    ends: list[Array | None] = []
    for border, sign in ((profile.strip.far, 1.0), (profile.strip.near, -1.0)):
        column = profile.strip.centres_px[:, 0] * profile.forwards + border
        reach = np.where(low & np.isfinite(column), sign * column, -np.inf)
        at = int(reach.argmax())
        ends.append(profile.strip.border_px(float(at), far=sign > 0) if np.isfinite(reach[at]) else None)
    return ends[0], ends[1]
