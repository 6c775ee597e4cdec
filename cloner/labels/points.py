"""Joints and skin points under clothes, by heat maps of the label net over the whole person."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.seen_points import PAIRS
from cloner.labels.decoder import POINT_SIDE_PX, SIDE_PX, probabilities
from cloner.vision.photographs.crops import Crop, move_points, photo_px_from_crop

Floats = NDArray[np.float32]

#: Which way the person's left lies in the picture, along its columns; a side photo does not say.
_LEFT: Final = {ViewId.BODY_FRONT: 1.0, ViewId.BODY_BACK: -1.0}
#: Cells around the likeliest one whose mean is the point: the net was taught to share a point among four.
_REACH: Final = 2


def locate_points(scores: Floats, crop: Crop, view: ViewId) -> NDArray[np.float64]:
    """Return the position of every point in the photo.

    A person whose face is veiled may be read as seen from behind, all lefts exchanged for rights, or half of them. What
    a front photo shows is known, so both maps of a pair are read together, and what lies on the left is left.

    Parameters
    ----------
    scores : (21, 64, 64) float32
        Log-odds of the points' places (``decoder.Scores``).
    crop : Crop
        Of the whole person.
    view : ViewId

    Returns
    -------
    (21, 2) float64
        Photo px; rows are ``cloner.generic.seen_points.NAMES``.
    """
    shares = probabilities(scores, axis=(1, 2))
    cells = np.array([_mean_around_peak(share, share) for share in shares])
    if view in _LEFT:
        for pair in PAIRS:
            cells[list(pair)] = _left_and_right(shares[list(pair)], _LEFT[view])
    scale = SIDE_PX / POINT_SIDE_PX
    photo_from_crop = photo_px_from_crop(crop, width=SIDE_PX, height=SIDE_PX)
    return move_points((cells + 0.5) * scale - 0.5, photo_from_crop)


def _left_and_right(shares: Floats, left: float) -> NDArray[np.float64]:
    """Return the cells (2, 2) of a left and a right point, both of whose maps (2, h, w) may show either."""
    both = shares.sum(axis=0)
    columns = np.arange(both.shape[1])
    middle = float((both.sum(axis=0) * columns).sum()) / 2.0
    on_left = left * (columns - middle) > 0.0
    return np.array([_mean_around_peak(both * side, *shares) for side in (on_left, ~on_left)])


def _mean_around_peak(where: Floats, *shares: Floats) -> NDArray[np.float64]:
    """Return the mean position (2,) around a map's peak; of several maps, around the highest peak."""
    row, column = np.unravel_index(int(where.argmax()), where.shape)
    share = max(shares, key=lambda each: float(each[row, column]))
    rows, columns = (slice(max(0, k - _REACH), k + _REACH + 1) for k in (int(row), int(column)))
    near = share[rows, columns]
    y, x = np.mgrid[rows.start : rows.start + near.shape[0], columns.start : columns.start + near.shape[1]]
    return np.array([(near * x).sum(), (near * y).sum()], np.float64) / float(near.sum())
