"""A photo in which no net detects anybody, because hair, a hood or a cap covers the face: colours of the other photos
help.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.hidden")

Picture = NDArray[np.uint8]
Bools = NDArray[np.bool_]

#: Photos are looked at with this many pixels a side at most.
_LONG_PX: Final = 240
#: Colours that stand for a person and for a room.
_PERSON_COLOURS, _ROOM_COLOURS = 16, 8
_WEIGHTS: Final = _CALIBRATED.triple("weights", "factor")
_ALIKE: Final = _CALIBRATED.number("alike", "lab")
_MIDDLE: Final = _CALIBRATED.triple("middle", "share")
_BORDER: Final = _CALIBRATED.number("border", "share")
SOMEBODY: Final = _CALIBRATED.number("somebody", "share")


def shares_colours(rgb: Picture, others: Iterable[tuple[Picture, Bools]]) -> float:
    """Return 0..1 how much of a portrait's middle has the colours of a person and not those of its own borders.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    others : iterable of (H, W, 3) uint8 and (H, W) bool
        Other photos of the person, and where in them the person is.
    """
    person = np.concatenate([_lab(_small(photo))[_small_mask(photo, mask)] for photo, mask in others])
    if len(person) < _PERSON_COLOURS:
        return 0.0
    picture = _small(rgb)
    lab, (height, width) = _lab(picture), picture.shape[:2]
    rim = max(1, round(_BORDER * min(height, width)))
    half = height // 2
    room = np.concatenate([
        lab[:rim].reshape(-1, 3), lab[:half, :rim].reshape(-1, 3), lab[:half, -rim:].reshape(-1, 3),
    ])  # fmt: skip
    top, left, right = int(_MIDDLE[0] * height), int(_MIDDLE[1] * width), int(_MIDDLE[2] * width)
    middle = lab[top:, left:right].reshape(-1, 3)
    own = _nearest(middle, _centres(person, _PERSON_COLOURS))
    foreign = _nearest(middle, _centres(room, _ROOM_COLOURS))
    return float(((own < _ALIKE) & (own < foreign)).mean())


def _small(rgb: Picture) -> Picture:
    scale = _LONG_PX / max(rgb.shape[:2])
    return np.asarray(cv2.resize(rgb, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA), np.uint8)


def _small_mask(rgb: Picture, mask: Bools) -> Bools:
    height, width = _small(rgb).shape[:2]
    small = cv2.resize(mask.astype(np.uint8), (width, height), interpolation=cv2.INTER_NEAREST)
    return np.asarray(small > 0, np.bool_)


def _lab(rgb: Picture) -> NDArray[np.float32]:
    """Return 8-bit Lab with scaled lightness."""
    lab = cv2.cvtColor(rgb, cv2.COLOR_RGB2Lab).astype(np.float32)
    return np.asarray(lab * np.array(_WEIGHTS, np.float32), np.float32)


def _centres(lab: NDArray[np.float32], count: int) -> NDArray[np.float32]:
    """Return the cluster centres of some colours."""
    cv2.setRNGSeed(0)
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 20, 0.5)
    best = np.zeros((len(lab), 1), np.int32)
    _, _, centres = cv2.kmeans(np.ascontiguousarray(lab), count, best, stop, 1, cv2.KMEANS_PP_CENTERS)
    return np.asarray(centres, np.float32)


def _nearest(lab: NDArray[np.float32], centres: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.asarray(np.linalg.norm(lab[:, None] - centres[None], axis=2).min(axis=1), np.float32)
