"""What each group perceives, through its leader's eyes, before anybody acts: a picture of the world as it was.

[S] Perception is the leader's; memory keeps what he perceived, as much as it holds; what is perceived becomes known.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.behaviour.ground import Indices, Mask
from cloner.behaviour.world import World
from cloner.records.arrays import Array

#: How far a leader sees a person or a thing; taste: across a room.
SIGHT_M: Final = 15.0
#: Nearer than this one notices what is behind one.
FEELS_M: Final = 1.5
#: A thing is seen although its own plinth stands there.
_PLINTH_M: Final = 1.0
_LEARNS_EVERY: Final = 20  # steps: a second


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """The world as it was before anybody selected: behaviours read this, never each other's new orders.

    ``things`` (g, t) which things each leader sees; ``place``, ``goal``, ``emotion`` of
    everybody.
    """

    things: Mask
    place: Array
    goal: Indices
    emotion: Indices


def perceive(world: World) -> Seen:
    """Return what is seen, and let every group remember and learn from it."""
    leaders = np.array([band.leader for band in world.bands])
    place = world.bodies.place
    things = np.zeros((len(leaders), len(world.things)), bool)
    present = world.bodies.present[leaders]
    for k, thing in enumerate(world.things):
        things[:, k] = present & sees_place(world, leaders, np.repeat(thing[None], len(leaders), axis=0))
    seen = Seen(things, place.copy(), world.bodies.goal.astype(np.int64), world.people.emotion.copy())
    _remember(world, seen)
    if world.steps % _LEARNS_EVERY == 0:
        _learn(world, leaders)
    return seen


def sees_place(world: World, who: Indices, place: Array) -> Mask:
    """Return whether each of some people sees a place of its own, (m,): before them, near enough, no wall between."""
    start, facing = world.bodies.place[who], world.bodies.facing[who]
    away = place - start
    far = np.sqrt(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1])
    before = (away[:, 0] * facing[:, 0] + away[:, 1] * facing[:, 1] > 0.0) | (far < FEELS_M)
    found = np.asarray(before & (far < SIGHT_M))
    some = np.flatnonzero(found)
    if len(some):
        share = np.maximum(far[some] - _PLINTH_M, 0.0) / np.maximum(far[some], 1e-9)
        found[some] = world.ground.sees(start[some], start[some] + share[:, None] * away[some])
    return found


def sees_anybody(world: World, leader: int, others: Indices) -> bool:
    """Return whether a leader sees one of some people; the nearest eight in sight are looked at."""
    others = others[others != leader]
    away = world.bodies.place[others] - world.bodies.place[leader]
    square = away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1]
    near = others[np.argsort(square, kind="stable")[:8]]
    return bool(len(near)) and bool(sees_place(world, np.full(len(near), leader), world.bodies.place[near]).any())


def _remember(world: World, seen: Seen) -> None:
    names = [one.name for one in world.scenario.things]
    for number, thing in np.argwhere(seen.things):
        memory = world.bands[number].memory
        if names[thing] not in {name for _, name in memory}:
            memory.append((world.time_s, names[thing]))


def _learn(world: World, leaders: Indices) -> None:
    """Let groups know the places their leaders see."""
    for number, place in enumerate(world.places):
        some = np.array([k for k, band in enumerate(world.bands) if number not in band.knows], np.int64)
        if not len(some):
            continue
        for k in some[sees_place(world, leaders[some], np.repeat(place.middle[None], len(some), axis=0))]:
            world.bands[k].knows.add(number)
            world.bands[k].memory.append((world.time_s, place.name))
