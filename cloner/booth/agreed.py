"""What a visitor's consent lets others do with the files, besides its text."""

from __future__ import annotations

from pathlib import Path

from cloner.booth.event import Event
from cloner.records.terms import LICENCES


def agreed_terms(event: Event, folder: Path, language: str) -> dict[str, str]:
    """Return what a consent given now in a language lets others do: the event's licence where its own text was read.

    Parameters
    ----------
    event : Event
    folder : Path
        The event's.
    language : str
    """
    licence = event.licence if event.consents.get(language, "").strip() else LICENCES[0]
    return {"event": event.title or folder.name, "licence": licence}
