"""How long a window's thread does not listen, by its own work: CPU time between two beats of its event loop."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent


class Silence:
    """Watches the window's thread while something is done step by step.

    A step is what one press of a hand begins; it is followed until nothing is left to do, one round of the event loop
    at a time. CPU seconds of the thread are counted, so that other work on the machine does not matter.
    """

    def __init__(self) -> None:
        self.longest: dict[str, float] = {}

    def step(self, name: str, act: Callable[[], object], done: Callable[[], bool] = lambda: True) -> float:
        """Do something, wait for what it begins, and return the longest stretch without listening, milliseconds."""
        begun = time.thread_time()
        act()
        longest = time.thread_time() - begun
        quiet, end = 0, time.monotonic() + 120.0
        while quiet < 20 or not done():
            if time.monotonic() > end:
                raise TimeoutError(name)
            begun = time.thread_time()
            QCoreApplication.processEvents()
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            spent = time.thread_time() - begun
            longest = max(longest, spent)
            quiet = quiet + 1 if spent < 0.002 else 0
            time.sleep(0.002)
        self.longest[name] = max(self.longest.get(name, 0.0), 1000.0 * longest)
        return 1000.0 * longest

    def told(self) -> str:
        """Return all steps, the longest first."""
        rows = sorted(self.longest.items(), key=lambda one: -one[1])
        return "\n".join(f"{spent:6.0f} ms  {name}" for name, spent in rows)
