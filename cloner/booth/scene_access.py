"""An event's visitors in a scene: which finished clones may take part, and the staff's PIN."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from cloner.booth.events.event import EVENT_FILE, read_event, visits
from cloner.booth.events.pin import PinLock
from cloner.booth.stage import result_of, scene_clones


def finished_clones(folder: Path) -> Path | Callable[[], tuple[Path, ...]]:
    """Return a function that lists clones that may be shown: in an event, those of visitors who agreed.

    A folder of results is returned as it is; who has recorded no consent is left out later.
    """
    if not (folder / EVENT_FILE).is_file():
        return folder
    return lambda: tuple(result_of(one) for one in scene_clones(visits(folder)))


def pin_check(folder: Path) -> Callable[[str], bool] | None:
    """Return a function that checks the event's PIN, None if it has none.

    Raises
    ------
    ClonerError
        If the event's settings cannot be read.
    """
    if not (folder / EVENT_FILE).is_file():
        return None
    door, kept = PinLock(), read_event(folder).pin
    return (lambda number: door.accepts(number, kept)) if kept else None
