"""Everything that is true in a running scenario: ground, places, things, people, groups' minds and orders."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour import dice, fields
from cloner.behaviour.channels import Orders
from cloner.behaviour.dice import purpose
from cloner.behaviour.ground import BODY_M, CELL_M, Ground, Indices, Mask, box, ground_of
from cloner.behaviour.model import Action, Group, Scenario
from cloner.behaviour.walking import STEP_S, Bodies, bodies_on
from cloner.errors import ClonerError
from cloner.records.arrays import Array

#: Weidmann's spread of walking speeds over their mean, .26 / 1.34; nobody further than two of it.
SPREAD: Final = 0.194
#: What everybody can do; points and emotions add to it.
ACTS: Final = ("stand", "walk", "run")
WALKING, WAITING, CALLED, ACTING, DONE = range(5)


@dataclass(slots=True, eq=False)
class Guest:
    """Somebody from outside: where his body is, where it is to be, and unit direction of where he looks; (2,) each."""

    at: Array
    wanted: Array
    facing: Array


@dataclass(slots=True, eq=False)
class Place:
    """Where one can go: its middle, corners (k, 2), act, how many it holds (0: any number), whether ways are known."""

    name: str
    middle: Array
    corners: Array
    act: str = ""
    seconds: float = 0.0
    holds: int = 0
    look_at: int = -1
    led: bool = False
    spots: dict[int, Array] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class Band:
    """One group's mind.

    ``home`` is its place in the scenario's groups; ``leader`` a person; ``visits`` its goals in turn; ``knows`` the
    places it knows; ``memory`` what its leader perceived last: (time, name); ``likes`` its liking of other groups.
    """

    home: int
    leader: int
    group: Group
    visits: list[int]
    knows: set[int]
    memory: deque[tuple[float, str]]
    follows: int = -1
    follows_until: float = np.inf
    follows_at_times: bool = False
    likes: dict[int, float] = field(default_factory=dict)
    acted: set[int] = field(default_factory=set)


@dataclass(slots=True, eq=False)
class People:
    """What is true of each person, a row each; feet are in `walking.Bodies`."""

    band: Indices
    home: Indices
    emotion: Indices
    value: Array
    pace: Array
    domination: Array
    visit: Indices
    phase: Indices
    until: Array
    leaving: Mask
    posture: Indices
    gaze: Indices
    idle: Indices


@dataclass(slots=True, eq=False)
class World:
    """A running scenario. ``seed`` decides all that is random; ``steps`` of `STEP_S` have been made."""

    scenario: Scenario
    seed: int
    ground: Ground
    bodies: Bodies
    people: People
    orders: Orders
    bands: list[Band]
    places: list[Place]
    things: Array
    awake: Mask
    acts: list[str]
    steps: int = 0
    events: set[str] = field(default_factory=set)
    guided: list[Action] = field(default_factory=list)
    cleared: list[tuple[int, float]] = field(default_factory=list)
    fired: set[int] = field(default_factory=set)
    expiring: list[tuple[float, int, NDArray[np.int64], tuple[str, ...]]] = field(default_factory=list)
    told: list[tuple[float, str]] = field(default_factory=list)
    guests: dict[int, Guest] = field(default_factory=dict)

    @property
    def time_s(self) -> float:
        """Seconds since the beginning."""
        return self.steps * STEP_S

    def members(self, band: int) -> Indices:
        """Return the people of a group who are there."""
        return np.flatnonzero((self.people.band == band) & self.bodies.present)

    def of_home(self, home: int) -> Indices:
        """Return the people of all groups that come from one of the scenario's."""
        bands = [k for k, band in enumerate(self.bands) if band.home == home]
        return np.flatnonzero(np.isin(self.people.band, bands) & self.bodies.present)

    def lead_to(self, place: int) -> None:
        """Tell the core the ways to a place, found when somebody first goes there."""
        one = self.places[place]
        if not one.led:
            distance = fields.distances(self.ground, one.corners)
            self.bodies.lead(place, distance, fields.region_cells(self.ground, one.corners))
            one.led = True

    def say(self, text: str) -> None:
        """Keep what happened."""
        self.told.append((self.time_s, text))


def world_of(scenario: Scenario, seed: int = 0) -> World:
    """Return the world of a checked scenario at its beginning.

    Raises
    ------
    ClonerError
        If a point cannot be stood at or reached, or the people do not fit.
    """
    ground = ground_of([np.array(one.corners) for one in scenario.floors],
                       [np.array(one.corners) for one in scenario.obstacles])  # fmt: skip
    names = [one.name for one in scenario.things]
    places = [
        Place(
            p.name,
            np.array(p.at),
            box(p.at, p.size),
            p.act,
            p.seconds,
            p.holds,
            names.index(p.look_at) if p.look_at else -1,
        )
        for p in scenario.points
    ]
    for place in places:
        if not fields.region_cells(ground, place.corners).any():
            raise ClonerError(f"nobody can stand at {place.name}", "Move its region onto the floor", place.name)
    count = scenario.people()
    people = _people(scenario, seed, count)
    bands = _bands(scenario, people, [place.name for place in places], seed)
    begin = _begin_at(scenario, ground, places, people, seed)
    bodies = bodies_on(ground, begin, places=len(places), seed=seed)
    bodies.spotted[:] = True
    bodies.present[:] = ~np.array([group.outside for group in scenario.groups])[people.home]
    angle = dice.uniform(seed, purpose("facing"), np.arange(count))
    bodies.facing[:, 0] = 2.0 * angle - 1.0
    bodies.facing[:, 1] = np.where(angle < 0.5, 1.0, -1.0) * np.sqrt(1.0 - (2.0 * angle - 1.0) ** 2)
    things = np.array([one.at for one in scenario.things], np.float64).reshape(-1, 2)
    acts = list(dict.fromkeys([*ACTS, *(p.act for p in scenario.points if p.act),
                               *(act for e in scenario.emotions for act in e.acts)]))  # fmt: skip
    return World(
        scenario, seed, ground, bodies, people, Orders(count), bands, places, things, np.zeros(len(things), bool), acts
    )


def _people(scenario: Scenario, seed: int, count: int) -> People:
    who = np.arange(count)
    sizes = [(home, 1 if group.alone else group.people, group.people if group.alone else 1)
             for home, group in enumerate(scenario.groups)]  # fmt: skip
    members = [(home, size) for home, size, times in sizes for _ in range(times)]
    band = np.repeat(np.arange(len(members)), [size for _, size in members])
    home = np.repeat([h for h, _ in members], [size for _, size in members])
    pace = np.clip(1.0 + SPREAD * dice.normal(seed, purpose("pace"), who), 1.0 - 2 * SPREAD, 1.0 + 2 * SPREAD)
    return People(
        band=band,
        home=home,
        emotion=_emotions(scenario, home, seed),
        pace=pace,
        value=0.6 + 0.4 * dice.uniform(seed, purpose("value"), who),
        domination=dice.uniform(seed, purpose("domination"), who),
        visit=np.full(count, -1),
        phase=np.full(count, DONE),
        until=np.zeros(count),
        leaving=np.zeros(count, bool),
        posture=np.zeros(count, np.int64),
        gaze=np.full(count, -1),
        idle=np.zeros(count, np.int64),
    )


def _emotions(scenario: Scenario, home: Indices, seed: int) -> Indices:
    """Return what each feels: of each group so many percent, to one person exactly, as said; the others another."""
    names = [one.name for one in scenario.emotions]
    found = np.zeros(len(home), np.int64)
    for number, group in enumerate(scenario.groups):
        main = names.index(group.feelings.emotion)
        members = dice.order(seed, purpose("feeling", number), np.flatnonzero(home == number))
        most = int(len(members) * group.feelings.percent / 100.0 + 0.5)
        others = [k for k, name in enumerate(names) if k != main and name != "afraid"]
        found[members[:most]] = main
        rest = members[most:]
        if len(rest) and others:
            pick = dice.uniform(seed, purpose("other feeling", number), rest)
            found[rest] = np.array(others)[(pick * len(others)).astype(np.int64)]
    return found


def _bands(scenario: Scenario, people: People, names: list[str], seed: int) -> list[Band]:
    homes = [one.name for one in scenario.groups]
    bands = []
    for number in range(int(people.band.max()) + 1):
        members = np.flatnonzero(people.band == number)
        home = int(people.home[members[0]])
        group = scenario.groups[home]
        knows = {names.index(one) for one in (group.knows if group.knows is not None else names)}
        band = Band(
            home,
            leader_of(group, members, people, seed),
            group,
            [names.index(one) for one in group.visits],
            knows,
            deque(maxlen=group.memory),
            likes={homes.index(name): value for name, value in group.likes},
        )
        if group.follows:
            band.follows, band.follows_at_times = homes.index(group.follows.group), group.follows.at_times
            band.follows_until = group.follows.seconds or np.inf
        bands.append(band)
    return bands


def leader_of(group: Group, members: Indices, people: People, seed: int) -> int:
    """Return who leads: the highest domination if leaders emerge, one at random, or, if named, the first."""
    if group.leader == "emerging":
        return int(members[np.argmax(people.domination[members])])
    if group.leader == "random":
        return int(dice.order(seed, purpose("leader"), members)[0])
    return int(members[0])


def _begin_at(scenario: Scenario, ground: Ground, places: list[Place], people: People, seed: int) -> Array:
    """Return where each person begins: in the region asked for, else anywhere, no two on one spot."""
    wide = int(np.ceil(2.5 * BODY_M / CELL_M))
    stands = ground.clear >= BODY_M
    stands &= (np.indices(stands.shape) % wide == 0).all(axis=0)
    taken = np.zeros_like(stands)
    found = np.zeros((len(people.home), 2))
    for number, group in enumerate(scenario.groups):
        members = np.flatnonzero(people.home == number)
        free = stands & ~taken
        if group.starts_at:
            wanted = next(place for place in places if place.name == group.starts_at)
            free = _nearest_cells(ground, free, wanted, len(members))
        row, column = np.nonzero(free)
        if len(row) < len(members):
            raise ClonerError(f"{group.people} people of {group.name} do not fit", "Make the floor larger", group.name)
        pick = dice.order(seed, purpose("begin", number), np.arange(len(row)))[: len(members)]
        found[members] = ground.middles(row[pick], column[pick])
        taken[row[pick], column[pick]] = True
    return found


def _nearest_cells(ground: Ground, free: Mask, place: Place, count: int) -> Mask:
    """Return the cells of a place's region, and as many around it as are needed."""
    distance = np.where(free, fields.distances(ground, place.corners), np.inf)
    enough = np.sort(distance.ravel())[min(count, distance.size) - 1]
    return np.asarray(np.isfinite(distance) & (distance <= max(float(enough), 0.0)))
