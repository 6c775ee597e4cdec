"""The film language: initial positions and timed events, one line each.

`docs/scenes.md` has every statement. Places are the plan's: metres, x to the right, y up, then height above the floor.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError, printable
from cloner.scenes.films.words import MOST_SECONDS, XY, Words
from cloner.untrusted import UnsuitableFile, read_untrusted

#: Bounds of a film's file, far beyond what a person writes; taste.
LARGEST_BYTES: Final = 1_000_000
MOST_ACTORS, MOST_LINES = 2_000, 5_000
FEELINGS: Final = ("regular", "sad", "calm", "happy", "explosive", "afraid")
ACTS: Final = ("look", "wave", "point", "photograph", "pay", "applaud", "lift", "sit", "stand")
#: What may be said: a file beside the film.
_SOUND: Final = re.compile(r"(?!\.)[^/\\\0]{1,200}\.(wav|txt)", re.IGNORECASE)
#: How the eye opens where nothing is said, degrees from bottom to top; a person from head to foot fills it at 2 m.
LENS_DEG: Final = 45.0


@dataclass(frozen=True, slots=True)
class Actor:
    """A person: name, clone ("" for any), position, direction (degrees clockwise from the plan's up), stone, height."""

    name: str
    clone: str
    at: XY
    facing_deg: float
    stone: bool
    up: float
    head_at: XY | None


@dataclass(frozen=True, slots=True)
class Order:
    """What a person does from a time on: walks, turns or acts; ``to`` a place, ``by`` a way, ``who`` somebody."""

    when: float
    actors: tuple[int, ...]
    kind: str
    to: XY = (0.0, 0.0)
    who: int = -1
    word: str = ""
    seconds: float = 0.0


@dataclass(frozen=True, slots=True)
class Key:
    """A change with a start and a duration: light, stars, stops, curtain, lantern, stone, up, the camera."""

    when: float
    kind: str
    values: tuple[float, ...]
    seconds: float = 0.0
    actors: tuple[int, ...] = ()
    who: int = -1


@dataclass(slots=True)
class Sequence:
    """A whole film; heads are (when, by whom, whose, how long given), speeches (when, by whom, the file's name)."""

    title: str = ""
    seconds: float = 30.0
    size_px: tuple[int, int] = (1280, 720)
    rate_hz: float = 25.0
    actors: list[Actor] = field(default_factory=list)
    groups: dict[str, tuple[int, ...]] = field(default_factory=dict)
    orders: list[Order] = field(default_factory=list)
    keys: list[Key] = field(default_factory=list)
    captions: list[tuple[float, float, str]] = field(default_factory=list)
    heads: list[tuple[float, int, int, float]] = field(default_factory=list)
    speeches: list[tuple[float, tuple[int, ...], str]] = field(default_factory=list)


def read_sequence(path: Path) -> Sequence:
    """Return the film of a file.

    Raises
    ------
    ClonerError
        If it cannot be read, or a line says something that is not understood.
    """
    try:
        text = read_untrusted(path, LARGEST_BYTES).decode("utf-8")
    except (OSError, UnsuitableFile, UnicodeDecodeError) as error:
        raise ClonerError("there is no film", "Give a text like samples/awakening.film", path.name) from error
    return parse_sequence(text, path.name)


def parse_sequence(text: str, where: str) -> Sequence:
    """Return the film of a text; see :func:`read_sequence`."""
    made = Sequence()
    lines = text.splitlines()
    if len(lines) > MOST_LINES:
        raise ClonerError(f"{len(lines)} lines are too many", f"Write at most {MOST_LINES}", where)
    for number, line in enumerate(lines, start=1):
        words = Words(line, number, where)
        if words.left():
            _STATEMENTS[words.word(*_STATEMENTS)](words, made)
            words.end()
    if not made.actors:
        raise ClonerError("nobody plays in the film", "Write a line like: actor first is anna at 3, 4", where)
    if not any(key.kind == "camera" for key in made.keys):
        hint = "Write a line like: at 0 s: camera at 7, -6, 1.7 looks at 7, 4, 1.2"
        raise ClonerError("the film has no camera", hint, where)
    return made


def _who(words: Words, film: Sequence) -> tuple[int, ...]:
    """Parse the name of a person, of rows, or everybody."""
    name = words.take("word", "an actor's name")
    if name == "everybody":
        return tuple(range(len(film.actors)))
    if name not in film.groups:
        raise words.wrong(f"one of {', '.join(list(film.groups)[:12]) or 'the actors (none yet)'}", 1)
    return film.groups[name]


def _film(words: Words, film: Sequence) -> None:
    film.title = words.take("text", "a title in quotes").strip('"')
    film.seconds = words.seconds("for", film.seconds)
    if film.seconds < 0.1:
        raise words.wrong("a time of at least .1 s", 2)
    if words.has(","):
        wide = words.number("a width in pixels", 16, 4096)
        words.must("x")
        film.size_px = round(wide), round(words.number("a height in pixels", 16, 4096))
    if words.has(","):
        film.rate_hz = words.number("frames a second", 1, 120)
        words.must("frames", "a", "second")


def _new(words: Words, film: Sequence) -> str:
    name = words.take("word", "a name")
    if name in film.groups or name in ("everybody", "camera", *_CHANGES):
        raise words.wrong("a name that is not taken", 1)
    return name


def _traits(words: Words, *, alone: bool) -> tuple[float, bool, float, XY | None]:
    """Parse ``facing 180 in stone, .3 m deep, head at 3, 4``; the last only for one person (``alone``)."""
    facing = words.number("degrees", -360, 360) if words.has("facing") else 180.0
    stone = words.has("in")
    if stone:
        words.must("stone")
    up, head = 0.0, None
    while words.has(","):
        if alone and words.has("head"):
            words.must("at")
            head = words.place()
        else:
            up = words.number("metres (such as .3 m deep)" + " or head at x, y" * alone, 0.0, 5.0)
            words.must("m")
            up *= -1.0 if words.word("deep", "high") == "deep" else 1.0
    return facing, stone, up, head


def _actor(words: Words, film: Sequence) -> None:
    name = _new(words, film)
    words.must("is")
    clone = words.take("word", "a clone's name")
    words.must("at")
    at = words.place()
    facing, stone, up, head = _traits(words, alone=True)
    film.groups[name] = (len(film.actors),)
    film.actors.append(Actor(name, "" if clone == "anybody" else clone, at, facing, stone, up, head))


def _rows(words: Words, film: Sequence) -> None:
    name = _new(words, film)
    words.must("of")
    across = round(words.number("how many stand side by side", 1, 500))
    words.must("x")
    deep = round(words.number("how many stand behind one another", 1, 500))
    words.must("from")
    low = words.place()
    words.must("to")
    high = words.place()
    facing, stone, up, _ = _traits(words, alone=False)
    if len(film.actors) + across * deep > MOST_ACTORS:
        raise words.wrong(f"at most {MOST_ACTORS} actors", 1)
    first = len(film.actors)
    for row in range(deep):
        for column in range(across):
            share = (column / max(across - 1, 1), row / max(deep - 1, 1))
            at = (low[0] + (high[0] - low[0]) * share[0], low[1] + (high[1] - low[1]) * share[1])
            film.actors.append(Actor(f"{name} {len(film.actors) - first + 1}", "", at, facing, stone, up, None))
    film.groups[name] = tuple(range(first, len(film.actors)))


def _at(words: Words, film: Sequence) -> None:
    when = words.number("a time in seconds", 0.0, MOST_SECONDS)
    words.must("s", ":")
    for kind, act in _CHANGES.items():
        if words.has(kind):
            act(words, film, when)
            return
    _deed(words, film, when)


def _camera(words: Words, film: Sequence, when: float) -> None:
    moves = words.word("at", "moves") == "moves"
    if moves:
        words.must("to")
    eye = words.numbers(3, "a place (x, y, height)")
    words.must("looks", "at")
    look, who = (0.0, 0.0, 0.0), -1
    if words.next_is("word"):
        who = _who(words, film)[0]
    else:
        look = words.numbers(3, "a place (x, y, height) or a name")  # type: ignore[assignment]
    lens = LENS_DEG
    if words.has(","):
        words.must("lens")
        lens = words.number("degrees", 2, 120)
    seconds = words.seconds("in") if moves else 0.0
    if moves and not any(key.kind == "camera" for key in film.keys):
        raise words.wrong("a line 'camera at ...' before it moves", 1)
    film.keys.append(Key(when, "camera" if not moves else "moves", (*eye, *look, lens), seconds, (), who))


def _values(kind: str, count: int, expected: str, low: float, high: float) -> Callable[[Words, Sequence, float], None]:
    def change(words: Words, film: Sequence, when: float) -> None:
        values = words.numbers(count, expected, low, high)
        film.keys.append(Key(when, kind, values, words.seconds("in", 0.0)))

    return change


def _lantern(words: Words, film: Sequence, when: float) -> None:
    words.must("at")
    place = words.numbers(3, "a place (x, y, height)")
    words.must("light")
    light = words.numbers(3, "red, green, blue", 0, 100)
    film.keys.append(Key(when, "lantern", (*place, *light), words.seconds("in", 0.0)))


def _curtain(words: Words, film: Sequence, when: float) -> None:
    opens = words.word("opens", "closes") == "opens"
    film.keys.append(Key(when, "curtain", (1.0 if opens else 0.0,), words.seconds("in", 1.0)))


def _caption(words: Words, film: Sequence, when: float) -> None:
    text = printable(words.take("text", "a text in quotes").strip('"'))
    film.captions.append((when, when + words.seconds("for", 4.0), text))


def _deed(words: Words, film: Sequence, when: float) -> None:
    actors = _who(words, film)
    deed = words.word("awakens", "hardens", "rises", "walks", "runs", "turns", "does", "feels", "gives", "says")
    if deed in ("awakens", "hardens"):
        seconds = words.seconds("in", 3.0)
        film.keys.append(Key(when, "stone", (0.0 if deed == "awakens" else 1.0,), seconds, actors))
    elif deed == "rises":
        film.keys.append(Key(when, "up", (0.0,), words.seconds("in", 2.0), actors))
    elif deed in ("walks", "runs"):
        by = words.word("to", "by") == "by"
        to = words.place()
        feeling = words.word(*FEELINGS) if words.left() else "regular"
        film.orders.append(Order(when, actors, deed + (" by" if by else ""), to, word=feeling))
    elif deed == "turns":
        words.must("to")
        who, to = (_who(words, film)[0], (0.0, 0.0)) if words.next_is("word") else (-1, words.place())
        film.orders.append(Order(when, actors, deed, to, who))
    elif deed == "does":
        film.orders.append(Order(when, actors, deed, word=words.word(*ACTS), seconds=words.seconds("for")))
    elif deed == "feels":
        film.orders.append(Order(when, actors, deed, word=words.word(*FEELINGS)))
    elif deed == "says":
        name = words.take("text", 'a file\'s name in quotes, such as "hello.wav"').strip('"')
        if not _SOUND.fullmatch(name):
            raise words.wrong("the name of a .wav or .txt file beside the film", 1)
        film.speeches.append((when, actors, name))
    else:
        other = _who(words, film)[0]
        words.must("the", "head")
        if film.actors[other].head_at is None:
            raise words.wrong(f"somebody whose head lies somewhere, unlike {film.actors[other].name}", 3)
        film.heads.append((when, actors[0], other, words.seconds("in")))


_STATEMENTS: Final[dict[str, Callable[[Words, Sequence], None]]] = {
    "film": _film, "actor": _actor, "rows": _rows, "at": _at,
}  # fmt: skip
#: What changes by keys, with how many values between which bounds.
_CHANGES: Final[dict[str, Callable[[Words, Sequence, float], None]]] = {
    "camera": _camera, "caption": _caption, "curtain": _curtain, "lantern": _lantern,
    "light": _values("light", 3, "red, green, blue", 0, 10), "stars": _values("stars", 1, "how bright, 0 to 1", 0, 1),
    "exposure": _values("stops", 1, "stops", -8, 8),
}  # fmt: skip
