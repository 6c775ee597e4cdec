"""One photo at full size: opened by a double click on its card, zoomed by the wheel, moved by dragging."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QVBoxLayout, QWidget

from cloner_gui.canvas.photos.view import PhotoView
from cloner_gui.widgets.pieces import label


class WholePhoto(QDialog):
    """A photo with what was found in it; Escape closes it.

    Parameters
    ----------
    title, verdict : str
    rgb : (H, W, 3) uint8
    """

    def __init__(self, title: str, verdict: str, rgb: NDArray[np.uint8], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(title)
        self.view, told = PhotoView(), label()
        self.view.setAccessibleName(title)
        told.setText(verdict)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        column = QVBoxLayout(self)
        column.addWidget(self.view, 1)
        column.addWidget(told)
        column.addWidget(buttons)
        room = (parent or self).screen().availableGeometry()
        self.resize(int(0.7 * room.width()), int(0.85 * room.height()))
        self.view.set_photo(rgb)
