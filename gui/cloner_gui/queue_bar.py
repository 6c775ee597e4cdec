"""What is cloned in the background just now, how long it still takes, and a way to stop it; seen on every page."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QToolButton, QWidget

from cloner_gui.pieces import name
from cloner_gui.session import Session
from cloner_gui.words import spoken_step, spoken_time, translate


class QueueBar(QWidget):
    """The queue of clones in one line; empty where nobody waits."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._queue = session.queue
        self.text, self.bar, self.cancel = QLabel(), QProgressBar(), QToolButton()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setFixedWidth(140)
        self.cancel.setText("✕")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for one in (self.text, self.bar, self.cancel):
            row.addWidget(one)
        self.cancel.clicked.connect(self._stop)
        self._queue.changed.connect(self._show)
        self._queue.progressed.connect(self._tell)
        self._show()

    def _show(self) -> None:
        folder = self._queue.at_work
        self.setVisible(folder is not None)
        if folder is not None:
            self._tell(folder, "photos", 0.0)
            name(self.cancel, translate("queue", "Stop cloning {name}").format(name=folder.name))
            name(self.bar, translate("queue", "Progress of {name}").format(name=folder.name))

    def _tell(self, folder: Path, step: str, fraction: float) -> None:
        left = spoken_time(self._queue.seconds_left(folder))
        more = self._queue.size() - 1
        waiting = translate("queue", ", {n} more wait").format(n=more) if more else ""
        told = translate("queue", "{name}: {step}, {left}").format(name=folder.name, step=spoken_step(step), left=left)
        self.text.setText(told + waiting)
        self.bar.setValue(round(1000 * fraction))

    def _stop(self) -> None:
        if self._queue.at_work is not None:
            self._queue.withdraw(self._queue.at_work)
