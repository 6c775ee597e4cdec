"""The language of films: who stands where, and what happens when; lines that read like a scenario's.

`docs/scenes.md` has every statement. Places are the plan's: metres, x to the right, y up, then height above the floor.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError, plain
from cloner.outside import UnfitFile, read_outside

XY = tuple[float, float]
XYZ = tuple[float, float, float]

LARGEST_BYTES: Final = 1_000_000
MOST_ACTORS, MOST_SECONDS, MOST_LINES = 2_000, 1_800.0, 5_000
FARTHEST: Final = 1_000.0
FEELINGS: Final = ("regular", "sad", "calm", "happy", "explosive", "afraid")
ACTS: Final = ("look", "wave", "point", "photograph", "pay", "applaud", "lift", "sit", "stand")
#: How the eye opens where nothing is said, degrees from bottom to top; a person from head to foot fills it at 2 m.
LENS_DEG: Final = 45.0
_TOKEN: Final = re.compile(r'\s*(?:("[^"]*")|([+-]?(?:\d+\.?\d*|\.\d+))|([^\W\d]\w*)|(.))')


@dataclass(frozen=True, slots=True)
class Actor:
    """Somebody: name, clone ("" for any), place, where to (degrees clockwise from the plan's up), stone, height."""

    name: str
    clone: str
    at: XY
    facing_deg: float
    stone: bool
    up: float
    head_at: XY | None


@dataclass(frozen=True, slots=True)
class Order:
    """What somebody does from a time on: walks, turns or acts; ``to`` a place, ``by`` a way, ``who`` somebody."""

    when: float
    actors: tuple[int, ...]
    kind: str
    to: XY = (0.0, 0.0)
    who: int = -1
    word: str = ""
    seconds: float = 0.0


@dataclass(frozen=True, slots=True)
class Key:
    """A change that begins at a time and takes some: light, stars, stops, curtain, lantern, stone, up, the camera."""

    when: float
    kind: str
    values: tuple[float, ...]
    seconds: float = 0.0
    actors: tuple[int, ...] = ()
    who: int = -1


@dataclass(slots=True)
class Sequence:
    """A whole film."""

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


def read_sequence(path: Path) -> Sequence:
    """Return the film that a file tells.

    Raises
    ------
    ClonerError
        If it cannot be read, or a line says something that is not understood.
    """
    try:
        text = read_outside(path, LARGEST_BYTES).decode("utf-8")
    except (OSError, UnfitFile, UnicodeDecodeError) as error:
        raise ClonerError("there is no film", "Give a text like samples/awakening.film", path.name) from error
    return sequence_of(text, path.name)


def sequence_of(text: str, where: str) -> Sequence:
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


class Words:
    """The words of one line, taken one after another; whatever does not fit is told with line, column and what does."""

    def __init__(self, line: str, number: int, where: str) -> None:
        self._where, self._number, self._at = where, number, 0
        self._tokens: list[tuple[str, str, int]] = []
        for match in _TOKEN.finditer(line):
            kind = ("text", "number", "word", "sign")[match.lastindex - 1] if match.lastindex else ""
            if match.group(match.lastindex or 0) == "#":
                break
            if kind and not (kind == "sign" and match.group(4).isspace()):
                self._tokens.append((kind, match.group(match.lastindex or 0), match.start(match.lastindex or 0) + 1))

    def left(self) -> bool:
        """Return whether anything is left."""
        return self._at < len(self._tokens)

    def wrong(self, expected: str, back: int = 0) -> ClonerError:
        """Return what to raise: what stands there, and what was expected."""
        at = self._at - back
        shown = plain(repr(self._tokens[at][1])) if at < len(self._tokens) else "the line's end"
        column = self._tokens[at][2] if at < len(self._tokens) else (self._tokens[-1][2] + len(self._tokens[-1][1]))
        return ClonerError(f"line {self._number}, column {column}: {shown} stands where {expected} was expected",
                           "docs/scenes.md has every statement", self._where)  # fmt: skip

    def take(self, kind: str, expected: str) -> str:
        """Take a token of a kind."""
        if not self.left() or self._tokens[self._at][0] != kind:
            raise self.wrong(expected)
        self._at += 1
        return self._tokens[self._at - 1][1]

    def word(self, *known: str) -> str:
        """Take one of some words."""
        expected = known[0] if len(known) == 1 else f"{', '.join(known[:-1])} or {known[-1]}"
        found = self.take("word", expected)
        if found not in known:
            raise self.wrong(expected, 1)
        return found

    def has(self, word: str) -> bool:
        """Take a word or sign if it is next."""
        if self.left() and self._tokens[self._at][1] == word and self._tokens[self._at][0] in ("word", "sign"):
            self._at += 1
            return True
        return False

    def must(self, *signs: str) -> None:
        """Take these words or signs."""
        for sign in signs:
            if not self.has(sign):
                raise self.wrong(repr(sign))

    def number(self, expected: str, low: float = -FARTHEST, high: float = FARTHEST) -> float:
        """Take a number within bounds."""
        value = float(self.take("number", expected))
        if not low <= value <= high:
            raise self.wrong(f"{expected} from {low:g} to {high:g}", 1)
        return value

    def numbers(self, count: int, expected: str, low: float = -FARTHEST, high: float = FARTHEST) -> tuple[float, ...]:
        """Take so many numbers with commas."""
        found = [self.number(expected, low, high)]
        for _ in range(count - 1):
            self.must(",")
            found.append(self.number(expected, low, high))
        return tuple(found)

    def place(self) -> XY:
        """Take x, y."""
        x, y = self.numbers(2, "a place (x, y)")
        return x, y

    def seconds(self, word: str, usual: float | None = None) -> float:
        """Take ``word N s``; without it the usual time, if there is one."""
        if usual is not None and not self.has(word):
            return usual
        if usual is None:
            self.must(word)
        found = self.number("a time in seconds", 0.0, MOST_SECONDS)
        self.must("s")
        return found

    def end(self) -> None:
        """Refuse what is left."""
        if self.left():
            raise self.wrong("the line's end")

    def who(self, film: Sequence) -> tuple[int, ...]:
        """Take the name of somebody, of rows, or everybody."""
        name = self.take("word", "an actor's name")
        if name == "everybody":
            return tuple(range(len(film.actors)))
        if name not in film.groups:
            raise self.wrong(f"one of {', '.join(list(film.groups)[:12]) or 'the actors (none yet)'}", 1)
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
    """Take ``facing 180 in stone, .3 m deep, head at 3, 4``; the last only of somebody ``alone``."""
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
    try_name = not words.left() or words._tokens[words._at][0] == "word"
    if try_name:
        who = words.who(film)[0]
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
    text = plain(words.take("text", "a text in quotes").strip('"'))
    film.captions.append((when, when + words.seconds("for", 4.0), text))


def _deed(words: Words, film: Sequence, when: float) -> None:
    actors = words.who(film)
    deed = words.word("awakens", "hardens", "rises", "walks", "runs", "turns", "does", "gives")
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
        if words._tokens[words._at : words._at + 1] and words._tokens[words._at][0] == "word":
            film.orders.append(Order(when, actors, "turns", who=words.who(film)[0]))
        else:
            film.orders.append(Order(when, actors, "turns", words.place()))
    elif deed == "does":
        word = words.word(*ACTS)
        film.orders.append(Order(when, actors, "does", word=word, seconds=words.seconds("for")))
    else:
        other = words.who(film)[0]
        words.must("the", "head")
        if film.actors[other].head_at is None:
            raise words.wrong(f"somebody whose head lies somewhere, unlike {film.actors[other].name}", 3)
        film.heads.append((when, actors[0], other, words.seconds("in")))


_STATEMENTS: Final[dict[str, Callable[[Words, Sequence], None]]] = {
    "film": _film, "actor": _actor, "rows": _rows, "at": _at,
}  # fmt: skip
_CHANGES: Final[dict[str, Callable[[Words, Sequence, float], None]]] = {
    "camera": _camera, "caption": _caption, "curtain": _curtain, "lantern": _lantern,
    "light": _values("light", 3, "red, green, blue", 0, 10), "stars": _values("stars", 1, "how bright, 0 to 1", 0, 1),
    "exposure": _values("stops", 1, "stops", -8, 8),
}  # fmt: skip
