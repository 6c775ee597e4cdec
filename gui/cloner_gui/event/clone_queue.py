"""Visitors who wait for their clone: one is cloned at a time, in the background, while the next is photographed."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from cloner.booth.growing import Shape
from cloner.booth.handover.takeaway import has_result
from cloner.booth.opened import Cloned
from cloner.booth.visitors import line
from cloner.booth.visitors.kept import RESULTS
from cloner.booth.visitors.visits import Visit, read_visit, write_visit
from cloner.errors import ClonerError
from cloner.project.folder import safe_identifier
from cloner_gui.background.worker import Task
from cloner_gui.event.services import Services

log = logging.getLogger(__name__)


def now_text() -> str:
    """Return the time as the visits' files keep it."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def update_visit(folder: Path, change: Callable[[Visit], Visit]) -> None:
    """Read, change and write a visit's file; a folder that went meanwhile stays gone."""
    if folder.is_dir():
        write_visit(folder, change(read_visit(folder)))


def note_asked(folder: Path) -> Path:
    """Note that a clone of a visitor was asked for now; return the visitor."""
    update_visit(folder, lambda visit: line.asked(visit, now_text()))
    return folder


class CloneQueue(QObject):
    """Clones visitors one after the other; who waits stands in the visits' files and survives a crash.

    Parameters
    ----------
    services : Services
    """

    changed = Signal()
    progressed = Signal(Path, str, float)
    finished = Signal(Path, object)
    failed = Signal(Path, object)
    grown = Signal(Path)
    """The body of the visitor who is cloned just now has another :attr:`shape`."""

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.formats: tuple[str, ...] = ("glb", "wrl")
        self.usual_s = line.USUAL_S
        self._services = services
        self._waiting: list[Path] = []
        self._task: Task | None = None
        self._at_work: Path | None = None
        self._fraction, self._since = 0.0, 0.0
        self.shape: Shape | None = None

    @property
    def at_work(self) -> Path | None:
        """The visitor who is cloned just now."""
        return self._at_work

    def holds(self, folder: Path | None) -> bool:
        """Return whether a visitor waits or is cloned just now."""
        return folder is not None and (folder == self._at_work or folder in self._waiting)

    def size(self) -> int:
        """Return how many wait, the one under way included."""
        return len(self._waiting) + (self._at_work is not None)

    def seconds_left(self, folder: Path) -> float:
        """Return how long a visitor in the queue still waits."""
        before = 0 if folder == self._at_work else 1 + self._waiting.index(folder)
        return line.seconds_left(self._fraction, time.monotonic() - self._since, self.usual_s, before)

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
        if folder == self._at_work and self._task is not None:
            self._task.wait()

    def _stop(self, folder: Path) -> None:
        if folder in self._waiting:
            self._waiting.remove(folder)
        elif folder == self._at_work and self._task is not None:
            self._task.cancel()

    def withdraw(self, folder: Path) -> None:
        """Take a visitor out of the queue, at once."""
        self._stop(folder)
        done = has_result(folder / RESULTS / safe_identifier(folder.name))
        update_visit(folder, lambda visit: line.withdrawn(visit, done))
        self.changed.emit()

    def close(self) -> None:
        """Stop the work and wait for it; who waits is cloned when the event is opened again."""
        self._waiting.clear()
        if self._task is not None:
            self._task.cancel()
            self._task.wait()

    def _next(self) -> None:
        if self._task is None and self._waiting:
            folder = self._waiting.pop(0)
            self._at_work, self._fraction, self._since = folder, 0.0, time.monotonic()
            task = Task(lambda progress: self._services.clone(folder, self.formats, progress, task.show))
            self._task, self.shape = task, None
            task.shown.connect(self._grow)
            task.progressed.connect(self._tell)
            task.succeeded.connect(self._take)
            task.failed.connect(self._complain)
            task.finished.connect(self._done)
            task.start()
        self.changed.emit()

    def _tell(self, step: str, fraction: float) -> None:
        if self._at_work is not None:
            self._fraction = fraction
            self.progressed.emit(self._at_work, step, fraction)

    def _grow(self, shape: Shape) -> None:
        if self._at_work is not None:
            self.shape = shape
            self.grown.emit(self._at_work)

    def _take(self, made: tuple[Cloned, float]) -> None:
        folder = self._let_go()
        if folder is not None:
            cloned, seconds = made
            log.info("%s: cloned in %.0f s", folder.name, seconds)
            update_visit(folder, lambda visit: line.cloned(visit, seconds, now_text()))
            self.finished.emit(folder, cloned)

    def _let_go(self) -> Path | None:
        """Return who was cloned, whose clone waits no longer: who is told of it must not find it under way still."""
        folder, self._at_work, self.shape = self._at_work, None, None
        return folder

    def _complain(self, error: ClonerError) -> None:
        folder = self._let_go()
        if folder is not None:
            log.warning("%s: not cloned", folder.name)
            update_visit(folder, lambda visit: line.failed(visit, str(error)))
            self.failed.emit(folder, error)

    def _done(self) -> None:
        self._task = None
        self._let_go()
        self._next()
