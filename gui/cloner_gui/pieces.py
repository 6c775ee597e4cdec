"""Small things that pages are made of: cards, labels, buttons that a screen reader can name."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

GAP = 12  # px between things on a page; taste
EDGE = 18  # px around a card's content; taste


class Card(QFrame):
    """A light sheet with things below each other; ``column`` takes them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(EDGE, EDGE, EDGE, EDGE)
        self.column.setSpacing(GAP)


def label(kind: str = "", *, wraps: bool = True) -> QLabel:
    """Return a label that may break its text; ``kind`` names its look: title, heading, dim, warn or good."""
    made = QLabel()
    made.setObjectName(kind)
    made.setWordWrap(wraps)
    made.setTextFormat(Qt.TextFormat.PlainText)
    return made


def button(kind: str = "") -> QPushButton:
    """Return a button; ``kind`` is "main" for the one thing to do next, "danger" for what cannot be undone."""
    made = QPushButton()
    made.setObjectName(kind)
    made.setSizePolicy(QSizePolicy.Policy.Minimum, QSizePolicy.Policy.Fixed)
    return made


def name(widget: QWidget, text: str, told: str = "") -> None:
    """Give a control the name, and if need be the description, that a screen reader says."""
    widget.setAccessibleName(text)
    if told:
        widget.setAccessibleDescription(told)
        widget.setToolTip(told)


def restyle(widget: QWidget, kind: str) -> None:
    """Give a widget another look of the style sheet."""
    if widget.objectName() != kind:
        widget.setObjectName(kind)
        widget.style().unpolish(widget)
        widget.style().polish(widget)
