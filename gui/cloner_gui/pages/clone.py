"""Fourth page: clone, and look at the result."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QVBoxLayout, QWidget

from cloner_gui.canvas.turntable import Turntable
from cloner_gui.session import Session
from cloner_gui.words import spoken_step


class ClonePage(QWidget):
    """Start the clone, watch it grow, turn it."""

    changed = Signal()
    title = "4  Clone"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.clone_button = QPushButton("Clone")
        self.cancel_button = QPushButton("Cancel")
        self.progress = QProgressBar()
        self.progress.setRange(0, 1000)
        self.status = QLabel()
        self.turntable = Turntable()
        self.turntable.failed.connect(session.failed)
        self.warnings = QLabel()
        self.warnings.setWordWrap(True)
        self.body_button, self.face_button = QPushButton("Whole person"), QPushButton("Face")
        self._lay_out()
        self.clone_button.clicked.connect(lambda: session.clone())
        self.cancel_button.clicked.connect(session.cancel)
        self.body_button.clicked.connect(lambda: self.turntable.frame("front"))
        self.face_button.clicked.connect(lambda: self.turntable.frame("face"))
        session.opened.connect(self._show)
        session.cloned.connect(self._show)
        session.refitted.connect(lambda: self.turntable.update_clone(session.clone_now()))
        session.busy_changed.connect(self._show_busy)
        session.progressed.connect(self._show_progress)
        self._show()

    def why_not(self) -> str:
        """Return why the next page cannot come yet."""
        return "" if self._session.outcome is not None else "Clone first."

    def _lay_out(self) -> None:
        top = QHBoxLayout()
        for widget in (self.clone_button, self.cancel_button, self.progress):
            top.addWidget(widget)
        top.addWidget(self.status, 1)
        bottom = QHBoxLayout()
        for button in (self.body_button, self.face_button):
            bottom.addWidget(button)
        bottom.addStretch(1)
        column = QVBoxLayout(self)
        column.addLayout(top)
        column.addWidget(self.turntable, 1)
        column.addWidget(self.warnings)
        column.addLayout(bottom)

    def _show(self) -> None:
        """Show the finished clone, or an empty place for it."""
        outcome = self._session.outcome
        self.turntable.set_clone(None if outcome is None else outcome.values["clone"])
        for button in (self.body_button, self.face_button):
            button.setEnabled(outcome is not None)
        self.status.setText("" if outcome is None else f"Written to {outcome.folder.parent.name}/{outcome.folder.name}")
        self.warnings.setText("" if outcome is None else "\n".join(f"• {text}" for text in outcome.warnings))
        self.warnings.setVisible(bool(self.warnings.text()))
        self._show_busy()
        self.changed.emit()

    def _show_busy(self) -> None:
        busy = self._session.busy
        self.clone_button.setEnabled(not busy and self._session.folder is not None)
        self.cancel_button.setEnabled(busy)
        self.progress.setVisible(busy)
        if busy:
            self.progress.setValue(0)  # the bar still shows the work before this one
        elif self._session.outcome is None:
            self.status.setText("")

    def _show_progress(self, step: str, fraction: float) -> None:
        self.progress.setValue(round(1000 * fraction))
        self.status.setText(spoken_step(step))
