"""Last page: what the visitor takes home."""

from __future__ import annotations

from PySide6.QtCore import QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from cloner_gui.session import Session


class TakeawayPage(QWidget):
    """Report and files of the finished clone."""

    changed = Signal()
    title = "5  Take away"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.status = QLabel()
        self.report_button, self.folder_button = QPushButton("Open report"), QPushButton("Open folder")
        row = QHBoxLayout()
        for button in (self.report_button, self.folder_button):
            row.addWidget(button)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.addWidget(self.status)
        column.addLayout(row)
        column.addStretch(1)
        self.report_button.clicked.connect(lambda: self._open("report.html"))
        self.folder_button.clicked.connect(lambda: self._open(""))
        session.opened.connect(self._show)
        session.cloned.connect(self._show)
        self._show()

    def why_not(self) -> str:
        """Return why no page comes after this one."""
        return "This is the last page."

    def _show(self) -> None:
        outcome = self._session.outcome
        for button in (self.report_button, self.folder_button):
            button.setEnabled(outcome is not None)
        self.status.setText("" if outcome is None else f"Written to {outcome.folder.parent.name}/{outcome.folder.name}")

    def _open(self, name: str) -> None:
        """Show a file of the result with the desktop's own program."""
        if self._session.outcome is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str((self._session.outcome.folder / name).resolve())))
