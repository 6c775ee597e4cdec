"""Tape measures of an operator, validated."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.frames import MILLIMETRES_PER_METRE, mm_from_m
from cloner.records.measures import BY_KEY, MEASURE_KEYS

#: By definition.
MILLIMETRES_PER_CENTIMETRE: Final = 10.0
#: Names that tailors use for keys of the table.
ALIASES: Final = {"chest": "bust_girth", "chest_girth": "bust_girth", "inside_leg": "inside_leg_height"}
#: Real people lie within these shares of the average person of their height, by far.
LEAST, MOST = 0.55, 2.2
LARGEST_CM: Final = 1e6  # also ends the whole numbers of TOML that no float holds
#: What a number would be in centimetres if it were written in another unit.
OTHER_UNITS: Final = {"millimetres": 0.1, "metres": 100.0, "inches": 2.54}


def read_tape(table: Mapping[str, Any], stature_m: float, where: str) -> tuple[tuple[str, float], ...]:
    """Return keys of the measures' table with millimetres.

    Parameters
    ----------
    table : mapping of str to number
        Centimetres by key; "_girth" may be left out.
    stature_m : float
        Tells which lengths are absurd.
    where : str
        For messages.

    Raises
    ------
    ClonerError
        If a name is unknown or given twice, or a value is no plausible number of centimetres.
    """
    found: dict[str, float] = {}
    for name, value in table.items():
        key = _key(name, where)
        if key in found:
            raise ClonerError(f"{key} is given twice", "Keep one of both", where)
        found[key] = _checked_cm(name, key, value, stature_m, where) * MILLIMETRES_PER_CENTIMETRE
    return tuple(found.items())


def _key(name: str, where: str) -> str:
    for key in (name, f"{name}_girth", ALIASES.get(name, "")):
        if key in BY_KEY:
            return key
    near = difflib.get_close_matches(name, (*MEASURE_KEYS, *ALIASES), n=3, cutoff=0.7)
    known = f"Did you mean {' or '.join(near)}?" if near else f"The measures are {', '.join(MEASURE_KEYS)}"
    raise ClonerError(f"the measure {name!r} is not known", known, where)


def _checked_cm(name: str, key: str, value: Any, stature_m: float, where: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < LARGEST_CM:  # neither nan
        hint = f"Write a number of centimetres: {name} = {_usual_cm(key, stature_m):.0f}"
        raise ClonerError(f"{name} must be a length", hint, where)
    usual = _usual_cm(key, stature_m)
    if LEAST * usual <= value <= MOST * usual:
        return float(value)
    message = (
        f"{value:g} cm cannot be the {name} of a person of {mm_from_m(stature_m) / MILLIMETRES_PER_CENTIMETRE:.0f} cm"
    )
    for unit, factor in OTHER_UNITS.items():
        if LEAST * usual <= value * factor <= MOST * usual:
            raise ClonerError(message, f"It looks like {unit}; write {name} = {value * factor:.1f}", where)
    raise ClonerError(message, f"Measure again; about {usual:.0f} cm is usual", where)


def _usual_cm(key: str, stature_m: float) -> float:
    """Return the measure of the average adult of a height."""
    from cloner.generic.measure_prior import load_measure_prior  # with scipy: only where somebody gave a measure
    from cloner.geometry.measurement.measuring import ALL_KEYS

    share = load_measure_prior().means.mean(axis=0)[ALL_KEYS.index(key)] / MILLIMETRES_PER_METRE
    return float(mm_from_m(stature_m * share)) / MILLIMETRES_PER_CENTIMETRE
