"""The reader of calibration files; the caller repeats each value's unit as a check."""

from __future__ import annotations

import functools
import importlib.resources
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Final

#: Units by the word that entries use, with what they mean.
UNITS: Final[Mapping[str, str]] = MappingProxyType({
    "m": "metres",
    "mm": "millimetres",
    "mm2": "square millimetres",
    "m, rad": "metres, and radians where an angle is meant",
    "px": "pixels",
    "px/m": "pixels a metre",
    "rad": "radians",
    "deg": "degrees",
    "iod": "distances of the pupils",
    "figure": "heights of the figure, crown to sole",
    "share": "a part of a whole",
    "factor": "times something of the same kind",
    "sigmas": "standard deviations",
    "cosine": "cosine of an angle",
    "sine": "sine of an angle",
    "grey": "grey levels of 8 bits",
    "lab": "distance of colours in 8-bit Lab",
    "score": "what a net gives, 0..1 or its log odds",
    "log": "logarithm of a ratio",
    "log odds": "logarithm of the odds, 0 where both are as likely",
    "cost": "what a search adds up; compared with others of its kind only",
    "pieces": "number of independent pieces of evidence",
})  # fmt: skip
#: Where a value may come from.
ORIGINS: Final[Mapping[str, str]] = MappingProxyType({
    "learned": "a script fits it to data; the entry names the script",
    "measured": "read off people, photographs or results; the entry says which",
    "tried": "compared with other values on known people; the entry says what they gave",
    "published": "anatomy, a standard, a survey, or a net's own number",
    "taste": "somebody's choice, by eye or for the reason told; nothing was measured for it alone",
    "unknown": "history tells neither reason nor figure",
})  # fmt: skip

Value = float | tuple[float, ...] | Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Entry:
    """One calibrated number.

    Attributes
    ----------
    value : float, tuple of float, or mapping of str to float
    unit : str
        One of `UNITS`.
    what : str
        What it is, a sentence.
    origin : str
        One of `ORIGINS`.
    how : str
        How it was found: benchmark, people, figures, source.
    since : str
        The commit that brought this value.
    """

    value: Value
    unit: str
    what: str
    origin: str
    how: str
    since: str


@dataclass(frozen=True, slots=True)
class Calibrated:
    """The numbers of one module.

    Attributes
    ----------
    module : str
        "room.module".
    entries : mapping of str to Entry
    """

    module: str
    entries: Mapping[str, Entry]

    def number(self, name: str, unit: str) -> float:
        """Return one number.

        Raises
        ------
        KeyError
            There is no such entry, it has another unit, or it is no single number.
        """
        value = self._value(name, unit)
        if not isinstance(value, float):
            raise KeyError(f"{self.module}.{name} is no single number")
        return value

    def numbers(self, name: str, unit: str) -> tuple[float, ...]:
        """Return several numbers in their order.

        Raises
        ------
        KeyError
            There is no such entry, it has another unit, or it is no list.
        """
        value = self._value(name, unit)
        if not isinstance(value, tuple):
            raise KeyError(f"{self.module}.{name} is no list of numbers")
        return value

    def pair(self, name: str, unit: str) -> tuple[float, float]:
        """Return two numbers; raises as `numbers` does."""
        first, second = self.numbers(name, unit)
        return first, second

    def triple(self, name: str, unit: str) -> tuple[float, float, float]:
        """Return three numbers; raises as `numbers` does."""
        first, second, third = self.numbers(name, unit)
        return first, second, third

    def quadruple(self, name: str, unit: str) -> tuple[float, float, float, float]:
        """Return four numbers; raises as `numbers` does."""
        first, second, third, fourth = self.numbers(name, unit)
        return first, second, third, fourth

    def table(self, name: str, unit: str) -> Mapping[str, float]:
        """Return numbers by name.

        Raises
        ------
        KeyError
            There is no such entry, it has another unit, or it is no table.
        """
        value = self._value(name, unit)
        if not isinstance(value, Mapping):
            raise KeyError(f"{self.module}.{name} is no table")
        return value

    def _value(self, name: str, unit: str) -> Value:
        entry = self.entries[name]
        if entry.unit != unit:
            raise KeyError(f"{self.module}.{name} is in {entry.unit!r}, not in {unit!r}")
        return entry.value


def calibrated(module: str) -> Calibrated:
    """Return the numbers of a module, "room.module" whatever its sub-room: table ``[module]`` of ``room.toml``.

    Raises
    ------
    KeyError
        There is no such file or table.
    """
    room, _, name = module.partition(".")
    return Calibrated(module, _room(room)[name])


def rooms() -> tuple[str, ...]:
    """Return the names of all files."""
    folder = importlib.resources.files("cloner.calibration")
    return tuple(sorted(file.name.removesuffix(".toml") for file in folder.iterdir() if file.name.endswith(".toml")))


def modules(room: str) -> tuple[str, ...]:
    """Return the names of a room's tables."""
    return tuple(_room(room))


@functools.cache
def _room(room: str) -> Mapping[str, Mapping[str, Entry]]:
    """Return a file's entries by module and name."""
    place = importlib.resources.files("cloner.calibration") / f"{room}.toml"
    if not place.is_file():
        raise KeyError(f"no calibration of {room!r}")
    data = tomllib.loads(place.read_text(encoding="utf-8"))
    return {module: {name: _entry(entry) for name, entry in table.items()} for module, table in data.items()}


def _entry(data: Mapping[str, Any]) -> Entry:
    value = data["value"]
    number: Value
    if isinstance(value, Mapping):
        number = MappingProxyType({str(name): float(one) for name, one in value.items()})
    elif isinstance(value, list):
        number = tuple(float(one) for one in value)
    else:
        number = float(value)
    return Entry(number, data["unit"], data["what"], data["origin"], data["how"], data["since"])
