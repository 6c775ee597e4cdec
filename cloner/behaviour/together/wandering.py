"""Group behaviour 8, safe wandering: who has no goal keeps a direction, turns before what would be met, and turns back.

[S] Collisions are predicted by the crossing of two lines, the angular velocity is changed, and after a time it and the
direction are what they were. The prediction is `steering`'s; here is the direction that it is given and returns to.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.dice import purpose
from cloner.behaviour.ground import Array, Indices, direction_bins
from cloner.behaviour.world import World

#: Largest angular velocity of a wanderer, rad/s, and how long one is kept, seconds; taste.
TURN_RAD_S: Final = 0.4
KEPT_S: Final = 4.0
#: A wall so near is turned away from, with this angular velocity.
WALL_M: Final = 1.6
WALL_RAD_S: Final = 1.5


def wander(world: World, who: Indices, seconds: float) -> Array:
    """Return the direction of each wanderer after some seconds more, (m, 2), and keep the angular velocities."""
    people = world.people
    way = people.facing[who]
    if world.steps % round(KEPT_S / seconds) == 0 or not people.turn[who].any():
        share = dice.uniform(world.seed, purpose("turn", int(world.time_s / KEPT_S)), who)
        people.turn[who] = (2.0 * share - 1.0) * TURN_RAD_S
    row, column = world.ground.cells(world.bodies.place[who])
    free = world.ground.free[row, column]
    m = np.arange(len(who))
    left, right = turned(way, 0.8), turned(way, -0.8)
    ahead = free[m, direction_bins(way[:, 0], way[:, 1])]
    room_left = free[m, direction_bins(left[:, 0], left[:, 1])]
    room_right = free[m, direction_bins(right[:, 0], right[:, 1])]
    aside = np.where(room_left >= room_right, WALL_RAD_S, -WALL_RAD_S)
    return turned(way, np.where(ahead < WALL_M, aside, people.turn[who]) * seconds)


def turned(way: Array, angle: Array | float) -> Array:
    """Return unit directions turned by small angles, radians, without a sine: by half their tangent."""
    half = np.asarray(angle) / 2.0
    square = half * half
    cosine, sine = (1.0 - square) / (1.0 + square), 2.0 * half / (1.0 + square)
    found = np.stack([cosine * way[:, 0] - sine * way[:, 1], sine * way[:, 0] + cosine * way[:, 1]], axis=1)
    length = np.sqrt(found[:, 0] * found[:, 0] + found[:, 1] * found[:, 1])
    return np.asarray(found / np.maximum(length, 1e-9)[:, None])
