"""What is cut off in a window: every text must have the room that it asks for."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any, Final

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QLabel,
    QLineEdit,
    QListView,
    QListWidget,
    QMenuBar,
    QScrollArea,
    QTableWidget,
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
    return found + [told for kind in _INSIDE for one in window.findChildren(kind) for told in _seen_in(window, one)]


def beyond_screen(window: QWidget, width: int, height: int) -> list[str]:
    """Return whether a window asks for more than a screen has, in points."""
    least = window.minimumSizeHint().expandedTo(window.minimumSize())
    if least.width() <= width and least.height() <= height:
        return []
    return [f"{type(window).__name__} asks for {least.width()} x {least.height()} of {width} x {height}"]


def _seen_in(window: QWidget, one: QWidget) -> list[str]:
    """Return what is cut off among the things that a visible control paints itself."""
    if not one.isVisibleTo(window) or one.window() is not window.window():
        return []
    return _INSIDE[next(kind for kind in _INSIDE if isinstance(one, kind))](one)


def _menu_bar(bar: QMenuBar) -> list[str]:
    """Return menus that have no room in the bar: Qt hides them behind an arrow."""
    places = {one.text(): bar.actionGeometry(one) for one in bar.actions() if one.isVisible()}
    return [f"menu {text!r} at {at}" for text, at in places.items() if at.right() >= bar.width() or at.isEmpty()]


def _table(table: QTableWidget) -> list[str]:
    """Return headings and cells that are narrower or lower than their texts."""
    head, cut = table.horizontalHeader(), []
    for column in range(table.columnCount()):
        title, wide = table.horizontalHeaderItem(column), head.sectionSize(column)
        if title is not None and head.sectionSizeHint(column) > wide:
            cut.append(f"heading {title.text()!r}: {wide} px wide, wants {head.sectionSizeHint(column)}")
        for row in range(table.rowCount()):
            item = table.item(row, column)
            if item is not None and item.text():
                wanted = table.sizeHintForIndex(table.indexFromItem(item))
                words = [one for one in item.text().split() if table.fontMetrics().horizontalAdvance(one) > wide]
                if words or (wanted.width() > wide and wanted.height() > table.rowHeight(row)):
                    cut.append(f"cell {item.text()!r}: {wide} x {table.rowHeight(row)} px, wants {wanted.toTuple()}")
    return cut


def _list(items: QListWidget) -> list[str]:
    """Return entries with a word wider than the list, or with more lines than there is room for."""
    cut, letters = [], items.fontMetrics()
    for row in range(items.count()):
        item = items.item(row)
        icons = items.viewMode() is QListView.ViewMode.IconMode
        wide = items.visualItemRect(item).width() - 2 * _LIST_EDGE
        lines = item.text().splitlines()
        words = [one for one in item.text().split() if letters.horizontalAdvance(one) > wide]
        broken = sum(
            letters.boundingRect(0, 0, max(wide, 1), 9999, Qt.TextFlag.TextWordWrap, one).height() for one in lines
        )
        high = items.visualItemRect(item).height() - (items.iconSize().height() if icons else 0)
        if words or broken > high:
            cut.append(f"entry {item.text()!r}: {broken} px of text in {wide} x {high} px")
    return cut


def _line(field: QLineEdit) -> list[str]:
    """Return what stands in an empty field and does not fit: nobody can scroll that."""
    text = field.placeholderText() if not field.text() else ""
    wide = field.fontMetrics().horizontalAdvance(text)
    room = field.contentsRect().width() - 4
    return [f"placeholder {text!r}: {wide} px in {room} px"] if wide > room else []


def _choice(box: QComboBox) -> list[str]:
    """Return an entry that is wider than the box: it is what is chosen, or may be."""
    room, letters = box.width() - _ARROW_PX, box.fontMetrics()
    wide = max((letters.horizontalAdvance(box.itemText(row)) for row in range(box.count())), default=0)
    return [f"choice {box.accessibleName()!r}: {wide} px in {room} px"] if wide > room else []


#: What the style sheet keeps beside the text: of an entry of a list, and of a box with its arrow.
_LIST_EDGE: Final = 8
_ARROW_PX: Final = 26 + 8
_INSIDE: Final[Mapping[type[QWidget], Callable[[Any], list[str]]]] = {
    QMenuBar: _menu_bar, QTableWidget: _table, QListWidget: _list, QLineEdit: _line, QComboBox: _choice,
}  # fmt: skip


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
    return [] if rich else [part for part in re.split(r"\s+|(?<=[-/])", one.text()) if part]


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
