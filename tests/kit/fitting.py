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
        if one.width() < wanted.width() or one.height() < wanted.height():
            return f"{one.width()} x {one.height()} px, wants {wanted.width()} x {wanted.height()}"
    if isinstance(one, QComboBox | QAbstractSpinBox):
        wanted = one.minimumSizeHint()
        if one.width() < wanted.width() or one.height() < wanted.height():
            return f"{one.width()} x {one.height()} px, wants {wanted.width()} x {wanted.height()}"
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
    parent, child = one.parentWidget(), one
    while parent is not None:
        place = QRect(one.mapTo(parent, QPoint()), one.size())
        scrolls = isinstance(parent.parentWidget(), QScrollArea) or isinstance(parent, QScrollArea)
        if place.left() < 0 or place.right() > parent.width():
            if not (scrolls and _scrolls_sideways(parent)):
                return f"beyond the side of {type(parent).__name__}"
        if not scrolls and not _inside_scroll(child, parent) and (place.top() < 0 or place.bottom() > parent.height()):
            return f"beyond the edge of {type(parent).__name__}"
        if parent.isWindow():
            break
        child, parent = parent, parent.parentWidget()
    return ""


def _inside_scroll(child: QWidget, parent: QWidget) -> bool:
    node = child
    while node is not None and node is not parent:
        if isinstance(node, QScrollArea):
            return True
        node = node.parentWidget()
    return False


def _scrolls_sideways(parent: QWidget) -> bool:
    area = parent if isinstance(parent, QScrollArea) else parent.parentWidget()
    return isinstance(area, QScrollArea) and area.verticalScrollBarPolicy() is Qt.ScrollBarPolicy.ScrollBarAlwaysOff
