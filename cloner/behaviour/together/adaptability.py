"""Group behaviour 7, space adaptability: a group that adapts uses the whole region, in as many parts as it has people.

[S] Without it only a small part near the goal is used. Everybody gets a spot, so no two ways end the same.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.dice import purpose
from cloner.behaviour.fields import region_cells
from cloner.behaviour.ground import BODY_M, CELL_M, Indices, Mask
from cloner.behaviour.world import Place, World
from cloner.records.arrays import Array

#: Two spots are no nearer than this.
APART_M: Final = 0.6


def give_spots(world: World, who: Indices, place: int) -> Array:
    """Return a spot in a place's region for each of some people of one group, (m, 2)."""
    people, point = world.people, world.places[place]
    adapts = world.bands[int(people.band[who[0]])].group.adapts
    free = _free_spots(world, point, place, who)
    if adapts:
        chosen = _spread(world, free, who, place)
    else:
        away = free - point.middle
        chosen = free[np.argsort(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1], kind="stable")[: len(who)]]
    if len(chosen) < len(who):  # more people than spots: they stand as near as they can
        every = _spots(world, point)
        more = dice.uniform(world.seed, purpose("crowded", place), who[len(chosen) :])
        chosen = np.concatenate([chosen, every[(more * len(every)).astype(np.int64)]])
    mixed = dice.order(world.seed, purpose("whose", place), np.arange(len(who)))
    return np.asarray(chosen[mixed])


def _spread(world: World, free: Array, who: Indices, place: int) -> Array:
    """Return as many spots as people, all over a region: one at random, then always the furthest from those taken."""
    if not len(free):
        return free
    at = int(dice.uniform(world.seed, purpose("spot", place), who[:1])[0] * len(free))
    chosen, nearest = [at], np.full(len(free), np.inf)
    while len(chosen) < min(len(who), len(free)):
        dx, dy = free[:, 0] - free[chosen[-1], 0], free[:, 1] - free[chosen[-1], 1]
        nearest = np.minimum(nearest, dx * dx + dy * dy)
        chosen.append(int(np.argmax(nearest)))
    return np.asarray(free[chosen])


def _spots(world: World, point: Place) -> Array:
    """Return where one can stand in a region, `APART_M` apart, (k, 2)."""
    every = round(APART_M / CELL_M)
    if every not in point.spots:
        row, column = np.nonzero(region_cells(world.ground, point.corners) & (world.ground.clear >= BODY_M))
        if not len(row):
            row, column = np.nonzero(region_cells(world.ground, point.corners))
        thin = ((row - row.min()) % every == 0) & ((column - column.min()) % every == 0)
        point.spots[every] = world.ground.middles(row[thin], column[thin])
    return point.spots[every]


def _free_spots(world: World, point: Place, place: int, who: Indices) -> Array:
    """Return the spots of a region at which nobody else stands or goes."""
    spots, bodies = _spots(world, point), world.bodies
    others = bodies.present & (bodies.goal == place)
    others[who] = False
    taken = bodies.target[others]
    if not len(taken):
        return spots
    return spots[~blocked(spots, taken)]


def blocked(spots: Array, taken: Array) -> Mask:
    """Return of spots on a lattice of `APART_M`, (k, 2), which have a taken place (m, 2) within half of it, (k,)."""
    low = spots.min(axis=0)
    table = np.full(((spots.max(axis=0) - low) / APART_M + 1.5).astype(np.int64), -1)
    column, row = np.round((spots - low) / APART_M).astype(np.int64).T
    table[column, row] = np.arange(len(spots))
    corner = np.floor((taken - low) / APART_M).astype(np.int64)
    blocked = np.zeros(len(spots), bool)
    for step in ((0, 0), (0, 1), (1, 0), (1, 1)):
        at = corner + step
        on = ((at >= 0) & (at < table.shape)).all(axis=1)
        number = table[at[on, 0], at[on, 1]]
        dx, dy = (spots[number] - taken[on]).T
        blocked[number[(number >= 0) & (dx * dx + dy * dy <= 0.25 * APART_M * APART_M)]] = True
    return blocked
