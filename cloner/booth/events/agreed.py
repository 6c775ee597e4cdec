"""What a visitor's consent allows others to do with the files."""

from __future__ import annotations

from pathlib import Path

from cloner.booth.events.event import Event
from cloner.records.terms import LICENCES


def offered_licences(event: Event) -> tuple[str, ...]:
    """Return the licences that a visitor may choose from: the narrowest one, and the wider ones that
    the event allows.
    """
    return LICENCES[: LICENCES.index(event.licence) + 1]


def default_licence(event: Event, language: str) -> str:
    """Return the licence selected by default: the one of the event's own terms if it has any.

    The window's own text says nothing of the kind, so that who reads it and chooses nothing keeps everything.

    Parameters
    ----------
    event : Event
    language : str
        Of the text that was read.
    """
    return event.licence if event.consents.get(language, "").strip() else LICENCES[0]


def agreed_terms(event: Event, folder: Path, language: str, chosen: str = "") -> dict[str, str]:
    """Return the terms of a consent that is given now, in a language.

    Parameters
    ----------
    event : Event
    folder : Path
        The event's.
    language : str
    chosen : str
        The licence that the visitor chose; "", or one that the event does not ask for, takes the usual one.
    """
    licence = chosen if chosen in offered_licences(event) else default_licence(event, language)
    return {"event": event.title or folder.name, "licence": licence}
