"""The tokens of a line; errors give line, column and what was expected."""

from __future__ import annotations

import re
from typing import Final

from cloner.errors import ClonerError, printable

XY = tuple[float, float]

#: Bounds of what a film may say: half an hour, a kilometre; taste.
MOST_SECONDS: Final = 1_800.0
FARTHEST: Final = 1_000.0
_TOKEN: Final = re.compile(r'\s*(?:("[^"]*")|([+-]?(?:\d+\.?\d*|\.\d+))|([^\W\d]\w*)|(.))')


class Words:
    """The tokens of one line; errors give line, column and what was expected."""

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
        """Return whether any token is left."""
        return self._at < len(self._tokens)

    def wrong(self, expected: str, back: int = 0) -> ClonerError:
        """Return the error for an unexpected token."""
        at = self._at - back
        shown = printable(repr(self._tokens[at][1])) if at < len(self._tokens) else "the line's end"
        column = self._tokens[at][2] if at < len(self._tokens) else (self._tokens[-1][2] + len(self._tokens[-1][1]))
        return ClonerError(f"line {self._number}, column {column}: {shown} stands where {expected} was expected",
                           "docs/scenes.md has every statement", self._where)  # fmt: skip

    def next_is(self, kind: str) -> bool:
        """Return whether a token of a kind (text, number, word, sign) is next."""
        return self.left() and self._tokens[self._at][0] == kind

    def take(self, kind: str, expected: str) -> str:
        """Take a token of a kind."""
        if not self.next_is(kind):
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
        """Take exactly these words or signs."""
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
        """Take some numbers separated by commas."""
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
        """Take ``word N s``; return the default if it is missing and there is one."""
        if usual is not None and not self.has(word):
            return usual
        if usual is None:
            self.must(word)
        found = self.number("a time in seconds", 0.0, MOST_SECONDS)
        self.must("s")
        return found

    def end(self) -> None:
        """Refuse remaining tokens."""
        if self.left():
            raise self.wrong("the line's end")
