"""The event's folder: its settings, and who is in it."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any, Final

from cloner.booth.visits import VISIT_FILE, Visit, read_visit, write_visit
from cloner.errors import ClonerError
from cloner.outside import read_outside
from cloner.project.atomic import write_text
from cloner.project.folder import holds_photos
from cloner.project.texts import LARGEST_BYTES

EVENT_FILE: Final = "event.json"
LOG_FILE: Final = "cloner.log"
FORMAT: Final = 1
LANGUAGES: Final = ("en", "de", "fr", "tr")
APPEARANCES: Final = ("system", "light", "dark", "contrast")
DEFAULT_RETENTION_DAYS: Final = 30  # taste: long enough to mend a complaint, short enough to be forgotten
_HINT: Final = f"Correct {EVENT_FILE}, or move it away to start with the usual settings"


@dataclass(frozen=True, slots=True)
class Event:
    """What holds for all visitors of an event.

    Attributes
    ----------
    language : str
        One of `LANGUAGES`.
    retention_days : int
        Visitors whose last change is older are to be forgotten; 0 keeps them.
    consent : str
        What visitors agree to; "" takes the window's own sentence.
    formats : tuple of str
        Exporters whose files visitors take away.
    camera_folder : str
        Where a tethered camera drops its photos; "" for none.
    link : str
        What the take-away code says, "{id}" standing for the visitor; "" points at the file.
    appearance : str
        One of `APPEARANCES`.
    text_percent : int
        Size of the window's text.
    big : bool
        Whether buttons are big enough for fingers.
    open : str
        Folder name of the visitor who was open last.
    """

    language: str = "en"
    retention_days: int = DEFAULT_RETENTION_DAYS
    consent: str = ""
    formats: tuple[str, ...] = ("glb", "wrl")
    camera_folder: str = ""
    link: str = ""
    appearance: str = "system"
    text_percent: int = 100
    big: bool = False
    open: str = ""


def read_event(folder: Path) -> Event:
    """Return the event's settings; the usual ones where nothing was set.

    Raises
    ------
    ClonerError
        If the file cannot be read or says something that cannot be.
    """
    path = folder / EVENT_FILE
    if not path.exists():
        return Event()
    try:
        told = json.loads(read_outside(path, LARGEST_BYTES))
    except (OSError, ValueError, RecursionError) as error:
        raise ClonerError("the event's settings cannot be read", _HINT, EVENT_FILE) from error
    if not isinstance(told, dict) or told.pop("format", None) != FORMAT:
        raise ClonerError(f'it must be an object with "format": {FORMAT}', _HINT, EVENT_FILE)
    return _checked(told)


def _checked(told: dict[str, Any]) -> Event:
    usual = asdict(Event())
    for key, value in told.items():
        if key not in usual:
            raise ClonerError(f"the key {key!r} is not known", _HINT, EVENT_FILE)
        if key == "formats":
            fine = isinstance(value, list) and all(isinstance(one, str) for one in value)
        else:
            fine = type(value) is type(usual[key])
        if not fine:
            raise ClonerError(f"{key} has a value of the wrong kind", _HINT, EVENT_FILE)
    event = Event(**{**told, "formats": tuple(told.get("formats", Event().formats))})
    known = event.language in LANGUAGES and event.appearance in APPEARANCES
    if not known or event.retention_days < 0 or not 50 <= event.text_percent <= 300:
        raise ClonerError("a setting is out of its range", _HINT, EVENT_FILE)
    return event


def write_event(folder: Path, event: Event) -> None:
    """Write the event's settings in one step.

    Raises
    ------
    ClonerError
        If the folder cannot be written.
    """
    told = {"format": FORMAT, **{one.name: getattr(event, one.name) for one in fields(event)}}
    write_text(folder / EVENT_FILE, json.dumps(told, indent=1, ensure_ascii=False) + "\n")


def is_visitor(folder: Path) -> bool:
    """Return whether a folder is one visitor's."""
    return (folder / VISIT_FILE).is_file() or holds_photos(folder)


def check_event_folder(folder: Path) -> None:
    """Refuse folders that are neither an event nor empty: visitors are not strewn among strangers' files.

    Raises
    ------
    ClonerError
        If the folder is missing or holds other things.
    """
    if not folder.is_dir():
        raise ClonerError("there is no such folder", "Choose another, or make it first", folder.name)
    try:
        inside = [path for path in folder.iterdir() if not path.name.startswith(".")]
    except OSError as error:
        raise ClonerError("the folder cannot be read", "Check its permissions", folder.name) from error
    if inside and not (folder / EVENT_FILE).exists() and not visitor_folders(folder):
        hint = "Choose an empty folder, an event's, or one with photos named body_front.jpg and so on"
        raise ClonerError("this folder holds other things than visitors", hint, folder.name)


def visitor_folders(root: Path) -> tuple[Path, ...]:
    """Return the folders of an event's visitors, by name."""
    inside = (path for path in sorted(root.iterdir()) if path.is_dir() and not path.name.startswith("."))
    return tuple(path for path in inside if is_visitor(path))


def new_visitor(root: Path, now: str) -> Path:
    """Make the folder of the next visitor, called by a number: names stay inside.

    Parameters
    ----------
    root : Path
        The event.
    now : str
        The time, for the visit's own file.

    Raises
    ------
    ClonerError
        If it cannot be made.
    """
    taken = [int(path.name[8:]) for path in root.glob("visitor-*") if path.name[8:].isdigit()]
    folder = root / f"visitor-{max(taken, default=0) + 1:03d}"
    try:
        folder.mkdir(parents=True)
    except OSError as error:
        raise ClonerError("the visitor's folder cannot be made", "Check permissions and space", root.name) from error
    write_visit(folder, replace(Visit(), started=now))
    return folder


def visits(root: Path, read: Callable[[Path], Visit] = read_visit) -> dict[Path, Visit]:
    """Return how far every visitor of an event has come, by folder; ``read`` reads one visit."""
    return {folder: read(folder) for folder in visitor_folders(root)}
