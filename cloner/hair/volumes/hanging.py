"""Hanging hair: what stands off the cap, lies on neck and shoulders, or falls over the ears."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.frames import m_from_mm, mm_from_m
from cloner.hair.volumes.cap import Scalp
from cloner.hair.volumes.pictures import FAR_MM
from cloner.hair.volumes.rows import agreed_mm
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

INNER_MM = 6.0  # the volume reaches this far into the head, so that the hairline is a clean cut
LYING_MM = 8.0  # taste: hair that a photo shows on neck, shoulders or back is so thick at least
DRAPE_MM = 25.0  # taste: hair that one side alone shows lies this thick on the skin at most
DRAPE_DOUBT_MM = 4.0  # without it a ponytail had a skirt of 5 cm, a cap a peak of hair behind
BESIDE_MM = 35.0  # taste: and so far before and behind the head's middle where it stands off beside head and neck
FALLS_FROM_MM = 90.0  # taste: from no higher over the ears' middle, lower where it stands off: no horns on a cap
CURTAINS = (1.0, 1.25, 1.5)  # taste: of half the head's width, how far aside hair hangs that falls behind as well
BELOW_EARS_MM = 10.0  # taste: hair that goes on so far below the ears' middle hangs


def has_side_view(views: list[HairView]) -> bool:
    """Return whether a photo shows the head from the side."""
    return any(view.posed.view.is_side for view in views)


def default_depth_m(scalp: Scalp) -> tuple[float, float]:
    """Return where hair ends behind and in front (z) without a side photo: a drape behind the head, at its roots."""
    hairy = scalp.points_m[scalp.hairy > 0.5, 2]
    front = hairy if hairy.size else scalp.points_m[:, 2]
    return float(scalp.points_m[:, 2].min()) - m_from_mm(DRAPE_MM), float(front.max())


def default_width_m(scalp: Scalp) -> tuple[float, float]:
    """Return where hair ends to the side (x) without a front or back photo: as wide as the head."""
    return float(scalp.points_m[:, 0].min()), float(scalp.points_m[:, 0].max())


def hanging_mm(
    views: list[HairView],
    points_m: Array,
    skin_mm: NDArray[np.float32],
    deep_m: tuple[float, float],
    wide_m: tuple[float, float],
    low_m: float,
) -> NDArray[np.float32]:
    """Return the field (N,) of hair that stands off the cap, hangs, or lies on neck, shoulders or cheeks, mm.

    Here all photos must agree, because labels low down are the least sure; what one side alone tells of lies thin and
    no wider than the head. If no photo shows the head from aside only what goes on below the ears hangs, a flap would
    stand before the temples; it falls beside the head's middle, however wide, and behind where it does on both sides.

    Parameters
    ----------
    views : list of HairView
    points_m : (N, 3)
    skin_mm : (N,) float32
        Signed distance to the whole body's skin, positive outside.
    deep_m : (float, float)
        As in :func:`agreed_mm`.
    wide_m : (float, float)
        As of :func:`default_width_m`.
    low_m : float
        Height of the ears.
    """
    field = np.full(len(skin_mm), -FAR_MM, np.float32)
    rows = np.flatnonzero(skin_mm > -INNER_MM)
    inside, sides = agreed_mm(views, points_m[rows], deep_m)
    drape = DRAPE_MM - skin_mm[rows]
    if has_side_view(views):
        within = mm_from_m(0.5) * (wide_m[1] - wide_m[0])
        within = within - mm_from_m(1.0) * np.abs(points_m[rows, 0] - 0.5 * (wide_m[0] + wide_m[1]))
        thin = np.where(sides > 1, np.float32(FAR_MM), np.minimum(drape, within))
    else:
        thin = np.where(sides > 1, np.float32(FAR_MM), drape)
        below = np.minimum(points_m[rows], (np.inf, low_m - m_from_mm(BELOW_EARS_MM), np.inf))
        beside = BESIDE_MM - mm_from_m(1.0) * np.abs(points_m[rows, 2] - 0.5 * (deep_m[0] + deep_m[1]))
        beside = np.minimum(beside, FALLS_FROM_MM - mm_from_m(1.0) * (points_m[rows, 1] - low_m) - skin_mm[rows])
        thin = np.where(agreed_mm(views, below, deep_m)[0] > 0.0, np.maximum(thin, beside), np.float32(-FAR_MM))
        behind = _behind_mm(views, points_m[rows], deep_m, wide_m, low_m)
        inside, thin = np.maximum(inside, behind), np.where(behind > 0.0, np.maximum(thin, drape), thin)
    # Hair that hangs free and is thinner than the labels' doubt is none.
    field[rows] = np.minimum(np.minimum(inside - DRAPE_DOUBT_MM, thin), skin_mm[rows] + INNER_MM)
    return field


def _behind_mm(
    views: list[HairView], points_m: Array, deep_m: tuple[float, float], wide_m: tuple[float, float], low_m: float
) -> NDArray[np.float32]:
    """Return the depth (N,) of points behind neck and back in hair that front photos show on both sides of them, mm."""
    field = np.full(len(points_m), -FAR_MM, np.float32)
    hidden = (points_m[:, 2] < 0.5 * (deep_m[0] + deep_m[1])) & (points_m[:, 1] < low_m)
    rows = np.flatnonzero(hidden & (points_m[:, 0] > wide_m[0]) & (points_m[:, 0] < wide_m[1]))
    middle_m, beside = 0.5 * (wide_m[0] + wide_m[1]), np.full((2, rows.size), -FAR_MM, np.float32)
    for depth, x_m in zip(beside, wide_m, strict=True):
        for reach in CURTAINS:
            aside = np.column_stack([np.full(rows.size, middle_m + reach * (x_m - middle_m)), points_m[rows, 1:]])
            np.maximum(depth, agreed_mm(views, aside, deep_m)[0], out=depth)
    field[rows] = beside.min(axis=0)
    return field
