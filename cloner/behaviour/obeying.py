"""Execute what was selected: orders become goals with spots, speeds, postures and gazes, then the core moves feet."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.dice import purpose
from cloner.behaviour.ground import Indices
from cloner.behaviour.together.adaptability import give_spots
from cloner.behaviour.together.flocking import natural_speed
from cloner.behaviour.together.guests import keep
from cloner.behaviour.walking import NOWHERE, STEP_S, walk
from cloner.behaviour.world import World

#: An idle act is kept so long, seconds.
IDLE_S: Final = 8.0


def obey(world: World) -> None:
    """Execute the orders for one step of `STEP_S`."""
    _take_goals(world)
    bodies, people, orders = world.bodies, world.people, world.orders
    bodies.avoids[:] = orders.chosen("avoidance") != 0
    ordered = orders.chosen("speed")
    bodies.wants[:] = np.where(ordered >= 0.0, ordered, natural_speed(world, np.arange(len(ordered))))
    if any(group.wanders for group in world.scenario.groups):
        bodies.wanders[:] = np.array([band.group.wanders for band in world.bands])[people.band]
    people.gaze = orders.chosen("gaze")
    bodies.looks[:] = people.gaze >= 0
    bodies.look[bodies.looks] = world.things[people.gaze[bodies.looks]]
    walk(bodies)
    keep(world)
    _pose(world)
    gone = bodies.present & people.leaving & bodies.settled
    bodies.present &= ~gone


def _take_goals(world: World) -> None:
    """Give those whose goal is new a spot there."""
    people, bodies = world.people, world.bodies
    goal = world.orders.chosen("goal")
    fresh = np.flatnonzero((goal != bodies.goal) & bodies.present)
    bodies.goal[fresh] = goal[fresh]
    for band, place in sorted({(int(people.band[one]), int(goal[one])) for one in fresh if goal[one] >= 0}):
        who = fresh[(people.band[fresh] == band) & (goal[fresh] == place)]
        world.lead_to(place)
        bodies.target[who] = give_spots(world, who, place)
        bodies.settled[who], bodies.direct[who], bodies.slow[who] = False, False, 0
    nowhere = fresh[goal[fresh] == NOWHERE]
    bodies.settled[nowhere] = True
    bodies.target[nowhere] = bodies.place[nowhere]


def _pose(world: World) -> None:
    """Choose what everybody does: an order, else walking or running, else an idle act of the emotion's."""
    people, bodies = world.people, world.bodies
    ordered = world.orders.chosen("posture")
    square = bodies.velocity[:, 0] * bodies.velocity[:, 0] + bodies.velocity[:, 1] * bodies.velocity[:, 1]
    moves = (square > 0.04) & (bodies.way != 0.0).any(axis=1)  # who steps aside goes on with what he does
    runs = square > 4.0
    if world.steps % round(IDLE_S / STEP_S) == 1:
        _idle(world, np.arange(len(moves)))
    idle = np.where(people.idle >= 0, people.idle, 0)
    people.posture = np.where(moves, np.where(runs, 2, 1), np.where(ordered >= 0, ordered, idle))


def _idle(world: World, who: Indices) -> None:
    """Choose an idle act for everybody from the range of the emotion."""
    share = dice.uniform(world.seed, purpose("idle", int(world.time_s / IDLE_S)), who)
    for number, emotion in enumerate(world.scenario.emotions):
        acts = np.array([world.acts.index(one) for one in emotion.acts])
        some = who[world.people.emotion[who] == number]
        world.people.idle[some] = acts[(share[some] * len(acts)).astype(np.int64)]
