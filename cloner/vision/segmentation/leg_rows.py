"""The outline around both legs, row by row, relative to the legs of the pose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array
from cloner.vision.photographs.arms import arm_zone

Bools = NDArray[np.bool_]

#: BlazePose rows: left, right.
SHOULDERS, HIPS, KNEES, ANKLES = (11, 12), (23, 24), (25, 26), (27, 28)
#: Everything below is a share of the figure's height in the photo.
LEG_SHARES = (0.055, 0.036, 0.027)  # half widths of a leg at hip, knee and ankle (generic mean) with trousers on
WAIST_SHARE = 0.62  # of shoulder to hip: cloth is loose from the waist down


@dataclass(frozen=True, slots=True, eq=False)
class LegRows:
    """The outline around both legs, row by row.

    Attributes
    ----------
    top_px : int
        First row, at the waist.
    level : (R,) 0 at the hips, 1 at the ankles
    edges_px : (R, 2) first and last column of the runs through image-left and image-right leg
    seen : (R, 2) bool, False where an arm makes the edge
    joined : (R,) bool, whether everything between both legs is filled
    filled : (R,) 0..1, how much of the room between usual legs is filled; 1 where there is none
    gap_px : (R,) room between the legs inside the cloth, as the pose and usual legs have it
    off_px : (R, 2) how far the edges stand off from usual legs
    inner_px : (R,) filled pixels between the legs' axes
    figure_px : float
    """

    top_px: int
    level: Array
    edges_px: Array
    seen: Bools
    joined: Bools
    filled: Array
    gap_px: Array
    off_px: Array
    inner_px: Array
    figure_px: float


def leg_rows(mask: Bools, pose_px: Array, visibility: Array) -> LegRows | None:
    """Return the outline around the legs from the waist down, None without a figure or legs.

    Parameters
    ----------
    mask : (H, W) bool, the filled outline
    pose_px, visibility : (33, 2), (33,), ``generic.seen_points.stance``
    """
    rows = np.flatnonzero(mask.any(axis=1))
    if rows.size < 100 or visibility[list(HIPS + KNEES + ANKLES)].max() < 0.3:
        return None
    figure = float(rows[-1] - rows[0] + 1)
    hips, ankles = pose_px[list(HIPS), 1].mean(), pose_px[list(ANKLES), 1].mean()
    waist = (1 - WAIST_SHARE) * pose_px[list(SHOULDERS), 1].mean() + WAIST_SHARE * hips
    if not waist < hips < ankles:
        return None
    at = np.arange(max(int(waist), 0), min(int(rows[-1]), mask.shape[0] - 1) + 1)
    axes = _leg_axes(pose_px, at)
    half = figure * np.interp((at - hips) / (ankles - hips), (0.0, 0.5, 1.0), LEG_SHARES)
    arms = arm_zone((pose_px, visibility), figure, mask.shape)[at]
    first, last = _runs(mask[at])
    columns = np.clip(np.round(axes).astype(int), 0, mask.shape[1] - 1)
    line = np.arange(len(at))
    edges = np.stack([first[line, columns[:, 0]], last[line, columns[:, 1]]], axis=1).astype(np.float64)
    inside = np.stack([mask[at, columns[:, k]] for k in (0, 1)], axis=1)
    edges = np.where(inside, edges, axes)
    reach = np.clip(np.round(edges).astype(int), 0, mask.shape[1] - 1)
    # an arm over the middle of the leg hides nothing of the edge beyond it
    seen = inside & ~np.stack([arms[line, reach[:, k]] for k in (0, 1)], axis=1)
    joined = inside.all(axis=1) & (last[line, columns[:, 0]] >= columns[:, 1])
    gap = np.maximum(axes[:, 1] - axes[:, 0] - 2.0 * half, 0.0)
    off = np.stack([axes[:, 0] - half - edges[:, 0], edges[:, 1] - axes[:, 1] - half], axis=1)
    total = np.concatenate([np.zeros((len(at), 1)), np.cumsum(mask[at], axis=1)], axis=1)
    inner = total[line, columns[:, 1] + 1] - total[line, columns[:, 0]]
    legs = axes[:, 1] - axes[:, 0] - gap
    filled = np.where(gap > 0.0, np.clip((inner - legs) / np.maximum(gap, 1e-9), 0.0, 1.0), 1.0)
    return LegRows(int(at[0]), (at - hips) / (ankles - hips), edges, seen, joined, filled, gap, off, inner, figure)


def _leg_axes(pose_px: Array, at: NDArray[np.int64]) -> Array:
    """Return the columns (R, 2) of the image-left and image-right leg's axis at rows."""
    columns = []
    for side in (0, 1):
        joints = pose_px[[HIPS[side], KNEES[side], ANKLES[side]]]
        columns.append(np.interp(at, joints[:, 1], joints[:, 0]))
    return np.sort(np.stack(columns, axis=1), axis=1)


def _runs(mask: Bools) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the first and last column of the run of True around every pixel of (R, W), meaningless where False."""
    columns = np.arange(mask.shape[1])
    before = np.maximum.accumulate(np.where(mask, -1, columns), axis=1) + 1
    after = np.minimum.accumulate(np.where(mask, mask.shape[1], columns)[:, ::-1], axis=1)[:, ::-1] - 1
    return before, after
