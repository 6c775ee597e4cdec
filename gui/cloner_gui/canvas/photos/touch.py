"""Touch on a picture: one finger acts as the left button, two zoom and pan."""

from __future__ import annotations

from typing import Protocol

from PySide6.QtCore import QEvent, QLineF, QPointF
from PySide6.QtGui import QEventPoint, QTouchEvent


class Touchable(Protocol):
    """What touch can do with a picture."""

    def take_hold(self, at: QPointF, *, finger: bool = False) -> None:
        """Take hold of what lies at a place."""

    def drag(self, to: QPointF) -> None:
        """Move what is held."""

    def let_go(self) -> None:
        """Hold nothing any more."""

    def pinch(self, move: QPointF, factor: float, about: QPointF) -> None:
        """Pan, and zoom about a place."""


class TouchHand:
    """Translates touches into the picture's mouse actions.

    Parameters
    ----------
    view : Touchable
    """

    def __init__(self, view: Touchable) -> None:
        self._view = view
        self._pinch: tuple[QPointF, float] | None = None

    def feel(self, event: QTouchEvent) -> None:
        """Follow the fingers."""
        event.accept()
        points = [point for point in event.points() if point.state() != QEventPoint.State.Released]
        if event.type() in (QEvent.Type.TouchEnd, QEvent.Type.TouchCancel) or not points:
            self._pinch = None
            self._view.let_go()
        elif len(points) == 1 and self._pinch is None:
            if event.type() == QEvent.Type.TouchBegin:
                self._view.take_hold(points[0].position(), finger=True)
            else:
                self._view.drag(points[0].position())
        elif len(points) >= 2:
            self._spread(points[0].position(), points[1].position())

    def _spread(self, first: QPointF, second: QPointF) -> None:
        """Zoom as the fingers part and move as they move together."""
        line = QLineF(first, second)
        middle, length = line.center(), max(line.length(), 1.0)
        if self._pinch is None:
            self._view.let_go()
        else:
            before, was = self._pinch
            self._view.pinch(middle - before, length / was, middle)
        self._pinch = middle, length
