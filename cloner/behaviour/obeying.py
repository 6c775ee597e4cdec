"""Execute what was selected: orders become goals with spots, directions, speeds, postures and gazes, then feet move."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.curves import along_curves, begin_curves
from cloner.behaviour.dice import purpose
from cloner.behaviour.fields import region_cells
from cloner.behaviour.ground import AHEAD_M, RAY_BODY_M, Array, Indices, Mask
from cloner.behaviour.together.adaptability import give_spots
from cloner.behaviour.together.flocking import natural_speed
from cloner.behaviour.together.wandering import turned, wander
from cloner.behaviour.walking import STEP_S, walk
from cloner.behaviour.world import Place, World

#: Who is so near to the own spot has arrived; who was pushed further goes back, metres.
THERE_M, AWAY_M = 0.12, 0.5
#: One slows down when the spot is nearer than one walks in this time, seconds: three times `RELAX_S`
#: stops without overshoot.
SLOWING_S: Final = 1.5
#: Who stands in a crowd within the region for so long, and has his spot so near, has arrived too. Without the second
#: people stop where a region begins and shut the door before it (museum, 3 seeds of 20).
STUCK_S, CLOSE_M = 2.0, 1.5
STILL_M_S: Final = 0.1
#: How far one sees a spot to walk straight to it, and how often one looks, in steps.
STRAIGHT_M: Final = 12.0
LOOKS_EVERY: Final = 10
#: Angular velocity of a body that walks or stands, rad/s: half a turn in a second (issue 25: a point is faced in 1 s).
TURNS_RAD_S: Final = 3.2
#: An idle act is kept so long, seconds.
IDLE_S: Final = 8.0


def obey(world: World) -> None:
    """Execute the orders for one step of `STEP_S`."""
    _take_goals(world)
    _arrive(world)
    bodies, people, orders = world.bodies, world.people, world.orders
    bodies.avoids[:] = orders.chosen("avoidance") != 0
    ordered = orders.chosen("speed")
    everybody = np.arange(len(people.goal))
    speed = np.where(ordered >= 0.0, ordered, natural_speed(world, everybody))
    away = people.target - bodies.place
    far = np.sqrt(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1])
    going = (people.goal >= 0) & ~people.settled
    bodies.own_speed[:] = np.where(going, np.minimum(speed, np.maximum(far / SLOWING_S, 0.2)), speed)
    bodies.way[:] = _ways(world, going, away, far)
    bodies.ahead[:] = np.where(going & people.direct, np.clip(far, 0.5, AHEAD_M), AHEAD_M)
    walk(bodies, world.ground)
    _turn(world)
    _pose(world, speed)
    gone = bodies.present & people.leaving & people.settled
    bodies.present &= ~gone


def _take_goals(world: World) -> None:
    """Give those whose goal is new a spot there."""
    people = world.people
    goal = world.orders.chosen("goal")
    fresh = np.flatnonzero((goal != people.goal) & world.bodies.present)
    people.goal[fresh] = goal[fresh]
    for band, place in sorted({(int(people.band[one]), int(goal[one])) for one in fresh if goal[one] >= 0}):
        who = fresh[(people.band[fresh] == band) & (goal[fresh] == place)]
        people.target[who] = give_spots(world, who, place)
        people.settled[who], people.direct[who], people.slow_steps[who] = False, False, 0
    nowhere = fresh[goal[fresh] < 0]
    people.settled[nowhere] = True
    people.target[nowhere] = world.bodies.place[nowhere]


def _arrive(world: World) -> None:
    """Let those who reached their spot, or cannot get nearer, stand; and those who were pushed away walk again."""
    people, bodies = world.people, world.bodies
    away = people.target - bodies.place
    square = away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1]
    going = (people.goal >= 0) & bodies.present
    people.settled |= going & (square < THERE_M * THERE_M)
    people.settled &= ~(going & (square > AWAY_M * AWAY_M))
    pace = bodies.velocity[:, 0] * bodies.velocity[:, 0] + bodies.velocity[:, 1] * bodies.velocity[:, 1]
    slow = going & ~people.settled & (pace < STILL_M_S * STILL_M_S) & (square < CLOSE_M * CLOSE_M)
    people.slow_steps = np.where(slow, people.slow_steps + 1, 0)
    for one in np.flatnonzero(people.slow_steps > STUCK_S / STEP_S):
        place = world.places[int(people.goal[one])]
        row, column = world.ground.cells(bodies.place[one : one + 1])
        if inside_region(world, place)[row[0], column[0]]:
            people.target[one], people.settled[one] = bodies.place[one], True


def inside_region(world: World, place: Place) -> Mask:
    """Return the cells of a place's region in which one can stand, (rows, cols), found once."""
    if place.cells is None:
        place.cells = region_cells(world.ground, place.corners)
    return place.cells


def _ways(world: World, going: Mask, away: Array, far: Array) -> Array:
    """Return the direction each wants to walk: to a spot in sight by a curve, else by the field; or as wanderers do."""
    people, bodies = world.people, world.bodies
    way = np.zeros_like(away)
    looks = np.flatnonzero(going & ((np.arange(len(going)) + world.steps) % LOOKS_EVERY == 0))
    if len(looks):
        near = far[looks] < STRAIGHT_M
        before = people.direct.copy()
        people.direct[looks] = False
        some = looks[near]
        people.direct[some] = world.ground.sees(bodies.place[some], people.target[some], RAY_BODY_M)
        begin_curves(world, some[people.direct[some] & ~before[some]])
    straight = np.flatnonzero(going & people.direct)
    way[straight] = along_curves(world, straight)
    row, column = world.ground.cells(bodies.place)
    for place in np.unique(people.goal[going & ~people.direct]):
        who = np.flatnonzero(going & ~people.direct & (people.goal == place))
        way[who] = world.way_to(int(place))[row[who], column[who]]
        inside = who[(way[who] == 0.0).all(axis=1)]  # in the region already: the spot is straight ahead
        way[inside] = away[inside] / np.maximum(far[inside], 1e-9)[:, None]
    wanderers = np.flatnonzero(_wanders(world) & (people.goal < 0) & bodies.present)
    if len(wanderers):
        way[wanderers] = wander(world, wanderers, STEP_S)
    return way


def _wanders(world: World) -> Mask:
    return np.array([band.group.wanders for band in world.bands])[world.people.band]


def _turn(world: World) -> None:
    """Turn bodies into the direction they walk, or, while they stand, to what they look at."""
    people, bodies = world.people, world.bodies
    people.gaze = world.orders.chosen("gaze")
    velocity = bodies.velocity
    pace = np.sqrt(velocity[:, 0] * velocity[:, 0] + velocity[:, 1] * velocity[:, 1])
    wanted = np.where((pace > 0.2)[:, None], velocity, 0.0)
    looks = np.flatnonzero((pace <= 0.2) & (people.gaze >= 0))
    wanted[looks] = world.things[people.gaze[looks]] - bodies.place[looks]
    length = np.sqrt(wanted[:, 0] * wanted[:, 0] + wanted[:, 1] * wanted[:, 1])
    some = np.flatnonzero(length > 0.0)
    unit, facing = wanted[some] / length[some, None], people.facing[some]
    step = TURNS_RAD_S * STEP_S
    cross = facing[:, 0] * unit[:, 1] - facing[:, 1] * unit[:, 0]
    dot = facing[:, 0] * unit[:, 0] + facing[:, 1] * unit[:, 1]
    near = (dot > 0.0) & (np.abs(cross) < step)
    people.facing[some] = np.where(near[:, None], unit, turned(facing, np.where(cross >= 0.0, step, -step)))


def _pose(world: World, speed: Array) -> None:
    """Choose what everybody does: an order, else walking or running, else an idle act of the emotion's."""
    people, bodies = world.people, world.bodies
    ordered = world.orders.chosen("posture")
    square = bodies.velocity[:, 0] * bodies.velocity[:, 0] + bodies.velocity[:, 1] * bodies.velocity[:, 1]
    moves, runs = square > 0.04, square > 4.0
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
