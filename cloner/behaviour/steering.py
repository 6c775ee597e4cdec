"""Which way and how fast to walk next: look along a fan of headings, take the one that leads nearest to the goal.

The source's safe wandering made precise: where would the lines of my next places and the others' cross; turn away, and
back when the way is free. The goal direction is always the fan's middle, so the previous heading returns by itself.

References
----------
Moussaid, Helbing, Theraulaz 2011, How simple rules determine pedestrian behavior and crowd disasters, PNAS 108(17).
Raupp Musse, Thalmann 2001 (ViCrowd), group behaviour 8. Measures in ``docs/behaviour_benchmark.md``.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from cloner.behaviour.ground import AHEAD_M, Array, Ground, Indices, Mask, direction_bins
from cloner.behaviour.nearby import wrapped

#: Headings on each side of the goal's, out to 75 degrees: the paper's field of vision, its steps halved.
_SIDES: Final = 12
_TAN_HALF: Final = 0.7673269879789604  # tan(37.5 degrees), so that the fan needs no sine
#: Seconds in which one could still stop: the paper has .5, .65 fits Weidmann better.
STOP_S: Final = 0.65
#: People are taken to walk half as they do and half as they want to: who stands but comes my way is avoided, who stands
#: but goes my way is followed. Lanes form by it (``docs/behaviour_benchmark.md``, two streams).
INTENT: Final = 0.5
#: Two who pass each other turn their shoulders; .8 of two radii is .32 m.
SHOULDERS: Final = 0.8
#: Nobody stands quite still before one who comes the other way, nearer than so: one edges past.
EDGING_M_S, EDGING_M = 0.3, 1.0
#: Square of the cosine of 45 degrees: others further aside are beside one. At 60 degrees a .75 m door jams at times.
BESIDE: Final = 0.5
_FEW: Final = 2  # headings between two looks at who needs no more of them


def _fan() -> list[tuple[float, float]]:
    """Return cosine and sine of each heading: ahead, then right before left, growing."""
    fan = [(1.0, 0.0)]
    for k in range(1, _SIDES + 1):
        t = k / _SIDES * _TAN_HALF
        cosine, sine = (1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)
        fan += [(cosine, -sine), (cosine, sine)]
    return fan


FAN: Final = _fan()


@dataclass(frozen=True, slots=True, eq=False)
class Others:
    """Of each person the others: (n, k) relative place, expected velocity, least distance, there, and passing."""

    x: Array
    y: Array
    vx: Array
    vy: Array
    reach: Array
    there: Mask
    passing: Mask

    def of(self, who: Indices | Mask) -> Others:
        """Return the same of some people."""
        return Others(self.x[who], self.y[who], self.vx[who], self.vy[who], self.reach[who], self.there[who],
                      self.passing[who])  # fmt: skip


def others_of(
    place: Array, velocity: Array, wish: Array, radius: Array, near: Indices, who: Indices, period_m: float = 0.0
) -> Others:
    """Return the others of some people from the table of the nearest, (m, 16); ``wish`` is the velocity each wants."""
    table = near[who]
    x, y = place[table, 0] - place[who, :1], place[table, 1] - place[who, 1:]
    if period_m:
        x = wrapped(x, period_m)
    expected = velocity + INTENT * (wish - velocity)
    passing = passes(wish, table, who)
    reach = (radius[table] + radius[who, None]) * np.where(passing, SHOULDERS, 1.0)
    return Others(x, y, expected[table, 0], expected[table, 1], reach, table >= 0, passing)


def passes(wish: Array, table: Indices, who: Indices) -> Mask:
    """Return which of the others want to go the other way, (m, k)."""
    return np.asarray(wish[table, 0] * wish[who, :1] + wish[table, 1] * wish[who, 1:] < 0.0)


def choose(
    ground: Ground, place: Array, way: Array, own_speed: Array, ahead: Array, others: Others
) -> tuple[Array, Array]:
    """Return the heading (n, 2) and speed (n,) each person chooses.

    Parameters
    ----------
    ground : Ground
    place : (n, 2) metres
    way : (n, 2)
        Unit direction to the goal.
    own_speed : (n,) m/s
        How fast each would like to walk.
    ahead : (n,) metres
        How far each looks: `AHEAD_M`, or to the goal; a wall behind the goal turns nobody.
    others : Others
        Of the same people; who is behind is not seen.
    """
    speed = np.maximum(own_speed, 0.05)
    seen = others.there & (others.x * way[:, :1] + others.y * way[:, 1:] > 0.0)
    row, column = ground.cells(place)
    count = len(place)
    best, chosen = np.full(count, np.inf), np.zeros(count, np.int64)
    rest = np.arange(count)
    part, free = _lines(_reachable(others, seen, speed), speed), ground.free[row, column]
    here = way, speed, ahead
    for k, (cosine, sine) in enumerate(FAN):
        wx, wy = here[0][:, 0], here[0][:, 1]
        ex, ey = cosine * wx - sine * wy, sine * wx + cosine * wy
        far = np.minimum(free[np.arange(len(rest)), direction_bins(ex, ey)], _meeting(ex, ey, here[1], part))
        far = np.minimum(far, here[2])
        away = here[2] * here[2] + far * far - 2.0 * cosine * here[2] * far
        better = away < best[rest]
        best[rest[better]], chosen[rest[better]] = away[better], k
        if k % _FEW == 0 and k + 1 < len(FAN):
            least = (
                here[2] * here[2] * (FAN[k + 1][1] * FAN[k + 1][1])
            )  # the best that any heading further out can give
            on = best[rest] > least
            if not on.any():
                break
            rest, free, part = rest[on], free[on], part.of(on)
            here = here[0][on], here[1][on], here[2][on]
    turn = np.array(FAN)[chosen]
    heading = np.stack(
        [turn[:, 0] * way[:, 0] - turn[:, 1] * way[:, 1], turn[:, 1] * way[:, 0] + turn[:, 0] * way[:, 1]], axis=1
    )
    wall = ground.free[row, column, direction_bins(heading[:, 0], heading[:, 1])]
    gap = np.minimum(wall, _gap(heading[:, 0], heading[:, 1], others))
    square = others.x * others.x + others.y * others.y
    edges = (seen & others.passing & (square < EDGING_M * EDGING_M)).any(axis=1)
    return heading, np.minimum(own_speed, np.maximum(gap / STOP_S, np.where(edges, EDGING_M_S, 0.0)))


def _reachable(others: Others, seen: Mask, speed: Array) -> Others:
    """Return the others less those who cannot be met within the look-ahead, in as few columns as they need."""
    pace = np.sqrt(others.vx * others.vx + others.vy * others.vy)
    room = np.sqrt(others.x * others.x + others.y * others.y) - others.reach
    meets = seen & (room < AHEAD_M + pace * (AHEAD_M / speed)[:, None])
    columns = int(meets.sum(axis=1).max(initial=0))
    if columns < meets.shape[1]:
        first = np.argsort(~meets, axis=1, kind="stable")[:, : max(columns, 1)]
        x, y, vx, vy, reach = (
            np.take_along_axis(one, first, axis=1) for one in (others.x, others.y, others.vx, others.vy, others.reach)
        )
        meets, passing = (np.take_along_axis(one, first, axis=1) for one in (meets, others.passing))
        return Others(x, y, vx, vy, reach, meets, passing)
    return replace(others, there=meets)


@dataclass(frozen=True, slots=True, eq=False)
class _Lines:
    """What the crossings of one's lines with the others' need at every heading: squares and products, (m, k)."""

    x: Array
    y: Array
    vx: Array
    vy: Array
    along: Array
    square: Array
    room: Array
    away: Mask

    def of(self, who: Mask) -> _Lines:
        """Return the same of some people."""
        return _Lines(*(getattr(self, name)[who] for name in self.__slots__))


def _lines(others: Others, speed: Array) -> _Lines:
    """Return what is needed for people of some speeds, (m,) m/s."""
    x, y, vx, vy = others.x, others.y, others.vx, others.vy
    square = vx * vx + vy * vy + (speed * speed)[:, None]
    return _Lines(x, y, vx, vy, x * vx + y * vy, square, x * x + y * y - others.reach * others.reach, ~others.there)


def _meeting(ex: Array, ey: Array, speed: Array, lines: _Lines) -> Array:
    """Return how far one gets in a direction at one's own speed before meeting anybody who walks on, (n,) metres."""
    sx, sy = (speed * ex)[:, None], (speed * ey)[:, None]
    a = lines.square - 2.0 * (sx * lines.vx + sy * lines.vy)
    b = sx * lines.x + sy * lines.y - lines.along
    root = b * b - a * lines.room
    misses = lines.away | (b <= 0.0) | (root <= 0.0)
    np.maximum(root, 0.0, out=root)
    np.sqrt(root, out=root)
    np.subtract(b, root, out=b)
    np.maximum(b, 0.0, out=b)
    np.maximum(a, 1e-9, out=a)
    b /= a
    b[misses] = np.inf
    return np.asarray(np.minimum(b.min(axis=1) * speed, AHEAD_M))


def _gap(ex: Array, ey: Array, others: Others) -> Array:
    """Return how far one gets in a direction before touching anybody who would stand still, (n,) metres.

    Who is more beside than before one does not stop one: of two in a door the first goes.
    """
    b = others.x * ex[:, None] + others.y * ey[:, None]
    square = others.x * others.x + others.y * others.y
    root = b * b - square + others.reach * others.reach
    meets = others.there & (b > 0.0) & (b * b > BESIDE * square) & (root > 0.0)
    far = np.where(meets, np.maximum(b - np.sqrt(np.maximum(root, 0.0)), 0.0), np.inf)
    return np.asarray(np.minimum(far.min(axis=1), AHEAD_M))
