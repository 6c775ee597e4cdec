"""Python's garbage is collected in the window's thread only.

Left to itself Python collects on whichever thread happens to allocate, and a widget that dies on a worker's thread
takes the program with it (seen in the tests: a segmentation fault while a photo was decoded).
"""

from __future__ import annotations

import gc
from typing import Final

from PySide6.QtCore import QObject, QTimer

#: How often it is looked whether there is garbage, milliseconds.
EVERY_MS: Final = 500


class GarbageCollector(QObject):
    """Replaces Python's automatic collection while it lives."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        gc.disable()
        timer = QTimer(self, interval=EVERY_MS)
        timer.timeout.connect(tidy)
        timer.start()

    def stop(self) -> None:
        """Let Python collect by itself again."""
        gc.enable()


def tidy() -> None:
    """Collect what Python would have collected by now: young generations often, old ones seldom."""
    due = [have > threshold > 0 for have, threshold in zip(gc.get_count(), gc.get_threshold(), strict=True)]
    for generation in (2, 1, 0):
        if due[generation]:
            gc.collect(generation)
            return
