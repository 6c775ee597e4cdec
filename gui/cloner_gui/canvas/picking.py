"""Which point lies under the mouse."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def nearest_point(places: NDArray[np.float64], at: tuple[float, float], reach: float) -> int | None:
    """Return the row of the place nearest to ``at``, or None when all are farther than ``reach``.

    Parameters
    ----------
    places : (N, 2) float64, widget coordinates
    at : (x, y), same frame
    reach : float, same unit
    """
    if not len(places):
        return None
    distance = np.linalg.norm(places - np.asarray(at), axis=1)
    row = int(np.argmin(distance))
    return row if distance[row] <= reach else None
