"""Small building blocks: cards, labels, buttons with accessible names."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QMouseEvent, QResizeEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QFrame,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QTableWidget,
    QVBoxLayout,
    QWidget,
)

GAP = 12  # px between things on a page; taste
EDGE = 18  # px around a card's content; taste
LINE_PX = 17  # height of a line of text of the usual size


class Card(QFrame):
    """A light sheet with a column of content."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(EDGE, EDGE, EDGE, EDGE)
        self.column.setSpacing(GAP)


class Scrolled(QScrollArea):
    """Scrolls up and down; what is inside is as high as its texts need in the width that is left beside the bar."""

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the inside to the new width."""
        super().resizeEvent(event)
        self._fit()

    def event(self, event: QEvent) -> bool:
        """Fit the inside when texts have changed: what is inside says so to what is around it."""
        fits = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self._fit()
        return fits

    def _fit(self) -> None:
        inside = self.widget()
        layout = None if inside is None else inside.layout()
        if inside is not None and layout is not None and layout.hasHeightForWidth():
            high = max(layout.totalHeightForWidth(self.viewport().width()), 0)
            if high != inside.minimumHeight():  # asked again and again it would never rest
                inside.setMinimumHeight(high)


def make_scrollable(page: QWidget, inside: QWidget) -> QScrollArea:
    """Make a page's content scroll vertically if the screen is low or the text large."""
    room = Scrolled()
    room.setWidget(inside)
    room.setWidgetResizable(True)
    room.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    room.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # it scrolls to whatever inside has the keyboard
    column = QVBoxLayout(page)
    column.setContentsMargins(0, 0, 0, 0)
    column.addWidget(room)
    return room


def label(kind: str = "", *, wraps: bool = True) -> QLabel:
    """Return a label that may wrap; ``kind`` selects its style: title, heading, dim, warn or good."""
    made = QLabel()
    made.setObjectName(kind)
    made.setWordWrap(wraps)
    made.setTextFormat(Qt.TextFormat.PlainText)
    return made


def box_with_label(box: QCheckBox, words: QLabel) -> QHBoxLayout:
    """Return a check box with a label that may wrap; a click on the label toggles the box."""

    def click(event: QMouseEvent) -> None:
        if box.isEnabled():
            box.click()

    words.setBuddy(box)
    words.mousePressEvent = click  # type: ignore[method-assign]
    box.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
    row = QHBoxLayout()
    row.addWidget(box)
    row.addWidget(words, 1)
    return row


def button(kind: str = "") -> QPushButton:
    """Return a button; ``kind`` is "main" for the next thing to do, "danger" for what cannot be undone."""
    made = QPushButton()
    made.setObjectName(kind)
    made.setSizePolicy(QSizePolicy.Policy.Minimum, QSizePolicy.Policy.Fixed)
    return made


def set_window_size(window: QWidget, width: int, height: int) -> None:
    """Give a window a size that grows with its font, within the screen.

    Parameters
    ----------
    window : QWidget
    width, height : int
        px where a line is `LINE_PX` high.
    """
    share = max(window.fontMetrics().height() / LINE_PX, 1.0)
    screen = window.screen().availableGeometry()
    window.resize(min(round(share * width), screen.width()), min(round(share * height), screen.height()))


def show_whole_columns(table: QTableWidget) -> None:
    """Make every column as wide as its heading and its longest cell; the table scrolls if needed."""
    table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    table.setHorizontalScrollMode(QTableWidget.ScrollMode.ScrollPerPixel)


def set_accessible_name(widget: QWidget, text: str, told: str = "") -> None:
    """Give a control a name, and optionally a description, for screen readers."""
    widget.setAccessibleName(text)
    if told:
        widget.setAccessibleDescription(told)
        widget.setToolTip(told)


def restyle(widget: QWidget, kind: str) -> None:
    """Give a widget another style of the style sheet."""
    if widget.objectName() != kind:
        widget.setObjectName(kind)
        widget.style().unpolish(widget)
        widget.style().polish(widget)
        for inside in widget.findChildren(QLabel):
            inside.style().unpolish(inside)
            inside.style().polish(inside)
