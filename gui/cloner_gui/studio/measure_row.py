"""One measure of a body: set by a slider or a number, or following from the others."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QDoubleSpinBox, QHBoxLayout, QSlider, QVBoxLayout, QWidget

from cloner_gui.language.words import TranslatedWords, translate
from cloner_gui.widgets.pieces import set_accessible_name

#: What the sliders tell, in the order of the form; the stature and the measures of `cloner.bodies.telling.PRESETS`.
STATURE: Final = "stature"
MEASURES: Final = TranslatedWords(
    "measures",
    {
        STATURE: QT_TRANSLATE_NOOP("measures", "Height without shoes"),
        "bust_girth": QT_TRANSLATE_NOOP("measures", "Chest"),
        "waist_girth": QT_TRANSLATE_NOOP("measures", "Waist"),
        "hip_girth": QT_TRANSLATE_NOOP("measures", "Hips"),
        "neck_girth": QT_TRANSLATE_NOOP("measures", "Neck"),
        "underbust_girth": QT_TRANSLATE_NOOP("measures", "Below the breast"),
        "thigh_girth": QT_TRANSLATE_NOOP("measures", "Thigh"),
        "inside_leg_height": QT_TRANSLATE_NOOP("measures", "Inside leg"),
        "arm_length": QT_TRANSLATE_NOOP("measures", "Arm"),
    },
)
#: Steps of the slider a centimetre.
_STEPS: Final = 10


class MeasureRow(QWidget):
    """A check box whether the measure is set, a slider and a number."""

    told = Signal()

    def __init__(self, key: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.key = key
        self.box, self.slider, self.number = QCheckBox(MEASURES[key]), QSlider(), QDoubleSpinBox()
        self.slider.setOrientation(Qt.Orientation.Horizontal)
        self.number.setDecimals(1)
        self.number.setSuffix(translate("studio", " cm"))
        self.number.setSingleStep(0.5)
        for one in (self.slider, self.number):
            set_accessible_name(one, MEASURES[key])
        if key == STATURE:
            self.box.setChecked(True)
            self.box.setEnabled(False)
        beside, column = QHBoxLayout(), QVBoxLayout(self)
        beside.addWidget(self.slider, 1)
        beside.addWidget(self.number)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.box)
        column.addLayout(beside)
        self.slider.valueChanged.connect(lambda value: self._tell(value / _STEPS))
        self.number.valueChanged.connect(self._tell)
        self.box.clicked.connect(lambda _: self.told.emit())

    def told_cm(self) -> float | None:
        """Return what is told, None where the measure follows from the others."""
        return self.number.value() if self.box.isChecked() else None

    def set_range(self, low_cm: float, high_cm: float) -> None:
        """Allow values between two; what is shown stays among them."""
        with QSignalBlocker(self.slider), QSignalBlocker(self.number):
            self.slider.setRange(round(low_cm * _STEPS), round(high_cm * _STEPS))
            self.number.setRange(low_cm, high_cm)

    def follow(self, cm: float) -> None:
        """Show what the measure came out at; it is not told by that."""
        with QSignalBlocker(self.slider), QSignalBlocker(self.number):
            self.number.setValue(cm)
            self.slider.setValue(round(cm * _STEPS))

    def _tell(self, cm: float) -> None:
        self.follow(cm)
        self.box.setChecked(True)
        self.told.emit()
