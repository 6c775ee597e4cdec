"""Group behaviour 1, flocking: the members walk at one speed, have one goal, take ways of their own, and wait.

[S] Four rules: same speed; same goals; paths made as for everybody; who arrived waits until all of the group are there.
"""

from __future__ import annotations

import numpy as np

from cloner.behaviour.channels import SCRIPT
from cloner.behaviour.dice import Indices
from cloner.behaviour.world import DONE, World


def one_speed(world: World) -> None:
    """Rule 1: let the members of each flocking group walk as fast as they do on average."""
    for number, band in enumerate(world.bands):
        if band.group.flocking:
            members = world.members(number)
            if len(members):
                total = 0.0
                for one in members:
                    total += float(natural_speed(world, np.array([one]))[0])
                world.orders.give(SCRIPT, "speed", members, total / len(members))


def natural_speed(world: World, who: Indices) -> np.ndarray:
    """Return how fast people walk by their emotion, its value and their own pace, (m,) m/s."""
    speeds = np.array([one.speed for one in world.scenario.emotions])
    regular = next((one.speed for one in world.scenario.emotions if one.name == "regular"), float(speeds[0]))
    people = world.people
    felt = regular + people.value[who] * (speeds[people.emotion[who]] - regular)
    return np.asarray(felt * people.pace[who])


def all_there(world: World, members: Indices) -> bool:
    """Rule 4: are all members of a group done where they were sent? Until then those who are there wait."""
    return bool((world.people.phase[members] == DONE).all())
