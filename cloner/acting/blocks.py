"""A scenario's obstacles as plain blocks, with heights by taste since a plan has none.

What holds a thing is its plinth, what is slim a pillar, all else is as high as a counter; a thing is a slim block.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.model import XY
from cloner.records.arrays import Array

#: Heights of what a plan leaves open: a plinth, a pillar that is cut off to see over it, a counter, other things,
#: metres (taste).
PLINTH_M, PILLAR_M, COUNTER_M, THING_M = 0.5, 3.0, 1.0, 1.8
#: A pillar is not wider than this, metres; a thing has this side.
SLIM_M: Final = 1.2
THING_SIDE_M: Final = 0.45


def obstacle_blocks(obstacles: Sequence[Sequence[XY]], things: Sequence[XY]) -> NDArray[np.float32]:
    """Return (3 T, 6) triangles' corners and normals of all blocks, metres, in the page's frame."""
    found: list[Array] = []
    shapes = [np.array(one, np.float64) for one in obstacles]
    for corners in shapes:
        holds = any(_inside(corners, thing) for thing in things)
        slim = np.ptp(corners, axis=0).max() <= SLIM_M
        found.append(_block(corners, 0.0, PLINTH_M if holds else PILLAR_M if slim else COUNTER_M))
    for thing in things:
        low = PLINTH_M if any(_inside(corners, thing) for corners in shapes) else 0.0
        half = THING_SIDE_M / 2.0
        box = np.array(thing) + half * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        found.append(_block(box, low, low + THING_M))
    return np.concatenate([np.zeros((0, 6)), *found]).astype(np.float32)


def _inside(corners: Array, place: XY) -> bool:
    """Return whether a point lies in a polygon, by the even-odd rule."""
    x, y = place
    first, last = corners, np.roll(corners, -1, axis=0)
    crosses = (first[:, 1] > y) != (last[:, 1] > y)
    rise = np.where(crosses, last[:, 1] - first[:, 1], 1.0)
    at = first[:, 0] + (y - first[:, 1]) / rise * (last[:, 0] - first[:, 0])
    return bool((crosses & (at > x)).sum() % 2)


def _block(corners: Array, low: float, high: float) -> Array:
    """Return (3 T, 6) the walls and the top of an upright block."""
    if _area(corners) < 0.0:
        corners = corners[::-1]
    found = []
    for one, other in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        way = other - one
        normal = np.array([way[1], 0.0, way[0]]) / max(float(np.hypot(*way)), 1e-9)
        quad = [_raised(one, low), _raised(other, low), _raised(other, high), _raised(one, high)]
        found += [np.hstack([quad[k], normal]) for k in (0, 1, 2, 0, 2, 3)]
    for triangle in _ears(corners):
        found += [np.hstack([_raised(corners[k], high), (0.0, 1.0, 0.0)]) for k in triangle]
    return np.array(found)


def _raised(place: Array, height: float) -> Array:
    return np.array([place[0], height, -place[1]])


def _area(corners: Array) -> float:
    """Return a polygon's area, negative where its corners go clockwise."""
    x, y = corners.T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2.0)


def _ears(corners: Array) -> list[tuple[int, int, int]]:
    """Return the triangles of a polygon with counter-clockwise corners, by ear clipping."""
    left, found = list(range(len(corners))), []
    while len(left) > 3:
        for k in range(len(left)):
            ear = (left[k - 1], left[k], left[(k + 1) % len(left)])
            others = [one for one in left if one not in ear]
            inside = any(_inside(corners[list(ear)], (corners[one][0], corners[one][1])) for one in others)
            if _area(corners[list(ear)]) > 0.0 and not inside:
                break
        else:  # crossing sides: whatever is left is told by its first corners
            break
        found.append(ear)
        left.pop(k)
    return [*found, (left[0], left[1], left[2])]
