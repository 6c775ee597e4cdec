"""``person.toml`` as a validated table."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.project.tape import read_tape
from cloner.project.texts import check_format, read_text
from cloner.records.terms import LICENCES, LONGEST_TERM, Terms

LONGEST_TOLD_TEXT: Final = 30  # of a word nobody knows; taste
PERSON_FORMAT: Final = 1  # files without a number are of format 1
_PERSON_KEYS: Final = {"format", "name", "height_cm", "notes", "measures", "consent", "event", "licence", "sex", "age"}
#: As which one may say to walk.
SEXES: Final = ("f", "m")
OLDEST_YEARS: Final = 125.0  # nobody was older


def person_table(path: Path) -> Mapping[str, Any]:
    """Return the checked table of ``person.toml``; empty when there is none."""
    if not path.exists():
        return {}
    try:
        data = tomllib.loads(read_text(path))
    except (ValueError, RecursionError) as error:  # endless numbers and brackets are no TOMLDecodeError
        raise ClonerError(
            f"this is not valid TOML ({error})", "Write lines like: height_cm = 172", path.name
        ) from error
    check_format(data.get("format", PERSON_FORMAT), PERSON_FORMAT, path.name)
    unknown = sorted(set(data) - _PERSON_KEYS)
    if unknown:
        known = ", ".join(sorted(_PERSON_KEYS))
        raise ClonerError(f"the key {unknown[0]!r} is not known", f"The keys are {known}", path.name)
    return data


def text_of(data: Mapping[str, Any], key: str) -> str:
    """Return a key's text, "" where there is none."""
    value = data.get(key, "")
    if not isinstance(value, str):
        raise ClonerError(f"{key} must be text in quotes", "Put it in quotes", f"person.toml, {key}")
    return value


def sex_and_age_of(data: Mapping[str, Any]) -> tuple[str, float]:
    """Return sex ("f", "m" or "") and age (years, 0 if unknown)."""
    sex, age = text_of(data, "sex"), data.get("age", 0)
    if sex not in ("", *SEXES):
        hint = 'Write sex = "f" or sex = "m", or leave it out'
        raise ClonerError(f"the sex {sex[:LONGEST_TOLD_TEXT]!r} is not known", hint, "person.toml, sex")
    if isinstance(age, bool) or not isinstance(age, int | float) or not 0 <= age <= OLDEST_YEARS:
        raise ClonerError("age must be years", "Write a line like: age = 71", "person.toml, age")
    return sex, float(age)


def terms_of(data: Mapping[str, Any]) -> Terms:
    """Return what the person allows others to do; nothing where no consent is recorded."""
    consent, event, licence = (text_of(data, key) for key in ("consent", "event", "licence"))
    if licence not in ("", *LICENCES):
        hint = f"The licences are {', '.join(LICENCES)}"
        raise ClonerError(f"the licence {licence[:LONGEST_TOLD_TEXT]!r} is not known", hint, "person.toml, licence")
    if not consent:
        return Terms()
    return Terms(text_of(data, "name").strip()[:LONGEST_TERM], event.strip()[:LONGEST_TERM], licence or LICENCES[0])


def tape_mm_of(data: Mapping[str, Any], stature_m: float) -> tuple[tuple[str, float], ...]:
    """Return the tape measures of ``[measures]``, by key of the measures' table, mm."""
    table = data.get("measures", {})
    if not isinstance(table, dict):
        hint = "Write a line [measures], and below it lines like: waist_girth = 70.2"
        raise ClonerError("measures must be a table of centimetres", hint, "person.toml, measures")
    return read_tape(table, stature_m, "person.toml, measures")
