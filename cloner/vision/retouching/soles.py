"""Shadows around the feet inside a mask: the contact shadow below the soles, and shaded floor between shoes."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from cloner.vision.retouching.skin_colour import log_chroma

#: Columns whose lowest pixel of the person lies this near to his lowest one show a foot, share of the figure.
FEET_SHARE: Final = 0.06
#: The darkest place lies this far inside the mask's edge at most, or this far below it; share of the figure.
DARKEST_SHARE, BELOW_SHARE = 0.010, 0.003
#: The shoe begins at most this far above the mask's edge, 17 mm of a grown-up: .016 found no texel more of the room and
#: took twice as much of black soles (21 photos; 60 % of what masks hold beyond the shoes is found).
HIGHEST_SHARE: Final = 0.010
#: The floor is asked this far below the mask's edge, share of the figure.
FLOOR_SHARE: Final = 0.02
#: Grey levels by which the shoe, and the floor, are lighter than what is between; noise is below 1 once blurred.
SHOE_RISE, FLOOR_RISE = 4.0, 15.0
#: Columns that agree by median on how high the line reaches, share of the figure.
ALONG_SHARE: Final = 0.012
#: Shoes are judged this deep inside the mask, share of the figure.
CORE_SHARE: Final = 0.006
#: Log ratios nearer than the first are the floor's hue, and farther than the second surely another; at most this
#: share of the shoes may have it.
SAME_HUE, OTHER_HUE, MOST_ALIKE = 0.25, 0.35, 0.06


def contact_shadow(rgb: NDArray[np.uint8], mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of a mask below the soles: from each column's darkest pixel up to the shoe.

    Where a sole is as dark as its shadow nothing tells them apart, and what begins above it counts as the shoe: some
    of a black sole is lost, which costs a texture nothing; an outline would shrink by it.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    """
    shadow = np.zeros(mask.shape, bool)
    rows = np.flatnonzero(mask.any(axis=1))
    if rows.size == 0:
        return shadow
    figure = float(rows[-1] - rows[0] + 1)
    lowest = len(mask) - 1 - mask[::-1].argmax(axis=0)
    column = np.flatnonzero(mask.any(axis=0) & (lowest > rows[-1] - FEET_SHARE * figure))
    column = column[lowest[column] + FLOOR_SHARE * figure < len(mask)]
    if column.size == 0:
        return shadow
    top = max(int(lowest[column].min() - 2.0 * HIGHEST_SHARE * figure), 0)
    grey = cv2.blur(cv2.GaussianBlur(rgb[top:], (0, 0), 1.0), (5, 1)).mean(axis=2, dtype=np.float32)
    height = _heights(grey, column, lowest[column] - top, figure)
    for x, bottom, reach in zip(column.tolist(), lowest[column].tolist(), height.tolist(), strict=True):
        shadow[bottom - reach + 1 : bottom + 1, x] = True
    return shadow & mask


def _heights(
    grey: NDArray[np.float32], column: NDArray[np.intp], lowest: NDArray[np.intp], figure: float
) -> NDArray[np.intp]:
    """Return the height (N,) px of the shadow above each column's lowest pixel; 0 where there is none."""
    below, deepest, highest = (round(share * figure) for share in (BELOW_SHARE, DARKEST_SHARE, HIGHEST_SHARE))
    step = np.arange(-below, highest + 1)[:, None]
    seen = grey[np.clip(lowest - step, 0, len(grey) - 1), column]
    darkest_at = seen[: below + deepest + 1].argmin(axis=0)
    darkest = seen.min(axis=0, where=step <= deepest, initial=np.inf)
    floor = grey[np.minimum(lowest + round(FLOOR_SHARE * figure), len(grey) - 1), column]
    shoe = (seen > darkest + SHOE_RISE) & (np.arange(len(step))[:, None] > darkest_at)
    found = shoe.any(axis=0) & (floor > darkest + FLOOR_RISE)
    height = np.where(found, np.maximum(shoe.argmax(axis=0) - below, 0), 0)
    spread = np.zeros(grey.shape[1], np.intp)  # neighbours by column: feet do not mix
    spread[column] = height
    return np.asarray(median_filter(spread, round(ALONG_SHARE * figure) | 1)[column], np.intp)


def shaded_floor(rgb: NDArray[np.uint8], mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of a mask between the shoes that show shaded floor.

    Shade darkens a floor but leaves its hue. Where shoes or trousers have that hue too nothing is told.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    """
    floor = np.zeros(mask.shape, bool)
    rows = np.flatnonzero(mask.any(axis=1))
    if rows.size == 0:
        return floor
    figure = float(rows[-1] - rows[0] + 1)
    part = np.s_[max(int(rows[-1] - FEET_SHARE * figure), 0) : int(rows[-1] + FLOOR_SHARE * figure)]
    person, soft = mask[part], cv2.GaussianBlur(rgb[part], (0, 0), 1.5)
    depth, away = (cv2.distanceTransform(own.astype(np.uint8), cv2.DIST_L2, 5) for own in (person, ~person))
    around = (away > 0.25 * FLOOR_SHARE * figure) & (away < FLOOR_SHARE * figure)
    deep = depth > CORE_SHARE * figure
    if not around.any() or not deep.any():
        return floor
    hue, _ = log_chroma(soft.reshape(-1, 3))
    own = np.median(hue[around.ravel()], axis=0)
    alike = (np.linalg.norm(hue - own, axis=1) < SAME_HUE).reshape(person.shape)
    if (np.linalg.norm(hue[deep.ravel()] - own, axis=1) < OTHER_HUE).mean() > MOST_ALIKE:
        return floor
    alike = cv2.medianBlur((alike & person).astype(np.uint8), 5) > 0
    _, pieces = cv2.connectedComponents(alike.astype(np.uint8), connectivity=8)
    open_ = np.unique(pieces[alike & (depth < 2.5)])
    floor[part] = np.isin(pieces, open_[open_ > 0])
    return floor
