"""An event's folder: its settings and its visitors."""

from __future__ import annotations

import contextlib
import json
import os
import re
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Final

from cloner.booth.visitors.repair import repair_file
from cloner.booth.visitors.visits import VISIT_FILE, Visit, read_visit, write_visit
from cloner.errors import ClonerError
from cloner.project.atomic import write_text
from cloner.project.folder import holds_photos
from cloner.project.texts import LARGEST_BYTES, check_format
from cloner.records.terms import LICENCES
from cloner.untrusted import read_untrusted

EVENT_FILE: Final = "event.json"
TRASH: Final = "trash"
ASIDE: Final = ".forgetting-"  # before the name of a visitor's folder whose deletion has begun
LOG_FILE: Final = "cloner.log"
#: Number of the file's format; older ones are read too.
FORMAT: Final = 2
LANGUAGES: Final = ("en", "de", "fr", "tr")
APPEARANCES: Final = ("system", "light", "dark", "contrast")
DEFAULT_RETENTION_DAYS: Final = 30  # taste: long enough to mend a complaint, short enough to be forgotten
DEFAULT_TRASH_DAYS: Final = 2  # taste: a slip is noticed on the same day or the next
DEFAULT_PHONE_HOURS: Final = 24  # taste: until the visitor is at home, and no longer
MOST_AT_ONCE: Final = 8  # taste: each takes a core and 1 GiB
_OLD_CONSENT: Final = "consent"
_CHOICES: Final = {"language": LANGUAGES, "appearance": APPEARANCES, "licence": LICENCES}
#: Least and largest value of settings that are numbers (taste).
_RANGES: Final = {
    "retention_days": (0, 3650), "trash_days": (0, 365), "text_percent": (50, 300), "phone_hours": (1, 24 * 30),
    "at_once": (1, MOST_AT_ONCE),
}  # fmt: skip
_WRITE_HINT: Final = "Check its permissions and the space left, or choose another"
_HINT: Final = f"Correct {EVENT_FILE}, or move it away to start with the usual settings"


@dataclass(frozen=True, slots=True)
class Event:
    """Settings that hold for all visitors of an event.

    Attributes
    ----------
    title : str
        What visitors know the event by; "" takes the folder's name.
    logo : str
        A picture's file, shown on the visitors' screen; "" for none.
    language : str
        One of `LANGUAGES`.
    retention_days : int
        Visitors whose last change is older are to be forgotten; 0 keeps them.
    trash_days : int
        How long who was thrown away can be brought back.
    consents : mapping of str to str
        What visitors agree to, by language, "{days}" standing for `retention_days`; a language without takes the
        window's own text.
    licence : str
        The most that visitors may let others do with their files, one of `cloner.records.terms.LICENCES`; each
        chooses at the consent (`cloner.booth.events.agreed`).
    formats : tuple of str
        Exporters whose files visitors take away.
    camera_folder : str
        Where a tethered camera drops its photos; "" for none.
    scene : str
        What visitors call the scene that their clones may walk in ("museum"); "" where there is none.
    link : str
        Address that the take-away code holds, "{id}" standing for the visitor; "" for none.
    at_once : int
        How many visitors are cloned at the same time, 1 to `MOST_AT_ONCE`.
    phone, phone_https : bool
        Whether visitors' phones are served a page on the booth's own network, and whether encrypted with a
        certificate of the booth's own.
    phone_hours : int
        How long a visitor's link leads there.
    pin : str
        The operator's number for settings, deletion and leaving, as `cloner.booth.events.pin` keeps it; "" asks nobody.
    appearance : str
        One of `APPEARANCES`.
    text_percent : int
        Size of the window's text.
    big : bool
        Whether buttons are big enough for fingers.
    calm : bool
        Whether nothing moves by itself.
    open : str
        Folder name of the visitor who was open last.
    """

    title: str = ""
    logo: str = ""
    language: str = "en"
    retention_days: int = DEFAULT_RETENTION_DAYS
    trash_days: int = DEFAULT_TRASH_DAYS
    consents: Mapping[str, str] = field(default_factory=dict)
    licence: str = LICENCES[0]
    formats: tuple[str, ...] = ("glb", "wrl")
    camera_folder: str = ""
    scene: str = ""
    at_once: int = 1
    link: str = ""
    phone: bool = False
    phone_https: bool = False
    phone_hours: int = DEFAULT_PHONE_HOURS
    pin: str = ""
    appearance: str = "system"
    text_percent: int = 100
    big: bool = False
    calm: bool = False
    open: str = ""


_USUAL: Final = asdict(Event())


def read_event(folder: Path) -> Event:
    """Return the event's settings; defaults where nothing was set.

    Raises
    ------
    ClonerError
        If the file cannot be read, says something that cannot be, or is of a newer version.
    """
    path = folder / EVENT_FILE
    if not path.exists():
        return Event()
    try:
        data = json.loads(read_untrusted(path, LARGEST_BYTES))
    except (OSError, ValueError, RecursionError) as error:
        raise ClonerError("the event's settings cannot be read", _HINT, EVENT_FILE) from error
    if not isinstance(data, dict) or "format" not in data:
        raise ClonerError(f'it must be an object with "format": {FORMAT}', _HINT, EVENT_FILE)
    if check_format(data.pop("format"), FORMAT, EVENT_FILE) == 1:
        data = _upgraded(data)
    for key, value in data.items():
        if key not in _USUAL:
            raise ClonerError(f"the key {key!r} is not known", _HINT, EVENT_FILE)
        if not _has_kind(key, value):
            raise ClonerError(f"{key} has a value of the wrong kind", _HINT, EVENT_FILE)
        if not _is_in_range(key, value):
            raise ClonerError("a setting is out of its range", _HINT, EVENT_FILE)
    return _event(data)


def open_event(folder: Path) -> tuple[Event, str]:
    """Return the event's settings, and a message if they were damaged and had to be repaired, else "".

    Raises
    ------
    ClonerError
        If they are of a newer version, or the folder cannot be written.
    """
    path = folder / EVENT_FILE
    message = repair_file(path, lambda: read_event(folder), salvage_event, lambda left: write_event(folder, left))
    return read_event(folder), message


def salvage_event(text: str) -> Event:
    """Return the settings that can still be read in a damaged file's text; defaults for the rest."""
    found: dict[str, Any] = {}
    for key in (*_USUAL, _OLD_CONSENT):
        place = re.search(rf'"{key}"\s*:\s*', text)
        if place is not None:
            with contextlib.suppress(ValueError, RecursionError):
                found[key] = json.JSONDecoder().raw_decode(text, place.end())[0]
    if not isinstance(found.get(_OLD_CONSENT, ""), str):
        found.pop(_OLD_CONSENT)
    kept = _upgraded(found)
    return _event({key: one for key, one in kept.items() if _has_kind(key, one) and _is_in_range(key, one)})


def _upgraded(data: Mapping[str, Any]) -> dict[str, Any]:
    """Return settings of format 1, which had one consent for all languages, in the current format."""
    left = {key: value for key, value in data.items() if key != _OLD_CONSENT}
    if data.get(_OLD_CONSENT):
        left["consents"] = {str(data.get("language", Event().language)): data[_OLD_CONSENT]}
    return left


def _event(data: Mapping[str, Any]) -> Event:
    return Event(**{**data, "formats": tuple(data.get("formats", Event().formats))})


def _has_kind(key: str, value: object) -> bool:
    if key == "formats":
        return isinstance(value, list) and all(isinstance(one, str) for one in value)
    if key == "consents":
        return isinstance(value, dict) and all(isinstance(one, str) for one in value.values())
    return type(value) is type(_USUAL[key])


def _is_in_range(key: str, value: Any) -> bool:
    if key in _CHOICES:
        return value in _CHOICES[key]
    if key == "consents":
        return set(value) <= set(LANGUAGES)
    low, high = _RANGES.get(key, (None, None))
    return low is None or high is None or low <= value <= high


def write_event(folder: Path, event: Event) -> None:
    """Write the event's settings in one step.

    Raises
    ------
    ClonerError
        If the folder cannot be written.
    """
    data = {"format": FORMAT, **{one.name: getattr(event, one.name) for one in fields(event)}}
    write_text(folder / EVENT_FILE, json.dumps(data, indent=1, ensure_ascii=False) + "\n")


def is_visitor(folder: Path) -> bool:
    """Return whether a folder belongs to one visitor."""
    return os.path.isfile(os.path.join(folder, VISIT_FILE)) or holds_photos(folder)


def check_event_folder(folder: Path) -> None:
    """Refuse folders that are neither an event nor empty, so that visitors are never mixed with other files.

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
    check_can_write(folder)
    if inside and not (folder / EVENT_FILE).exists() and not visitor_folders(folder):
        hint = "Choose an empty folder, an event's, or one with photos named body_front.jpg and so on"
        raise ClonerError("this folder holds other things than visitors", hint, folder.name)


def check_can_write(folder: Path) -> None:
    """Refuse a folder that cannot be written when it is opened rather than at the first photo.

    Raises
    ------
    ClonerError
        If nothing can be stored there.
    """
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise ClonerError("nothing can be written into this folder", _WRITE_HINT, folder.name) from error


def visitor_folders(root: Path) -> tuple[Path, ...]:
    """Return the folders of an event's visitors, sorted by name."""
    with os.scandir(root) as inside:
        names = sorted(one.name for one in inside if one.is_dir() and not one.name.startswith("."))
    return tuple(path for path in (root / name for name in names) if is_visitor(path))


def new_visitor(root: Path, now: str) -> Path:
    """Create the next visitor's folder; it is called by a number, so that names appear only in files.

    Parameters
    ----------
    root : Path
    now : str
        The time, for the visit's own file.

    Raises
    ------
    ClonerError
        If it cannot be made.
    """
    known = [path.name.removeprefix(ASIDE) for place in (root, root / TRASH) for path in place.glob("*visitor-*")]
    taken = [int(name[8:]) for name in known if name.startswith("visitor-") and name[8:].isdigit()]
    folder = root / f"visitor-{max(taken, default=0) + 1:03d}"
    try:
        folder.mkdir(parents=True)
    except OSError as error:
        raise ClonerError("the visitor's folder cannot be made", "Check permissions and space", root.name) from error
    write_visit(folder, replace(Visit(), started=now))
    return folder


def visits(root: Path, read: Callable[[Path], Visit] = read_visit) -> dict[Path, Visit]:
    """Return the progress of every visitor of an event by folder; ``read`` reads one visitor's."""
    return {folder: read(folder) for folder in visitor_folders(root)}
