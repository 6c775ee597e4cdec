"""A photo in which no net sees anybody: hair, a hood or a cap may hide the face. The other photos tell of it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Bools = NDArray[np.bool_]

#: Photos are looked at with this many pixels a side at most.
_LONG_PX: Final = 240
#: Colours that stand for a person and for a room.
_PERSON_COLOURS, _ROOM_COLOURS = 16, 8
#: Lamps change lightness most: it counts half.
_WEIGHTS: Final = (0.5, 1.0, 1.0)
#: A pixel farther than this from all of a person's colours, in 8-bit Lab so weighed, is not his (taste).
_ALIKE: Final = 16.0
#: Part of the picture in which a portrait's head and shoulders lie: rows from, columns from and to.
_MIDDLE: Final = (0.25, 0.3, 0.7)
#: Part of the top and the sides that is room about a portrait.
_BORDER: Final = 0.06
#: Share of the middle in the person's colours and not in the room's from which somebody is there.
#: (8 side photos, six of them with faces that hair, hoods or caps hide: 0.49 to 0.93; 17 pictures of rooms, landscapes
#: and things against 8 people: 130 of 136 below).
SOMEBODY: Final = 0.47


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
    """Return 8-bit Lab with its lightness weighed."""
    lab = cv2.cvtColor(rgb, cv2.COLOR_RGB2Lab).astype(np.float32)
    return np.asarray(lab * np.array(_WEIGHTS, np.float32), np.float32)


def _centres(lab: NDArray[np.float32], count: int) -> NDArray[np.float32]:
    """Return the middles of the clusters of some colours."""
    cv2.setRNGSeed(0)
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 20, 0.5)
    best = np.zeros((len(lab), 1), np.int32)
    _, _, centres = cv2.kmeans(np.ascontiguousarray(lab), count, best, stop, 1, cv2.KMEANS_PP_CENTERS)
    return np.asarray(centres, np.float32)


def _nearest(lab: NDArray[np.float32], centres: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.asarray(np.linalg.norm(lab[:, None] - centres[None], axis=2).min(axis=1), np.float32)
