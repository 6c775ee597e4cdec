"""The bar on every page: what is cloned in the background, the remaining time, and a way to stop it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QToolButton, QWidget

from cloner_gui.event.booth import Booth
from cloner_gui.language.words import duration_text, step_text, translate
from cloner_gui.widgets.pieces import set_accessible_name

_LEAST_PX: Final = 170
_LINES: Final = 2


class QueueBar(QWidget):
    """The queue of clones in one line; empty if nobody waits."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth, self._queue = booth, booth.session.queue
        self._hidden = False
        self._texts: tuple[str, ...] = ("",)
        self.text, self.bar, self.cancel = QLabel(), QProgressBar(), QToolButton()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setFixedWidth(90)
        self.text.setWordWrap(True)
        self.text.setMinimumWidth(_LEAST_PX)
        self.cancel.setText("✕")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.text, 1)
        row.addWidget(self.bar)
        row.addWidget(self.cancel)
        self.cancel.clicked.connect(self._stop)
        self._queue.changed.connect(self._show)
        self._queue.progressed.connect(self._tell)
        self._show()

    def _show(self) -> None:
        folder = self._queue.at_work
        self.setVisible(folder is not None and not self._is_seen_elsewhere())
        if folder is not None:
            called = self._booth.name_of(folder)
            self._tell(folder, "photos", 0.0)
            set_accessible_name(self.cancel, translate("queue", "Stop cloning {name}").format(name=called))
            set_accessible_name(self.bar, translate("queue", "Progress of {name}").format(name=called))

    def leave_to_page(self, hidden: bool) -> None:
        """Hide the bar while the page shows the open visitor's progress itself."""
        self._hidden = hidden
        self._show_or_hide()

    def _is_seen_elsewhere(self) -> bool:
        return self._hidden and self._queue.at_work == self._booth.session.folder

    def _show_or_hide(self) -> None:
        self.setVisible(self._queue.at_work is not None and not self._is_seen_elsewhere())

    def _tell(self, folder: Path, step: str, fraction: float) -> None:
        if folder != self._queue.at_work:
            return  # of several at once the first one's progress is seen
        left = duration_text(self._queue.seconds_left(folder))
        more = self._queue.size() - 1
        waiting = translate("queue", ", {n} more wait").format(n=more) if more else ""
        called, pattern = self._booth.name_of(folder), translate("queue", "{name}: {step}, {left}")
        told = pattern.format(name=called, step=step_text(step), left=left) + waiting
        self._texts = (told, f"{called}: {left}{waiting}", f"{called}: {left}", called)
        self.text.setToolTip(told)
        self._fit()
        self.bar.setValue(round(1000 * fraction))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the text to the available width."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        """Say as much as fits into a few lines: higher it would take the page's room, which must not move."""
        letters = self.text.fontMetrics()
        longest = max(map(letters.horizontalAdvance, re.split(r"\s|(?<=-)", self._texts[0])))
        self.text.setMinimumWidth(max(_LEAST_PX, longest + 2))  # a long name in large letters
        room = QRect(0, 0, max(self.text.width(), self.text.minimumWidth()), 9999)
        high, wraps = _LINES * letters.lineSpacing(), Qt.TextFlag.TextWordWrap
        fits = (one for one in self._texts if letters.boundingRect(room, wraps, one).height() <= high)
        self.text.setText(next(fits, self._texts[-1]))

    def _stop(self) -> None:
        if self._queue.at_work is not None:
            self._queue.withdraw(self._queue.at_work)
