"""Retention: what an event holds of its visitors, for how long, and its deletion."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import Final

from cloner.booth.events.event import ASIDE, TRASH, visitor_folders
from cloner.booth.events.trash import over, thrown_away
from cloner.errors import ClonerError
from cloner.personal_data.holdings import Holding, holding_of, older_than
from cloner.personal_data.privacy import forget_all

#: One deletion at a time: each finishes what all before it have put aside.
_ALONE: Final = threading.Lock()


def held(root: Path) -> tuple[Holding, ...]:
    """Return the data held of every visitor of an event, in the trash and set aside too."""
    folders = (*visitor_folders(root), *thrown_away(root), *_aside(root))
    return tuple(_holding(folder) for folder in folders)


def _holding(folder: Path) -> Holding:
    """Return the data held of a visitor, set aside or not."""
    return holding_of(folder.name.removeprefix(ASIDE), folder, None)


def overdue(root: Path, days: int, now: datetime) -> tuple[Holding, ...]:
    """Return the data past its retention period; nothing where an event keeps its visitors (0 days)."""
    return older_than(held(root), days, now) if days > 0 else ()


def put_aside(folder: Path) -> Path:
    """Take a visitor who is to be forgotten out of the event at once, and return where the files wait for their end.

    From now on nobody lists, shows, serves or clones them. `finish` deletes them, after a crash when the event is
    opened again.

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


def finish(root: Path) -> tuple[str, ...]:
    """Delete everybody who was put aside and return the event's files that still speak of them.

    It reads every file of the event and belongs on another thread.

    Raises
    ------
    ClonerError
        If not everything can be deleted.
    """
    with _ALONE:
        return forget_visitors(_aside(root), root)


def tidied(root: Path, trash_days: int, now: datetime) -> tuple[str, ...]:
    """Finish deletions that were broken off, and delete who lay in the trash for so long; as :func:`finish`."""
    for folder in over(root, trash_days, now):
        put_aside(folder)
    return finish(root)


def _aside(root: Path) -> list[Path]:
    places = (root, root / TRASH)
    return [path for place in places for path in sorted(place.glob(f"{ASIDE}*")) if path.is_dir()]


def forget_visitors(folders: Sequence[Path], root: Path | None) -> tuple[str, ...]:
    """Delete visitors with everything derived and return the event's files that still speak of them.

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
