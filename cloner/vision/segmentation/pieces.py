"""Connected components of a mask, computed in its bounding box only."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int32]
Box = tuple[slice, slice]


def box_around(mask: NDArray[np.bool_] | NDArray[np.uint8], air: int = 0) -> Box:
    """Return the rows and columns around a mask (H, W) with a margin in pixels; an empty box for an empty mask."""
    left, top, width, height = cv2.boundingRect(mask.view(np.uint8))
    if not width:
        return np.s_[top:top, left:left]
    return np.s_[max(top - air, 0) : top + height + air, max(left - air, 0) : left + width + air]


def connected_pieces(mask: NDArray[np.bool_] | NDArray[np.uint8]) -> tuple[Box, Ints, Ints]:
    """Return a mask's bounding box, its 8-connected components there, and their statistics.

    Returns
    -------
    box : pair of slices
        Rows and columns of the mask; without any pixel an empty box.
    pieces : (h, w) int32
        Number of each pixel's piece in the box, 0 outside the mask.
    figures : (N + 1, 5) int32
        A row a piece as OpenCV orders them (``cv2.CC_STAT_AREA`` and others), left and top counted in the whole mask;
        the first row is what is outside.
    """
    shown = mask.view(np.uint8)
    box = box_around(shown)
    if box[0].stop == box[0].start:
        return box, np.zeros((0, 0), np.int32), np.zeros((1, 5), np.int32)
    _, pieces, figures, _ = cv2.connectedComponentsWithStats(shown[box], connectivity=8)
    figures[:, cv2.CC_STAT_LEFT] += box[1].start
    figures[:, cv2.CC_STAT_TOP] += box[0].start
    return box, np.asarray(pieces, np.int32), np.asarray(figures, np.int32)


def pieces_on(mask: NDArray[np.bool_], place: NDArray[np.bool_], share: float) -> NDArray[np.bool_]:
    """Return the components (H, W) of a mask with more than a share of their area on a region (H, W)."""
    box, pieces, figures = connected_pieces(mask)
    inside = np.bincount(pieces[place[box]], minlength=len(figures))
    most = inside > share * figures[:, cv2.CC_STAT_AREA]
    most[0] = False
    found = np.zeros(mask.shape, np.bool_)
    found[box] = most[pieces]
    return found


def largest_piece(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the largest component (H, W) of a mask; nothing of an empty one."""
    box, pieces, figures = connected_pieces(mask)
    found = np.zeros(mask.shape, np.bool_)
    if len(figures) > 1:
        found[box] = pieces == 1 + figures[1:, cv2.CC_STAT_AREA].argmax()
    return found
