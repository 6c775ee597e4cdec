"""Initial state of a scenario's people: emotions, speeds and dominance by chance, groups and leaders."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.dice import purpose_number
from cloner.behaviour.ground import Indices
from cloner.behaviour.model import Group, Scenario
from cloner.behaviour.tables import PHASES, Names, Tables
from cloner.records.arrays import Array

#: Weidmann's spread of walking speeds over their mean, .26 / 1.34; nobody further than two of it.
SPREAD: Final = 0.194


def initial_people(scenario: Scenario, seed: int, count: int) -> Tables:
    """Return the initial rows of people."""
    who = np.arange(count)
    sizes = [(home, 1 if group.alone else group.people, group.people if group.alone else 1)
             for home, group in enumerate(scenario.groups)]  # fmt: skip
    members = [(home, size) for home, size, times in sizes for _ in range(times)]
    band = np.repeat(np.arange(len(members)), [size for _, size in members])
    home = np.repeat([h for h, _ in members], [size for _, size in members])
    vigour = np.clip(1.0 + SPREAD * dice.normal(seed, purpose_number("pace"), who), 1.0 - 2 * SPREAD, 1.0 + 2 * SPREAD)
    return {
        "band": band,
        "home": home,
        "emotion": _emotions(scenario, home, seed),
        "value": 0.6 + 0.4 * dice.uniform(seed, purpose_number("value"), who),
        "vigour": vigour,
        "domination": dice.uniform(seed, purpose_number("domination"), who),
        "visited": np.full(count, -1),
        "phase": np.full(count, PHASES.index("done")),
        "gaze": np.full(count, -1),
    }


def _emotions(scenario: Scenario, home: Indices, seed: int) -> Indices:
    """Return each person's emotion: the given percentage of each group, exact to one person; others get another one."""
    names = [one.name for one in scenario.emotions]
    found = np.zeros(len(home), np.int64)
    for number, group in enumerate(scenario.groups):
        main = names.index(group.feelings.emotion)
        members = dice.shuffled(seed, purpose_number("feeling", number), np.flatnonzero(home == number))
        most = int(len(members) * group.feelings.percent / 100.0 + 0.5)
        others = [k for k, name in enumerate(names) if k != main and name != "afraid"]
        found[members[:most]] = main
        rest = members[most:]
        if len(rest) and others:
            pick = dice.uniform(seed, purpose_number("other feeling", number), rest)
            found[rest] = np.array(others)[(pick * len(others)).astype(np.int64)]
    return found


def initial_bands(scenario: Scenario, names: Names, people: Tables, seed: int) -> Tables:
    """Return the initial minds of groups."""
    members = np.split(np.arange(len(people["band"])), np.flatnonzero(np.diff(people["band"])) + 1)
    homes = people["home"][[one[0] for one in members]]
    longest = max(len(names.points), 1, *(len(one.visits) for one in scenario.groups))
    known = np.zeros((len(scenario.groups), len(names.points)), bool)
    visits = np.zeros((len(scenario.groups), longest), np.int64)
    for k, group in enumerate(scenario.groups):
        known[k, [names.points.index(one) for one in (names.points if group.knows is None else group.knows)]] = True
        visits[k, : len(group.visits)] = [names.points.index(one) for one in group.visits]
    follows = [one.follows for one in scenario.groups]
    return {
        "band_home": homes,
        "leader": np.array([_leader_of(scenario.groups[home], own, people["domination"], seed)
                            for home, own in zip(homes, members, strict=True)]),
        "follows": np.array([names.groups.index(one.group) if one else -1 for one in follows])[homes],
        "follows_until": np.array([(one and one.seconds) or np.inf for one in follows])[homes],
        "at_times": np.array([bool(one and one.at_times) for one in follows])[homes],
        "visit_count": np.array([len(one.visits) for one in scenario.groups])[homes],
        "visits": visits[homes],
        "knows": known[homes],
    }  # fmt: skip


def _leader_of(group: Group, members: Indices, domination: Array, seed: int) -> int:
    """Return the leader: the highest domination if leaders emerge, a random one, or, if named, the first."""
    if group.leader == "emerging":
        return int(members[np.argmax(domination[members])])
    if group.leader == "random":
        return int(dice.shuffled(seed, purpose_number("leader"), members)[0])
    return int(members[0])
