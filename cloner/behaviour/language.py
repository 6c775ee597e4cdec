"""Parser of the scenario language: records of `model`, or one error with line, column and what was expected."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

from lark import Lark, Token, Transformer, UnexpectedInput
from lark.exceptions import UnexpectedCharacters, UnexpectedEOF, UnexpectedToken, VisitError

from cloner.behaviour.checking import check_actions, check_scenario, scenario_error
from cloner.behaviour.grammar import CALLED, GRAMMAR
from cloner.behaviour.model import (
    EMOTIONS,
    Action,
    Emotion,
    Feeling,
    Follows,
    Group,
    Point,
    Rule,
    Scenario,
    Shape,
    Thing,
    When,
    Who,
)  # fmt: skip
from cloner.errors import ClonerError
from cloner.untrusted import read_untrusted_text

LARGEST_BYTES: Final = 1_000_000  # taste: a hundred times what a person types
_MOST_EXPECTED: Final = 6  # more words than this say less


#: What a clause tells without a value of its own.
_FLAGS: Final[dict[str, dict[str, Any]]] = {
    "one_at_a_time": {"holds": 1}, "shared": {"holds": 0}, "outside": {"outside": True},
    "flocking": {"flocking": True}, "adapts": {"adapts": True}, "wanders": {"wanders": True},
}  # fmt: skip
#: What the one value of a clause is called.
_TOLD: Final = {"region": "size"} | {name: name for name in ("holds", "look_at", "leader", "memory", "starts_at")}


class Word(str):
    """A name with its position in the text."""

    __slots__ = ("column", "line")
    line: int
    column: int


class _Records(Transformer[Token, Any]):  # type: ignore[misc]  # lark may not be there when types are checked
    """Transforms the parse tree into records."""

    def NAME(self, token: Token) -> Word:
        word = Word(token)
        word.line, word.column = token.line or 0, token.column or 0
        return word

    def NUMBER(self, token: Token) -> float:
        return float(token)

    def INT(self, token: Token) -> int:
        return int(token)

    def STRING(self, token: Token) -> str:
        return str(token)[1:-1]

    def xy(self, found: list[Any]) -> tuple[float, float]:
        return found[0], found[1]

    size = xy

    def scene(self, found: list[Any]) -> tuple[str, Any]:
        return "scene", found[0]

    def floor_box(self, found: list[Any]) -> tuple[str, Any]:
        (ax, ay), (bx, by) = found
        return "floors", Shape(((ax, ay), (bx, ay), (bx, by), (ax, by)))

    def floor_through(self, found: list[Any]) -> tuple[str, Any]:
        return "floors", Shape(tuple(found))

    def obstacle_box(self, found: list[Any]) -> tuple[str, Any]:
        name, (x, y), (w, h) = found
        return "obstacles", Shape(_corners(x, y, w, h), name)

    def obstacle_through(self, found: list[Any]) -> tuple[str, Any]:
        return "obstacles", Shape(tuple(found[1:]), found[0])

    def act(self, found: list[Any]) -> dict[str, Any]:
        return {"act": found[0], "seconds": found[1]}

    def point(self, found: list[Any]) -> tuple[str, Any]:
        return "points", Point(found[0], found[1], **_merged(found[2:], found[0]))

    def thing(self, found: list[Any]) -> tuple[str, Any]:
        return "things", Thing(*found)

    def emotion(self, found: list[Any]) -> tuple[str, Any]:
        name, speed, walk, *acts = found
        return "emotions", Emotion(name, speed, walk or name, tuple(one for one in acts if one) or ("stand",))

    def feeling(self, found: list[Any]) -> dict[str, Any]:
        return {"feelings": Feeling(found[0], 100.0 if found[1] is None else found[1])}

    def visits(self, found: list[Any]) -> dict[str, Any]:
        *names, again = found
        return {"visits": tuple(names), "again": again is not None}

    def knows(self, found: list[Any]) -> dict[str, Any]:
        return {"knows": tuple(found)}

    def follows(self, found: list[Any]) -> dict[str, Any]:
        return {"follows": Follows(found[0], found[1] or 0.0)}

    def follows_at_times(self, found: list[Any]) -> dict[str, Any]:
        return {"follows": Follows(found[0], at_times=True)}

    def likes(self, found: list[Any]) -> dict[str, Any]:
        return {"likes": (found[0], found[1])}

    def crowd(self, found: list[Any]) -> tuple[str, Any]:
        people, name, *parts = found
        return "groups", _group(name, people, parts, alone=True)

    def group(self, found: list[Any]) -> tuple[str, Any]:
        name, people, *parts = found
        return "groups", _group(name, people, parts, alone=False)

    def everybody(self, found: list[Any]) -> Who:
        return Who("everybody")

    def they(self, found: list[Any]) -> Who:
        return Who("they")

    def named(self, found: list[Any]) -> Who:
        return Who("name", found[0])

    def on_event(self, found: list[Any]) -> When:
        return When("event", what=found[0])

    def on_sees(self, found: list[Any]) -> When:
        return When("sees", found[0], found[1], awake=found[2] is not None)

    def on_sees_feeling(self, found: list[Any]) -> When:
        return When("sees feeling", found[0], found[1])

    def on_is(self, found: list[Any]) -> When:
        return When("is", found[0], found[1])

    def on_reaches(self, found: list[Any]) -> When:
        return When("reaches", found[0], found[1])

    def actions(self, found: list[Any]) -> tuple[Action, ...]:
        return tuple(found)

    def at_rule(self, found: list[Any]) -> tuple[str, Any]:
        return "rules", Rule(When("at", seconds=found[0]), found[1])

    def when_rule(self, found: list[Any]) -> tuple[str, Any]:
        return "rules", Rule(found[0], found[1])

    def clear(self, found: list[Any]) -> Action:
        return Action("clear", what=found[0], seconds=found[1] or 0.0)

    def split(self, found: list[Any]) -> Action:
        return Action("split", Who("name", found[0]), count=found[1])

    def event(self, found: list[Any]) -> Action:
        return Action("event", what=found[0])

    def __default__(self, data: str, children: list[Any], meta: Any) -> Any:
        """Return a clause's record, or "who verb what seconds" as an action."""
        if data in _FLAGS:
            return _FLAGS[data]
        if data in _TOLD:
            return {_TOLD[data]: children[0]}
        if data == "start":
            return [one for one in children if one is not None]
        who, what, seconds = [*children, None, None][:3]
        return Action("act" if data == "do" else str(data), who, what or "", seconds or 0.0)


def _merged(parts: Sequence[dict[str, Any]], name: str) -> dict[str, Any]:
    """Return all parts as one; a repeated part is an error."""
    data: dict[str, Any] = {}
    for part in parts:
        for key, value in part.items():
            if key in data:
                raise scenario_error(f"{name} is told its {key.replace('_', ' ')} twice", "Keep one of both", name)
            data[key] = value
    return data


def _group(name: str, people: int, parts: Sequence[dict[str, Any]], *, alone: bool) -> Group:
    parts = [part for part in parts if part is not None]
    likes = tuple(part["likes"] for part in parts if "likes" in part)
    return Group(name, people, alone, likes=likes, **_merged([part for part in parts if "likes" not in part], name))


def _corners(x: float, y: float, w: float, h: float) -> tuple[tuple[float, float], ...]:
    return (x - w / 2, y - h / 2), (x + w / 2, y - h / 2), (x + w / 2, y + h / 2), (x - w / 2, y + h / 2)


@functools.cache
def _parser() -> Lark:
    return Lark(GRAMMAR, parser="lalr", start=["start", "actions"], maybe_placeholders=True)


def _parsed(text: str, start: str, where: str) -> Any:
    try:
        return _Records().transform(_parser().parse(text, start=start))
    except UnexpectedInput as error:
        raise _explain(error, text, where) from error
    except VisitError as error:
        if isinstance(error.orig_exc, ClonerError):
            raise error.orig_exc from error
        raise


def _explain(error: UnexpectedInput, text: str, where: str) -> ClonerError:
    """Return the error message for an unexpected token."""
    if isinstance(error, UnexpectedToken):
        found, expected = str(error.token).strip(), error.accepts or error.expected
        if error.token.type in {"$END", "_NL"} or not found:
            found = "the end of the line" if error.token.type == "_NL" else "the end of the text"
        else:
            found = repr(found)
    elif isinstance(error, UnexpectedCharacters):
        found, expected = repr(text[error.pos_in_stream]), error.allowed or set()
    else:
        found, expected = "the end of the text", error.expected if isinstance(error, UnexpectedEOF) else set()
    names = sorted({_operator_name(one) for one in expected})
    expectation = ", ".join(names[:_MOST_EXPECTED]) + (", ..." if len(names) > _MOST_EXPECTED else "")
    at_end = error.line is None or error.line < 1
    line = text.count("\n") + 1 if at_end else error.line
    column = len(text) - text.rfind("\n") if at_end else error.column
    return ClonerError(f"{found} does not fit", f"Expected: {expectation}", f"{where}, line {line}, column {column}")


def _operator_name(terminal: str) -> str:
    """Return an operator's name for a terminal symbol."""
    if terminal in CALLED:
        return CALLED[terminal]
    pattern = next((one.pattern for one in _parser().terminals if one.name == terminal), None)
    return str(getattr(pattern, "value", terminal))


def parse_scenario(text: str, where: str = "scenario") -> Scenario:
    """Return the scenario of a text.

    Raises
    ------
    ClonerError
        If a word does not fit, or a name is unknown: with line and column.
    """
    data: dict[str, list[Any]] = {}
    for kind, record in _parsed(text if text.endswith("\n") else text + "\n", "start", where):
        data.setdefault(kind, []).append(record)
    own = {one.name: one for one in data.get("emotions", ())}
    emotions = tuple(own.pop(one.name, one) for one in EMOTIONS) + tuple(own.values())
    parts = {kind: tuple(data.get(kind, ())) for kind in ("floors", "obstacles", "points", "things", "groups", "rules")}
    return check_scenario(Scenario(emotions=emotions, scene=(data.get("scene") or [""])[0], **parts), where)


def read_scenario(path: Path) -> Scenario:
    """Return the scenario of a file.

    Raises
    ------
    ClonerError
        If it cannot be read or says something wrong.
    """
    return parse_scenario(scenario_text(path), path.name)


def scenario_text(path: Path) -> str:
    """Return the text of a scenario's file.

    Raises
    ------
    ClonerError
        If it cannot be read, is too large or no text.
    """
    return read_untrusted_text(path, "the scenario", "Give a text file, such as samples/museum.crowd", LARGEST_BYTES)


def parse_actions(text: str, scenario: Scenario, where: str = "order") -> tuple[Action, ...]:
    """Return the actions of one line, as a guide gives them.

    Raises
    ------
    ClonerError
        As :func:`parse_scenario`.
    """
    actions: tuple[Action, ...] = _parsed(text, "actions", where)
    return check_actions(actions, scenario, where)
