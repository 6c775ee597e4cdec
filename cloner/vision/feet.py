"""Whether a person stands on bare feet: is the colour of the feet the colour of the face?"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

#: Largest distance of mean colours a, b in CIE Lab (of 8-bit values) that is still the same skin (taste).
SAME_SKIN = 9.0
#: Value of skin in the labels of the head.
_SKIN = 1


def is_barefoot(
    rgb: NDArray[np.uint8],
    mask: NDArray[np.bool_],
    labels: NDArray[np.uint8],
    feet_px: NDArray[np.float64],
    reach_px: float,
) -> bool:
    """Return whether both feet have the colour of the head's skin.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) bool, the person
    labels : (H, W) uint8, 1 where the head shows skin
    feet_px : (N, 2) points in the feet, between heel and toe, photo pixels
    reach_px : float
        Half the side of the square looked at around each point.
    """
    face = labels == _SKIN
    if int(face.sum()) < 50:
        return False
    lab = cv2.cvtColor(rgb, cv2.COLOR_RGB2LAB).astype(np.float64)
    skin = np.median(lab[face], axis=0)
    reach = max(int(reach_px), 1)
    for column, row in np.round(feet_px).astype(int):
        box = np.s_[max(row - reach, 0) : row + reach + 1, max(column - reach, 0) : column + reach + 1]
        inside = mask[box]
        if not inside.any():
            return False
        foot = np.median(lab[box][inside], axis=0)
        if np.linalg.norm(foot[1:] - skin[1:]) > SAME_SKIN or foot[0] < 0.4 * skin[0]:
            return False
    return len(feet_px) > 0
