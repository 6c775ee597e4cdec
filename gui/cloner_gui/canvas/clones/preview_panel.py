"""The clone with all display options: mode, photo below it, and motion."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSizePolicy, QSlider, QVBoxLayout, QWidget

from cloner.frames import ViewId
from cloner.records.clones import Clone
from cloner.records.photos import Photo
from cloner_gui.canvas.clones.acting import GAP_COLOURS, GAP_SHOWN_MM, MODES, MOTIONS, OUTLINE
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.language.words import VIEW_TITLES, translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.letters import without_mnemonic
from cloner_gui.widgets.pieces import button, set_accessible_name


class PreviewPanel(QWidget):
    """A preview above its controls."""

    used = Signal()
    """A control was used: what moves by itself stops."""
    gaps_wanted = Signal()
    """The way of looking that needs distances was chosen."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.preview = Preview()
        self.mode, self.motion, self.overlay = QComboBox(), QComboBox(), QComboBox()
        for box in (self.mode, self.motion, self.overlay):
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)  # also after the language changed
        self.opacity = QSlider(Qt.Orientation.Horizontal)
        self.opacity.setRange(0, 100)
        self.opacity.setValue(60)
        self.opacity.setFixedWidth(140)
        self.body_button, self.face_button = button(), button()
        self.scale = QLabel(alignment=Qt.AlignmentFlag.AlignRight)
        self._labels = {widget: QLabel() for widget in (self.mode, self.motion, self.overlay, self.opacity)}
        self._photos: Mapping[ViewId, Photo] = {}
        self._growing = False
        self._lay_out()
        self._speak()
        self.mode.currentIndexChanged.connect(self._take_mode)
        self.motion.currentIndexChanged.connect(self._take_motion)
        for box in (self.mode, self.motion, self.overlay):
            box.activated.connect(self.used)
        for one in (self.body_button, self.face_button):
            one.clicked.connect(self.used)
        self.overlay.currentIndexChanged.connect(self._take_overlay)
        self.opacity.valueChanged.connect(lambda value: self.preview.set_opacity(value / 100.0))
        self.body_button.clicked.connect(lambda: self._frame("front"))
        self.face_button.clicked.connect(lambda: self._frame("face"))
        self.preview.set_opacity(self.opacity.value() / 100.0)
        self.set_clone(None, {})

    def set_clone(self, clone: Clone | None, photos: Mapping[ViewId, Photo]) -> None:
        """Show a clone, and offer the photos that it can be laid over."""
        self._growing = False
        self._photos = {} if clone is None else {view: photos[view] for view in clone.views if view in photos}
        self.preview.set_clone(clone)
        self.motion.setCurrentIndex(0)
        self._fill_overlay()
        for widget in (self.body_button, self.face_button, *self._labels):
            widget.setEnabled(clone is not None)
        self._take_mode()
        self._take_overlay()

    def show_growing(self, body: Clone) -> None:
        """Show a body that is not finished: its shape alone, from where it is seen already."""
        if not self._growing:
            self.set_clone(None, {})
            self._growing = True
            self.preview.set_mode(OUTLINE)
        self.preview.update_clone(body)

    def _lay_out(self) -> None:
        looks, acts = Flow(), Flow()
        for row, widgets in ((looks, (self.mode, self.overlay, self.opacity)), (acts, (self.motion,))):
            for widget in widgets:
                self._labels[widget].setBuddy(widget)
                pair = QWidget()
                pair.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
                both = QHBoxLayout(pair)
                both.setContentsMargins(0, 0, 0, 0)
                both.addWidget(self._labels[widget])
                both.addWidget(widget)
                row.addWidget(pair)
        acts.addWidget(self.body_button)
        acts.addWidget(self.face_button)
        acts.addWidget(self.scale)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.preview, 1)
        column.addLayout(looks)
        column.addLayout(acts)

    def _speak(self) -> None:
        """Put all words into the window's language."""
        modes = (
            translate("preview", "Photo texture"),
            translate("preview", "Shape alone"),
            translate("preview", "Wire mesh"),
            translate("preview", "Distance from the outlines"),
        )
        motions = (
            translate("preview", "Stand"),
            translate("preview", "Walk"),
            translate("preview", "Breathe"),
            translate("preview", "Blink"),
            translate("preview", "Smile"),
            translate("preview", "Talk"),
            translate("preview", "Wave"),
        )
        for box, texts in ((self.mode, modes), (self.motion, motions)):
            for row, text in enumerate(texts):
                if box.count() <= row:
                    box.addItem(text)
                box.setItemText(row, text)
        says = (
            (self.mode, translate("preview", "&Show")),
            (self.overlay, translate("preview", "&Over")),
            (self.opacity, translate("preview", "Co&ver")),
            (self.motion, translate("preview", "&Move")),
        )
        for widget, text in says:
            self._labels[widget].setText(text)
            set_accessible_name(widget, without_mnemonic(text))
        self.body_button.setText(translate("preview", "Whole pe&rson"))
        self.face_button.setText(translate("preview", "&Face"))
        self.scale.setText(_scale_text())
        self._fill_overlay()

    def _fill_overlay(self) -> None:
        now = self.overlay.currentData()
        self.overlay.blockSignals(True)
        self.overlay.clear()
        self.overlay.addItem(translate("preview", "no photo"), None)
        for view in self._photos:
            self.overlay.addItem(VIEW_TITLES[view], view)
        self.overlay.setCurrentIndex(max(self.overlay.findData(now), 0))
        self.overlay.blockSignals(False)

    def _frame(self, framing: str) -> None:
        self.overlay.setCurrentIndex(0)
        self.preview.frame(framing)

    def _take_mode(self) -> None:
        mode = MODES[max(self.mode.currentIndex(), 0)]
        self.scale.setVisible(mode == "gaps")
        self.preview.set_mode(mode)
        if mode == "gaps":
            self.gaps_wanted.emit()

    def _take_motion(self) -> None:
        self.preview.play(MOTIONS[max(self.motion.currentIndex(), 0)])

    def _take_overlay(self) -> None:
        view = self.overlay.currentData()
        photo = self._photos.get(view)
        self.opacity.setEnabled(photo is not None)
        self.preview.set_overlay(view, None if photo is None else photo.rgb)

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()


def _scale_text() -> str:
    """Return what the colours of distances mean."""
    blocks = "".join(
        f'<span style="color:#{red:02x}{green:02x}{blue:02x}">█</span>' for _, (red, green, blue) in GAP_COLOURS
    )
    told = translate("preview", "between the clone's and the photos' outlines")
    return f"0 {blocks} {GAP_SHOWN_MM:.0f} mm {told}"
