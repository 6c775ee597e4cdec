"""A visitor's progress: the window's page, the queue, and the operator's effort."""

from __future__ import annotations

import json
import logging
import os
from dataclasses import asdict, dataclass
from enum import StrEnum
from pathlib import Path
from typing import Final

from cloner.project.atomic import write_text
from cloner.project.texts import LARGEST_BYTES
from cloner.untrusted import read_untrusted

log = logging.getLogger(__name__)

VISIT_FILE: Final = "visit.json"


class State(StrEnum):
    """The state of a visitor's clone."""

    NONE = "none"
    WAITING = "waiting"  # also while it is cloned: after a crash it is simply cloned again
    CLONED = "cloned"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class Visit:
    """A visitor's progress.

    Attributes
    ----------
    page, view : str
        The page and the photo that were seen last.
    state : State
    queued : str
        When the clone was asked for, ISO 8601; orders the queue.
    problem : str
        Why the last clone failed.
    started : str
        When the visitor came.
    language : str
    seconds : float
        For how long the visitor was open in the window.
    clone_seconds : float
    clicks, drags : int
    declined : bool
        Whether an operator took the visitor out of the queue: nobody is cloned against that.
    trashed : str
        When the visitor was thrown away, ISO 8601; "" for who was not.
    shown : bool
        Whether the visitor agreed to be seen, by first name, on the screen for visitors.
    inhabits : bool
        Whether the visitor agreed to walk in the event's scene.
    finished : str
        When the clone was finished, ISO 8601; "" while there is none.
    """

    page: str = "visitor"
    view: str = ""
    state: State = State.NONE
    queued: str = ""
    problem: str = ""
    started: str = ""
    language: str = ""
    seconds: float = 0.0
    clone_seconds: float = 0.0
    clicks: int = 0
    drags: int = 0
    declined: bool = False
    shown: bool = False
    inhabits: bool = False
    trashed: str = ""
    finished: str = ""


_KINDS: Final = {key: type(value) for key, value in asdict(Visit()).items()}


def read_visit(folder: Path) -> Visit:
    """Return a visitor's progress; a new one if the file is missing or damaged.

    The file is the window's own memory: losing it costs a click, so it never stands in the way of the photos.
    """
    try:
        data = json.loads(read_untrusted(folder / VISIT_FILE, LARGEST_BYTES))
        return Visit(**{key: _KINDS[key](value) for key, value in data.items() if key in _KINDS})
    except FileNotFoundError:
        return Visit()
    except (OSError, ValueError, TypeError, AttributeError, ArithmeticError, RecursionError):
        log.warning("%s: the visit's file cannot be read; it starts anew", folder.name)
        return Visit()


class KnownVisits:
    """Reads visits, and a file again only after it has changed, as there can be hundreds."""

    def __init__(self) -> None:
        self._known: dict[Path, tuple[tuple[int, int, int], Visit]] = {}

    def read(self, folder: Path) -> Visit:
        """Return a visitor's progress, as :func:`read_visit` does."""
        try:
            found = os.stat(os.path.join(folder, VISIT_FILE))  # asked for hundreds of visitors at once
        except OSError:
            self._known.pop(folder, None)
            return read_visit(folder)
        stamp = (found.st_ino, found.st_mtime_ns, found.st_size)
        known = self._known.get(folder)
        if known is None or known[0] != stamp:
            known = self._known[folder] = (stamp, read_visit(folder))
        return known[1]


def write_visit(folder: Path, visit: Visit) -> None:
    """Write a visitor's progress atomically.

    Raises
    ------
    ClonerError
        If the folder cannot be written.
    """
    write_text(folder / VISIT_FILE, json.dumps(asdict(visit), indent=1, ensure_ascii=False) + "\n")
