"""A running scenario: its ground and tables in the engine's memory, and its state by name.

Everything that moves is in the engine (`core/`): Python lays out the beginning, passes orders on, and looks.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.core.host import CrowdEngine
from cloner.behaviour.dice import purpose_number
from cloner.behaviour.feet import IDLE, WALK, Feet
from cloner.behaviour.ground import BODY_M, CELL_M, Ground, Indices, Mask, make_ground
from cloner.behaviour.inhabitants import initial_bands, initial_people
from cloner.behaviour.model import Action, Scenario
from cloner.behaviour.tables import Names, Tables, collect_names, make_tables
from cloner.behaviour.walking import STEP_S, Bodies, engine_bodies
from cloner.errors import ClonerError
from cloner.records.arrays import Array

#: Who may order whom: the later one wins ([S]: guided before reaction before script before what is innate).
LEVELS: Final = ("innate", "script", "reaction", "guided")
#: What can be ordered: a place, m/s, an act, a thing to look at, 0 or 1; -1 says that nothing is.
CHANNELS: Final = ("goal", "speed", "posture", "gaze", "avoidance")


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """A destination: its centre (2,), and the cells (rows, cols) of its region."""

    name: str
    middle: Array
    region: Mask


@dataclass(frozen=True, slots=True)
class Band:
    """The present state of one group's mind.

    ``home`` is its place in the scenario's groups; ``leader`` a person; ``visits`` its goals in turn; ``knows`` the
    places it knows; ``memory`` what its leader perceived last: (time, name); ``follows`` a home, or -1.
    """

    home: int
    leader: int
    visits: list[int]
    knows: set[int]
    memory: list[tuple[float, str]]
    follows: int


@dataclass(frozen=True, slots=True, eq=False)
class People:
    """The state of each person's mind, one row each, in the engine's own memory; feet are in `walking.Bodies`."""

    band: Indices
    home: Indices
    emotion: Indices
    value: Array
    vigour: Array
    domination: Array
    phase: Indices
    until: Array
    posture: Indices
    gaze: Indices


@dataclass(slots=True, eq=False)
class World:
    """A running scenario. ``seed`` decides all that is random; ``steps`` of `STEP_S` have been made.

    ``orders`` holds of each of `CHANNELS` what each of `LEVELS` orders everybody, (4, n); ``told`` what happened;
    ``guided`` orders from outside that wait for the next step. ``log`` is all that came from outside, in turn: before
    which step, what of the engine was called, and with which values; who does the same goes the same steps.
    """

    scenario: Scenario
    seed: int
    ground: Ground
    bodies: Bodies
    people: People
    names: Names
    places: list[Place]
    orders: dict[str, Array]
    steps: int = 0
    told: list[tuple[float, str]] = field(default_factory=list)
    guided: deque[Action] = field(default_factory=deque)
    log: list[tuple[int, str, tuple[Any, ...]]] = field(default_factory=list)

    @property
    def core(self) -> CrowdEngine:
        """The engine."""
        return self.bodies.core

    @property
    def time_s(self) -> float:
        """Seconds since the beginning."""
        return self.steps * STEP_S

    @property
    def acts(self) -> list[str]:
        """Names of postures."""
        return self.names.acts

    @property
    def bands(self) -> list[Band]:
        """All groups' minds."""
        arrays, found = self.core.arrays, []
        names = [*self.names.things, *self.names.points]
        for k in range(int(arrays["numbers"][1])):
            memory = zip(arrays["memory_time"][k], arrays["memory_name"][k], strict=True)
            found.append(Band(
                int(arrays["band_home"][k]), int(arrays["leader"][k]),
                arrays["visits"][k, : arrays["visit_count"][k]].tolist(),
                set(np.flatnonzero(arrays["knows"][k]).tolist()),
                [(float(when), names[what]) for when, what in list(memory)[: arrays["memory_count"][k]]],
                int(arrays["follows"][k]),
            ))  # fmt: skip
        return found

    def hear(self, name: str, *values: float) -> Any:
        """Report an outside event to the engine, and log it."""
        self.log.append((self.steps, name, values))
        return self.core.call(name, *values)

    def members(self, band: int) -> Indices:
        """Return the people of a group who are there."""
        return np.flatnonzero((self.people.band == band) & self.bodies.present)

    def of_home(self, home: int) -> Indices:
        """Return the people of all groups that originate from one of the scenario's."""
        homes = self.core.arrays["band_home"][self.people.band]
        return np.flatnonzero((homes == home) & self.bodies.present)

    def distances(self, place: int) -> Array:
        """Return the walking distance (rows, cols) of each cell from a place's region, metres; inf if unreachable."""
        self.core.call("lead", place)
        return np.array(self.core.arrays["distance"])


def make_world(scenario: Scenario, seed: int = 0, feet: Feet | None = None) -> World:
    """Return the initial world of a valid scenario; with feet it reports footings too (`feet.take_footings`).

    Raises
    ------
    ClonerError
        If a point cannot be stood at or reached, or the people do not fit.
    """
    ground = make_ground([np.array(one.corners) for one in scenario.floors],
                       [np.array(one.corners) for one in scenario.obstacles])  # fmt: skip
    names = collect_names(scenario, feet.still if feet else ())
    tables = make_tables(scenario, names, ground)
    for point, region in zip(scenario.points, tables["regions"], strict=True):
        if not region.any():
            raise ClonerError(f"nobody can stand at {point.name}", "Move its region onto the floor", point.name)
    count = scenario.people()
    people = initial_people(scenario, seed, count)
    bands = initial_bands(scenario, names, people, seed)
    counts = _counts(ground, tables | people | bands, count)
    if feet:
        counts |= {**feet.counts(), "acts": len(names.acts)}
    core = CrowdEngine(counts, _xy(ground.low), seed=seed)
    bodies = engine_bodies(core, ground, np.zeros((count, 2)))
    for name, rows in (tables | people | bands).items():
        core.arrays[name][: len(rows)] = rows
    core.arrays["ends"][:] = np.inf
    core.arrays["orders"][:] = -1.0
    core.arrays["orders"][CHANNELS.index("avoidance"), 0] = 1.0
    regular = names.emotions.index("regular") if "regular" in names.emotions else 0
    core.arrays["numbers"][:] = 0, len(bands["leader"]), regular, 0
    if feet:
        acts, walks = names.acts, [one.walk for one in scenario.emotions]
        feet.fill(core, [feet.still.get(one, IDLE) for one in acts], [feet.walks.get(one, WALK) for one in walks])
    places = [Place(one.name, np.array(one.at), region)
              for one, region in zip(scenario.points, tables["regions"], strict=True)]  # fmt: skip
    own = People(**{name: core.arrays[name] for name in People.__slots__})
    orders = dict(zip(CHANNELS, core.arrays["orders"], strict=True))
    world = World(scenario, seed, ground, bodies, own, names, places, orders)
    bodies.place[:] = bodies.target[:] = _starting_places(world)
    bodies.spotted[:] = True
    bodies.present[:] = ~np.array([group.outside for group in scenario.groups])[own.home]
    angle = dice.uniform(seed, purpose_number("facing"), np.arange(count))
    bodies.facing[:, 0] = 2.0 * angle - 1.0
    bodies.facing[:, 1] = np.where(angle < 0.5, 1.0, -1.0) * np.sqrt(1.0 - (2.0 * angle - 1.0) ** 2)
    return world


def _xy(place: Array) -> tuple[float, float]:
    return float(place[0]), float(place[1])


def _counts(ground: Ground, tables: Tables, people: int) -> dict[str, int]:
    """Return the sizes of all tables; splitting can make as many groups as there are people."""
    rows, cols, reach = ground.near.shape
    places, things = len(tables["place_middle"]), len(tables["thing_place"])
    bands, longest = tables["visits"].shape
    events = tables["rule_rows"][:, 3][tables["rule_rows"][:, 0] == 1]
    return {
        "people": people, "rows": rows, "cols": cols, "walls": len(ground.walls), "reach": reach, "places": places,
        "homes": len(tables["home_flags"]), "bands": bands + people, "visits": longest,
        "memory": min(int(tables["home_memory"].max()), places + things), "things": things,
        "emotions": len(tables["speed"]), "likes": len(tables["likes"]), "idle_acts": len(tables["idle_acts"]),
        "rules": len(tables["rule_rows"]), "actions": len(tables["action_rows"]),
        "events": int(events.max(initial=-1)) + 1, "spots": len(tables["spots"]), "lattice": len(tables["lattice"]),
    }  # fmt: skip


def _starting_places(world: World) -> Array:
    """Return each person's starting point: in the requested region, else anywhere, without duplicates."""
    scenario, ground, seed = world.scenario, world.ground, world.seed
    wide = int(np.ceil(2.5 * BODY_M / CELL_M))
    stands = ground.clear >= BODY_M
    stands &= (np.indices(stands.shape) % wide == 0).all(axis=0)
    taken = np.zeros_like(stands)
    found = np.zeros((len(world.people.home), 2))
    for number, group in enumerate(scenario.groups):
        members = np.flatnonzero(world.people.home == number)
        free = stands & ~taken
        if group.starts_at:
            wanted = world.names.points.index(group.starts_at)
            free = _nearest_cells(world.distances(wanted), free, len(members))
        row, column = np.nonzero(free)
        if len(row) < len(members):
            raise ClonerError(f"{group.people} people of {group.name} do not fit", "Make the floor larger", group.name)
        pick = dice.shuffled(seed, purpose_number("begin", number), np.arange(len(row)))[: len(members)]
        found[members] = ground.middles(row[pick], column[pick])
        taken[row[pick], column[pick]] = True
    return found


def _nearest_cells(distance: Array, free: Mask, count: int) -> Mask:
    """Return the cells of a place's region, and as many around it as are needed, given their distances."""
    distance = np.where(free, distance, np.inf)
    enough = np.sort(distance.ravel())[min(count, distance.size) - 1]
    return np.asarray(np.isfinite(distance) & (distance <= max(float(enough), 0.0)))
