"""Long work off the window's thread, with progress and cancellation."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QThread, QTimer, Signal

from cloner.errors import Cancelled, ClonerError

log = logging.getLogger(__name__)

Work = Callable[[Callable[[str, float], None]], object]


_running: set[Kept] = set()


def stop_all_tasks() -> None:
    """Stop the work of all pages and wait for it, as a thread that outlives the program crashes it."""
    threads = tuple(_running)
    for thread in threads:
        thread.cancel()
    for thread in threads:
        thread.wait()


def defect_message() -> ClonerError:
    """Return the message about a defect for the operator; the log has it already."""
    message = "something went wrong that the program did not expect"
    return ClonerError(message, "Start it from a terminal with -v and send what it prints", "Cloner")


class Kept(QThread):
    """A thread without another owner: it is destroyed in the window's thread, after its end, outside its own signals.

    It has no parent, because a parent that goes first ends the program ("destroyed while thread is still running").
    """

    def __init__(self) -> None:
        super().__init__()
        self._cancelled = threading.Event()
        self.finished.connect(self._leave)

    def start(self, priority: QThread.Priority = QThread.Priority.InheritPriority) -> None:
        """Begin the work on a new thread."""
        _running.add(self)
        super().start(priority)

    def cancel(self) -> None:
        """Ask the work to stop at its next chance."""
        self._cancelled.set()

    def _leave(self) -> None:
        """Come to the end on the window's thread, before anybody else hears of it."""
        self.wait()  # Qt tells of the end while the thread still winds up
        QTimer.singleShot(0, self._go)

    def _go(self) -> None:
        _running.discard(self)
        self.deleteLater()


class Task(Kept):
    """Runs one function; exactly one of ``succeeded``, ``failed`` and ``stopped`` follows, then ``finished``.

    Parameters
    ----------
    work : callable
        Gets ``progress(step, fraction)``, which raises Cancelled once :meth:`cancel` was called.
    """

    progressed = Signal(str, float)
    shown = Signal(object)
    """What the work handed to :meth:`show`."""
    succeeded = Signal(object)
    failed = Signal(object)
    stopped = Signal()

    def __init__(self, work: Work) -> None:
        super().__init__()
        self._work: Work | None = work
        self._tell: Callable[[], Any] = self.stopped.emit

    def show(self, value: object) -> None:
        """Show something of the work under way; for the work itself, on its thread."""
        self.shown.emit(value)

    def run(self) -> None:
        """Do the work; Qt calls this on the new thread. Who waits for the value gets it from the window's thread."""
        assert self._work is not None
        try:
            value = self._work(self._progress)
        except Cancelled:
            pass
        except ClonerError as error:
            told = error
            self._tell = lambda: self.failed.emit(told)
        except Exception:  # this is one of the three places that may catch everything
            log.exception("the work failed")
            self._tell = lambda: self.failed.emit(defect_message())
        else:
            self._tell = lambda: self.succeeded.emit(value)

    def _leave(self) -> None:
        """Tell what became of the work; what it held goes on the window's thread, as everything of Qt's must."""
        super()._leave()
        tell, self._tell, self._work = self._tell, self.stopped.emit, None
        tell()

    def _progress(self, step: str, fraction: float) -> None:
        if self._cancelled.is_set():
            raise Cancelled
        self.progressed.emit(step, fraction)
