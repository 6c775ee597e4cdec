"""A scenario as numeric tables for the engine (`core/minds/state.ts`)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.ground import BODY_M, CELL_M, Ground, Mask, rectangle
from cloner.behaviour.model import Action, Group, Scenario, When, Who
from cloner.records.arrays import Array

#: What everybody can do; points, emotions and rules add to it.
ACTS: Final = ("stand", "walk", "run")
#: Flags of groups, who leads them, verbs, whom orders are for, phases of a visit, kinds of rules: the engine's numbers.
FLAGS: Final = ("flocking", "adapts", "wanders", "again", "outside")
LEADS: Final = ("random", "emerging")
VERBS: Final = ("become", "go", "run", "leave", "gather", "follow", "look", "act", "free", "ignore", "heed", "awaken",
                "sleep", "clear", "split", "event")  # fmt: skip
WHO: Final = ("everybody", "they", "name")
PHASES: Final = ("walking", "waiting", "called", "acting", "done")
KINDS: Final = ("at", "event", "sees", "sees group", "sees feeling", "is", "reaches")
#: Two spots of a place are so far apart, metres (core/minds/adaptability.ts): room for a body, and to turn.
APART_M: Final = 0.6
#: Who likes another group more than the own joins it.
OWN_LIKING: Final = 0.5
#: One is served where a body can stand, as near the point as that is.
_SERVED_M: Final = BODY_M

Tables = dict[str, NDArray[Any]]


@dataclass(frozen=True, slots=True)
class Names:
    """The names behind the numbers in a scenario's tables; ``acts`` and ``events`` grow with new orders."""

    groups: list[str]
    points: list[str]
    things: list[str]
    emotions: list[str]
    acts: list[str]
    events: list[str]

    def row_of(self, action: Action) -> tuple[int, int, int, int, int]:
        """Return an action as a row: verb, who, whose, what, count."""
        verb = VERBS.index(action.verb)
        if action.verb in {"awaken", "sleep"}:
            return verb, 0, self.things.index(action.who.name), -1, 0
        what = -1
        if action.verb in {"act", "event"}:
            known = self.acts if action.verb == "act" else self.events
            if action.what not in known:
                known.append(str(action.what))
            what = known.index(action.what)
        elif action.what:
            lists = {"become": self.emotions, "follow": self.groups, "look": self.things}
            what = lists.get(action.verb, self.points).index(action.what)
        return verb, *self._whose(action.who), what, action.count

    def condition(self, when: When) -> tuple[int, int, int, int, int]:
        """Return a rule's condition as the first numbers of its row: kind, who, whose, what, whether awake."""
        kind, what = when.kind, -1
        if kind == "event":
            what = self.events.index(when.what)
        elif kind == "sees" and when.what in self.things:
            what = self.things.index(when.what)
        elif kind == "sees":
            kind, what = "sees group", self.groups.index(when.what)
        elif kind == "reaches":
            what = self.points.index(when.what)
        elif kind != "at":
            what = self.emotions.index(when.what)
        return KINDS.index(kind), *self._whose(when.who), what, int(when.awake)

    def _whose(self, who: Who) -> tuple[int, int]:
        """Return the number of a group's name; a name that belongs to no group stands for nobody."""
        home = self.groups.index(who.name) if who.name in self.groups else -1
        return WHO.index(who.kind), home


def collect_names(scenario: Scenario, more_acts: Iterable[str] = ()) -> Names:
    """Return the names of a scenario; its actors may know more acts, which orders can name."""
    orders = [one for rule in scenario.rules for one in rule.actions]
    events = [one.what for one in orders if one.verb == "event"]
    acts = [*ACTS, *(p.act for p in scenario.points if p.act), *(act for e in scenario.emotions for act in e.acts),
            *(one.what for one in orders if one.verb == "act"), *more_acts]  # fmt: skip
    return Names(
        [str(one.name) for one in scenario.groups],
        [str(one.name) for one in scenario.points],
        [str(one.name) for one in scenario.things],
        [str(one.name) for one in scenario.emotions],
        list(dict.fromkeys(map(str, acts))),
        list(dict.fromkeys(map(str, [*events, *(r.when.what for r in scenario.rules if r.when.kind == "event")]))),
    )


def make_tables(scenario: Scenario, names: Names, ground: Ground) -> Tables:
    """Return the tables of a scenario by the engine's names (`core.host.ARRAYS`).

    Raises
    ------
    ValueError
        Nothing that `checking.checked` lets pass.
    """
    return _groups(scenario, names) | _feelings(scenario, names) | _places(scenario, names, ground) | _rules(
        scenario, names)  # fmt: skip


def _groups(scenario: Scenario, names: Names) -> Tables:
    likes: list[list[int]] = []
    for home, group in enumerate(scenario.groups):
        liked = [(-much, names.groups.index(other)) for other, much in dict(group.likes).items() if much > OWN_LIKING]
        likes.append([other for _, other in sorted(liked) if other != home])
    return {
        "home_flags": np.array([_flags(one) for one in scenario.groups]),
        "home_leads": np.array([_leads(one) for one in scenario.groups]),
        "home_memory": np.array([one.memory for one in scenario.groups]).clip(0, 2**31 - 1),
        "likes_first": _offsets(likes),
        "likes": np.array([one for own in likes for one in own], np.int64),
    }


def _flags(group: Group) -> int:
    return sum(1 << k for k, name in enumerate(FLAGS) if getattr(group, name))


def _leads(group: Group) -> int:
    """Return the kind of leader: random, emerging, or, by a name, the first."""
    return LEADS.index(group.leader) if group.leader in LEADS else len(LEADS)


def _feelings(scenario: Scenario, names: Names) -> Tables:
    acts = [[names.acts.index(act) for act in one.acts or ACTS[:1]] for one in scenario.emotions]
    return {
        "thing_place": np.array([one.at for one in scenario.things], np.float64).reshape(-1, 2),
        "speed": np.array([one.speed for one in scenario.emotions]),
        "idle_first": _offsets(acts),
        "idle_acts": np.array([one for own in acts for one in own], np.int64),
    }


def _places(scenario: Scenario, names: Names, ground: Ground) -> Tables:
    points = scenario.points
    corners = [rectangle(one.at, one.size) for one in points]
    regions = [ground.region(one) for one in corners]
    spots = [_standing_places(ground, one) for one in regions]
    middles = np.array([one.at for one in points], np.float64).reshape(-1, 2)
    lattices = [_lattice(one) for one in spots]
    nearest = [_by_distance(one, middle) for one, middle in zip(spots, middles, strict=True)]
    return {
        "regions": np.array(regions).reshape(len(points), *ground.clear.shape),
        "place_middle": middles,
        "place_low": np.array([one.min(axis=0) for one in corners]).reshape(-1, 2),
        "place_high": np.array([one.max(axis=0) for one in corners]).reshape(-1, 2),
        "place_counter": _service_places(ground, middles),
        "place_seconds": np.array([one.seconds for one in points], np.float64),
        "place_act": np.array([names.acts.index(one.act) if one.act else -1 for one in points], np.int64),
        "place_holds": np.array([one.holds for one in points], np.int64).clip(0, 2**31 - 1),
        "place_look": np.array([names.things.index(p.look_at) if p.look_at else -1 for p in points], np.int64),
        "spot_first": _offsets(spots),
        "spots": np.concatenate([np.zeros((0, 2)), *spots]),
        "spots_nearest": np.concatenate([np.zeros(0, np.int64), *nearest]),
        "lattice_first": _offsets([one.ravel() for one in lattices]),
        "lattice_wide": np.array([one.shape[1] for one in lattices], np.int64),
        "lattice_low": np.array([one.min(axis=0, initial=np.inf) for one in spots]).reshape(-1, 2),
        "lattice": np.concatenate([np.zeros(0, np.int64), *(one.ravel() for one in lattices)]),
    }


def _standing_places(ground: Ground, region: Mask) -> Array:
    """Return points to stand in a region, `APART_M` apart, (k, 2)."""
    every = round(APART_M / CELL_M)
    row, column = np.nonzero(region & (ground.clear >= BODY_M))
    if not len(row):
        row, column = np.nonzero(region)
    if not len(row):
        return np.zeros((0, 2))
    thin = ((row - row.min()) % every == 0) & ((column - column.min()) % every == 0)
    thin[0] |= not thin.any()  # of a region with a bitten corner, none may lie on the lattice
    return ground.middles(row[thin], column[thin])


def _lattice(spots: Array) -> NDArray[np.int64]:
    """Return the numbers of standing places by cell, (rows, cols), -1 for none."""
    if not len(spots):
        return np.full((1, 1), -1)
    low = spots.min(axis=0)
    wide, deep = ((spots.max(axis=0) - low) / APART_M + 1.5).astype(np.int64)
    table = np.full((deep, wide), -1)
    column, row = np.round((spots - low) / APART_M).astype(np.int64).T
    table[row, column] = np.arange(len(spots))
    return table


def _by_distance(spots: Array, middle: Array) -> NDArray[np.int64]:
    away = spots - middle
    return np.argsort(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1], kind="stable")


def _service_places(ground: Ground, middles: Array) -> Array:
    """Return where one is served at each point, (p, 2)."""
    row, column = np.nonzero(ground.clear >= _SERVED_M)
    at = ground.middles(row, column)
    found = np.zeros((len(middles), 2))
    for k, middle in enumerate(middles):
        away = at - middle
        found[k] = at[np.argmin(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1])]
    return found


def _rules(scenario: Scenario, names: Names) -> Tables:
    rows: list[tuple[int, ...]] = []
    actions: list[tuple[int, ...]] = []
    seconds: list[float] = []
    for rule in scenario.rules:
        rows.append((*names.condition(rule.when), len(actions), len(rule.actions), 0))
        actions += [names.row_of(one) for one in rule.actions]
        seconds += [one.seconds for one in rule.actions]
    return {
        "rule_rows": np.array(rows, np.int64).reshape(-1, 8),
        "rule_seconds": np.array([one.when.seconds for one in scenario.rules], np.float64),
        "action_rows": np.array(actions, np.int64).reshape(-1, 5),
        "action_seconds": np.array(seconds, np.float64),
    }


def _offsets(lists: Sequence[Sequence[Any] | NDArray[Any]]) -> NDArray[np.int64]:
    """Return the offsets of concatenated lists, and the end of the last."""
    return np.cumsum([0, *map(len, lists)])
