"""Deleted visitors: kept in the event's trash for some days, then removed for good.

Who wants everything deleted is not put here but forgotten at once (`cloner.booth.events.keeping`). What lies here is
still held, and is listed as such.
"""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

from cloner.booth.events.event import TRASH, visitor_folders
from cloner.booth.handover.takeaway import has_result
from cloner.booth.visitors.kept import RESULTS
from cloner.booth.visitors.line import withdrawn
from cloner.booth.visitors.visits import State, read_visit, write_visit
from cloner.errors import ClonerError
from cloner.project.folder import safe_identifier


def throw_away(folder: Path, now: datetime) -> Path:
    """Put a visitor into the trash of its event and return where it lies.

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
            visit = withdrawn(visit, has_result(folder / RESULTS / safe_identifier(folder.name)))
        write_visit(folder, replace(visit, trashed=when, shown=False, inhabits=False))
        return folder.rename(to)
    except OSError as error:
        raise ClonerError("the visitor cannot be moved", "Check permissions and space", folder.name) from error


def bring_back(folder: Path) -> Path:
    """Take a visitor out of the trash and return where it lies.

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


def thrown_away(root: Path) -> tuple[Path, ...]:
    """Return who lies in an event's trash."""
    place = root / TRASH
    return visitor_folders(place) if place.is_dir() else ()


def ends(folder: Path, days: int) -> datetime | None:
    """Return when a visitor of the trash goes for good, UTC; None who went meanwhile.

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


def over(root: Path, days: int, now: datetime) -> tuple[Path, ...]:
    """Return who has been in the trash for so long that it goes for good."""
    ended = ((folder, ends(folder, days)) for folder in thrown_away(root))
    return tuple(folder for folder, end in ended if end is not None and now >= end)
