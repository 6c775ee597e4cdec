"""Sentences that come from the library in English (errors, warnings, notes), in the window's language."""

from __future__ import annotations

import functools
import re
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.measures import BY_KEY
from cloner_gui.language.point_names import is_point, point_label
from cloner_gui.language.told_sentences import SENTENCES as BOOTH_SENTENCES
from cloner_gui.language.told_studio import STUDIO_SENTENCES
from cloner_gui.language.words import VIEW_TITLES, TranslatedWords, translate

if TYPE_CHECKING:
    from cloner.interactive.refitting import RefittedBody


#: All that the library may say in the window.
SENTENCES: Final = BOOTH_SENTENCES + STUDIO_SENTENCES


def translated(sentence: str) -> str:
    """Return a sentence of the library in the window's language; unknown ones unchanged."""
    found = template_of(sentence)
    if found is None:
        return sentence
    template, parts = found
    text = translate("told", template)
    for number, part in enumerate(parts, start=1):
        text = text.replace(f"%{number}", _told_part(part))
    return text


def translated_error(error: ClonerError) -> str:
    """Return an error's message and hint, in the window's language."""
    where = translated_where(error.where)
    hint = translated(error.hint)
    message = translated(error.message)
    said = f"{where}: {message}" if where else message[:1].upper() + message[1:]
    return f"{said}. {hint}" + ("" if hint.endswith("?") else ".")


#: Files of the program's own, as the operator knows them.
FILES: Final = TranslatedWords(
    "told",
    {
        "event.json": QT_TRANSLATE_NOOP("told", "The event's settings"),
        "corrections.json": QT_TRANSLATE_NOOP("told", "The corrected points"),
        "person.toml": QT_TRANSLATE_NOOP("told", "What is known of the visitor"),
        "visit.json": QT_TRANSLATE_NOOP("told", "The visit"),
        "clone.npz": QT_TRANSLATE_NOOP("told", "The clone"),
        "Consent": QT_TRANSLATE_NOOP("told", "Consent"),
        "Stick": QT_TRANSLATE_NOOP("told", "Stick"),
        "Printer": QT_TRANSLATE_NOOP("told", "Printer"),
    },
)


def translated_where(where: str) -> str:
    """Return the place of an error, without names of files and options that the window does not show."""
    if where.startswith("--") or where in BY_KEY:  # the sentence names the measure itself
        return ""
    first, comma, rest = where.partition(", ")
    stem = Path(first).stem.partition(".")[0]
    if stem in list(ViewId):
        said = VIEW_TITLES[stem]
    elif re.fullmatch(r"photo_\d+", stem):
        said = translate("told", "A photo")
    elif re.fullmatch(r"visitor-0*(\d+)", first):
        said = translate("visitor", "Visitor {n}").format(n=int(first[8:]))
    else:
        said = FILES.get(first, "") or translated(first)
    view = rest.partition(".")[0]
    more = VIEW_TITLES[view] if view in list(ViewId) else rest
    return f"{said}, {more}" if comma and more else said


def stale_text() -> str:
    """Return the sentence that a clone is older than the points and the height."""
    return translate("clone", "Points or height were changed since: what is seen and taken away is the clone before.")


def translated_problem(problem: str) -> str:
    """Return why a clone failed, from a visit's file (``str`` of the error), in the window's language."""
    where, _, rest = problem.partition(": ")
    message, _, hint = rest.partition(". ")
    return translated_error(ClonerError(message, hint, where)) if hint else problem


def refit_text(refitted: RefittedBody) -> str:
    """Return the result of the corrected points on the last clone's body."""
    failed = [
        f"{VIEW_TITLES[one.view]}, {point_label(one.name)}: {translated(one.note)}."
        for one in refitted.obeyed
        if one.is_missed
    ]
    said = " ".join(failed) or translate("points", "The body follows; hair and textures will when you clone again.")
    more = translate("points", "Clone again: this changes more than is shown.")
    return said if refitted.is_whole else f"{said} {more}"


def template_of(sentence: str) -> tuple[str, tuple[str, ...]] | None:
    """Return the known sentence that matches, and its values; None for an unknown one."""
    if sentence in SENTENCES:
        return sentence, ()
    for template, pattern in _patterns():
        match = pattern.fullmatch(sentence)
        if match is not None:
            return template, match.groups()
    return None


def _told_part(part: str) -> str:
    if part in list(ViewId):
        return VIEW_TITLES[part]
    return FILES.get(part, "") or (point_label(part) if is_point(part) else translated(part))


@functools.cache
def _patterns() -> tuple[tuple[str, re.Pattern[str]], ...]:
    """Return the sentences with places in them as patterns, those that say most themselves first."""
    open_ones = sorted((one for one in SENTENCES if "%1" in one), key=len, reverse=True)
    return tuple((one, re.compile(re.sub(r"%\d", "(.+?)", re.escape(one)))) for one in open_ones)
