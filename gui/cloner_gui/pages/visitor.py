"""First page: who stands there, and how tall."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QDoubleSpinBox, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from cloner.project.folder import DEFAULT_HEIGHT_CM, LARGEST_HEIGHT_CM, SMALLEST_HEIGHT_CM
from cloner_gui.session import Session


class VisitorPage(QWidget):
    """The height of the visitor."""

    changed = Signal()
    title = "1  Visitor"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.height_known = QCheckBox("Height without shoes")
        self.height_field = QDoubleSpinBox()
        self.height_field.setRange(SMALLEST_HEIGHT_CM, LARGEST_HEIGHT_CM)
        self.height_field.setSuffix(" cm")
        self.height_field.setDecimals(1)
        self.height_hint = QLabel()
        row = QHBoxLayout()
        for widget in (self.height_known, self.height_field):
            row.addWidget(widget)
        row.addWidget(self.height_hint, 1)
        column = QVBoxLayout(self)
        column.addLayout(row)
        column.addStretch(1)
        self.height_known.toggled.connect(self._take_height)
        self.height_field.valueChanged.connect(self._take_height)
        session.opened.connect(self._show)
        self._show()

    def why_not(self) -> str:
        """Return why the next page cannot come yet."""
        return ""

    def _show(self) -> None:
        height = self._session.height_cm
        self.height_field.setValue(DEFAULT_HEIGHT_CM if height is None else height)
        self.height_known.setChecked(height is not None)
        self._take_height()

    def _take_height(self) -> None:
        """Hand the height to the session; say what an unknown height means."""
        known = self.height_known.isChecked()
        self.height_field.setEnabled(known)
        self._session.height_cm = self.height_field.value() if known else None
        hint = "" if known else f"Unknown: {DEFAULT_HEIGHT_CM:.0f} cm is assumed and every length is unscaled."
        self.height_hint.setText(hint)
        self.changed.emit()
