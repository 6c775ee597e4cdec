"""The walkable world: floors without obstacles, as walls and as a raster.

Frame: metres on the floor, x to the right and y up on the plan; a scene's (x, z) are the plan's (x, y).
Plain float64 with + - * / and square roots, so that another machine makes the same tables.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.records.arrays import Array

Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

#: Side of a cell; a .75 m door, .35 m of which a body's middle can use, always holds one.
CELL_M: Final = 0.2
#: A standing body as a disc. Half of Weidmann's least room a person at 5.4 /m2 would be .22.
BODY_M: Final = 0.2
#: Rays are cast by a slimmer disc: shoulders turn in a door.
RAY_BODY_M: Final = 0.15
#: Cells that fit a machine: 2,000 m x 2,000 m would need 100 million.
LARGEST_CELLS: Final = 4_000_000
_CONTACT_M: Final = 0.55  # walls nearer to a cell's middle than this can be touched from within the cell
_SIDE_M: Final = 1e-6
_FAR_M: Final = 8.0  # nobody asks how much further a wall is than this
_HINT: Final = "Give a floor, such as: floor 0, 0 to 30, 12"


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """The walkable area.

    ``walls`` (S, 4) start and end of each wall; ``clear`` (rows, cols) distance of a cell's middle to the nearest wall,
    at most 8, negative where nobody can stand; ``near`` (rows, cols, k) places in ``walls`` of those within reach, -1
    for none. Metres.
    """

    low: Array
    walls: Array
    clear: Array
    near: Indices

    def cells(self, place: Array) -> tuple[Indices, Indices]:
        """Return row and column of the cell of each point (n, 2), clipped to the raster."""
        column = ((place[:, 0] - self.low[0]) / CELL_M).astype(np.int64)
        row = ((place[:, 1] - self.low[1]) / CELL_M).astype(np.int64)
        rows, cols = self.clear.shape
        return np.maximum(np.minimum(row, rows - 1), 0), np.maximum(np.minimum(column, cols - 1), 0)

    def middles(self, row: Indices, column: Indices) -> Array:
        """Return the centres of cells, (n, 2) metres."""
        return np.stack([self.low[0] + (column + 0.5) * CELL_M, self.low[1] + (row + 0.5) * CELL_M], axis=-1)

    def is_free(self, place: Array) -> Mask:
        """Return whether a body can stand at each point, (n,)."""
        row, column = self.cells(place)
        return np.asarray(self.clear[row, column] >= RAY_BODY_M)

    def region(self, corners: Array) -> Mask:
        """Return the free cells (rows, cols) whose centre lies in a region with corners (k, 2)."""
        row, column = np.indices(self.clear.shape)
        within = inside(self.middles(row.ravel(), column.ravel()), corners).reshape(self.clear.shape)
        return np.asarray(within & (self.clear >= RAY_BODY_M))


def rectangle(middle: Sequence[float], size: Sequence[float]) -> Array:
    """Return the corners of a rectangle, (4, 2), counter-clockwise."""
    x, y, w, h = middle[0], middle[1], size[0] / 2.0, size[1] / 2.0
    return np.array([[x - w, y - h], [x + w, y - h], [x + w, y + h], [x - w, y + h]])


def inside(place: Array, corners: Array) -> Mask:
    """Return whether points (n, 2) lie in a polygon (k, 2), (n,), by the even-odd rule."""
    odd = np.zeros(len(place), bool)
    x, y = place[:, 0], place[:, 1]
    for (ax, ay), (bx, by) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if ay == by:
            continue
        crosses = (y < ay) != (y < by)
        odd ^= crosses & (x < ax + (y - ay) / (by - ay) * (bx - ax))
    return odd


def make_ground(floors: Sequence[Array], obstacles: Sequence[Array] = ()) -> Ground:
    """Return the ground of floors (each (k, 2) corners; overlapping ones are merged) minus obstacles.

    Raises
    ------
    ClonerError
        If there is no floor, it is too large, or nobody fits anywhere.
    """
    if not floors:
        raise ClonerError("there is nothing to walk on", _HINT, "floor")
    points = np.concatenate(floors)
    low = points.min(axis=0) - CELL_M
    size = points.max(axis=0) + CELL_M - low
    cols, rows = (int(n) for n in np.ceil(size / CELL_M))
    if rows * cols > LARGEST_CELLS:
        raise ClonerError(f"a floor of {size[0]:.0f} x {size[1]:.0f} m is too large", "Make it smaller", "floor")
    walls = _walls(floors, obstacles)
    row, column = (one.ravel() for one in np.indices((rows, cols)))
    middle = np.stack([low[0] + (column + 0.5) * CELL_M, low[1] + (row + 0.5) * CELL_M], axis=1)
    away, near = _wall_distances(low, middle.reshape(rows, cols, 2), walls)
    clear = np.where(_open(middle, floors, obstacles).reshape(rows, cols), away, -away)
    if clear.max() < BODY_M:
        raise ClonerError("nobody fits between the walls", "Make the floor wider or the obstacles smaller", "floor")
    return Ground(low, walls, clear, near)


def _open(place: Array, floors: Sequence[Array], obstacles: Sequence[Array]) -> Mask:
    on = np.zeros(len(place), bool)
    for corners in floors:
        on |= inside(place, corners)
    for corners in obstacles:
        on &= ~inside(place, corners)
    return on


def _walls(floors: Sequence[Array], obstacles: Sequence[Array]) -> Array:
    """Return the edges, cut where they intersect, that have floor on one side only."""
    edges = np.concatenate([np.hstack([one, np.roll(one, -1, axis=0)]) for one in (*floors, *obstacles)])
    pieces: list[tuple[float, ...]] = []
    for ax, ay, bx, by in edges:
        cuts = sorted({0.0, 1.0, *_cuts(np.array([ax, ay]), np.array([bx, by]), edges)})
        for s, t in pairwise(cuts):
            pieces.append((ax + s * (bx - ax), ay + s * (by - ay), ax + t * (bx - ax), ay + t * (by - ay)))
    found = np.array(pieces)
    along = found[:, 2:] - found[:, :2]
    length = np.sqrt(along[:, 0] * along[:, 0] + along[:, 1] * along[:, 1])
    found, along, length = found[length > 1e-9], along[length > 1e-9], length[length > 1e-9]
    aside = np.stack([-along[:, 1], along[:, 0]], axis=1) / length[:, None] * _SIDE_M
    middle = (found[:, :2] + found[:, 2:]) / 2.0
    left, right = (_open(middle + sign * aside, floors, obstacles) for sign in (1.0, -1.0))
    return np.unique(np.asarray(found[left != right]), axis=0)


def _cuts(start: Array, end: Array, edges: Array) -> list[float]:
    """Return the parameters 0..1 at which other edges cross or touch an edge."""
    along = end - start
    first, across = edges[:, :2] - start, edges[:, 2:] - edges[:, :2]
    turn = along[0] * across[:, 1] - along[1] * across[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        own = (first[:, 0] * across[:, 1] - first[:, 1] * across[:, 0]) / turn
        other = (first[:, 0] * along[1] - first[:, 1] * along[0]) / turn
    meet = (turn != 0.0) & (own > 0.0) & (own < 1.0) & (other >= 0.0) & (other <= 1.0)
    cuts = own[meet].tolist()
    lies = (turn == 0.0) & (np.abs(first[:, 0] * along[1] - first[:, 1] * along[0]) < 1e-9)  # on the same line
    for corner in (edges[lies, :2], edges[lies, 2:]):
        share = ((corner - start) @ along) / max(float(along @ along), 1e-18)
        cuts += share[(share > 0.0) & (share < 1.0)].tolist()
    return [float(one) for one in cuts]


def _wall_distances(low: Array, middle: Array, walls: Array) -> tuple[Array, Indices]:
    """Return the distance of each cell's centre (rows, cols, 2) to the nearest wall, and the walls within reach."""
    rows, cols = middle.shape[:2]
    nearest = np.full((rows, cols), _FAR_M)
    touched: list[tuple[Indices, int]] = []
    number = np.arange(rows * cols).reshape(rows, cols)
    for k, wall in enumerate(walls):
        ends = wall.reshape(2, 2)
        first = np.maximum(((ends.min(axis=0) - _FAR_M - low) / CELL_M).astype(np.int64), 0)
        last = ((ends.max(axis=0) + _FAR_M - low) / CELL_M).astype(np.int64) + 1
        part = np.s_[first[1] : last[1], first[0] : last[0]]
        away = np.sqrt(_square_to(middle[part].reshape(-1, 2), wall)).reshape(nearest[part].shape)
        nearest[part] = np.minimum(nearest[part], away)
        touched.append((number[part][away < _CONTACT_M], k))
    count = np.zeros(rows * cols, np.int64)
    for cells, _ in touched:
        count[cells] += 1
    near = np.full((rows * cols, int(count.max(initial=0)) or 1), -1, np.int64)
    count[:] = 0
    for cells, k in touched:
        near[cells, count[cells]] = k
        count[cells] += 1
    return nearest, near.reshape(rows, cols, -1)


def _square_to(place: Array, wall: Array) -> Array:
    """Return the squared distance of points (n, 2) to a wall."""
    ax, ay, bx, by = wall
    ux, uy = bx - ax, by - ay
    dx, dy = place[:, 0] - ax, place[:, 1] - ay
    share = np.clip((dx * ux + dy * uy) / (ux * ux + uy * uy), 0.0, 1.0)
    dx, dy = dx - share * ux, dy - share * uy
    return np.asarray(dx * dx + dy * dy)
