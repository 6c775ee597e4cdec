"""Pages in order, each created when first needed, so that the window opens fast."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from PySide6.QtCore import Signal, SignalInstance
from PySide6.QtWidgets import QStackedWidget, QWidget


class Page(Protocol):
    """What the window expects of a page, besides being a widget."""

    changed: SignalInstance

    def why_not(self) -> str:
        """Return why the next page cannot come yet, or an empty string."""


class Shelf(QStackedWidget):
    """Shows one page.

    Parameters
    ----------
    makers : sequence of callable
        Make the pages, in their order.
    """

    made = Signal(object)

    def __init__(self, makers: Sequence[Callable[[], QWidget]], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._makers = list(makers)
        self._pages: dict[int, QWidget] = {}
        self._empty = [QWidget() for _ in makers]
        for empty in self._empty:
            self.addWidget(empty)

    def page(self, number: int) -> QWidget:
        """Return a page, made now if it was not yet."""
        if number not in self._pages:
            current, empty = self.currentIndex(), self._empty[number]
            page = self._pages[number] = self._makers[number]()
            self.insertWidget(number, page)
            self.removeWidget(empty)
            empty.deleteLater()
            self.setCurrentIndex(current)
            self.made.emit(page)
        return self._pages[number]

    def show_page(self, number: int) -> None:
        """Show a page."""
        self.page(number)
        self.setCurrentIndex(number)
