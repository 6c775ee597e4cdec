"""Crops for the label net: the whole person, and the head alone."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.labels.decoder import SIDE_PX
from cloner.vision.photographs.crops import Crop
from cloner.vision.photographs.head_frame import HeadFrame

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.crops")

PERSON_SHARE: Final = _CALIBRATED.number("person_share", "share")
#: A crop's border is read so far inside it, pixels of the label net.
INSIDE_PX: Final = 2
HEAD_SHARE: Final = _CALIBRATED.number("head_share", "share")


def person_crop(person: NDArray[np.bool_], view: ViewId) -> Crop:
    """Return the square around the whole person; of a face photo, the whole photo.

    Parameters
    ----------
    person : (H, W) bool
        Some pixel is True.
    view : ViewId
    """
    height, width = person.shape
    if view.is_face:
        side = float(max(height, width))
        return Crop((width - 1) / 2.0, (height - 1) / 2.0, side, side)
    rows, columns = np.flatnonzero(person.any(axis=1)), np.flatnonzero(person.any(axis=0))
    side = PERSON_SHARE * float(max(np.ptp(rows), np.ptp(columns)) + 1)
    return Crop(float(columns[0] + columns[-1]) / 2, float(rows[0] + rows[-1]) / 2, side, side)


def is_cut_by_crop(crop: Crop, person: NDArray[np.float32]) -> bool:
    """Return whether a person in a crop continues above or below it, still inside the photo.

    Parameters
    ----------
    crop : Crop
    person : (H, W) float32
        Probability of the person, 0 beyond the crop.
    """
    half = (0.5 - INSIDE_PX / SIDE_PX) * crop.height_px
    ends = (round(crop.y_px - half), round(crop.y_px + half))
    return any(0 < end < len(person) - 1 and bool((person[end] > 0.5).any()) for end in ends)


def head_crop(head: HeadFrame) -> Crop:
    """Return the square around the head."""
    side = HEAD_SHARE * max(head.head_px, 8.0)
    return Crop(head.x_px, (head.top_px + head.chin_px) / 2, side, side)
