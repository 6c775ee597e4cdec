"""A body of metaballs: their positions and radii are edited, and the skin follows."""

from __future__ import annotations

import functools
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QCheckBox, QDoubleSpinBox, QFileDialog, QGridLayout, QLabel, QListWidget, QWidget

from cloner.booth.studio.values import Figure, StatueWish, received
from cloner.errors import ClonerError
from cloner.project.atomic import write_text
from cloner.records.clones import Clone
from cloner.statues.blobs import Blob, read_blobs, written_blobs
from cloner_gui.event.booth import Booth
from cloner_gui.language.told import translated_error
from cloner_gui.language.words import translate
from cloner_gui.studio.blob_names import blob_label
from cloner_gui.studio.blob_scene import BlobPreview, move_blob
from cloner_gui.studio.statues import StatueBench
from cloner_gui.widgets.pieces import button, label, set_accessible_name

#: What of a blob's ends may be told here, cm; its file takes more.
_RADIUS_CM: Final = (0.5, 60.0)
_OFF_CM: Final = 60.0
_WIDE: Final = (0.2, 5.0)
_LINES: Final = 7


class BlobsWindow(StatueBench):
    """Metaballs, and the body on them."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(booth, translate("studio", "Body of blobs"), parent, usual=True)
        self.list, self.preview, self.refused = QListWidget(), BlobPreview(), label("warn")
        self.shown = QCheckBox(translate("studio", "Show the &blobs"))
        self.open_button, self.file_button = button(), button()
        self.numbers: dict[str, QDoubleSpinBox] = {}
        self._base: Clone | None = None
        self.blobs: tuple[Blob, ...] = ()
        self._stale = False
        self._place()
        self._connect()
        self.begin_anew()
        self.settle()

    def _place(self) -> None:
        self.preview.say_when_empty("")
        self.shown.setChecked(True)
        self.open_button.setText(translate("studio", "&Open a file of blobs…"))
        self.file_button.setText(translate("studio", "Sa&ve the blobs as a file…"))
        self.list.setFixedHeight(_LINES * 2 * self.fontMetrics().height())
        self.field(translate("studio", "Bl&obs"), self.list)
        grid, inside = QGridLayout(), QWidget()
        grid.setContentsMargins(0, 0, 0, 0)
        for row, (key, text) in enumerate(_numbers().items()):
            field = self.numbers[key] = QDoubleSpinBox()
            unit = key.startswith("wide")
            field.setSingleStep(0.05 if unit else 0.5)
            field.setDecimals(2 if unit else 1)
            field.setSuffix("" if unit else translate("studio", " cm"))
            field.setRange(*(_WIDE if unit else _RADIUS_CM if key.startswith("radius") else (-_OFF_CM, _OFF_CM)))
            said = QLabel(text)
            said.setBuddy(field)
            set_accessible_name(field, text)
            grid.addWidget(said, row, 0)
            grid.addWidget(field, row, 1)
        inside.setLayout(grid)
        self.controls.addWidget(inside)
        self.field(translate("studio", "&Material"), self.material)
        for one in (self.open_button, self.file_button):
            self.controls.addWidget(one)
        self.end_fields()
        self.stage.addWidget(self.shown)
        self.stage.addWidget(self.preview, 1)
        self.stage.addWidget(self.refused)

    def _connect(self) -> None:
        self.subject.changed.connect(self.begin_anew)
        self.list.currentRowChanged.connect(self._show_blob)
        for key, field in self.numbers.items():
            field.valueChanged.connect(functools.partial(self._take_number, key))
        self.shown.toggled.connect(self._show)
        self.preview.blob_chosen.connect(self.list.setCurrentRow)
        self.preview.blob_moved.connect(self.move_blob)
        self.preview.failed.connect(self.notice.tell)
        self.open_button.clicked.connect(self._open)
        self.file_button.clicked.connect(self._save_file)
        self.busy_changed.connect(self._tell_ready)

    # --- blobs ------------------------------------------------------------------------

    def begin_anew(self) -> None:
        """Fit blobs to a body, to begin with."""
        self._base = None
        if not self.is_ready():
            self.preview.set_clone(None)
        else:
            self.work("begin_blobs", self.onto(), then=self._take_base)

    def _take_base(self, made: tuple[Clone, tuple[Blob, ...]]) -> None:
        self._base = received(made[0])
        self.preview.set_clone(self._base)
        self.take_blobs(made[1])

    def take_blobs(self, blobs: tuple[Blob, ...]) -> None:
        """Edit other blobs."""
        self.blobs = blobs
        with QSignalBlocker(self.list):
            self.list.clear()
            self.list.addItems([blob_label(blob.name) for blob in blobs])
        self.list.setCurrentRow(0)
        self._show_blob()
        self._lay()

    def move_blob(self, row: int, by_m: NDArray[np.float64]) -> None:
        """Move a blob by (3,) metres."""
        self._change(row, move_blob(self.blobs[row], by_m))
        self._show_blob()

    def _change(self, row: int, blob: Blob) -> None:
        self.blobs = (*self.blobs[:row], blob, *self.blobs[row + 1 :])
        self._show()
        self._lay()

    def _take_number(self, key: str, value: float) -> None:
        row = self.list.currentRow()
        if row < 0:
            return
        blob, (what, _, place) = self.blobs[row], key.partition(" ")
        if what == "wide":
            wide = [*blob.wide]
            wide[int(place)] = value
            blob = replace(blob, wide=(wide[0], wide[1], wide[2]))
        elif what == "radius":
            end = min(int(place), len(blob.ends) - 1)
            radius = [*blob.radius_m]
            radius[end] = value / 100.0
            blob = replace(blob, radius_m=tuple(radius))
        else:
            by = np.zeros(3)
            by[int(place)] = value / 100.0 - blob.off_m[0][int(place)]
            blob = move_blob(blob, by)
        self._change(row, blob)

    def _show_blob(self) -> None:
        """Show the numbers of the chosen blob."""
        row = self.list.currentRow()
        if 0 <= row < len(self.blobs):
            blob = self.blobs[row]
            values = {"radius 0": 100.0 * blob.radius_m[0], "radius 1": 100.0 * blob.radius_m[-1]}
            values |= {f"off {axis}": 100.0 * blob.off_m[0][axis] for axis in range(3)}
            values |= {f"wide {axis}": blob.wide[axis] for axis in range(3)}
            for key, value in values.items():
                with QSignalBlocker(self.numbers[key]):
                    self.numbers[key].setValue(value)
            self.numbers["radius 1"].setEnabled(len(blob.ends) == 2)
        self._show()

    def _show(self) -> None:
        self.preview.show_blobs(self.blobs, self.list.currentRow(), shown=self.shown.isChecked())

    # --- the body on them ------------------------------------------------------------------

    def _lay(self) -> None:
        """Have the skin laid on the blobs; what is moved meanwhile is laid next."""
        self.refused.setText("")
        self._stale = self.busy
        if not self.busy and self._base is not None:
            self.work("place_blobs", self.onto(), self.blobs, then=self._take_figure, failed=self._refuse, quiet=True)

    def _take_figure(self, made: Figure) -> None:
        if self._base is not None:
            shells = zip(self._base.shells, made.shells_m, strict=True)
            loose = tuple(replace(shell, vertices_m=places) for shell, places in shells)
            self.preview.update_clone(replace(self._base, vertices_m=made.vertices_m, shells=loose))

    def _refuse(self, error: ClonerError) -> None:
        self.refused.setText(translated_error(error))

    def _tell_ready(self) -> None:
        ready = self._base is not None and not self.refused.text()
        self.save_button.setEnabled(not self.busy and ready)
        for one in (self.kind, self.subject):
            one.setEnabled(not self.busy or self._quiet)
        if not self.busy and self._stale:
            self._lay()

    def save(self, wish: StatueWish) -> None:
        """Write the body."""
        self.work("save_blobs", self.onto(), self.blobs, wish, then=self.tell_written)

    # --- files ---------------------------------------------------------------------------------

    def _open(self) -> None:
        title = translate("studio", "File of blobs")
        path, _ = QFileDialog.getOpenFileName(self, title, "", f"{title} (*.json)")
        if path:
            try:
                self.take_blobs(read_blobs(Path(path)))
            except ClonerError as error:
                self.notice.tell(error)

    def _save_file(self) -> None:
        title = translate("studio", "File of blobs")
        path, _ = QFileDialog.getSaveFileName(self, title, "body.blobs.json", f"{title} (*.json)")
        if path and self._base is not None:
            try:
                write_text(Path(path), written_blobs(self.blobs, self._base.stamp))
            except ClonerError as error:
                self.notice.tell(error)
            else:
                self.tell_written(Path(path))


def _numbers() -> dict[str, str]:
    """Return what can be told of a blob: keys and words."""
    return {
        "radius 0": translate("studio", "Radius"),
        "radius 1": translate("studio", "Radius at the other end"),
        "off 0": translate("studio", "To the left"),
        "off 1": translate("studio", "Upwards"),
        "off 2": translate("studio", "Forwards"),
        "wide 0": translate("studio", "Times as wide"),
        "wide 1": translate("studio", "Times as high"),
        "wide 2": translate("studio", "Times as deep"),
    }
