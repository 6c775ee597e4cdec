"""What an event holds of its visitors, for how long, and how all of it goes."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

from cloner.booth.events.event import visitor_folders
from cloner.booth.events.trash import thrown_away
from cloner.personal_data.holdings import Holding, holding_of, older_than
from cloner.personal_data.privacy import forget


def held(root: Path) -> tuple[Holding, ...]:
    """Return what is held of every visitor of an event, also of those without a photo and of those in the trash."""
    return tuple(holding_of(folder.name, folder, None) for folder in (*visitor_folders(root), *thrown_away(root)))


def overdue(root: Path, days: int, now: datetime) -> tuple[Holding, ...]:
    """Return what should have gone by now; nothing where an event keeps its visitors (0 days)."""
    return older_than(held(root), days, now) if days > 0 else ()


def forget_visitor(folder: Path, root: Path | None) -> tuple[str, ...]:
    """Delete a visitor with everything derived and return the event's files that still speak of it.

    Parameters
    ----------
    folder : Path
        The visitor's.
    root : Path or None
        The event; None for a visitor's folder that stands alone, beside which nothing is searched.

    Raises
    ------
    ClonerError
        If not everything can be deleted.
    """
    return forget(holding_of(folder.name, folder, None), root, None)
