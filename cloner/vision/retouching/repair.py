"""Repair of photos before texturing: no background colour at the person's edge."""

from __future__ import annotations

from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

Kind = TypeVar("Kind", bound=np.generic)

FAR_PX = 1e4  # farther than any photo is wide
LEAST_MASS = 0.01  # a mean of fewer pixels of the neighbourhood is none
AIR_SHARE = 0.06  # of the mask's size: lookups miss the outline by less; farther out the nearest colours run on
THICKNESS_KEPT = 0.55  # taste: a finger thinner than the band keeps the colour of its inner 45 %


def repair_bleeding(
    rgb: NDArray[np.uint8],
    mask: NDArray[np.bool_],
    band_px: float,
    unsafe: NDArray[np.bool_] | None = None,
) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Replace border and background pixels by the nearest safe foreground colour.

    The paper walks from each border pixel along the inward normal to the first
    safe foreground pixel; the nearest safe pixel of a distance transform is
    the same pixel, found for all at once. Departure: the colour also fills
    the background nearby, so that a slightly displaced lookup finds the person.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    band_px : float
        Width of the unsafe band inside the outline.
    unsafe : (H, W) bool, optional
        More of the mask that may not show the person.

    Returns
    -------
    repaired : (H, W, 3) uint8, without background anywhere; a copy of ``rgb`` when the mask is empty
    inside_px : (H, W) float32
        Signed distance to the outline, positive inside, pixels.

    References
    ----------
    Method notes section 10.1 (digitisation).
    """
    if not mask.any():
        return rgb.copy(), signed_distance(mask)
    signed = signed_distance(mask)
    (top, bottom), (left, right) = _box(mask, AIR_SHARE)
    part = np.s_[top:bottom, left:right]
    near = _spread_safe(rgb[part], signed[part], band_px, None if unsafe is None else unsafe[part])
    ends = (top, len(mask) - bottom, left, mask.shape[1] - right)
    return np.asarray(cv2.copyMakeBorder(near, *ends, cv2.BORDER_REPLICATE), np.uint8), signed


def _box(mask: NDArray[np.bool_], air: float) -> tuple[tuple[int, int], tuple[int, int]]:
    """Return first and end of the rows and columns around a mask, with a margin of this share of its larger side."""
    spans = [np.flatnonzero(mask.any(axis=axis))[[0, -1]] for axis in (1, 0)]
    wide = int(air * max(np.ptp(span) for span in spans)) + 1
    (top, bottom), (left, right) = (
        (max(int(span[0]) - wide, 0), min(int(span[1]) + wide + 1, size))
        for span, size in zip(spans, mask.shape, strict=True)
    )
    return (top, bottom), (left, right)


def _spread_safe(
    rgb: NDArray[np.uint8], signed: NDArray[np.float32], band_px: float, unsafe: NDArray[np.bool_] | None
) -> NDArray[np.uint8]:
    """Return a picture (H, W, 3) with its safe pixels, by signed distance (H, W), spread over all others."""
    inside = np.maximum(signed, 0.0)
    reach = 2 * int(np.ceil(band_px)) + 1
    thickness = cv2.dilate(inside, np.ones((reach, reach), np.uint8))
    safe = inside >= np.minimum(band_px, np.maximum(THICKNESS_KEPT * thickness, 1.0))
    if unsafe is not None and (safe & ~unsafe).any():
        safe &= ~unsafe
    repaired = spread_nearest(rgb, safe)
    # The nearest pixel alone draws streaks; a small blur outside the safe part hides them.
    soft = cv2.GaussianBlur(repaired, (0, 0), max(band_px / 2.0, 0.8))
    return np.asarray(cv2.copyTo(repaired, safe.astype(np.uint8), soft), np.uint8)


def spread_nearest(rgb: NDArray[np.uint8], known: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the picture (H, W, 3) in which every unknown pixel shows the nearest known one's colour.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    known : (H, W) bool, at least one True
    """
    _, labels = cv2.distanceTransformWithLabels(
        (~known).astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    # Labels count the known pixels row by row; four bytes a colour are fetched at once.
    colours = np.zeros((int(np.count_nonzero(known)) + 1, 4), np.uint8)
    colours[labels[known], :3] = rgb[known]
    spread = np.take(colours.view(np.uint32).ravel(), labels).view(np.uint8)
    return np.ascontiguousarray(spread.reshape(*known.shape, 4)[..., :3])


def nearest_known(picture: NDArray[Kind], known: NDArray[np.bool_], wanted: NDArray[np.bool_]) -> NDArray[Kind]:
    """Return the values (K,) of a picture (H, W) at the known pixel nearest to each wanted one; at
    least one is known.
    """
    _, index = cv2.distanceTransformWithLabels(
        (~known).astype(np.uint8), cv2.DIST_L2, 3, labelType=cv2.DIST_LABEL_PIXEL
    )
    values: NDArray[Kind] = np.zeros(int(index.max()) + 1, picture.dtype)
    values[index[known]] = picture[known]
    found: NDArray[Kind] = values[index[wanted]]
    return found


def remove_outside_body(mask: NDArray[np.bool_], body: NDArray[np.bool_], reach_px: float) -> NDArray[np.bool_]:
    """Return the mask (H, W) without what extends beyond the fitted body.

    A box of the skin's colour beside an arm is part of the mask, but no limb is that wide: the fit left it out.
    Where the mask stands out farther than a fit errs, all of it outside the body goes.

    Parameters
    ----------
    mask : (H, W) bool, the person
    body : (h, w) bool, the fitted body's picture, perhaps smaller
    reach_px : float
        Pixels of ``body`` that a fit errs by.
    """
    size = body.shape[::-1]
    small = cv2.resize(mask.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0
    away = cv2.distanceTransform((~body).astype(np.uint8), cv2.DIST_L2, 5)
    far = (small & (away > reach_px)).astype(np.uint8)
    if not far.any() or not body.any():
        return mask
    width = 4 * int(np.ceil(reach_px)) + 1  # down to the body, and as far along it
    room = (cv2.dilate(far, np.ones((width, width), np.uint8)) > 0) & ~body
    return np.asarray(
        mask & (cv2.resize(room.astype(np.uint8), mask.shape[::-1], interpolation=cv2.INTER_NEAREST) == 0), bool
    )


def remove_background_coloured(rgb: NDArray[np.uint8], mask: NDArray[np.bool_], reach_px: float) -> NDArray[np.bool_]:
    """Return the mask (H, W) without border pixels whose colour matches the surroundings.

    Between strands and through thin edges the surroundings shine. A pixel
    belongs to them when its colour is nearer to their mean nearby than to the
    mean of the mask's inside nearby.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool
    reach_px : float
        How deep pixels are judged, and over which width means are taken.
    """
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    if rows.size == 0:
        return mask.copy()
    air = int(3 * reach_px) + 1
    box = np.s_[max(rows[0] - air, 0) : rows[-1] + air + 1, max(columns[0] - air, 0) : columns[-1] + air + 1]
    inner, colours = mask[box], rgb[box].astype(np.float32)
    depth = cv2.distanceTransform(inner.astype(np.uint8), cv2.DIST_L2, 3)
    core = depth > 0.5 * reach_px
    own, own_mass = _local_mean(colours, core if core.any() else inner, reach_px)
    other, other_mass = _local_mean(colours, ~inner, reach_px)
    nearer = ((colours - other) ** 2).sum(axis=2) < ((colours - own) ** 2).sum(axis=2)
    doubtful = (depth < 2.0 * reach_px) & (own_mass > LEAST_MASS) & (other_mass > LEAST_MASS)
    kept = mask.copy()
    kept[box] = inner & ~(nearer & doubtful)
    return kept if kept.any() else mask.copy()


def _local_mean(
    rgb: NDArray[np.float32], where: NDArray[np.bool_], reach_px: float
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the mean colour (h, w, 3) of marked pixels around each pixel, and their share (h, w)."""
    size = 2 * int(np.ceil(2.0 * reach_px)) + 1
    share = cv2.blur(where.astype(np.float32), (size, size))
    total = cv2.blur(rgb * where[..., None], (size, size))
    return np.asarray(total / np.maximum(share, 1e-6)[..., None], np.float32), np.asarray(share, np.float32)


def signed_distance(mask: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (H, W) float32 distance to a mask's outline in px, positive inside; without an outline `FAR_PX`."""
    if mask.all() or not mask.any():
        return np.full(mask.shape, FAR_PX if mask.all() else -FAR_PX, np.float32)
    inside = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    outside = cv2.distanceTransform((~mask).astype(np.uint8), cv2.DIST_L2, 5)
    # The outline runs half-way between the last pixel inside and the first outside.
    return np.asarray(np.where(mask, inside - 0.5, 0.5 - outside), np.float32)
