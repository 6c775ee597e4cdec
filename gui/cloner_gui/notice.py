"""The quiet bar: what went wrong and what to do, without stopping anybody."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QToolButton, QWidget

from cloner.errors import ClonerError
from cloner_gui.pieces import name
from cloner_gui.told import told_error
from cloner_gui.words import translate


class Notice(QFrame):
    """Shows one message until it is closed or another comes."""

    closed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("notice")
        self.text = QLabel()
        self.text.setWordWrap(True)
        self.close_button = QToolButton()
        self.close_button.setText("✕")
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 6, 6, 6)
        row.addWidget(self.text, 1)
        row.addWidget(self.close_button)
        self.close_button.clicked.connect(self.hide)
        self.hide()

    def tell(self, error: ClonerError) -> None:
        """Show what is wrong and what to do."""
        self.say(told_error(error))

    def say(self, text: str) -> None:
        """Show a message; screen readers hear it as the bar's name."""
        self.text.setText(text)
        name(self.close_button, translate("window", "Close the message"))
        name(self, text)
        self.show()
