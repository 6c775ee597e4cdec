"""The way to a region round all obstacles: distances over the raster; the core has the direction in each cell.

A field is seeded by the whole region: seeded by a point it funnels everybody into a line (walkers §1).
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from cloner.behaviour.ground import CELL_M, RAY_BODY_M, Ground, Mask
from cloner.records.arrays import Array

#: A way closer to a wall than this costs up to twice as much: people keep half a metre off; taste.
SHY_M: Final = 0.5
#: Sixteen neighbours: the eight around and the knight's moves.
_MOVES: Final = tuple(
    (r, c) for r in range(-2, 3) for c in range(-2, 3) if (abs(r), abs(c)) in {(0, 1), (1, 0), (1, 1), (1, 2), (2, 1)}
)


def distances(ground: Ground, region: Array) -> Array:
    """Return how far each cell is from the cells in a region's corners (k, 2), (rows, cols); inf if out of reach.

    Dijkstra over sixteen neighbours: the least of all sums along ways, whatever the order of equal ones.
    """
    rows, cols = ground.clear.shape
    seeds = np.flatnonzero(region_cells(ground, region).ravel())
    if not len(seeds):
        return np.full((rows, cols), np.inf)
    start, end, cost = _graph(ground)
    graph = coo_array((cost, (start, end)), shape=(rows * cols, rows * cols)).tocsr()
    found = dijkstra(graph, directed=True, indices=seeds, min_only=True)
    return np.asarray(found, np.float64).reshape(rows, cols)


def region_cells(ground: Ground, region: Array) -> Mask:
    """Return the cells (rows, cols) in which one can stand whose middle lies in a region's corners (k, 2)."""
    from cloner.behaviour.ground import inside

    row, column = np.indices(ground.clear.shape)
    middle = ground.middles(row.ravel(), column.ravel())
    within = inside(middle, region).reshape(ground.clear.shape)
    return np.asarray(within & (ground.clear >= RAY_BODY_M))


def _graph(ground: Ground) -> tuple[NDArray[np.int64], NDArray[np.int64], Array]:
    """Return the moves between cells: from, to and what they cost, metres."""
    rows, cols = ground.clear.shape
    number = np.arange(rows * cols).reshape(rows, cols)
    stands = ground.clear >= RAY_BODY_M
    price = 1.0 + np.clip((SHY_M - ground.clear) / (SHY_M - RAY_BODY_M), 0.0, 1.0)
    starts, ends, costs = [], [], []
    for r, c in _MOVES:
        here = np.s_[max(0, -r) : rows - max(0, r), max(0, -c) : cols - max(0, c)]
        there = np.s_[max(0, r) : rows - max(0, -r), max(0, c) : cols - max(0, -c)]
        both = stands[here] & stands[there]
        length = CELL_M * float(np.sqrt(float(r * r + c * c)))
        if abs(r) + abs(c) > 1:  # the way between must not cut a corner
            middle = (ground.clear[here] + ground.clear[there]) / 2.0
            both &= middle > length / 2.0 * 0.3
        starts.append(number[here][both])
        ends.append(number[there][both])
        costs.append(length * (price[here][both] + price[there][both]) / 2.0)
    return np.concatenate(starts), np.concatenate(ends), np.concatenate(costs)
