"""The body during cloning: animated from one stage's shape to the next one's."""

from __future__ import annotations

import time
from typing import Final

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from cloner.booth.body_preview import Shape, plain_clone
from cloner.records.arrays import Array

#: How long the body takes from one shape to the next, seconds; taste.
GROWS_S: Final = 0.9
#: Between two pictures of it, milliseconds: the clone itself is made on the same cores.
_FRAME_MS: Final = 75


class Growth(QObject):
    """Animates a plain body from shape to shape."""

    shown = Signal(object)
    """A Clone, body alone, to be drawn."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._start: Array | None = None
        self._goal: Array | None = None
        self._began = 0.0
        self._film = QTimer(self, interval=_FRAME_MS)
        self._film.timeout.connect(self._step)

    @property
    def active(self) -> bool:
        """Whether there is a growing body."""
        return self._goal is not None

    def take(self, shape: Shape) -> None:
        """Grow into a shape; the first one stands there at once."""
        goal = np.asarray(shape.vertices_m, dtype=np.float64)
        self._start = goal if self._goal is None else self._now()
        self._goal, self._began = goal, time.monotonic()
        self._film.start()
        self._step()

    def forget(self) -> None:
        """Let go of the body."""
        self._film.stop()
        self._start = self._goal = None

    def _now(self) -> Array:
        """Return the body's (V, 3) vertices at this instant."""
        assert self._start is not None
        assert self._goal is not None
        share = min((time.monotonic() - self._began) / GROWS_S, 1.0)
        eased = share * share * (3.0 - 2.0 * share)
        return self._start + eased * (self._goal - self._start)

    def _step(self) -> None:
        if time.monotonic() - self._began > GROWS_S:
            self._film.stop()
        self.shown.emit(plain_clone(self._now()))
