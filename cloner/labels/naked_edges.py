"""Row-wise edges of trunk, thighs and neck under clothes and hair, by the label net."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.labels.decoder import PART_SIDE_PX, probabilities
from cloner.vision.photographs.crops import Crop, move_points, photo_px_from_crop

Floats = NDArray[np.float32]

#: What is read, as the table's first column counts it.
TRUNK, LEFT_THIGH, RIGHT_THIGH, NECK = range(4)
#: Of which planes each is the sum, in a crop of the whole person and in one of the head, where the trunk begins with
#: the neck. The planes' order is that of ``PARTS`` in ``generic_models/build/label_crops.py``.
IN_PERSON: Final = {TRUNK: (2, 9, 10), LEFT_THIGH: (9,), RIGHT_THIGH: (10,)}
IN_HEAD: Final = {NECK: (2,)}
#: Planes of the arms, which may lie before the trunk's edge.
ARMS: Final = slice(3, 9)
#: Of a photo of the face.
NO_EDGES: Final = np.zeros((0, 4))


def body_edges(scores: Floats, crop: Crop, read: Mapping[int, tuple[int, ...]]) -> NDArray[np.float64]:
    """Return where parts of the naked body begin and end in every row of the net's picture.

    Parameters
    ----------
    scores : (15, 128, 128) float32
        Log-odds of the parts (``decoder.Scores``).
    crop : Crop
    read : mapping of int to tuple of int
        `IN_PERSON` or `IN_HEAD`, as the crop is.

    Returns
    -------
    (N, 4) float64
        `TRUNK` (down to the knees), `LEFT_THIGH`, `RIGHT_THIGH` or `NECK` (and all below it); row, left and right end
        in photo px. Rows are left out where an arm lies over an end.
    """
    shares = probabilities(scores)
    arms = shares[ARMS].sum(axis=0)
    photo_from_crop = photo_px_from_crop(crop, width=PART_SIDE_PX, height=PART_SIDE_PX)
    found = []
    for kind, planes in read.items():
        share = shares[list(planes)].sum(axis=0)
        for row in np.flatnonzero((share > 0.5).any(axis=1)):
            inside = np.flatnonzero(share[row] > 0.5)
            ends = [_end(share[row], arms[row], int(last), step) for last, step in ((inside[0], -1), (inside[-1], 1))]
            if None not in ends:
                places = move_points(np.array([[end, row] for end in ends], np.float64), photo_from_crop)
                found.append((kind, places[0, 1], places[0, 0], places[1, 0]))
    return np.array(found).reshape(-1, 4)


def _end(share: Floats, arms: Floats, last: int, step: int) -> float | None:
    """Return where a probability falls to a half beyond its last column, None where an arm or the border is."""
    beyond = last + step
    if not 0 <= beyond < len(share) or arms[beyond] > 0.5:
        return None
    return last + step * float((share[last] - 0.5) / (share[last] - share[beyond]))
