"""Visitors waiting for their clone: cloned in the background while the next one is photographed."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from cloner.booth.body_preview import Shape
from cloner.booth.handover.takeaway import has_result
from cloner.booth.opened import Cloned
from cloner.booth.visitors import waiting_line
from cloner.booth.visitors.cached_work import RESULTS
from cloner.booth.visitors.visits import Visit, read_visit, write_visit
from cloner.errors import ClonerError
from cloner.project.folder import safe_identifier
from cloner_gui.background.worker import Task
from cloner_gui.event.services import Services

log = logging.getLogger(__name__)


def now_text() -> str:
    """Return the time in the format of the visits' files."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def update_visit(folder: Path, change: Callable[[Visit], Visit]) -> None:
    """Read, change and write a visit's file, unless the folder was removed meanwhile."""
    if folder.is_dir():
        write_visit(folder, change(read_visit(folder)))


def note_asked(folder: Path) -> Path:
    """Record that a clone of a visitor was requested now; return the visitor."""
    update_visit(folder, lambda visit: waiting_line.with_request(visit, now_text()))
    return folder


@dataclass(slots=True)
class _Run:
    """A clone under way.

    Attributes
    ----------
    task : Task
    since : float
        When it began, by the monotonic clock, seconds.
    fraction : float
        How much is done, 0..1.
    shape : Shape or None
        The body as far as it has come.
    """

    task: Task
    since: float
    fraction: float = 0.0
    shape: Shape | None = None


class CloneQueue(QObject):
    """Clones visitors, several at once if requested; the queue is stored in the visits' files and survives a crash.

    Parameters
    ----------
    services : Services
    """

    changed = Signal()
    progressed = Signal(Path, str, float)
    finished = Signal(Path, object)
    failed = Signal(Path, object)
    grown = Signal(Path)
    """A visitor who is cloned just now has another :meth:`shape`."""

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.formats: tuple[str, ...] = ("glb", "wrl")
        self.usual_s = waiting_line.USUAL_S
        self._at_once = 1
        self._services = services
        self._waiting: list[Path] = []
        self._runs: dict[Path, _Run] = {}
        self._ending: set[Path] = set()  # answered already; their threads still wind up

    @property
    def at_work(self) -> Path | None:
        """The visitor who has been cloned for longest of those who are cloned just now."""
        return next(iter(self._runs), None)

    def clone_at_once(self, many: int) -> None:
        """Clone so many visitors at the same time from now on."""
        if many != self._at_once:
            self._at_once = many
            self._next()

    def holds(self, folder: Path | None) -> bool:
        """Return whether a visitor waits or is cloned just now."""
        return folder is not None and (folder in self._runs or folder in self._waiting)

    def size(self) -> int:
        """Return how many wait, those under way included."""
        return len(self._waiting) + len(self._runs)

    def shape(self, folder: Path) -> Shape | None:
        """Return the body of a visitor as far as the clone under way has come."""
        return self._runs[folder].shape if folder in self._runs else None

    def seconds_left(self, folder: Path) -> float:
        """Return how long a visitor in the queue still waits."""
        run = self._runs.get(folder) or next(iter(self._runs.values()), None)
        before = 0 if folder in self._runs else 1 + self._waiting.index(folder) // self._at_once
        fraction, spent_s = (run.fraction, time.monotonic() - run.since) if run is not None else (0.0, 0.0)
        return waiting_line.seconds_left(fraction, spent_s, self.usual_s, before)

    def ask(self, folder: Path) -> None:
        """Put a visitor at the end of the queue."""
        if not self.holds(folder):
            self.resume((note_asked(folder),))

    def resume(self, folders: tuple[Path, ...]) -> None:
        """Go on with visitors who waited already."""
        self._waiting += [folder for folder in folders if not self.holds(folder)]
        self._next()

    def drop(self, folder: Path) -> None:
        """Clone a visitor who goes no more, and wait until nothing is written: the clone's process ends at once."""
        self._stop(folder)
        if folder in self._runs:
            self._runs[folder].task.wait()

    def _stop(self, folder: Path) -> None:
        if folder in self._waiting:
            self._waiting.remove(folder)
        elif folder in self._runs:
            self._runs[folder].task.cancel()

    def withdraw(self, folder: Path) -> None:
        """Take a visitor out of the queue, at once."""
        self._stop(folder)
        done = has_result(folder / RESULTS / safe_identifier(folder.name))
        update_visit(folder, lambda visit: waiting_line.without_request(visit, done))
        self.changed.emit()

    def close(self) -> None:
        """Stop the work and wait for it; who waits is cloned when the event is opened again."""
        self._waiting.clear()
        for run in self._runs.values():
            run.task.cancel()
        for run in self._runs.values():
            run.task.wait()

    def _next(self) -> None:
        while self._waiting and len(self._runs) + len(self._ending) < self._at_once:
            self._begin(self._waiting.pop(0))
        self.changed.emit()

    def _begin(self, folder: Path) -> None:
        task = Task(lambda progress: self._services.clone(folder, self.formats, progress, task.show))
        self._runs[folder] = _Run(task, time.monotonic())
        task.shown.connect(partial(self._grow, folder))
        task.progressed.connect(partial(self._tell, folder))
        task.succeeded.connect(partial(self._take, folder))
        task.failed.connect(partial(self._complain, folder))
        task.finished.connect(partial(self._done, folder, task))
        task.start()

    def _tell(self, folder: Path, step: str, fraction: float) -> None:
        if folder in self._runs:
            self._runs[folder].fraction = fraction
            self.progressed.emit(folder, step, fraction)

    def _grow(self, folder: Path, shape: Shape) -> None:
        if folder in self._runs:
            self._runs[folder].shape = shape
            self.grown.emit(folder)

    def _take(self, folder: Path, made: tuple[Cloned, float]) -> None:
        cloned, seconds = made
        self._let_go(folder)
        log.info("%s: cloned in %.0f s", folder.name, seconds)
        update_visit(folder, lambda visit: waiting_line.with_clone(visit, seconds, now_text()))
        self.finished.emit(folder, cloned)

    def _let_go(self, folder: Path) -> None:
        """Let a clone wait no longer: who is told of it must not find it under way still."""
        del self._runs[folder]
        self._ending.add(folder)

    def _complain(self, folder: Path, error: ClonerError) -> None:
        self._let_go(folder)
        log.warning("%s: not cloned", folder.name)
        update_visit(folder, lambda visit: waiting_line.with_failure(visit, str(error)))
        self.failed.emit(folder, error)

    def _done(self, folder: Path, task: Task) -> None:
        if folder in self._runs and self._runs[folder].task is task:
            del self._runs[folder]
        self._ending.discard(folder)
        self._next()
