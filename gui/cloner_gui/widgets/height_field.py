"""A height in centimetres or in feet and inches."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QDoubleSpinBox, QSpinBox, QWidget

from cloner.booth.visitors.person_file import cm_from_feet, feet_from_cm
from cloner.project.folder import DEFAULT_HEIGHT_CM, LARGEST_HEIGHT_CM, SMALLEST_HEIGHT_CM
from cloner_gui.language.words import translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.pieces import restyle, set_accessible_name


class HeightField(QWidget):
    """Whether the height is known, and the height; entering one marks it as known."""

    changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.known = QCheckBox()
        self.cm, self.feet, self.inches = QDoubleSpinBox(), QSpinBox(), QDoubleSpinBox()
        self.unit = QComboBox()
        self.unit.addItems(["cm", "ft in"])
        self.cm.setRange(SMALLEST_HEIGHT_CM, LARGEST_HEIGHT_CM)
        self.cm.setDecimals(1)
        self.feet.setRange(2, 8)
        self.feet.setSuffix(" ft")
        self.inches.setRange(0.0, 11.5)
        self.inches.setSingleStep(0.5)
        self.inches.setDecimals(1)
        self.inches.setSuffix(" in")
        row = Flow(self)
        for one in (self.cm, self.feet, self.inches, self.unit, self.known):
            row.addWidget(one)
        self.known.toggled.connect(self._tell)
        self.cm.valueChanged.connect(self._take_cm)
        self.feet.valueChanged.connect(self._take_feet)
        self.inches.valueChanged.connect(self._take_feet)
        self.unit.currentIndexChanged.connect(self._show)
        self.set_height(None)

    def first_field(self) -> QWidget:
        """Return the field that the height's label belongs to."""
        return self.cm

    def speak(self) -> None:
        """Say everything in the window's language."""
        self.known.setText(translate("visitor", "known"))
        set_accessible_name(self.known, translate("visitor", "Height is known"))
        set_accessible_name(self.cm, translate("visitor", "Height in centimetres"))
        set_accessible_name(self.feet, translate("visitor", "Height, feet"))
        set_accessible_name(self.inches, translate("visitor", "Height, inches"))
        set_accessible_name(self.unit, translate("visitor", "Unit of the height"))

    def height_cm(self) -> float | None:
        """Return the height, None where it is unknown."""
        return self.cm.value() if self.known.isChecked() else None

    def set_height(self, height_cm: float | None) -> None:
        """Show a height; nobody is told."""
        self.cm.blockSignals(True)
        self.blockSignals(True)
        self.cm.setValue(DEFAULT_HEIGHT_CM if height_cm is None else height_cm)
        self.known.setChecked(height_cm is not None)
        self.blockSignals(False)
        self.cm.blockSignals(False)
        self._show()

    def _tell(self) -> None:
        self._show()
        self.changed.emit()

    def _take_cm(self) -> None:
        self.known.setChecked(True)
        self._tell()

    def _take_feet(self) -> None:
        if self.unit.currentIndex() == 1:
            self.known.setChecked(True)
            self.cm.setValue(cm_from_feet(self.feet.value(), self.inches.value()))

    def _show(self) -> None:
        """Show the fields of the chosen unit."""
        in_feet = self.unit.currentIndex() == 1
        feet, inches = feet_from_cm(self.cm.value())
        for field, value in ((self.feet, feet), (self.inches, inches)):
            field.setVisible(in_feet)
            field.blockSignals(True)
            field.setValue(value)  # type: ignore[arg-type]
            field.blockSignals(False)
        self.cm.setVisible(not in_feet)
        for one in (self.cm, self.feet, self.inches):
            restyle(one, "" if self.known.isChecked() else "dim")
