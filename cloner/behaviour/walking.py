"""One step of everybody's feet: heading and speed by `steering`, then bodies apart from each other and from walls.

Fixed steps of .05 s. Half of the people choose anew in each step: nobody mirrors the one who comes towards them.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from cloner.behaviour.ground import AHEAD_M, Array, Ground, Indices, Mask
from cloner.behaviour.nearby import nearest, wrapped
from cloner.behaviour.steering import SHOULDERS, choose, others_of, passes

STEP_S: Final = 0.05
#: Time in which a person comes to the speed that was chosen; Helbing, Molnar 1995 have .5 s.
RELAX_S: Final = 0.5
#: The table of neighbours is kept so many steps, in which two people come .55 m nearer at most.
NEIGHBOURS_KEPT: Final = 4
#: Share of an overlap that both bodies make good in a step; less than half each keeps a jam from trembling.
_APART: Final = 0.4
_TOUCHING: Final = 8  # neighbours that can touch a body of .2 m at once


@dataclass(slots=True, eq=False)
class Bodies:
    """Where everybody is and wants to go; all arrays have a row a person.

    ``place, velocity`` (n, 2) m, m/s; ``radius`` m; ``way`` (n, 2) unit direction to the goal, zero to stand;
    ``own_speed`` m/s; ``ahead`` how far one looks, m; ``avoids`` whether collisions are avoided; ``present``
    whether the person is in the world.
    """

    place: Array
    velocity: Array
    radius: Array
    way: Array
    own_speed: Array
    avoids: Mask
    present: Mask
    heading: Array = field(init=False)
    pace: Array = field(init=False)
    near: Indices = field(init=False)
    ahead: Array = field(init=False)
    steps: int = 0

    def __post_init__(self) -> None:
        self.heading = self.way.copy()
        self.pace = np.zeros(len(self.place))
        self.ahead = np.full(len(self.place), AHEAD_M)
        self.near = np.zeros((0, 0), np.int64)


def walk(bodies: Bodies, ground: Ground, *, period_m: float = 0.0) -> None:
    """Move everybody by one step of `STEP_S`."""
    here = np.flatnonzero(bodies.present)
    if len(here) == 0:
        bodies.steps += 1
        return
    if bodies.steps % NEIGHBOURS_KEPT == 0 or len(bodies.near) != len(here):
        bodies.near = nearest(bodies.place[here], bodies.velocity[here], period_m=period_m)
    place, velocity, radius = bodies.place[here], bodies.velocity[here], bodies.radius[here]
    turn = np.flatnonzero((here + bodies.steps) % 2 == 0)
    if len(turn):
        _choose(bodies, ground, here, turn, period_m)
    wanted = bodies.heading[here] * bodies.pace[here, None]
    velocity = velocity + (wanted - velocity) * (STEP_S / RELAX_S)
    before = place
    place = place + velocity * STEP_S
    wish = bodies.way[here] * bodies.own_speed[here, None]
    place = _apart(place, wish, radius, bodies.near, period_m)
    place = _off_walls(place, radius, ground)
    moved = (place - before) / STEP_S
    slower = moved[:, 0] * velocity[:, 0] + moved[:, 1] * velocity[:, 1]
    square = velocity[:, 0] * velocity[:, 0] + velocity[:, 1] * velocity[:, 1]
    share = np.clip(slower / np.maximum(square, 1e-9), 0.0, 1.0)
    bodies.velocity[here] = velocity * share[:, None]
    if period_m:
        place[:, 0] = place[:, 0] - period_m * np.floor(place[:, 0] / period_m)
    bodies.place[here] = place
    bodies.steps += 1


def _choose(bodies: Bodies, ground: Ground, here: Indices, turn: Indices, period_m: float) -> None:
    """Let those whose turn it is choose heading and pace."""
    who = here[turn]
    place, velocity, radius = bodies.place[here], bodies.velocity[here], bodies.radius[here]
    wish = bodies.way[here] * bodies.own_speed[here, None]
    others = others_of(place, velocity, wish, radius, bodies.near, turn, period_m)
    others.there[~bodies.avoids[who]] = False
    way, speed = bodies.way[who], bodies.own_speed[who]
    heading, pace = choose(ground, bodies.place[who], way, speed, bodies.ahead[who], others)
    stands = (way[:, 0] == 0.0) & (way[:, 1] == 0.0)
    bodies.heading[who] = np.where(stands[:, None], 0.0, heading)
    bodies.pace[who] = np.where(stands, 0.0, pace)


def _apart(place: Array, wish: Array, radius: Array, near: Indices, period_m: float) -> Array:
    """Return the places after bodies that overlap have moved apart, all at once; sums in the order of neighbours."""
    table = near[:, :_TOUCHING]
    dx, dy = place[:, :1] - place[table, 0], place[:, 1:] - place[table, 1]
    if period_m:
        dx = wrapped(dx, period_m)
    away = np.sqrt(dx * dx + dy * dy)
    passing = passes(wish, table, np.arange(len(place)))
    over = (radius[:, None] + radius[table]) * np.where(passing, SHOULDERS, 1.0) - away
    over[(table < 0) | (over < 0.0)] = 0.0
    if not over.any():
        return place
    share = _APART * over / np.maximum(away, 1e-6)
    push = np.zeros_like(place)
    for k in range(table.shape[1]):
        push[:, 0] = push[:, 0] + share[:, k] * dx[:, k]
        push[:, 1] = push[:, 1] + share[:, k] * dy[:, k]
    return place + push


def _off_walls(place: Array, radius: Array, ground: Ground) -> Array:
    """Return the places after every body that touches a wall was moved off it, wall after wall."""
    row, column = ground.cells(place)
    near = ground.near[row, column]
    who = np.flatnonzero(near[:, 0] >= 0)
    if not len(who):
        return place
    place = place.copy()
    for k in range(near.shape[1]):
        who = who[near[who, k] >= 0]
        if not len(who):
            break
        ax, ay, bx, by = ground.walls[near[who, k]].T
        ux, uy = bx - ax, by - ay
        dx, dy = place[who, 0] - ax, place[who, 1] - ay
        share = np.clip((dx * ux + dy * uy) / (ux * ux + uy * uy), 0.0, 1.0)
        dx, dy = dx - share * ux, dy - share * uy
        away = np.sqrt(dx * dx + dy * dy)
        over = np.maximum(radius[who] - away, 0.0) / np.maximum(away, 1e-6)
        place[who, 0] = place[who, 0] + over * dx
        place[who, 1] = place[who, 1] + over * dy
    return place
