"""Gradient magnitudes, and histograms of gradient directions (HOG)."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

#: Directions and side of a cell, px, of histograms of gradients (Dalal and Triggs 2005).
_BINS: Final = 9
_CELL_PX: Final = 8
#: Keeps histograms of flat places near zero: the gradient of noise, grey levels a pixel times the cell's pixels.
_FLAT: Final = 4.0 * 64


def magnitudes(across: NDArray[np.float32], down: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the lengths (H, W) of vectors given by two pictures (H, W), rounded as IEEE 754 says.

    OpenCV's ``magnitude`` rounds by where in memory its pictures lie: one clone in a hundred had other bytes.
    """
    squares = across * across
    squares += down * down
    np.sqrt(squares, out=squares)
    return squares


def gradient_histograms(picture: NDArray[np.float32]) -> Array:
    """Return the flattened HOG of a grey picture: cells of 8 px, 9 unsigned directions.

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
    strength = magnitudes(across, down)
    turn = np.mod(np.arctan2(down, across), np.pi) * (_BINS / np.pi)
    low = turn.astype(np.int64)
    share = turn - low
    rows, columns = picture.shape[0] // _CELL_PX, picture.shape[1] // _CELL_PX
    cell = np.arange(rows).repeat(_CELL_PX)[:, None] * columns + np.arange(columns).repeat(_CELL_PX)
    flat, size = cell * _BINS, rows * columns * _BINS
    sums = np.bincount((flat + low % _BINS).ravel(), ((1.0 - share) * strength).ravel(), size)
    sums += np.bincount((flat + (low + 1) % _BINS).ravel(), (share * strength).ravel(), size)
    cells = sums.reshape(rows, columns, _BINS)
    energy = cv2.blur((cells**2).sum(axis=-1), (3, 3)) * 9.0
    return np.asarray((cells / np.sqrt(energy + _FLAT**2)[..., None]).ravel())
