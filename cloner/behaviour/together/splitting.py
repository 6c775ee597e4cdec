"""Group behaviour 6, split: members chosen at random get new intentions and are groups of their own."""

from __future__ import annotations

from collections import deque
from dataclasses import replace

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.channels import SCRIPT
from cloner.behaviour.dice import Indices, purpose
from cloner.behaviour.world import DONE, World, leader_of


def split(world: World, number: int, into: int) -> list[int]:
    """Split a group into so many, each of a random size, and return the new ones; the first part stays as it is."""
    members = world.members(number)
    into = min(into, len(members))
    if into < 2:
        return []
    mixed = dice.order(world.seed, purpose("split", world.steps), members)
    mixed = np.concatenate([mixed[mixed == world.bands[number].leader], mixed[mixed != world.bands[number].leader]])
    places = np.arange(1, len(members))
    cuts = np.sort(dice.order(world.seed, purpose("cuts", world.steps), places)[: into - 1])
    parts = np.split(mixed, cuts)
    made = [_new_band(world, number, np.sort(part)) for part in parts[1:]]
    world.say(f"{world.bands[number].group.name} splits into {', '.join(str(len(part)) for part in parts)}")
    return made


def _new_band(world: World, number: int, members: Indices) -> int:
    """Make a group of some members: it knows what the old one knew and goes to other places first."""
    old = world.bands[number]
    leader = leader_of(old.group, members, world.people, world.seed)
    known = np.array(sorted(set(old.visits) or old.knows), np.int64)
    now = int(world.bodies.goal[old.leader])
    order = known[np.argsort(dice.uniform(world.seed, purpose("intention", leader), known), kind="stable")]
    visits = [int(one) for one in order if one != now] + [int(one) for one in order if one == now]
    fresh = replace(old, leader=leader, visits=visits, knows=set(old.knows), memory=deque(old.memory, old.group.memory),
                    follows=-1, likes=dict(old.likes), acted=set(old.acted))  # fmt: skip
    world.bands.append(fresh)
    people = world.people
    people.band[members], people.visit[members], people.phase[members] = len(world.bands) - 1, -1, DONE
    world.orders.withdraw(SCRIPT, members, ("goal", "speed", "posture", "gaze"))
    return len(world.bands) - 1
