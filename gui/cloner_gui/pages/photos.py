"""Second page: which photos."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import (
    QFileDialog,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from cloner.frames import ViewId
from cloner_gui.canvas.painting import pixmap_of
from cloner_gui.session import Session
from cloner_gui.words import VIEW_TITLES, what_is_missing

_THUMBNAIL_PX: Final = 300


class PhotosPage(QWidget):
    """Choose or drop a folder; see its photos."""

    changed = Signal()
    title = "2  Photos"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.setAcceptDrops(True)
        self.folder_label = QLabel()
        self.missing_label = QLabel()
        self.missing_label.setWordWrap(True)
        choose = QPushButton("Choose folder…")
        choose.clicked.connect(self.choose_folder)
        self.thumbnails = {view: QLabel() for view in ViewId}
        self._lay_out(choose)
        session.opened.connect(self._show)
        self._show()

    def why_not(self) -> str:
        """Return why the next page cannot come yet, or an empty string."""
        return "" if self._session.photos.photos else "Choose a folder with photos first."

    def _lay_out(self, choose: QPushButton) -> None:
        top = QHBoxLayout()
        top.addWidget(choose)
        top.addWidget(self.folder_label, 1)
        grid = QGridLayout()
        for column, (view, label) in enumerate(self.thumbnails.items()):
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
            label.setMinimumSize(140, _THUMBNAIL_PX)
            label.setStyleSheet("border: 1px dashed palette(mid); color: palette(mid);")
            grid.addWidget(label, 0, column)
            grid.addWidget(QLabel(VIEW_TITLES[view], alignment=Qt.AlignmentFlag.AlignCenter), 1, column)
        column_of_all = QVBoxLayout(self)
        column_of_all.addLayout(top)
        column_of_all.addLayout(grid)
        column_of_all.addWidget(self.missing_label)
        column_of_all.addStretch(1)

    def choose_folder(self) -> None:
        """Ask for a folder and open it."""
        folder = QFileDialog.getExistingDirectory(self, "Folder with photos")
        if folder:
            self._session.open(Path(folder))

    def _show(self) -> None:
        """Show the open folder."""
        session = self._session
        self.folder_label.setText("" if session.folder is None else session.folder.name)
        for view, label in self.thumbnails.items():
            photo = session.photos.photos.get(view)
            if photo is None:
                label.clear()
                label.setText("missing")
            else:
                mode = Qt.TransformationMode.SmoothTransformation
                label.setPixmap(pixmap_of(photo.rgb).scaledToHeight(_THUMBNAIL_PX, mode))
        self.missing_label.setText("\n".join([what_is_missing(session.photos.photos), *session.warnings]))
        self.changed.emit()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take folders, or photos inside one."""
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Open the dropped folder, or the folder of a dropped photo."""
        path = Path(event.mimeData().urls()[0].toLocalFile())
        self._session.open(path if path.is_dir() else path.parent)
