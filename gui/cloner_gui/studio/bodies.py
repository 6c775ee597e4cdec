"""Bodies from measures: sliders beside the body, which follows them; or a clone with changed measures."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Final

from PySide6.QtWidgets import QComboBox, QFileDialog, QLineEdit, QSpinBox, QWidget

from cloner.bodies.children import OLDEST, USUAL_AGE, YOUNGEST
from cloner.bodies.telling import PRESETS, BodySpecification, statures_m, untold_mm
from cloner.booth.studio.values import BodyWish, Figure, received
from cloner.errors import ClonerError
from cloner.project.folder import safe_identifier
from cloner.records.clones import Clone
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.event.booth import Booth
from cloner_gui.language.told import translated_error
from cloner_gui.language.words import translate
from cloner_gui.studio.bench import Bench, Subject
from cloner_gui.studio.measure_row import STATURE, MeasureRow
from cloner_gui.widgets.pieces import button, label

WOMAN, MAN, CLONE = "f", "m", ""
FOUR, NINE = "four", "nine"
#: Sliders go so many spreads to either side of what is usual; a body may have 4.5 (`FAR`).
_SPREADS: Final = 4.0
#: Side of a saved body's texture, texels; as `cloner body` has it.
_TEXELS: Final = 2048


class BodiesWindow(Bench):
    """A body with given measures."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(booth, translate("studio", "Body from measures"), parent)
        self.subject, self.preview = Subject(booth), Preview()
        self.kind, self.preset, self.refused = QComboBox(), QComboBox(), label("warn")
        self.age = QSpinBox()
        self.rows = {key: MeasureRow(key) for key in (STATURE, *_in_order())}
        self.name_field, self.save_button = QLineEdit(), button("main")
        self.preview.say_when_empty("")
        self._base: Clone | None = None
        self._sex, self._stale = WOMAN, False
        self._fill()
        self._place()
        self._connect()
        self._take_kind()
        self.settle()

    def wish(self) -> BodyWish | None:
        """Return what is told; None where a clone is wanted and none is chosen."""
        source = self.subject.path if self.kind.currentData() == CLONE else None
        if source is None and self.kind.currentData() == CLONE:
            return None
        told = {key: row.told_cm() for key, row in self.rows.items() if key != STATURE and row.isVisibleTo(self)}
        known = {key: value for key, value in told.items() if value is not None}
        return BodyWish(self._sex, self.rows[STATURE].number.value(), known, source, float(self.age.value()))

    def _fill(self) -> None:
        for text, kind in (
            (translate("studio", "A woman or a girl"), WOMAN),
            (translate("studio", "A man or a boy"), MAN),
            (translate("studio", "A clone, told new measures"), CLONE),
        ):
            self.kind.addItem(text, kind)
        self.age.setRange(int(YOUNGEST), int(OLDEST))
        self.age.setValue(int(USUAL_AGE))
        self.age.setSuffix(translate("studio", " years"))
        self.age.setKeyboardTracking(False)
        self.preset.addItem(translate("studio", "Four, as a shop asks"), FOUR)
        self.preset.addItem(translate("studio", "Nine, as a tailor takes"), NINE)
        self.save_button.setText(translate("studio", "&Save the body…"))

    def _place(self) -> None:
        self.field(translate("studio", "&Who"), self.kind)
        self.field(translate("studio", "&Age"), self.age)
        self.controls.addWidget(self.subject)
        self.field(translate("studio", "&Measures"), self.preset)
        for row in self.rows.values():
            self.controls.addWidget(row)
        self.field(translate("studio", "&Name of the body"), self.name_field)
        self.controls.addStretch(1)
        self.stage.addWidget(self.preview, 1)
        self.stage.addWidget(self.refused)
        self.deeds.addWidget(self.save_button)

    def _connect(self) -> None:
        self.kind.activated.connect(self._take_kind)
        self.age.valueChanged.connect(self._take_kind)
        self.subject.changed.connect(self._take_kind)
        self.preset.activated.connect(self._take_preset)
        for row in self.rows.values():
            row.told.connect(self._shape)
        self.rows[STATURE].told.connect(self._set_ranges)
        self.save_button.clicked.connect(self._save)
        self.busy_changed.connect(self._tell_ready)
        self.preview.failed.connect(self.notice.tell)

    # --- what is told -----------------------------------------------------------------

    def _take_kind(self) -> None:
        """Begin with somebody else, of whom nothing is told yet."""
        kind = str(self.kind.currentData())
        self.subject.setVisible(kind == CLONE)
        self._base, self._sex = None, kind
        for key, row in self.rows.items():
            row.box.setChecked(key == STATURE)
        usual = translate("studio", "body")
        called = f"{self.subject.path.name}-2" if kind == CLONE and self.subject.path is not None else usual
        self.name_field.setText(called)
        self._take_preset()

    def _take_preset(self) -> None:
        shown = (STATURE, *PRESETS[str(self.preset.currentData())])
        for key, row in self.rows.items():
            row.setVisible(key in shown)
        self._shape()

    def _set_ranges(self) -> None:
        """Let sliders go as far as bodies of this height do."""
        age = float(self.age.value())
        low, high = statures_m(self._sex, age)
        self.rows[STATURE].set_range(100.0 * low, 100.0 * high)
        usual = untold_mm(BodySpecification(self._sex, self.rows[STATURE].number.value() / 100.0, {}, age))
        for key, row in self.rows.items():
            if key != STATURE:
                mean, spread = usual[key]
                row.set_range((mean - _SPREADS * spread) / 10.0, (mean + _SPREADS * spread) / 10.0)

    # --- the body ------------------------------------------------------------------------

    def _shape(self) -> None:
        """Have the body made as it is told now; what is told meanwhile is made next."""
        wish = self.wish()
        self.refused.setText("")
        if self.busy or wish is None:
            self._stale = self.busy
            if wish is None:
                self.preview.set_clone(None)
        elif self._base is None:
            self.work("begin_body", wish, then=self._take_base)
        else:
            self._stale = False
            self.work("shape_body", wish, then=self._take_figure, failed=self._refuse, quiet=True)

    def _take_base(self, made: tuple[Clone, str]) -> None:
        self._base, self._sex = received(made[0]), made[1]
        self._set_ranges()
        self.rows[STATURE].follow(100.0 * self._base.stature_m)
        self._set_ranges()
        for key, row in self.rows.items():
            if key in self._base.measures_mm:
                row.follow(self._base.measures_mm[key] / 10.0)
        self.preview.set_clone(self._base)
        self._stale = True

    def _take_figure(self, made: Figure) -> None:
        if self._base is None:
            return
        shells = zip(self._base.shells, made.shells_m, strict=True)
        shown = replace(
            self._base,
            vertices_m=made.vertices_m,
            joints_m=made.joints_m,
            shells=tuple(replace(shell, vertices_m=places) for shell, places in shells),
        )
        self.preview.update_clone(shown)
        for key, row in self.rows.items():
            if row.told_cm() is None and key in made.mm:
                row.follow(made.mm[key] / 10.0)

    def _refuse(self, error: ClonerError) -> None:
        self.refused.setText(translated_error(error))

    def _tell_ready(self) -> None:
        """Go on with what was told meanwhile, once a job is done."""
        self.save_button.setEnabled(not self.busy and self._base is not None and not self.refused.text())
        for one in (self.kind, self.subject, self.preset, self.age):
            one.setEnabled(not self.busy or self._quiet)
        if not self.busy and self._stale:
            self._shape()

    def _save(self) -> None:
        """Write the body as a folder like any clone's; a changed clone beside the clone, as its visitor's."""
        wish = self.wish()
        if wish is None:
            return
        if wish.source is not None:
            out = wish.source.resolve().parent
        else:
            chosen = QFileDialog.getExistingDirectory(self, translate("studio", "Folder for bodies"))
            if not chosen:
                return
            out = Path(chosen)
        called = safe_identifier(self.name_field.text().strip() or "body")
        formats = self.booth.settings.formats
        self.work("save_body", wish, out, called, formats, _TEXELS, then=self.tell_written)


def _in_order() -> tuple[str, ...]:
    """Return the measures of both presets, those of the short one first."""
    return tuple(dict.fromkeys((*PRESETS[FOUR], *PRESETS[NINE])))
