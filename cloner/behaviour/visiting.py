"""The script of each person's visits: walk there, wait for a turn, act, be done, go on; or to known places at random.

[S] A group's goals are shared by its members; at an AP of individual use one acts at a time; if no intentions are
given, the crowd's knowledge generates them at random. A place that is not known cannot be gone to.
"""

from __future__ import annotations

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.channels import SCRIPT
from cloner.behaviour.dice import Indices, purpose
from cloner.behaviour.together.flocking import all_there
from cloner.behaviour.together.following import is_following
from cloner.behaviour.world import ACTING, CALLED, DONE, WAITING, WALKING, Band, World


def visit(world: World) -> None:
    """Carry on the visits of everybody whose group follows nobody."""
    own = np.array([band.follows < 0 or not is_following(world, k) for k, band in enumerate(world.bands)])
    people = world.people
    here = world.bodies.present & own[people.band]
    ordered = world.orders.rows["goal"][SCRIPT]
    away = here & (people.phase != WALKING) & (people.phase != DONE) & (world.bodies.goal != ordered)
    _let_go(world, np.flatnonzero(away))
    there = here & world.bodies.settled & (world.bodies.goal == ordered) & (ordered >= 0)
    for one in np.flatnonzero(there & (people.phase != DONE)):
        _carry_on(world, int(one))
    _go_on(world, np.flatnonzero(here & (people.phase == DONE)))


def users(world: World, place: int) -> Indices:
    """Return who is served at a place, or was called to be."""
    people = world.people
    served = (people.phase == ACTING) | (people.phase == CALLED)
    return np.flatnonzero(world.bodies.present & served & (world.orders.rows["goal"][SCRIPT] == place))


def _carry_on(world: World, one: int) -> None:
    """Take the next step of somebody who stands where the script sent him."""
    people, number = world.people, int(world.bodies.goal[one])
    place = world.places[number]
    if people.phase[one] == WALKING:
        if place.holds and place.act:
            people.phase[one], people.until[one] = WAITING, world.time_s
        elif place.act:
            _begin(world, one)
        else:
            people.phase[one] = DONE
    elif people.phase[one] == WAITING:
        if len(users(world, number)) < place.holds and _is_next(world, one, number):
            people.phase[one] = CALLED
            if place.holds == 1:  # served at the point itself
                world.bodies.target[one], world.bodies.settled[one] = _counter(world, number), False
    elif people.phase[one] == CALLED:
        _begin(world, one)
    elif people.phase[one] == ACTING and world.time_s >= people.until[one]:
        _let_go(world, np.array([one]))
        people.phase[one] = DONE


def _is_next(world: World, one: int, place: int) -> bool:
    """Return whether nobody has waited longer."""
    people = world.people
    waiting = world.bodies.present & (people.phase == WAITING) & (world.bodies.goal == place)
    others = np.flatnonzero(waiting)
    return one == int(others[np.lexsort((others, people.until[others]))[0]])


def _counter(world: World, place: int) -> np.ndarray:
    """Return where one stands to be served: as near the point as one can stand."""
    ground, middle = world.ground, world.places[place].middle
    row, column = np.nonzero(ground.clear >= 0.2)
    at = ground.middles(row, column)
    away = at - middle
    return np.asarray(at[np.argmin(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1])])


def _begin(world: World, one: int) -> None:
    people, place = world.people, world.places[int(world.bodies.goal[one])]
    people.phase[one], people.until[one] = ACTING, world.time_s + place.seconds
    world.orders.give(SCRIPT, "posture", one, world.acts.index(place.act))
    if place.look_at >= 0:
        world.orders.give(SCRIPT, "gaze", one, place.look_at)


def _let_go(world: World, who: Indices) -> None:
    """End what people do at a place; who was called away begins anew later."""
    if len(who):
        world.orders.withdraw(SCRIPT, who, ("posture", "gaze"))
        world.people.phase[who] = WALKING


def _go_on(world: World, done: Indices) -> None:
    """Send those who are done to their next goal; a flocking group goes when all are."""
    people = world.people
    for number in np.unique(people.band[done]):
        band = world.bands[number]
        ready = done[people.band[done] == number]
        if band.group.flocking:
            if not all_there(world, world.members(int(number))):
                continue
        if band.group.outside or (band.group.wanders and not band.visits):
            continue
        for one in ready:
            goal = next_goal(world, band, int(one))
            if goal >= 0:
                world.orders.give(SCRIPT, "goal", one, goal)
                people.phase[one] = WALKING


def next_goal(world: World, band: Band, one: int) -> int:
    """Count one visit more and return its place; -1 if there is none, or it is not known."""
    people = world.people
    index = int(people.visit[one]) + 1
    if not band.visits:
        return _by_chance(world, band, one, index)
    if index >= len(band.visits):
        if not band.group.again:
            return -1
        index = 0
    if band.visits[index] not in band.knows:
        return -1
    people.visit[one] = index
    return band.visits[index]


def _by_chance(world: World, band: Band, one: int, index: int) -> int:
    """Return a known place that is not where one is; members of a flocking group have the same chance."""
    now = int(world.bodies.goal[one])
    known = [place for place in sorted(band.knows) if place != now]
    if not known or band.group.wanders:
        return -1
    chooser = band.leader if band.group.flocking else one
    share = float(dice.uniform(world.seed, purpose("visit", index), np.array([chooser]))[0])
    world.people.visit[one] = index
    return known[int(share * len(known))]
