"""The contour of a front or back photo beside the pose's axes: one side contour each, row by row, and two arms."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.nets import pose_rows as net
from cloner.geometry.meshes.vectors import arc_lengths
from cloner.records.arrays import Array
from cloner.vision.segmentation.outline_walk import SoftMask, Strip, gap_between, polyline, sample, walk_strip

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.side_contours")

Bools = NDArray[np.bool_]

REACH: Final = _CALIBRATED.number("reach", "figure")
SLACK: Final = _CALIBRATED.number("slack", "figure")
ARM_HALF: Final = _CALIBRATED.number("arm_half", "figure")
_FINGERS: Final = _CALIBRATED.number("fingers", "factor")


@dataclass(frozen=True, slots=True, eq=False)
class SideContour:
    """The contour on one side of a person seen from the front or behind, one entry per picture row.

    Attributes
    ----------
    side : int
        0 the person's left, 1 the right.
    outwards : float
        1 where this side lies towards the image's right, else -1.
    rows : (T,) float64
        Picture rows from the ears to the lowest row of the person.
    strip : Strip
        Across the axis neck, hip, knee, ankle; ``far`` is the outer border, ``near`` the inner one.
    midline : (T,) float64
        Columns of the trunk's middle line (ears, shoulders, hips, straight on below).
    arm_gap, leg_gap : (T,) float64
        Background between this axis and the arm's, and between both legs' axes, px; NaN beside no arm.
    arm_outline : (T,) bool
        Whether the outer border may be the arm's or the hand's.
    veiled : (T,) bool
        Whether hair makes the outer border.
    """

    side: int
    outwards: float
    rows: Array
    strip: Strip
    midline: Array
    arm_gap: Array
    leg_gap: Array
    arm_outline: Bools
    veiled: Bools

    @property
    def half_width(self) -> Array:
        """Return the distance (T,) px of the outer contour from the trunk's middle line."""
        outer = self.strip.centres_px[:, 0] + self.outwards * self.strip.far
        return np.asarray((outer - self.midline) * self.outwards)

    def place(self, row: float) -> float:
        """Return the entry of a picture row."""
        return float(row - self.rows[0])


def outward_sign(pose_px: Array, side: int) -> float:
    """Return 1 where a side's shoulder and hip lie to the image's right of the other's, else -1."""
    apart = sum(float(pose_px[pair[side], 0] - pose_px[pair[1 - side], 0]) for pair in (net.SHOULDERS, net.HIPS))
    return 1.0 if apart > 0 else -1.0


def arm_polyline(pose_px: Array, side: int) -> Array:
    """Return (4, 2) shoulder, elbow, wrist and fingertips of an arm, px."""
    shoulder, elbow, wrist = (pose_px[pair[side]] for pair in (net.SHOULDERS, net.ELBOWS, net.WRISTS))
    knuckles = (pose_px[net.FINGERS[0][side]] + pose_px[net.FINGERS[1][side]]) / 2
    return np.array([shoulder, elbow, wrist, wrist + (1.0 + _FINGERS) * (knuckles - wrist)])


def polyline_columns(rows: Array, line_px: Array) -> Array:
    """Return the columns (T,) of a downward polyline (K, 2) at some rows, extrapolated beyond its ends."""
    down = np.maximum.accumulate(line_px[:, 1]) + 1e-3 * np.arange(len(line_px))
    return np.interp(rows, down, line_px[:, 0])


def find_side_contour(figure: SoftMask, pose_px: Array, side: int, hair: Bools) -> SideContour:
    """Return the contour beside one side's axis.

    Parameters
    ----------
    figure : Figure
    pose_px : (33, 2) float64
    side : int
    hair : (H, W) bool
    """
    outwards = outward_sign(pose_px, side)
    ears, shoulders, hips = (pose_px[list(pair)].mean(axis=0) for pair in (net.EARS, net.SHOULDERS, net.HIPS))
    rows = np.arange(np.floor(ears[1]), np.ceil(figure.bottom_px[1]) + 1.0)
    middle = [ears, shoulders, hips]
    midline = polyline_columns(rows, np.array(middle))
    leg = [np.array([polyline_columns(rows, _leg(pose_px, which, middle[:2])), rows]).T for which in (side, 1 - side)]
    across = np.tile([outwards, 0.0], (len(rows), 1))
    strip = walk_strip(figure, leg[0], across, REACH * figure.height_px, slack_px=SLACK * figure.height_px)
    arm_gap, arm_column = _gap_beside_arm(figure, pose_px, side, rows, leg[0])
    outer = leg[0][:, 0] + outwards * strip.far
    close = np.abs(outer - arm_column) < ARM_HALF * figure.height_px
    closed = np.isfinite(arm_column) & ~(arm_gap > 0.0) & close
    within = np.stack([outer - outwards * 0.005 * figure.height_px, rows], axis=1)
    veiled = sample(hair.astype(np.float32), np.nan_to_num(within)) > 0.5
    return SideContour(
        side, outwards, rows, strip, midline, arm_gap, gap_between(figure, leg[0], leg[1]), closed, veiled
    )


def _leg(pose_px: Array, side: int, above: list[Array]) -> Array:
    """Return the (K, 2) axis from the neck through a leg to its sole."""
    return np.array([*above, *(pose_px[pair[side]] for pair in (net.HIPS, net.KNEES, net.ANKLES))])


def _gap_beside_arm(figure: SoftMask, pose_px: Array, side: int, rows: Array, leg_px: Array) -> tuple[Array, Array]:
    """Return the background (T,) between arm and trunk, and the columns (T,) of the arm's axis; NaN beside no arm."""
    line = arm_polyline(pose_px, side)
    beside = (rows >= line[0, 1]) & (rows <= line[:, 1].max())
    column = np.where(beside, polyline_columns(rows, line), np.nan)
    gap = np.full(len(rows), np.nan)
    if beside.any():
        arm = np.stack([column, rows], axis=1)[beside]
        gap[beside] = gap_between(figure, leg_px[beside], arm)
    return gap, column


def arm_strip(figure: SoftMask, pose_px: Array, side: int) -> tuple[Strip, Array]:
    """Return the contour across one arm, ``far`` outwards, and the path length (T,) from the shoulder, px."""
    line = arm_polyline(pose_px, side)
    places, along = polyline(line)
    blur = max(0.04 * figure.height_px, 1.0)
    ahead, behind = np.clip(along + blur, 0, along[-1]), np.clip(along - blur, 0, along[-1])
    corners = arc_lengths(line)
    tangent = np.stack([np.interp(ahead, corners, line[:, k]) - np.interp(behind, corners, line[:, k]) for k in (0, 1)])
    tangent = (tangent / np.maximum(np.linalg.norm(tangent, axis=0), 1e-9)).T
    across = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)  # to the image's right of an arm that hangs down
    across = across * outward_sign(pose_px, side)
    reach = 0.08 * figure.height_px
    return walk_strip(figure, places, across, reach, slack_px=SLACK * figure.height_px), along
