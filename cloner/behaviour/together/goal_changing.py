"""Group behaviour 3, goal changing: who likes another group better joins it; who dominates most leads, elsewhere."""

from __future__ import annotations

from collections import deque
from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.channels import SCRIPT
from cloner.behaviour.dice import Indices, purpose
from cloner.behaviour.perceiving import Seen
from cloner.behaviour.world import DONE, WALKING, World
from cloner.records.arrays import Array

#: How much everybody likes the own group.
OWN_LIKING: Final = 0.5
#: A group that is so near can be joined, metres; taste.
NEAR_M: Final = 5.0


def change(world: World, seen: Seen) -> None:
    """Let people change group by liking, then groups change leader by domination."""
    for number, band in enumerate(world.bands):
        if not band.likes:
            continue
        for home in sorted(band.likes, key=lambda one: (-band.likes[one], one)):
            if band.likes[home] > OWN_LIKING and home != band.home:
                _join_near(world, number, home, seen.place)
    for number, band in enumerate(world.bands):
        if band.group.leader == "emerging":
            members = world.members(number)
            if len(members):
                first = int(members[np.argmax(world.people.domination[members])])
                if first != band.leader:
                    lead(world, number, first)


def _join_near(world: World, number: int, home: int, place: Array) -> None:
    """Let each member who is near the leader of a better liked group join it."""
    for one in world.members(number):
        for other, band in enumerate(world.bands):
            if band.home != home or other == number or not world.bodies.present[band.leader]:
                continue
            dx, dy = place[band.leader] - place[one]
            if dx * dx + dy * dy < NEAR_M * NEAR_M:
                join(world, np.array([one]), other)
                break


def join(world: World, who: Indices, number: int) -> None:
    """Let people leave their group, take another's goals from where it is now, and lead nobody."""
    people, left = world.people, {int(one) for one in world.people.band[who]}
    leader = world.bands[number].leader
    people.band[who], people.visit[who], people.phase[who] = number, people.visit[leader], WALKING
    world.orders.withdraw(SCRIPT, who, ("goal", "speed", "posture", "gaze"))
    goal = int(world.orders.rows["goal"][SCRIPT, leader])
    if goal >= 0:
        world.orders.give(SCRIPT, "goal", who, goal)
    else:
        people.phase[who] = DONE
    world.say(f"{len(who)} joined {world.bands[number].group.name}")
    for old in left:
        members = world.members(old)
        if len(members) and world.bands[old].leader not in members:
            world.bands[old].leader = int(members[np.argmax(world.people.domination[members])])


def lead(world: World, number: int, person: int) -> None:
    """Let somebody lead a group: he takes it through the goals in an order of his own."""
    band = world.bands[number]
    band.leader = person
    rest = np.array(band.visits, np.int64)
    keys = dice.uniform(world.seed, purpose("taste", person), rest)
    band.visits = [int(one) for one in rest[np.argsort(keys, kind="stable")]]
    members = world.members(number)
    world.people.visit[members], world.people.phase[members] = -1, DONE
    world.orders.withdraw(SCRIPT, members, ("goal",))
    band.memory = deque(maxlen=band.group.memory)
    world.say(f"{band.group.name} has another leader")
