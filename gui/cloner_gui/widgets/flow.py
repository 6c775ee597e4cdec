"""Rows that wrap: controls side by side as far as they fit, the rest below, in every language and size."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtWidgets import QLayout, QLayoutItem, QSizePolicy, QWidget

from cloner_gui.widgets.pieces import GAP


class Flow(QLayout):
    """Lays out its items like the words of a text.

    Parameters
    ----------
    parent : QWidget or None
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._items: list[QLayoutItem] = []
        self._highs: dict[int, int] = {}  # heights by width that were worked out since anything changed
        self._least: QSize | None = None
        self.setContentsMargins(0, 0, 0, 0)
        self.setSpacing(GAP // 2)

    def addItem(self, item: QLayoutItem) -> None:
        """Take an item; Qt calls this."""
        self._items.append(item)

    def count(self) -> int:
        """Return how many items there are."""
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        """Return an item."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        """Remove an item."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self) -> Qt.Orientation:
        """Return that it fills the height where one of its items does."""
        grows = any(bool(item.expandingDirections() & Qt.Orientation.Vertical) for item in self._shown())
        return Qt.Orientation.Vertical if grows else Qt.Orientation(0)

    def hasHeightForWidth(self) -> bool:
        """Return that it grows downwards where it is narrow."""
        return True

    def heightForWidth(self, width: int) -> int:
        """Return how high it is in a width, px."""
        if width not in self._highs:
            self._highs[width] = self._place(QRect(0, 0, width, 0), move=False)
        return self._highs[width]

    def invalidate(self) -> None:
        """Forget sizes: an item has changed; Qt calls this."""
        self._highs, self._least = {}, None
        super().invalidate()

    def setGeometry(self, rect: QRect) -> None:
        """Place all items."""
        super().setGeometry(rect)
        self._place(rect, move=True)

    def sizeHint(self) -> QSize:
        """Return the size of one unbroken row."""
        shown = self._shown()
        width = sum(item.sizeHint().width() for item in shown) + self.spacing() * max(len(shown) - 1, 0)
        return QSize(width, max((item.sizeHint().height() for item in shown), default=0))

    def minimumSize(self) -> QSize:
        """Return the size of the largest item."""
        if self._least is None:
            sizes = [item.minimumSize().expandedTo(_least(item)) for item in self._shown()]
            width = max((one.width() for one in sizes), default=0)
            self._least = QSize(width, max((one.height() for one in sizes), default=0))
        return self._least

    def _shown(self) -> list[QLayoutItem]:
        return [item for item in self._items if not item.isEmpty()]

    def _place(self, rect: QRect, *, move: bool) -> int:
        """Break the items into rows and return how high these are."""
        rows: list[list[tuple[QLayoutItem, int]]] = [[]]
        left = 0
        for item in self._shown():
            width = min(max(item.sizeHint().width(), _least(item).width()), max(rect.width(), 1))
            if rows[-1] and left + width > rect.width():
                rows.append([])
                left = 0
            rows[-1].append((item, width))
            left += width + self.spacing()
        highs = [max((_height(item, width) for item, width in row), default=0) for row in rows]
        needed = sum(highs) + self.spacing() * (len(rows) - 1)
        if move and self.expandingDirections() and rect.height() > needed:
            highs = [high + (rect.height() - needed) // len(rows) for high in highs]
        top = rect.top()
        page = self.parentWidget()
        mirrored = page is not None and page.isRightToLeft()
        for row, high in zip(rows, highs, strict=True):
            self._place_row(row, QRect(rect.left(), top, rect.width(), high), mirrored) if move else None
            top += high + self.spacing()
        return max(top - self.spacing() - rect.top(), 0)

    def _place_row(self, row: list[tuple[QLayoutItem, int]], room: QRect, mirrored: bool) -> None:
        wants = [bool(item.expandingDirections() & Qt.Orientation.Horizontal) for item, _ in row]
        spare = room.width() - sum(width for _, width in row) - self.spacing() * (len(row) - 1)
        each = spare // sum(wants) if any(wants) and spare > 0 else 0
        left = 0
        for (item, width), grows in zip(row, wants, strict=True):
            wide = width + each * grows
            high = _height(item, wide) if _is_flat(item) else room.height()
            x = room.right() + 1 - left - wide if mirrored else room.left() + left
            item.setGeometry(QRect(QPoint(x, room.top() + (room.height() - high) // 2), QSize(wide, high)))
            left += wide + self.spacing()


def _is_flat(item: QLayoutItem) -> bool:
    """Return whether an item keeps its height, as buttons do; others fill their row."""
    widget = item.widget()
    return widget is not None and widget.sizePolicy().verticalPolicy() is QSizePolicy.Policy.Fixed


def _least(item: QLayoutItem) -> QSize:
    widget = item.widget()
    return QSize(0, 0) if widget is None else widget.minimumSizeHint().expandedTo(widget.minimumSize())


def _height(item: QLayoutItem, width: int) -> int:
    if item.hasHeightForWidth():
        return item.heightForWidth(width)
    widget = item.widget()
    fixed = widget is not None and widget.sizePolicy().verticalPolicy() is QSizePolicy.Policy.Fixed
    return item.sizeHint().height() if fixed or widget is None else max(item.sizeHint().height(), _least(item).height())
