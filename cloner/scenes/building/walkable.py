"""The walkable area of a page's visitor: a raster of the floors without obstacles."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation

from cloner.scenes.building.solids import Room

#: Side of a cell, and a body's half width, metres.
CELL_M, BODY_M = 0.1, 0.25
#: What ends below the first is stepped over, what begins above the second is walked under, metres.
KNEE_M, HEAD_M = 0.15, 1.9
#: No raster has more cells: a plan's floors are 20,000 m2 at most, but may lie far apart.
MOST_CELLS: Final = 4_000_000


def make_walkable(room: Room) -> tuple[NDArray[np.uint8], tuple[float, float], float]:
    """Return (rows, columns) 1 where one may walk, the first cell's corner (x, z), and the side of a cell, metres.

    Rows go along Z, columns along X, in the page's frame.
    """
    lows = np.array([[one.low[0], -one.high[1]] for one in room.plan.floors])
    highs = np.array([[one.high[0], -one.low[1]] for one in room.plan.floors])
    low, high = lows.min(axis=0), highs.max(axis=0)
    step = CELL_M
    while np.prod(np.ceil((high - low) / step)) > MOST_CELLS:
        step *= 2.0
    columns, rows = (int(one) for one in np.maximum(np.ceil((high - low) / step), 1.0))
    x, z = low[0] + (np.arange(columns) + 0.5) * step, low[1] + (np.arange(rows) + 0.5) * step
    free = np.zeros((rows, columns), bool)
    for first, last in zip(lows, highs, strict=True):
        free |= _inside(x, z, first, last)
    for first, last in room.boxes:
        if first[1] < HEAD_M and last[1] > KNEE_M:
            free &= ~_inside(x, z, first[[0, 2]], last[[0, 2]])
    reach = int(np.ceil(BODY_M / step))
    around = np.hypot(*np.mgrid[-reach : reach + 1, -reach : reach + 1]) * step <= BODY_M
    walls = binary_dilation(~np.pad(free, reach, constant_values=False), around)[reach:-reach, reach:-reach]
    return (free & ~walls).astype(np.uint8), (float(low[0]), float(low[1])), step


def _inside(
    x: NDArray[np.float64], z: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64]
) -> NDArray[np.bool_]:
    return np.asarray(((z >= low[1]) & (z <= high[1]))[:, None] & ((x >= low[0]) & (x <= high[0]))[None])
