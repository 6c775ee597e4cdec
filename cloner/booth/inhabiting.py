"""An event's visitors in a scene: whose finished clones take part, and the number that the staff types."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from cloner.booth.events.event import EVENT_FILE, read_event, visits
from cloner.booth.events.pin import Door
from cloner.booth.stage import inhabiting_clones, result_of


def finished_clones(folder: Path) -> Path | Callable[[], tuple[Path, ...]]:
    """Return a finder of clones that may be shown: of an event those of visitors who agreed.

    A folder of results is returned as it is; who has recorded no consent is left out later.
    """
    if not (folder / EVENT_FILE).is_file():
        return folder
    return lambda: tuple(result_of(one) for one in inhabiting_clones(visits(folder)))


def number_asked(folder: Path) -> Callable[[str], bool] | None:
    """Return a check of whether a number is the event's PIN, None where it has none.

    Raises
    ------
    ClonerError
        If the event's settings cannot be read.
    """
    if not (folder / EVENT_FILE).is_file():
        return None
    door, kept = Door(), read_event(folder).pin
    return (lambda number: door.opens(number, kept)) if kept else None
