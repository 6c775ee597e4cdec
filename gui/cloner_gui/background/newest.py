"""Short work in a background thread: of each kind only the latest request is done.

Pictures of the clone, its outline, and its body after a drag: each takes some ten milliseconds and is out of date as
soon as the hand moves on. One thread does them all, because a GL context stays on its thread.
"""

from __future__ import annotations

import atexit
import functools
import logging
import threading
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import shiboken6
from PySide6.QtCore import QObject, Qt, Signal

from cloner.errors import ClonerError
from cloner_gui.background.worker import defect_message

log = logging.getLogger(__name__)

#: How long the end waits for work under way, seconds: a picture takes a tenth of one.
PATIENCE_S: Final = 10.0


@dataclass(frozen=True, slots=True, eq=False)
class _Wish:
    """Work that somebody waits for: ``then`` gets its value, ``failed`` its error, both on the window's thread."""

    owner: QObject
    work: Callable[[], Any]
    then: Callable[[Any], None]
    failed: Callable[[ClonerError], None]


class LatestOnly(QObject):
    """A thread and its latest requests."""

    _answered = Signal()  # the answers lie in a queue: nothing that Qt counts by itself changes threads

    def __init__(self) -> None:
        super().__init__()
        self._wishes: dict[tuple[int, str], _Wish] = {}
        self._begun: deque[_Wish] = deque()  # their owners: a widget's last reference must not go on the other thread
        self._answers: deque[Any] = deque()
        self._told = threading.Condition()
        self._ends = False
        self._thread: threading.Thread | None = None
        self._answered.connect(self._hand_back, Qt.ConnectionType.QueuedConnection)

    @property
    def idle(self) -> bool:
        """Whether everything that was asked for is answered."""
        return not self._wishes and not self._begun

    def ask(
        self,
        owner: QObject,
        kind: str,
        work: Callable[[], Any],
        then: Callable[[Any], None],
        failed: Callable[[ClonerError], None],
    ) -> None:
        """Do work soon, in place of what the owner asked for of this kind and was not begun yet.

        Parameters
        ----------
        owner : QObject
            Who asks; once it is deleted nobody is answered.
        kind : str
        work : callable
            Runs on the other thread: it may touch values, no widget.
        then, failed : callable
            Called with the work's value or error on the window's thread.
        """
        with self._told:
            self._wishes[id(owner), kind] = _Wish(owner, work, then, failed)
            if self._thread is None:
                self._thread = threading.Thread(target=self._run, name="newest", daemon=True)
                self._thread.start()
            self._told.notify()

    def drop(self, owner: QObject, kind: str) -> None:
        """Do not begin what the owner asked for of this kind."""
        with self._told:
            self._wishes.pop((id(owner), kind), None)

    def close(self) -> None:
        """End the thread; what was not begun is not done. Another wish starts another thread."""
        with self._told:
            self._ends = True
            self._wishes.clear()
            self._told.notify()
        if self._thread is not None:
            self._thread.join(PATIENCE_S)
        self._thread, self._ends = None, False

    def _run(self) -> None:
        while True:
            with self._told:
                self._told.wait_for(lambda: self._ends or bool(self._wishes))
                if self._ends:
                    return
                self._begun.append(self._wishes.pop(next(iter(self._wishes))))
                work = self._begun[-1].work
            self._answers.append(_done(work))
            del work  # the last reference to what it holds goes with the wish, on the window's thread
            self._answered.emit()

    def _hand_back(self) -> None:
        wish, answer = self._begun.popleft(), self._answers.popleft()
        if shiboken6.isValid(wish.owner):
            (wish.failed if isinstance(answer, ClonerError) else wish.then)(answer)


def _done(work: Callable[[], Any]) -> Any:
    """Return the value or the error of some work."""
    try:
        return work()
    except ClonerError as error:
        return error
    except Exception:  # as in `worker.Task`: the thread must outlive the defect of one picture
        log.exception("the work failed")
        return defect_message()


@functools.cache
def shared_latest() -> LatestOnly:
    """Return the program's one thread for short work."""
    made = LatestOnly()
    atexit.register(made.close)
    return made
