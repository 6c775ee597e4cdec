"""Writing of ``person.toml``: name, height and consent from the window; other entries are kept."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

from cloner.booth.visitors.visits import VISIT_FILE
from cloner.errors import ClonerError
from cloner.frames import cm_from_m
from cloner.project.atomic import write_text
from cloner.project.folder import PERSON_FILE, read_consent, read_person
from cloner.project.texts import read_text
from cloner.untrusted import walk_files

#: By definition.
CENTIMETRES_PER_INCH: Final = 2.54
INCHES_PER_FOOT: Final = 12
AGREED: Final = ("event", "licence")


def cm_from_feet(feet: int, inches: float) -> float:
    """Return centimetres."""
    return (feet * INCHES_PER_FOOT + inches) * CENTIMETRES_PER_INCH


def feet_from_cm(height_cm: float) -> tuple[int, float]:
    """Return whole feet and inches, to half an inch."""
    inches = round(2.0 * height_cm / CENTIMETRES_PER_INCH) / 2.0
    return int(inches // INCHES_PER_FOOT), inches % INCHES_PER_FOOT


def write_person(
    folder: Path,
    *,
    name: str,
    height_cm: float | None,
    consent: str,
    agreed: Mapping[str, str] = MappingProxyType({}),
) -> None:
    """Write a visitor's facts atomically; notes and tape measures are kept, comments are not.

    Parameters
    ----------
    folder : Path
    name : str
    height_cm : float or None
    consent : str
        "" takes it back, and the licence with it.
    agreed : mapping of str to str
        What came with a new consent: "event", its title, and "licence".

    Raises
    ------
    ClonerError
        If the height is absurd, the old file is malformed or the folder cannot be written.
    """
    read_person(folder, height_cm)  # refuses absurd heights and malformed files
    path = folder / PERSON_FILE
    data: dict[str, Any] = tomllib.loads(read_text(path)) if path.exists() else {}
    data |= {"name": name, "height_cm": height_cm, "consent": consent, **agreed}
    if not consent:
        data |= dict.fromkeys(AGREED, "")
    tables = {key: value for key, value in data.items() if isinstance(value, Mapping)}
    lines = [_line(key, value) for key, value in data.items() if key not in tables and value not in ("", None)]
    for title, table in tables.items():
        lines += ["", f"[{title}]", *(_line(key, value) for key, value in table.items())]
    write_text(path, "\n".join(lines) + "\n")


def person_facts(folder: Path) -> tuple[str, float | None, str]:
    """Return name, height in centimetres if known, and consent."""
    person = read_person(folder)
    height = round(cm_from_m(person.stature_m), 1) if person.stature_is_known else None
    return person.name, height, read_consent(folder)


def consent_given(text: str, now: datetime, language: str) -> str:
    """Return the record of a consent: its text as shown, time, and language."""
    return f"{text.strip()} ({now:%Y-%m-%d %H:%M} UTC, {language})"


def consent_words(consent: str) -> str:
    """Return the text that was agreed to, without time and language."""
    return re.sub(r"\s*\(\d{4}-\d\d-\d\d[^()]*\)$", "", consent)


def consent_when(consent: str) -> str:
    """Return when and in which language a consent was given, if recorded; else the whole record."""
    found = re.search(r"\((\d{4}-\d\d-\d\d[^()]*)\)$", consent)
    return found.group(1) if found else consent


def consent_language(consent: str) -> str:
    """Return the language in which a consent was read, "de"; "" if not recorded."""
    found = re.search(r"\(\d{4}-\d\d-\d\d[^()]*, (\w\w)\)$", consent)
    return found.group(1) if found else ""


def check_consent(folder: Path) -> None:
    """Refuse to store anything of a visitor who has not agreed.

    Raises
    ------
    ClonerError
        If no consent is recorded.
    """
    if not read_consent(folder):
        hint = "Ask the visitor and tick the consent on the first page"
        raise ClonerError("no photo is stored before the visitor agreed", hint, "Consent")


def _line(key: str, value: object) -> str:
    """Return one line of TOML; JSON's strings are TOML's, but for the one control sign that JSON leaves bare."""
    text = json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return f"{key} = {text}"


def is_untouched(folder: Path) -> bool:
    """Return whether nothing is known of a visitor yet: no name, height, consent or photo."""
    files = {path.name for path in walk_files(folder) if path.is_file()}
    try:
        return files <= {VISIT_FILE, PERSON_FILE} and person_facts(folder) == ("", None, "")
    except ClonerError:
        return False
