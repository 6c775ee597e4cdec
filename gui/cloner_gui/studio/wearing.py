"""Dressing a clone: a garment is placed, sewn, settled in a fabric, simulated in a walk, and saved."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QComboBox, QFileDialog, QMessageBox, QSpinBox, QWidget

from cloner.booth.studio.values import Arranged, Draped, Outfit, received
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from cloner_gui.background.newest import shared_latest
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import translate
from cloner_gui.studio.bench import Bench, Subject
from cloner_gui.studio.draped import DrapedPreview, PiecesView
from cloner_gui.studio.wardrobe import FABRICS, GARMENTS, TARGETS
from cloner_gui.widgets.pieces import button, label
from cloner_gui.widgets.step_bar import StepBar

ARRANGE, SEW, FABRIC, ANIMATE, EXPORT = range(5)
#: Lengths that may be asked for, cm; the first stands for the usual one.
_LENGTHS_CM: Final = (14, 120)
_WALK: Final = "walk"


class WearingWindow(Bench):
    """A garment on a clone, step by step."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(booth, translate("studio", "Dress a clone"), parent)
        self.subject = Subject(booth)
        self.steps, self.preview, self.pieces = StepBar(5), DrapedPreview(), PiecesView()
        self.garment, self.fabric, self.motion = QComboBox(), QComboBox(), QComboBox()
        self.bare, self.length, self.told = QCheckBox(), QSpinBox(), label("dim")
        self.next_button, self.over_button = button("main"), button()
        self._under: Outfit | None = None
        self.preview.say_when_empty(translate("studio", "Choose a clone that is finished."))
        self.step = ARRANGE
        self._fill()
        self._place()
        self._connect()
        self._begin_anew()
        self.settle()

    def outfit(self) -> Outfit | None:
        """Return what is chosen; None without a clone."""
        if self.subject.path is None:
            return None
        length = self.length.value()
        return Outfit(
            self.subject.path,
            self.bare.isChecked(),
            str(self.garment.currentData()),
            None if length == _LENGTHS_CM[0] else float(length),
            str(self.fabric.currentData()),
            str(self.motion.currentData()),
            self._under,
        )

    def _fill(self) -> None:
        for kind in GARMENTS:
            self.garment.addItem(GARMENTS[kind], kind)
        self.garment.addItem(translate("studio", "A file of my own…"), "")
        for kind in FABRICS:
            self.fabric.addItem(FABRICS[kind], kind)
        self.fabric.setCurrentIndex(list(FABRICS).index("cotton"))
        self.motion.addItem(translate("studio", "Own walk"), _WALK)
        self.motion.addItem(translate("studio", "A captured walk…"), "")
        self.length.setRange(*_LENGTHS_CM)
        self.length.setSuffix(translate("studio", " cm"))
        self.length.setSpecialValueText(translate("studio", "as usual"))
        self.bare.setText(translate("studio", "&Instead of the photographed clothes"))
        self.told.setText(translate("studio", "Otherwise it is worn over the clothes of the photos."))

    def _place(self) -> None:
        self.field(translate("studio", "Who wears it"), self.subject)
        self.controls.addWidget(self.bare)
        self.controls.addWidget(self.told)
        self.field(translate("studio", "&Garment"), self.garment)
        self.field(translate("studio", "&Length"), self.length)
        self.field(translate("studio", "&Fabric"), self.fabric)
        self.field(translate("studio", "&Motion"), self.motion)
        self.field(translate("studio", "Pieces"), self.pieces)
        self.controls.addStretch(1)
        self.stage.addWidget(self.steps)
        self.stage.addWidget(self.preview, 1)
        self.over_button.setText(translate("studio", "Something &over it"))
        self.deeds.addWidget(self.over_button)
        self.deeds.addWidget(self.next_button)

    def _connect(self) -> None:
        self.subject.changed.connect(self._take_subject)
        self.bare.clicked.connect(self._ask_bare)
        self.garment.activated.connect(self._take_garment)
        self.length.valueChanged.connect(self._cut_anew)
        self.fabric.activated.connect(self._hang_again)
        self.motion.activated.connect(self._take_motion)
        self.steps.chosen.connect(self._go_back)
        self.next_button.clicked.connect(self.go_on)
        self.over_button.clicked.connect(self.wear_over)
        self.busy_changed.connect(self._show_step)
        self.preview.failed.connect(self.notice.tell)

    # --- what is chosen -------------------------------------------------------------

    def _take_subject(self) -> None:
        self.bare.setChecked(False)  # of each clone anew: nobody is undressed because somebody before was
        self._begin_anew()

    def _ask_bare(self, wanted: bool) -> None:
        """Take photographed clothes off only where the operator says so."""
        if not wanted:
            self._begin_anew()
            return
        self.bare.setChecked(False)
        if not self.booth.allowed():
            return
        title = translate("studio", "Photographed clothes")
        text = translate("studio", "Take the photographed clothes of {name} off?").format(name=self.subject.who.text())
        box = QMessageBox(QMessageBox.Icon.Question, title, text, parent=self)
        box.setInformativeText(
            translate("studio", "The garment is then worn over neutral underwear. Ask the visitor first.")
        )
        yes = box.addButton(translate("studio", "Take them off"), QMessageBox.ButtonRole.AcceptRole)
        box.setDefaultButton(box.addButton(QMessageBox.StandardButton.Cancel))
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.finished.connect(functools.partial(self._take_bare, box, yes))
        box.open()

    def _take_bare(self, box: QMessageBox, yes: object, _: int) -> None:
        if box.clickedButton() is yes:
            self.bare.setChecked(True)
            self._begin_anew()

    def _take_garment(self, row: int) -> None:
        if self._took_file(self.garment, row, translate("studio", "File of a garment"), "*.svg *.json"):
            self._cut_anew()

    def _take_motion(self, row: int) -> None:
        if self._took_file(self.motion, row, translate("studio", "Captured walk"), "*.bvh"):
            self._begin_anew()

    def _took_file(self, box: QComboBox, row: int, title: str, kinds: str) -> bool:
        """Ask for a file where the last entry was chosen, which stands for one; False where none was given."""
        if row != box.count() - 1:
            return True
        path, _ = QFileDialog.getOpenFileName(self, title, "", f"{title} ({kinds})")
        if not path:
            box.setCurrentIndex(0)
            return False
        known = box.findData(path)
        if known < 0:
            known = box.count() - 1
            box.insertItem(known, Path(path).name, path)
        box.setCurrentIndex(known)
        return True

    # --- steps ------------------------------------------------------------------------

    def go_on(self) -> None:
        """Do what this step is for."""
        outfit = self.outfit()
        if outfit is None:
            return
        if self.step == ARRANGE:
            self.work("arrange", outfit, then=self._take_arranged)
        elif self.step == SEW:
            self._hang(outfit)
        elif self.step == FABRIC:
            self.work("walk", outfit, then=self._take_loop, shows=self.preview.show_draped)
        else:
            self._export(outfit)

    def wear_over(self) -> None:
        """Keep what is worn, and begin with a garment over it."""
        self._under = self.outfit()
        self.step = ARRANGE
        self.pieces.show_pieces(())
        self._show_step()

    def _begin_anew(self) -> None:
        """Forget all garments: another one, or another clone, is wanted."""
        self.cancel()
        self.step, self._under = ARRANGE, None
        self.pieces.show_pieces(())
        self.preview.show_draped(None)
        self.preview.set_clone(None)
        self.written.setText("")
        path = self.subject.path
        if path is not None:
            shared_latest().ask(
                self,
                "clone",
                functools.partial(load_clone_at, path),
                functools.partial(self._take_clone, path),
                self.notice.tell,
            )
        self._show_step()

    def _cut_anew(self) -> None:
        """Forget the garment at hand; what is worn below it stays."""
        if self._under is None:
            self._begin_anew()
        else:
            self._reach(ARRANGE)

    def _take_clone(self, path: Path, clone: Clone) -> None:
        if self.step == ARRANGE and path == self.subject.path:
            self.preview.set_clone(clone)

    def _go_back(self, step: int) -> None:
        """Go back to an earlier step."""
        if step < self.step and not self.busy:
            self.step = step
            if step == ARRANGE:
                self._cut_anew()
            self._show_step()

    def _take_arranged(self, made: Arranged) -> None:
        self.pieces.show_pieces(made.pieces_m)
        self.preview.show_draped(made.draped)
        self.preview.update_clone(received(made.below))
        self._reach(SEW)

    def _hang(self, outfit: Outfit) -> None:
        self.work("hang", outfit, then=lambda _: self._reach(FABRIC), shows=self.preview.show_draped)

    def _hang_again(self) -> None:
        """Let the garment hang in another fabric, where it has hung already."""
        outfit = self.outfit()
        if self.step >= FABRIC and outfit is not None:
            self.step = FABRIC
            self._hang(outfit)

    def _take_loop(self, found: tuple[Draped, float]) -> None:
        self.preview.show_draped(*found)
        self._reach(ANIMATE)

    def _export(self, outfit: Outfit) -> None:
        """Ask for a file and write the clone in its garment into it."""
        kinds = {f"{TARGETS[kind]} (*{kind})": kind for kind in TARGETS}
        start = f"{outfit.clone.name}-{Path(outfit.garment).stem}.glb"
        title = translate("studio", "Save the dressed clone")
        target, kind = QFileDialog.getSaveFileName(self, title, start, ";;".join(kinds))
        if not target:
            return
        path, ending = Path(target), kinds.get(kind, ".glb")
        if not ending:
            path = path.with_suffix("") if path.suffix.lower() in TARGETS else path
        elif path.suffix.lower() not in TARGETS or not path.suffix:
            path = path.with_name(path.name + ending)
        self.work("save_worn", outfit, path, then=self._take_written)

    def _take_written(self, path: Path) -> None:
        self.tell_written(path)
        self._reach(EXPORT)

    def _reach(self, step: int) -> None:
        self.step = step
        self._show_step()

    def _show_step(self) -> None:
        """Say which step is at hand and what comes next."""
        titles = (
            translate("studio", "Arrange"),
            translate("studio", "Sew"),
            translate("studio", "Fabric"),
            translate("studio", "Animate"),
            translate("studio", "Export"),
        )
        deeds = (
            translate("studio", "A&rrange"),
            translate("studio", "Se&w"),
            translate("studio", "Let it wal&k"),
            translate("studio", "&Save as…"),
            translate("studio", "&Save as…"),
        )
        self.steps.show_steps(titles, self.step, 0 if self.busy else self.step)
        self.next_button.setText(deeds[self.step])
        self.over_button.setVisible(self.step >= ANIMATE)
        self.over_button.setEnabled(not self.busy)
        self.next_button.setEnabled(not self.busy and self.subject.path is not None)
        for one in (self.garment, self.length, self.fabric):
            one.setEnabled(not self.busy)
        for other in (self.subject, self.bare, self.motion):
            other.setEnabled(not self.busy and self._under is None)
