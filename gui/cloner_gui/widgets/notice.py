"""Messages at the page's lower edge: what went wrong and what to do, without moving the layout."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QTimer, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QToolButton, QWidget

from cloner.errors import ClonerError
from cloner_gui.language.told import translated_error
from cloner_gui.language.words import translate
from cloner_gui.widgets.pieces import restyle, set_accessible_name

#: How long good news is shown, milliseconds; what went wrong stays until somebody closes it or the visitor goes.
NEWS_MS = 8000
_EDGE = 8


class Notice(QFrame):
    """Shows messages one after the other, each once.

    Parameters
    ----------
    over : QWidget
        The page, over whose lower edge the bar lies.
    """

    closed = Signal()

    def __init__(self, over: QWidget) -> None:
        super().__init__(over.parentWidget())
        self.setObjectName("notice")
        self._over = over
        self._waiting: list[tuple[str, str]] = []
        self.text, self.count = QLabel(), QLabel()
        self.text.setWordWrap(True)
        self.close_button = QToolButton()
        self.close_button.setText("✕")
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 6, 6, 6)
        row.addWidget(self.text, 1)
        row.addWidget(self.count)
        row.addWidget(self.close_button)
        self._news = QTimer(self, singleShot=True, interval=NEWS_MS)
        self._news.timeout.connect(self.close_one)
        self.close_button.clicked.connect(self.close_one)
        over.installEventFilter(self)
        self.hide()

    @property
    def messages(self) -> tuple[str, ...]:
        """What is still to be read, the newest first."""
        return tuple(text for text, _ in self._waiting)

    def tell(self, error: ClonerError) -> None:
        """Show what is wrong and what to do."""
        self._add(translated_error(error), "notice")

    def say(self, text: str) -> None:
        """Show what is good to know, for a while."""
        self._add(text, "news")

    def close_one(self) -> None:
        """Take the message that is seen away, and show the one before."""
        self._waiting = self._waiting[1:]
        self._show()

    def clear(self) -> None:
        """Take all messages away: they spoke of a visitor who is not here any more."""
        self._waiting = []
        self._show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay where the page's lower edge is."""
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move):
            self._place()
        return False

    def _add(self, text: str, kind: str) -> None:
        self._waiting = [(text, kind), *((other, its) for other, its in self._waiting if other != text)]
        self._show()

    def _show(self) -> None:
        """Show the newest message, and how many there are; screen readers hear it as the bar's name."""
        self.setVisible(bool(self._waiting))
        self._news.stop()
        if not self._waiting:
            self.closed.emit()
            return
        text, kind = self._waiting[0]
        self.text.setText(text)
        more = len(self._waiting) - 1
        self.count.setText(translate("window", "{n} more").format(n=more) if more else "")
        self.count.setVisible(more > 0)
        restyle(self, kind)
        set_accessible_name(self.close_button, translate("window", "Close the message"))
        set_accessible_name(self, text)
        if kind == "news":
            self._news.start()
        self._place()

    def _place(self) -> None:
        if self.isHidden():
            return
        area = self._over.geometry()
        width = max(area.width() - 2 * _EDGE, 100)
        height = max(self.heightForWidth(width), self.sizeHint().height() if self.heightForWidth(width) < 0 else 0)
        height = min(height, area.height())
        self.setGeometry(area.left() + _EDGE, area.bottom() - height - _EDGE, width, height)
        self.raise_()
