"""The event's own picture: chosen from the disk, shown small, removed again."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QFileDialog, QLabel, QWidget

from cloner_gui.language.words import translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.pieces import button, set_accessible_name

_SEEN_PX: Final = 48


class LogoField(QWidget):
    """A picture's file, or none; files that are no pictures are refused.

    Parameters
    ----------
    path : str
        What is chosen at first; "" for none.
    """

    def __init__(self, path: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.path, self.seen = "", QLabel()
        self.choose_button, self.none_button = button(), button()
        self.choose_button.setText(translate("settings", "Choose a &picture…"))
        self.none_button.setText(translate("settings", "No pictu&re"))
        set_accessible_name(self.seen, translate("settings", "Logo of the event"))
        row = Flow(self)
        for one in (self.seen, self.choose_button, self.none_button):
            row.addWidget(one)
        self.choose_button.clicked.connect(self._choose)
        self.none_button.clicked.connect(lambda: self.show_path(""))
        self.show_path(path)

    def show_path(self, path: str) -> None:
        """Show a picture; the one before stays where the file is none."""
        picture = QPixmap(path) if path else QPixmap()
        if path and picture.isNull():
            return
        self.path = path
        self.seen.setVisible(bool(path))
        self.none_button.setVisible(bool(path))
        self.seen.setToolTip(Path(path).name)
        if path:
            self.seen.setPixmap(picture.scaledToHeight(_SEEN_PX, Qt.TransformationMode.SmoothTransformation))

    def _choose(self) -> None:
        kinds = translate("settings", "Pictures")
        chosen, _ = QFileDialog.getOpenFileName(
            self, translate("settings", "Logo of the event"), "", f"{kinds} (*.png *.jpg *.jpeg *.svg *.webp)"
        )
        if chosen:
            self.show_path(chosen)
