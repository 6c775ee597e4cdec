"""Retention: which data of its visitors an event stores, for how long, and their deletion."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import Final

from cloner.booth.events.event import ASIDE, TRASH, visitor_folders
from cloner.booth.events.trash import expired, trashed_visitors
from cloner.errors import ClonerError
from cloner.personal_data.holdings import Holding, holding_of, older_than
from cloner.personal_data.privacy import forget_all

#: One deletion at a time: each finishes what all before it have put aside.
_ALONE: Final = threading.Lock()


def stored_data(root: Path) -> tuple[Holding, ...]:
    """Return the data stored of every visitor of an event, including the trash and what is being deleted."""
    folders = (*visitor_folders(root), *trashed_visitors(root), *_set_aside_folders(root))
    return tuple(_holding(folder) for folder in folders)


def _holding(folder: Path) -> Holding:
    """Return the stored data of a visitor in any of these places."""
    return holding_of(folder.name.removeprefix(ASIDE), folder, None)


def overdue_data(root: Path, days: int, now: datetime) -> tuple[Holding, ...]:
    """Return the data past its retention period; nothing if the event keeps its visitors (0 days)."""
    return older_than(stored_data(root), days, now) if days > 0 else ()


def set_aside(folder: Path) -> Path:
    """Remove a visitor who is to be forgotten from the event at once, and return the folder that awaits deletion.

    From now on nobody lists, shows, serves or clones them. `finish_deletions` deletes them, after a crash when the
    event is opened again.

    Raises
    ------
    ClonerError
        If the folder cannot be moved.
    """
    if folder.name.startswith(ASIDE):
        return folder
    try:
        return folder.rename(folder.with_name(ASIDE + folder.name))
    except OSError as error:
        raise ClonerError("the visitor cannot be moved", "Check permissions and space", folder.name) from error


def finish_deletions(root: Path) -> tuple[str, ...]:
    """Delete everybody who was set aside, and return the event's files that still mention them.

    It reads every file of the event and belongs on another thread.

    Raises
    ------
    ClonerError
        If not everything can be deleted.
    """
    with _ALONE:
        return forget_visitors(_set_aside_folders(root), root)


def tidy_up(root: Path, trash_days: int, now: datetime) -> tuple[str, ...]:
    """Finish interrupted deletions and delete visitors who were in the trash for long enough; as
    :func:`finish_deletions`.
    """
    for folder in expired(root, trash_days, now):
        set_aside(folder)
    return finish_deletions(root)


def _set_aside_folders(root: Path) -> list[Path]:
    places = (root, root / TRASH)
    return [path for place in places for path in sorted(place.glob(f"{ASIDE}*")) if path.is_dir()]


def forget_visitors(folders: Sequence[Path], root: Path | None) -> tuple[str, ...]:
    """Delete visitors with all derived files, and return the event's files that still mention them.

    Parameters
    ----------
    folders : sequence of Path
        The visitors', put aside or not.
    root : Path or None
        The event; None for a visitor's folder that stands alone, beside which nothing is searched.

    Raises
    ------
    ClonerError
        If not everything can be deleted.
    """
    gone = [_holding(folder) for folder in folders]
    return forget_all(gone, root, None) if gone else ()
