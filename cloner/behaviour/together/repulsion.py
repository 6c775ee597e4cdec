"""Group behaviour 5, repulsion: while a region is cleared, goals in it become goals outside; then all are free."""

from __future__ import annotations

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.channels import REACTION
from cloner.behaviour.dice import purpose
from cloner.behaviour.ground import inside
from cloner.behaviour.perceiving import Seen
from cloner.behaviour.world import World


def repel(world: World, seen: Seen) -> None:
    """Send whoever is in a cleared region, or goes there, to a point outside it that was chosen at random."""
    over = [one for one in world.cleared if one[1] <= world.time_s]
    world.cleared = [one for one in world.cleared if one[1] > world.time_s]
    for place, _ in over:
        world.orders.withdraw(REACTION, _kept_away(world), ("goal",))
        world.say(f"{world.places[place].name} is free again")
    for place, _ in world.cleared:
        outside = _outside(world, place)
        if not len(outside):
            continue
        goal = world.orders.chosen("goal")
        unfit = (goal == place) | (np.isin(goal, outside, invert=True) & (goal >= 0))
        unfit |= inside(seen.place, world.places[place].corners) & ~np.isin(goal, outside)
        who = np.flatnonzero(unfit & world.bodies.present)
        if len(who):
            pick = dice.uniform(world.seed, purpose("away", place), who)
            world.orders.give(REACTION, "goal", who, outside[(pick * len(outside)).astype(np.int64)])


def _outside(world: World, place: int) -> np.ndarray:
    """Return the places whose region does not meet a place's."""
    low, high = world.places[place].corners.min(axis=0), world.places[place].corners.max(axis=0)
    fit = [k for k, one in enumerate(world.places)
           if (one.corners.max(axis=0) < low).any() or (one.corners.min(axis=0) > high).any()]  # fmt: skip
    return np.array(fit, np.int64)


def _kept_away(world: World) -> np.ndarray:
    return np.flatnonzero(world.orders.rows["goal"][REACTION] >= 0)
