"""Validation of scenarios before they run: names, numbers, places; the same for text and Python."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Sequence
from typing import Final

from cloner.behaviour.model import MOST_PEOPLE, VERBS, XY, Action, Group, Rule, Scenario, Shape
from cloner.errors import ClonerError

#: Nothing is further away than this, metres; a typing mistake is.
FURTHEST_M: Final = 10_000.0
#: No people walk faster: the step of .05 s moves a body by less than its own radius.
FASTEST_M_S: Final = 3.5
LONGEST_S: Final = 1e6
_NAMED_ALREADY: Final = "Give it another name"


def scenario_error(message: str, hint: str, name: str, where: str = "scenario") -> ClonerError:
    """Return the error about a name, with line and column if it comes from a file."""
    line, column = getattr(name, "line", 0), getattr(name, "column", 0)
    return ClonerError(message, hint, f"{where}, line {line}, column {column}" if line else where)


def check_scenario(scenario: Scenario, where: str = "scenario") -> Scenario:
    """Return the scenario itself if it is valid.

    Raises
    ------
    ClonerError
        If anything in it cannot be.
    """
    for kind, names in _names(scenario).items():
        _check_distinct(kind, names, where)
    if not scenario.floors:
        raise ClonerError("there is nothing to walk on", "Give a floor, such as: floor 0, 0 to 30, 12", where)
    for shape in (*scenario.floors, *scenario.obstacles):
        _check_shape(shape, where)
    for point in scenario.points:
        _check_near((point.at, point.size), point.name, where)
        if min(point.size) <= 0.0:
            raise scenario_error(
                f"the region of {point.name} has no size", "Give it a width and a height", point.name, where
            )
        _check_seconds(point.seconds, point.name, where)
        if point.look_at:
            _check_known("thing", point.look_at, _names(scenario)["thing"], where)
    for thing in scenario.things:
        _check_near((thing.at,), thing.name, where)
    for emotion in scenario.emotions:
        if not 0.1 <= emotion.speed <= FASTEST_M_S:
            raise scenario_error(
                f"{emotion.name} walks {emotion.speed:g} m/s", f"Give .1 to {FASTEST_M_S} m/s", emotion.name, where
            )
    for group in scenario.groups:
        _check_group(group, scenario, where)
    for rule in scenario.rules:
        _check_rule(rule, scenario, where)
    if not 1 <= scenario.people() <= MOST_PEOPLE:
        raise ClonerError(f"a scenario of {scenario.people()} people", f"Give 1 to {MOST_PEOPLE} people", where)
    return scenario


def check_actions(actions: tuple[Action, ...], scenario: Scenario, where: str) -> tuple[Action, ...]:
    """Return the actions themselves if everything they name exists."""
    names = _names(scenario)
    for action in actions:
        if action.verb not in VERBS:
            raise scenario_error(f"nobody can {action.verb}", f"Say one of {', '.join(VERBS)}", action.verb, where)
        kind = VERBS[action.verb]
        if kind:
            _check_known(kind, action.what, names[kind], where)
        if action.who.kind == "name":
            among = "thing" if action.verb in {"awaken", "sleep"} else "group"
            _check_known(among, action.who.name, names[among], where)
        if action.verb == "split" and action.count < 2:
            raise scenario_error(
                "a group is split into two or more", "Write: split NAME into 2", action.who.name, where
            )
        if action.who.kind == "they" and where == "order":
            raise ClonerError("'they' means nobody in an order", "Name a group, or say everybody", where)
        _check_seconds(action.seconds, action.what, where)
    return actions


def _names(scenario: Scenario) -> dict[str, list[str]]:
    return {
        "point": [one.name for one in scenario.points],
        "thing": [one.name for one in scenario.things],
        "emotion": [one.name for one in scenario.emotions],
        "group": [one.name for one in scenario.groups],
    }


def _check_distinct(kind: str, names: Sequence[str], where: str) -> None:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise scenario_error(f"there are two {kind}s called {name}", _NAMED_ALREADY, name, where)
        seen.add(name)


def _check_known(kind: str, name: str, names: Sequence[str], where: str) -> None:
    if name in names:
        return
    near = difflib.get_close_matches(name, names, 1)
    known = (
        f"Did you mean {near[0]}" if near else f"Known: {', '.join(names[:8])}" if names else f"Give one: {kind} ..."
    )
    raise scenario_error(f"there is no {kind} called {name}", known, name, where)


def _check_shape(shape: Shape, where: str) -> None:
    name = shape.name or "floor"
    _check_near(shape.corners, name, where)
    area = sum(
        ax * by - bx * ay
        for (ax, ay), (bx, by) in zip(shape.corners, shape.corners[1:] + shape.corners[:1], strict=True)
    )
    if len(shape.corners) < 3 or abs(area) < 1e-6:
        raise scenario_error(f"{name} has no area", "Give three corners or more that are not on one line", name, where)


def _check_near(pairs: Iterable[XY], name: str, where: str) -> None:
    if not all(math.isfinite(value) and abs(value) <= FURTHEST_M for pair in pairs for value in pair):
        raise scenario_error(f"{name} is too far away or too large", f"Stay within {FURTHEST_M:.0f} m", name, where)


def _check_seconds(seconds: float, name: str, where: str) -> None:
    if not 0.0 <= seconds <= LONGEST_S:
        raise scenario_error(f"{seconds:g} seconds are no time", "Give 0 or more seconds", name, where)


def _check_group(group: Group, scenario: Scenario, where: str) -> None:
    names = _names(scenario)
    if group.people < 1:
        raise scenario_error(f"{group.name} has nobody", "Give it one person or more", group.name, where)
    if group.memory < 0:
        raise scenario_error(f"the memory of {group.name} is less than nothing", "Give 0 or more", group.name, where)
    _check_known("emotion", group.feelings.emotion, names["emotion"], where)
    if not 0.0 <= group.feelings.percent <= 100.0:
        raise scenario_error(
            f"{group.feelings.percent:g} % is no share", "Give 0 to 100 %", group.feelings.emotion, where
        )
    for point in (*group.visits, *(group.knows or ()), *((group.starts_at,) if group.starts_at else ())):
        _check_known("point", point, names["point"], where)
    for other, liking in group.likes:
        _check_known("group", other, names["group"], where)
        if not 0.0 <= liking <= 1.0:
            raise scenario_error(f"a liking of {liking:g}", "Give 0 to 1", other, where)
    if group.follows:
        _check_known("group", group.follows.group, names["group"], where)
        if group.follows.group == group.name:
            raise scenario_error(f"{group.name} follows itself", "Name another group", group.follows.group, where)
        _check_seconds(group.follows.seconds, group.follows.group, where)


def _check_rule(rule: Rule, scenario: Scenario, where: str) -> None:
    names, when = _names(scenario), rule.when
    _check_seconds(when.seconds, when.what, where)
    if when.who.kind == "name":
        _check_known("group", when.who.name, names["group"], where)
    if when.kind == "sees":
        _check_known("thing or group", when.what, names["thing"] + names["group"], where)
    if when.kind in {"is", "sees feeling"}:
        _check_known("emotion", when.what, names["emotion"], where)
    if when.kind == "reaches":
        _check_known("point", when.what, names["point"], where)
    check_actions(rule.actions, scenario, where)
    if when.kind in {"at", "event"}:
        for action in rule.actions:
            if action.who.kind == "they":
                raise ClonerError("'they' means nobody here", "Name a group, or say everybody", where)
