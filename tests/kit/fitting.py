"""What is cut off in a window: every text must have the room that it asks for."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QLabel,
    QScrollArea,
    QWidget,
)


def cut_texts(window: QWidget) -> list[str]:
    """Return what is cut off among the visible controls of a window, as sentences."""
    found = []
    for one in window.findChildren(QWidget):
        if one.isVisibleTo(window) and one.window() is window.window():
            told = _too_small(one) or _out_of_sight(one)
            if told:
                found.append(f"{type(one).__name__} {_text(one)!r}: {told}")
    return found


def _text(one: QWidget) -> str:
    return str(one.text()) if isinstance(one, QAbstractButton | QLabel) else one.accessibleName()


def _too_small(one: QWidget) -> str:
    """Return what a control lacks for its text."""
    if isinstance(one, QLabel) and one.text() and one.pixmap().isNull():
        if one.wordWrap():
            wanted = one.heightForWidth(one.width())
            longest = max((one.fontMetrics().horizontalAdvance(word) for word in _words(one)), default=0)
            if longest > one.contentsRect().width():
                return f"a word of {longest} px in {one.contentsRect().width()} px"
            return f"{one.height()} px high, wants {wanted}" if one.height() < wanted else ""
        wanted = one.sizeHint().width()
        return f"{one.width()} px wide, wants {wanted}" if one.width() < wanted else ""
    if isinstance(one, QAbstractButton) and one.text() and not one.inherits("QComboBoxListViewItem"):
        wanted = one.sizeHint() if isinstance(one, QCheckBox) else one.minimumSizeHint()
        high = one.fontMetrics().height() + 6
        if one.width() < wanted.width() or one.height() < high:
            return f"{one.width()} x {one.height()} px, wants {wanted.width()} x {high}"
    if isinstance(one, QComboBox | QAbstractSpinBox):
        wide, high = one.minimumSizeHint().width(), one.fontMetrics().height()
        if one.width() < wide or one.height() < high:
            return f"{one.width()} x {one.height()} px, wants {wide} x {high}"
    return ""


def _words(one: QLabel) -> list[str]:
    rich = one.textFormat() is Qt.TextFormat.RichText or (
        one.textFormat() is Qt.TextFormat.AutoText and "<" in one.text()
    )
    return [] if rich else one.text().split()


def _out_of_sight(one: QWidget) -> str:
    """Return whether a control with a text lies outside what is around it; what scrolls may do so up and down."""
    if not isinstance(one, QLabel | QAbstractButton | QComboBox | QAbstractSpinBox) or not _text(one):
        return ""
    parent, up_and_down, sideways = one.parentWidget(), False, False
    while parent is not None:
        place = QRect(one.mapTo(parent, QPoint()), one.size())
        area = parent.parentWidget()
        if isinstance(area, QScrollArea) and parent is area.viewport():
            up_and_down = True
            sideways = sideways or area.verticalScrollBarPolicy() is Qt.ScrollBarPolicy.ScrollBarAlwaysOff
        if not sideways and (place.left() < 0 or place.right() >= parent.width()):
            return f"beyond the side of {type(parent).__name__} ({place.left()} to {place.right()} of {parent.width()})"
        if not up_and_down and (place.top() < 0 or place.bottom() >= parent.height()):
            return f"beyond the edge of {type(parent).__name__}"
        if parent.isWindow():
            break
        parent = area
    return ""
