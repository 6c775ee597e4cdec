"""How long a window's thread does not listen, by its own work between two beats of its event loop."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Final, Protocol

from PySide6.QtCore import QCoreApplication, QEvent

#: What is read beside the window's thread: pictures and clones.
LARGE: Final = (".jpg", ".jpeg", ".png", ".npz", ".glb")


class Meter(Protocol):
    """Measures the work of this thread from :meth:`begin` to :meth:`end`; less than ``least`` is none."""

    least: float

    def begin(self) -> None:
        """Measure from now on."""

    def end(self) -> float:
        """Return how much was done."""


class Calls:
    """Counts functions called on this thread, Python's own and its libraries': the same number on every machine."""

    least = 500.0

    def __init__(self) -> None:
        self._count = 0

    def begin(self) -> None:
        """Count from now on."""
        self._count = 0
        sys.setprofile(self._note)

    def end(self) -> float:
        """Return how many there were."""
        sys.setprofile(None)
        return float(self._count)

    def _note(self, _frame: object, event: str, _value: object) -> None:
        self._count += event in ("call", "c_call")


class Milliseconds:
    """Measures milliseconds of processor time of this thread: other work on the machine hardly matters."""

    least = 2.0

    def __init__(self) -> None:
        self._begun = 0.0

    def begin(self) -> None:
        """Measure from now on."""
        self._begun = time.thread_time()

    def end(self) -> float:
        """Return how many it took."""
        return 1000.0 * (time.thread_time() - self._begun)


class Silence:
    """Watches the window's thread while something is done step by step.

    A step is what one press of a hand begins; it is followed until nothing is left to do, one round of the event loop
    at a time.

    Parameters
    ----------
    meter : Meter
        What work is measured by.
    """

    def __init__(self, meter: Meter) -> None:
        self._meter = meter
        self.longest: dict[str, float] = {}

    def step(
        self, name: str, act: Callable[[], object], done: Callable[[], bool] = lambda: True, *, goes_on: bool = False
    ) -> None:
        """Do something, wait for what it begins, and keep the longest stretch without listening.

        Parameters
        ----------
        name : str
        act, done : callable
        goes_on : bool
            Whether work goes on afterwards that nobody waits for: it is followed for a while only.
        """
        longest = self._stretch(act)
        quiet, end = 0, time.monotonic() + 120.0
        while quiet < 20 or not done():
            if time.monotonic() > end:
                raise TimeoutError(name)
            spent = self._stretch(_beat)
            longest = max(longest, spent)
            quiet = quiet + 1 if goes_on or spent < self._meter.least else 0
            time.sleep(0.002)
        self.longest[name] = max(self.longest.get(name, 0.0), longest)

    def told(self, unit: str) -> str:
        """Return all steps, the longest first."""
        rows = sorted(self.longest.items(), key=lambda one: -one[1])
        return "\n".join(f"{spent:6.0f} {unit}  {name}" for name, spent in rows)

    def _stretch(self, act: Callable[[], object]) -> float:
        self._meter.begin()
        try:
            act()
        finally:
            spent = self._meter.end()
        return spent


def _beat() -> None:
    QCoreApplication.processEvents()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


class LargeFiles:
    """Notes the large files that the thread which made it opens from Python, while ``with`` it."""

    def __init__(self) -> None:
        self._thread, self._watches = threading.get_ident(), False
        self.opened: list[str] = []
        sys.addaudithook(self._hear)  # there is no way to take it out again: it only rests

    def __enter__(self) -> LargeFiles:
        """Begin to note."""
        self._watches = True
        return self

    def __exit__(self, *_: object) -> None:
        """Rest."""
        self._watches = False

    def _hear(self, event: str, values: Sequence[Any]) -> None:
        if self._watches and event == "open" and threading.get_ident() == self._thread:
            path = values[0]
            if isinstance(path, str | Path) and Path(path).suffix.lower() in LARGE:
                self.opened.append(Path(path).name)
