"""Gaps between hanging hair and shoulders, closed where a front or back photo shows hair and none anything else.

A shoulder stands some millimetres lower than in the photo, hair some millimetres higher: one saw through between them.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, binary_erosion

from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

#: Half the widest gap that is closed, voxels of 4 mm: bodies and heads err by a centimetre each.
REACH: Final = 6
#: How far the photos' outlines of hair may contradict it, mm.
DOUBT_MM: Final = 4.0
#: How deep what closes a gap lies in the hair, mm: half a voxel.
DEEP_MM: Final = 2.0


def close_gaps(
    views: list[HairView],
    found_mm: NDArray[np.float32],
    skin_mm: NDArray[np.float32],
    points_m: Array,
    rows: NDArray[np.int64],
    free: NDArray[np.bool_],
) -> NDArray[np.float32]:
    """Return the hair's field (N,), mm, with gaps between it and the skin filled.

    Parameters
    ----------
    views : list of HairView
    found_mm : (N,) float32
        The field so far, positive inside.
    skin_mm : (X, Y, Z) float32
        The distance to the whole body's skin, positive outside.
    points_m : (N, 3) at rest
    rows : (N,) their places in that grid
    free : (N,) bool
        Around a tail, which swings: it lies on nothing.
    """
    hair = np.zeros(skin_mm.shape, bool)
    hair.ravel()[rows] = found_mm > 0.0
    reached = binary_dilation(hair | (skin_mm <= 0.0), iterations=REACH)
    closed = binary_erosion(reached, iterations=REACH, border_value=1).ravel()[rows]
    near = binary_dilation(hair, iterations=2 * REACH).ravel()[rows]
    asked = np.flatnonzero(closed & near & ~free & (found_mm <= 0.0) & (skin_mm.ravel()[rows] > 0.0))
    shown = np.zeros(len(asked), np.bool_)
    for view in views:
        inside, judged = view.evidence(points_m[asked])
        if not view.posed.view.is_side:  # from aside a tail's width and the neck beside it are one
            shown |= judged & (inside > 0.0)
        open_here = judged & (inside < -DOUBT_MM)
        asked, shown = asked[~open_here], shown[~open_here]
    result = found_mm.copy()
    result[asked[shown]] = DEEP_MM
    return result
