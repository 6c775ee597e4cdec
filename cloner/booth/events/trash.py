"""Deleted visitors: kept in the event's trash for some days, then removed permanently.

Who wants everything deleted is not put here but forgotten at once (`cloner.booth.events.retention`). What lies here is
still held, and is listed as such.
"""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

from cloner.booth.events.event import TRASH, visitor_folders
from cloner.booth.handover.takeaway import has_result
from cloner.booth.visitors.cached_work import RESULTS
from cloner.booth.visitors.visits import State, read_visit, write_visit
from cloner.booth.visitors.waiting_line import without_request
from cloner.errors import ClonerError
from cloner.project.folder import safe_identifier


def move_to_trash(folder: Path, now: datetime) -> Path:
    """Move a visitor to the trash of its event and return the new folder.

    Raises
    ------
    ClonerError
        If it cannot be moved.
    """
    to = folder.parent / TRASH / folder.name
    try:
        to.parent.mkdir(exist_ok=True)
        when = now.isoformat(timespec="seconds")
        visit = read_visit(folder)
        if visit.state is State.WAITING:
            visit = without_request(visit, has_result(folder / RESULTS / safe_identifier(folder.name)))
        write_visit(folder, replace(visit, trashed=when, shown=False, inhabits=False))
        return folder.rename(to)
    except OSError as error:
        raise ClonerError("the visitor cannot be moved", "Check permissions and space", folder.name) from error


def restore(folder: Path) -> Path:
    """Move a visitor out of the trash and return the new folder.

    Raises
    ------
    ClonerError
        If it cannot be moved.
    """
    to = folder.parent.parent / folder.name
    try:
        if to.exists():
            raise FileExistsError(to.name)
        back = folder.rename(to)
    except OSError as error:
        raise ClonerError("the visitor cannot be moved", "Check permissions and space", folder.name) from error
    write_visit(back, replace(read_visit(back), trashed=""))
    return back


def trashed_visitors(root: Path) -> tuple[Path, ...]:
    """Return the folders in an event's trash."""
    place = root / TRASH
    return visitor_folders(place) if place.is_dir() else ()


def deletion_time(folder: Path, days: int) -> datetime | None:
    """Return when a visitor in the trash is deleted permanently, UTC; None if the folder is gone.

    It is counted from the folder's time where nothing says when.
    """
    try:
        came = datetime.fromisoformat(read_visit(folder).trashed)
    except ValueError:
        try:
            came = datetime.fromtimestamp(folder.stat().st_mtime, UTC)
        except FileNotFoundError:
            return None
    return (came if came.tzinfo is not None else came.replace(tzinfo=UTC)) + timedelta(days=days)


def expired(root: Path, days: int, now: datetime) -> tuple[Path, ...]:
    """Return the visitors who have been in the trash for long enough to be deleted permanently."""
    ended = ((folder, deletion_time(folder, days)) for folder in trashed_visitors(root))
    return tuple(folder for folder, end in ended if end is not None and now >= end)
