"""The kiosk: full screen, no menus, no other visitors; deletion and leaving need the operator's number."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QInputDialog, QLineEdit, QWidget

from cloner.booth.events.pin import PinLock
from cloner_gui.language.words import translate

if TYPE_CHECKING:
    from cloner_gui.main_window import MainWindow


def ask_number(parent: QWidget) -> str:
    """Ask for the operator's number; "" if none is entered."""
    title = translate("kiosk", "Operator")
    told, fine = QInputDialog.getText(
        parent, title, translate("kiosk", "Number of the operator"), QLineEdit.EchoMode.Password
    )
    return told if fine else ""


class Kiosk(QObject):
    """Locks the window for visitors.

    Parameters
    ----------
    window : MainWindow
    """

    changed = Signal()

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._booth = window, window.booth
        self._door = PinLock()
        self.on = False
        window.booth.allowed = self.allows
        self._key = QShortcut(QKeySequence("Ctrl+Shift+K"), window)
        self._key.activated.connect(self.toggle)

    def toggle(self) -> None:
        """Begin, or end with the right number."""
        if not self.on:
            self._begin()
        elif self.allows():
            self._end()

    def allows(self) -> bool:
        """Return whether an operator's action is allowed: always outside the kiosk."""
        if not self.on:
            return True
        if self._door.is_locked():
            self._booth.told.emit(translate("kiosk", "Too many wrong numbers: wait half a minute."))
            return False
        number = ask_number(self._window)
        if not number:
            return False
        fine = self._door.accepts(number, self._booth.settings.pin)
        if not fine:
            self._booth.told.emit(translate("kiosk", "This is not the number."))
        return fine

    def _begin(self) -> None:
        if not self._booth.settings.pin:
            self._booth.told.emit(translate("kiosk", "Give the operator a number under Event, Settings first."))
            return
        self.on = True
        self._show()
        self._window.showFullScreen()

    def _end(self) -> None:
        self.on = False
        self._show()
        self._window.showNormal()

    def _show(self) -> None:
        self._window.menuBar().setVisible(not self.on)
        self._window.visitor.show_others(not self.on)
        self.changed.emit()
