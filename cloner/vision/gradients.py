"""Histograms of gradient directions: what a picture's neighbourhood looks like, whatever its light."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_BINS: Final = 9
_CELL_PX: Final = 8
#: Keeps histograms of flat places near zero: the gradient of noise, grey levels a pixel times the cell's pixels.
_FLAT: Final = 4.0 * 64


def describe(picture: NDArray[np.float32]) -> Array:
    """Return the flat histograms of gradient directions of a grey picture, cells of 8 px with 9 unsigned directions.

    Each cell is divided by the norm of its three-by-three neighbourhood.

    Parameters
    ----------
    picture : (h, w) float32, grey levels; both sides multiples of 8

    References
    ----------
    Dalal, Triggs 2005. Ours interpolates between directions only and normalises by a smooth neighbourhood.
    """
    across = cv2.Sobel(picture, cv2.CV_32F, 1, 0, ksize=1)
    down = cv2.Sobel(picture, cv2.CV_32F, 0, 1, ksize=1)
    strength = np.hypot(across, down)
    turn = np.mod(np.arctan2(down, across), np.pi) * (_BINS / np.pi)
    low = np.floor(turn)
    share = turn - low
    size = (picture.shape[1] // _CELL_PX, picture.shape[0] // _CELL_PX)
    planes = []
    for direction in range(_BINS):
        weight = np.where(np.mod(low, _BINS) == direction, 1.0 - share, 0.0)
        weight += np.where(np.mod(low + 1, _BINS) == direction, share, 0.0)
        planes.append(cv2.resize((weight * strength).astype(np.float32), size, interpolation=cv2.INTER_AREA))
    cells = np.stack(planes, axis=-1).astype(np.float64) * _CELL_PX**2
    energy = cv2.blur((cells**2).sum(axis=-1), (3, 3)) * 9.0
    return np.asarray((cells / np.sqrt(energy + _FLAT**2)[..., None]).ravel())
