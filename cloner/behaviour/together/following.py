"""Group behaviour 2, following: a group takes another's goals, for ever or for times chosen at random."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.channels import SCRIPT
from cloner.behaviour.dice import purpose
from cloner.behaviour.perceiving import Seen
from cloner.behaviour.world import DONE, World

#: Periods of following at times, seconds; taste.
PERIOD_S: Final = (10.0, 40.0)


def follow(world: World, seen: Seen) -> None:
    """Give the members of each following group the goal that the followed group's leader had."""
    for number, band in enumerate(world.bands):
        if band.follows < 0:
            continue
        if world.time_s >= band.follows_until:
            band.follows = -1
            members = world.members(number)
            world.orders.withdraw(SCRIPT, members, ("goal",))
            world.people.phase[members] = DONE
            continue
        if band.follows_at_times and not at_this_time(world, number):
            continue
        leaders = [other.leader for other in world.bands if other.home == band.follows]
        leaders = [one for one in leaders if world.bodies.present[one] and seen.goal[one] >= 0]
        if leaders:
            members = world.members(number)
            goal = int(seen.goal[leaders[0]])
            band.knows.add(goal)
            world.orders.give(SCRIPT, "goal", members, goal)


def at_this_time(world: World, number: int) -> bool:
    """Return whether a group that follows at times does so now: periods follow each other, by turns, from the first."""
    begin, count = 0.0, 0
    while True:
        share = float(dice.uniform(world.seed, purpose("following", count), np.array([number]))[0])
        begin += PERIOD_S[0] + share * (PERIOD_S[1] - PERIOD_S[0])
        if begin > world.time_s:
            return count % 2 == 0
        count += 1


def is_following(world: World, number: int) -> bool:
    """Return whether a group has its goals from another one now."""
    band = world.bands[number]
    return band.follows >= 0 and (not band.follows_at_times or at_this_time(world, number))
