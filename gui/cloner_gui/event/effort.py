"""Counts the operator's clicks: of mouse and touch, or Return and Space on a button."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractButton, QWidget

from cloner_gui.event.booth import Booth

_PRESSES = (QEvent.Type.MouseButtonPress, QEvent.Type.TouchBegin)
_KEYS = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)


class ClickCounter(QObject):
    """An event filter for the whole program."""

    def __init__(self, booth: Booth) -> None:
        super().__init__()
        self._booth = booth
        self._last = 0

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Count a press once, though it is offered to a widget and then to those below."""
        if isinstance(watched, QWidget):
            if event.type() in _PRESSES:
                stamp = event.timestamp()  # type: ignore[attr-defined]
                self._booth.clicks += stamp != self._last
                self._last = stamp
            elif isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress and event.key() in _KEYS:
                self._booth.clicks += isinstance(watched, QAbstractButton)
        return False
