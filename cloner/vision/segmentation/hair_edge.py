"""The hair's boundary against skin and cloth, refined by the colours on both sides."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.photographs.head_frame import face_organs
from cloner.vision.segmentation.colours import colour_ratio, quantise_colours
from cloner.vision.segmentation.pieces import box_around

Floats = NDArray[np.float32]
Flags = NDArray[np.bool_]

#: Size of the head on which the edge is drawn: a pixel is 0.7 mm.
FINE_HEAD_PX: Final = 320.0
#: Shares of a head (about 225 mm): how far from the coarse edge pixels are decided anew, and beyond which they teach.
OPEN, SURE = 0.09, 0.012
#: Pixels whose colours are learned lie this near to the edge, and windows of colours have this sigma.
TEACHERS, WINDOW = 0.20, 0.045
#: Weights of the coarse log-odds, the colours of all the head and those nearby.
WEIGHTS: Final = (0.35, 0.30, 0.60)
#: Log-odds that one source may claim.
LIMIT: Final = 5.0
#: Rounds: a lock that the coarse labels cut short is followed by one open band a round.
ROUNDS: Final = 2
#: Agreement of like neighbours: strength and step of colour, grey levels, of the smoother.
SPREADING, STEP = 400.0, 4.0
#: What lies between hair and background and is thinner than twice this is shine on the hair, share of a head.
SLIVER: Final = 0.02
#: Probability that such a strip gets.
FILLED: Final = 0.6


def draw_edge(
    rgb: NDArray[np.uint8],
    hair: Floats,
    person: Flags,
    face: NDArray[np.float64] | None,
    head_px: float,
    ear_px: float,
) -> Flags:
    """Return the hair (H, W) of a photo around a head, its boundary drawn at ``FINE_HEAD_PX`` per head.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    hair : (H, W) float32, 0..1
        Coarse probability.
    person : (H, W) bool
    face : (468, 2) float64 or None
        Face mesh in px of ``rgb``.
    head_px, ear_px : float
        Crown to chin, and the row of the ear's middle.
    """
    factor = min(FINE_HEAD_PX / max(head_px, 8.0), 1.0)
    size = (max(4, round(rgb.shape[1] * factor)), max(4, round(rgb.shape[0] * factor)))
    small = np.asarray(cv2.resize(rgb, size, interpolation=cv2.INTER_AREA), np.uint8)
    coarse = np.asarray(cv2.resize(hair, size, interpolation=cv2.INTER_AREA), np.float32)
    inside = cv2.resize(person.astype(np.float32), size, interpolation=cv2.INTER_AREA) > 0.5
    never = np.zeros(inside.shape, np.bool_) if face is None else face_organs(face * factor, inside.shape)
    fine = sharpen_hair(small, coarse, inside, never, head_px * factor)
    above = slice(0, int(max(ear_px * factor, 0.0)))  # lower down skin and cloth too are thin beside hair
    filled = fill_slivers(fine[above] > 0.5, inside[above], head_px * factor)
    fine[above] = np.where(filled, np.maximum(fine[above], FILLED), fine[above])
    whole = cv2.resize(fine, (rgb.shape[1], rgb.shape[0]), interpolation=cv2.INTER_LINEAR)
    return np.asarray(person & (whole > 0.5))


def sharpen_hair(rgb: NDArray[np.uint8], hair: Floats, person: Flags, never: Flags, head_px: float) -> Floats:
    """Return the hair's probability (H, W) with its boundary along the photo's colours.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
        Part of a photo around the head.
    hair : (H, W) float32, 0..1
        Coarse probability, its edge some millimetres off.
    person, never : (H, W) bool
        The person; what is no hair whatever its colour (eyes, brows, lips).
    head_px : float
        Crown to chin.
    """
    found = np.where(person, hair, 0.0).astype(np.float32)
    if not (found > 0.5).any():
        return found
    box = box_around(found > 0.5, int(TEACHERS * head_px) + 2)
    part = np.ascontiguousarray(rgb[box])
    for _ in range(ROUNDS):
        found[box] = _sharpening_round(part, found[box], person[box], never[box], head_px)
    return found


def _sharpening_round(rgb: NDArray[np.uint8], hair: Floats, person: Flags, never: Flags, head_px: float) -> Floats:
    """Return the hair's probability (H, W) after one more decision near its boundary."""
    now = (hair > 0.5).astype(np.uint8)
    away = cv2.distanceTransform(now, cv2.DIST_L2, 3) + cv2.distanceTransform(1 - now, cv2.DIST_L2, 3)
    near = (away < TEACHERS * head_px) & person & ~never
    open_ = near & (away < OPEN * head_px)
    sure = near & (away > SURE * head_px)
    if not open_.any():
        return hair
    palette = quantise_colours(np.asarray(cv2.cvtColor(rgb, cv2.COLOR_RGB2Lab), np.uint8), near)
    ratios = np.zeros((2, *now.shape), np.float32)
    window = max(WINDOW * head_px, 2.0)
    ratios[:, open_] = colour_ratio(palette, sure & (now > 0), sure & (now == 0), open_, window_px=window)
    wide, close = (np.clip(cv2.GaussianBlur(ratio, (0, 0), 1.0), -LIMIT, LIMIT) for ratio in ratios)
    own = WEIGHTS[0] * np.clip(_log_odds(hair), -LIMIT, LIMIT) + WEIGHTS[1] * wide + WEIGHTS[2] * close
    passed = np.where(person, np.where(open_, own, np.where(now > 0, LIMIT, -LIMIT)), 0.0).astype(np.float32)
    odds = own + _smoothed_log_odds(rgb, passed, person)
    return np.where(open_, 1.0 / (1.0 + np.exp(-odds)), hair).astype(np.float32)


def fill_slivers(hair: Flags, person: Flags, head_px: float) -> Flags:
    """Return hair (H, W) with the person's thin strips between it and the background, such as shine."""
    if not hair.any():  # also of a head whose ears are the picture's first row: no rows at all
        return hair
    size = 2 * max(1, round(SLIVER * head_px)) + 1
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    shown = (person & ~hair).astype(np.uint8)
    thick = cv2.morphologyEx(shown, cv2.MORPH_OPEN, disc)
    near_hair = cv2.dilate(hair.astype(np.uint8), disc) > 0
    near_wall = cv2.dilate((~person).astype(np.uint8), disc) > 0
    return np.asarray(hair | ((shown > 0) & (thick == 0) & near_hair & near_wall))


def _smoothed_log_odds(rgb: NDArray[np.uint8], odds: Floats, person: Flags) -> Floats:
    """Return log odds (H, W) averaged over similar neighbours of the person."""
    smoother = cv2.ximgproc.createFastGlobalSmootherFilter(rgb, SPREADING, STEP)
    mass = smoother.filter(person.astype(np.float32))
    return np.asarray(smoother.filter(odds) / np.maximum(mass, 1e-3), np.float32)


def _log_odds(probability: Floats) -> Floats:
    clipped = np.clip(probability, 0.005, 0.995)
    return np.asarray(np.log(clipped / (1.0 - clipped)), np.float32)
