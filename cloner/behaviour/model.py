"""The records of a scenario, written in the language or made in Python.

Places are metres on the plan (`ground`); times seconds; emotions' values and likings 0..1. Names are plain words; one
that came from a text also carries ``line`` and ``column``, so that a wrong one can be shown.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

#: More people than this are no scene on one machine at twice real time (walkers §1).
MOST_PEOPLE: Final = 20_000
XY = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Point:
    """A point to pass (IP), or to act at (AP) if ``act`` is given; its capacity ``holds``, 0 for unlimited."""

    name: str
    at: XY
    size: XY = (1.0, 1.0)
    act: str = ""
    seconds: float = 0.0
    holds: int = 0
    look_at: str = ""


@dataclass(frozen=True, slots=True)
class Thing:
    """Something to see and to look at, such as a statue; inactive until an event awakens it."""

    name: str
    at: XY


@dataclass(frozen=True, slots=True)
class Shape:
    """A polygon: a floor, or an obstacle with a name."""

    corners: tuple[XY, ...]
    name: str = ""


@dataclass(frozen=True, slots=True)
class Emotion:
    """How one walks who feels it fully: style, speed in m/s, and the act while standing."""

    name: str
    speed: float
    walk: str
    acts: tuple[str, ...] = ("stand",)


#: The source's five and afraid. Speeds are what the walks of ``cloner/motion`` give (walkers §4); afraid: taste.
EMOTIONS: Final = (
    Emotion("sad", 0.87, "sad", ("stand", "sit")),
    Emotion("calm", 1.11, "calm", ("stand", "sit", "look")),
    Emotion("regular", 1.34, "regular", ("stand", "look")),
    Emotion("happy", 1.46, "happy", ("stand", "look", "wave", "photograph")),
    Emotion("explosive", 1.66, "explosive", ("wave", "applaud", "point")),
    Emotion("afraid", 1.9, "afraid", ("stand",)),
)


@dataclass(frozen=True, slots=True)
class Feeling:
    """A percentage that feels this emotion; the others feel a random other one."""

    emotion: str
    percent: float = 100.0


@dataclass(frozen=True, slots=True)
class Follows:
    """Whom a group follows: always, for some ``seconds``, or ``at_times`` chosen at random."""

    group: str
    seconds: float = 0.0
    at_times: bool = False


@dataclass(frozen=True, slots=True)
class Group:
    """People with one mind; or, ``alone``, a crowd of people with a mind each.

    ``leader`` is "random", "emerging" (the highest domination) or a name. ``knows`` None is every point. ``likes``
    holds pairs of a group and a liking 0..1. Without ``visits`` they go to known points at random, or wander. Who comes
    from ``outside`` is not there before somebody comes, and is led by nobody here (`together.guests`).
    """

    name: str
    people: int
    alone: bool = False
    leader: str = "random"
    feelings: Feeling = Feeling("regular", 100.0)
    visits: tuple[str, ...] = ()
    again: bool = False
    knows: tuple[str, ...] | None = None
    memory: int = 10
    follows: Follows | None = None
    likes: tuple[tuple[str, float], ...] = ()
    flocking: bool = False
    adapts: bool = False
    wanders: bool = False
    starts_at: str = ""
    outside: bool = False


@dataclass(frozen=True, slots=True)
class Who:
    """Whom an action is for: "everybody", "they" (who triggered a rule), or a "name" of a group, crowd or thing."""

    kind: str
    name: str = ""


@dataclass(frozen=True, slots=True)
class Action:
    """One ordered action.

    ``verb`` is one of `VERBS`; ``what`` its emotion, point, thing, group or act; ``seconds`` how long (0: until other
    orders), ``count`` into how many a group splits.
    """

    verb: str
    who: Who = Who("everybody")
    what: str = ""
    seconds: float = 0.0
    count: int = 0


#: Verb and the kind of thing that ``what`` names.
VERBS: Final = {
    "become": "emotion", "go": "point", "run": "point", "leave": "point", "gather": "point", "follow": "group",
    "look": "thing", "act": "", "free": "", "ignore": "", "heed": "", "awaken": "", "sleep": "", "clear": "point",
    "split": "", "event": "",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class When:
    """The condition of a rule.

    ``kind`` is "at" (``seconds``), "event" (``what``), "sees" (``what`` is a thing, if need be ``awake``, or a group),
    "sees feeling" (``what`` is an emotion of others), "is" (an emotion of their own) or "reaches" (a point).
    """

    kind: str
    who: Who = Who("everybody")
    what: str = ""
    seconds: float = 0.0
    awake: bool = False


@dataclass(frozen=True, slots=True)
class Rule:
    """Actions upon a condition: a time (script), an event or a perception (reaction)."""

    when: When
    actions: tuple[Action, ...]


@dataclass(frozen=True, slots=True)
class Scenario:
    """A world and its people."""

    floors: tuple[Shape, ...]
    obstacles: tuple[Shape, ...] = ()
    points: tuple[Point, ...] = ()
    things: tuple[Thing, ...] = ()
    emotions: tuple[Emotion, ...] = EMOTIONS
    groups: tuple[Group, ...] = ()
    rules: tuple[Rule, ...] = ()
    scene: str = field(default="")

    def people(self) -> int:
        """Return the number of people."""
        return sum(one.people for one in self.groups)
