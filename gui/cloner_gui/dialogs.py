"""The one way an error reaches the operator."""

from __future__ import annotations

import logging
import sys
from types import TracebackType

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QMessageBox, QWidget

from cloner.errors import ClonerError

log = logging.getLogger(__name__)


def show_error(error: ClonerError, parent: QWidget | None = None) -> QMessageBox:
    """Open a dialog that says what is wrong, where, and what to do; the window stays usable behind it."""
    box = QMessageBox(QMessageBox.Icon.Warning, "Cloner", f"{error.where}: {error.message}.", parent=parent)
    box.setInformativeText(f"{error.hint}.")
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.open()
    return box


def catch_everything() -> None:
    """Show a dialog for errors that escape from a slot; without it Qt only prints them."""

    def hook(kind: type[BaseException], value: BaseException, trace: TracebackType | None) -> None:
        log.error("unexpected error", exc_info=(kind, value, trace))
        if QApplication.instance() is not None:
            error = value if isinstance(value, ClonerError) else _unexpected(value)
            show_error(error, QApplication.activeWindow())

    sys.excepthook = hook


def _unexpected(value: BaseException) -> ClonerError:
    message = f"something went wrong that the program did not expect ({type(value).__name__})"
    return ClonerError(message, "Start it from a terminal with -v and send what it prints", "Cloner")
