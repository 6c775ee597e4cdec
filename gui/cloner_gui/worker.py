"""Long work off the window's thread, with progress and cancellation."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable

from PySide6.QtCore import QObject, QThread, Signal

from cloner.errors import Cancelled, ClonerError

log = logging.getLogger(__name__)

Work = Callable[[Callable[[str, float], None]], object]


_running: set[Task] = set()


def stop_all_tasks() -> None:
    """Ask all work of all pages to stop and wait for it: a thread that outlives its program ends it with a crash."""
    tasks = tuple(_running)
    for task in tasks:
        task.cancel()
    for task in tasks:
        task.wait()


def unexpected() -> ClonerError:
    """Return what the operator is told about a defect; the log has it already."""
    message = "something went wrong that the program did not expect"
    return ClonerError(message, "Start it from a terminal with -v and send what it prints", "Cloner")


class Task(QThread):
    """Runs one function; exactly one of ``succeeded``, ``failed`` and ``stopped`` follows.

    Parameters
    ----------
    work : callable
        Gets ``progress(step, fraction)``, which raises Cancelled once :meth:`cancel` was called.
    """

    progressed = Signal(str, float)
    succeeded = Signal(object)
    failed = Signal(object)
    stopped = Signal()

    def __init__(self, work: Work, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._work = work
        self._cancelled = threading.Event()
        self.finished.connect(self._leave)

    def start(self, priority: QThread.Priority = QThread.Priority.InheritPriority) -> None:
        """Begin the work on a new thread."""
        _running.add(self)
        super().start(priority)

    def cancel(self) -> None:
        """Ask the work to stop at its next progress call."""
        self._cancelled.set()

    def run(self) -> None:
        """Do the work; Qt calls this on the new thread."""
        try:
            value = self._work(self._progress)
        except Cancelled:
            self.stopped.emit()
        except ClonerError as error:
            self.failed.emit(error)
        except Exception:  # this is one of the three places that may catch everything
            log.exception("the work failed")
            self.failed.emit(unexpected())
        else:
            self.succeeded.emit(value)

    def _leave(self) -> None:
        """Be forgotten, on the window's thread: the last reference to a thread must not go on that thread itself."""
        _running.discard(self)

    def _progress(self, step: str, fraction: float) -> None:
        if self._cancelled.is_set():
            raise Cancelled
        self.progressed.emit(step, fraction)
