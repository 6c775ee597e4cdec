"""Statues: what their windows share, and a clone in stone."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP
from PySide6.QtWidgets import QComboBox, QFileDialog, QLineEdit, QWidget

from cloner.booth.studio.values import StatueWish, received
from cloner.project.folder import safe_identifier
from cloner.records.clones import Clone
from cloner_gui.canvas.clones.preview import Preview
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import TranslatedWords, translate
from cloner_gui.studio.bench import Bench, Subject
from cloner_gui.widgets.pieces import button

MATERIALS: Final = TranslatedWords(
    "materials",
    {
        "stone": QT_TRANSLATE_NOOP("materials", "Stone"),
        "clay": QT_TRANSLATE_NOOP("materials", "Clay"),
        "bronze": QT_TRANSLATE_NOOP("materials", "Bronze"),
        "marble": QT_TRANSLATE_NOOP("materials", "Marble"),
    },
)
POSES: Final = TranslatedWords(
    "materials",
    {
        "rest": QT_TRANSLATE_NOOP("materials", "As photographed"),
        "standing": QT_TRANSLATE_NOOP("materials", "Arms hanging"),
        "guard": QT_TRANSLATE_NOOP("materials", "On guard"),
        "hail": QT_TRANSLATE_NOOP("materials", "Hailing"),
    },
)
USUAL, CLONE = "usual", "clone"
#: Side of the texture of a statue that is nobody's clone, texels; as `cloner statue` has it.
_TEXELS: Final = 2048


class StatueBench(Bench):
    """A window of the studio that makes a statue: initial clone, material, name, saving."""

    def __init__(self, booth: Booth, title: str, parent: QWidget | None = None, *, usual: bool) -> None:
        super().__init__(booth, title, parent)
        self.subject, self.kind, self.material = Subject(booth), QComboBox(), QComboBox()
        self.name_field, self.save_button = QLineEdit(), button("main")
        self._usual = usual
        if usual:
            self.kind.addItem(translate("studio", "The usual man"), USUAL)
            self.material.addItem(translate("studio", "Its own colours"), "")
        self.kind.addItem(translate("studio", "A clone"), CLONE)
        for one in MATERIALS:
            self.material.addItem(MATERIALS[one], one)
        self.save_button.setText(translate("studio", "&Save the statue…"))
        self.name_field.setText(translate("studio", "statue"))
        if usual:
            self.field(translate("studio", "La&id on"), self.kind)
        self.controls.addWidget(self.subject)
        self.kind.activated.connect(self._take_kind)
        self.subject.setVisible(not usual)

    def onto(self) -> Path | None:
        """Return the clone that it begins with; None for the usual man, or where none is chosen."""
        return self.subject.path if self.kind.currentData() == CLONE else None

    def is_ready(self) -> bool:
        """Return whether there is anything to begin with."""
        return self.kind.currentData() != CLONE or self.subject.path is not None

    def end_fields(self) -> None:
        """Put name and button below the other fields."""
        self.field(translate("studio", "&Name of the statue"), self.name_field)
        self.controls.addStretch(1)
        self.deeds.addWidget(self.save_button)
        self.save_button.clicked.connect(self._ask_where)

    def save(self, wish: StatueWish) -> None:
        """Ask for the job that writes the statue."""
        raise NotImplementedError

    def begin_anew(self) -> None:
        """Begin with another clone."""
        raise NotImplementedError

    def _take_kind(self) -> None:
        self.subject.setVisible(self.kind.currentData() == CLONE)
        self.begin_anew()

    def _ask_where(self) -> None:
        """Write beside the clone, whose visitor the statue belongs to; else into a folder that is chosen."""
        onto = self.onto()
        if onto is not None:
            out = onto.resolve().parent
        else:
            chosen = QFileDialog.getExistingDirectory(self, translate("studio", "Folder for statues"))
            if not chosen:
                return
            out = Path(chosen)
        called = safe_identifier(self.name_field.text().strip() or "statue")
        formats = tuple(self.booth.settings.formats)
        self.save(StatueWish(str(self.material.currentData()), out, called, formats, _TEXELS))


class StoneWindow(StatueBench):
    """A clone in a material."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(booth, translate("studio", "Clone in stone"), parent, usual=False)
        self.pose, self.preview = QComboBox(), Preview()
        for one in POSES:
            self.pose.addItem(POSES[one], one)
        self.preview.say_when_empty(translate("studio", "Choose a clone that is finished."))
        self.field(translate("studio", "&Material"), self.material)
        self.field(translate("studio", "&Pose"), self.pose)
        self.end_fields()
        self.stage.addWidget(self.preview, 1)
        self.subject.changed.connect(self.begin_anew)
        self.material.activated.connect(self.carve)
        self.pose.activated.connect(self.carve)
        self.busy_changed.connect(self._show_ready)
        self.preview.failed.connect(self.notice.tell)
        self.begin_anew()
        self.settle()

    def begin_anew(self) -> None:
        """Cut another clone."""
        self.preview.set_clone(None)
        if self.subject.path is not None:
            self.name_field.setText(f"{self.subject.path.name}-{self.material.currentData()}")
        self.carve()

    def carve(self) -> None:
        """Show the clone in its material and pose."""
        onto = self.onto()
        if onto is not None:
            self.name_field.setText(f"{onto.name}-{self.material.currentData()}")
            material, pose = str(self.material.currentData()), str(self.pose.currentData())
            self.work("carve", onto, material, pose, then=self._take_statue)
        self._show_ready()

    def save(self, wish: StatueWish) -> None:
        """Write the statue."""
        self.work("save_carved", self.onto(), str(self.pose.currentData()), wish, then=self.tell_written)

    def _take_statue(self, statue: Clone) -> None:
        statue = received(statue)
        if self.preview.pixmap().isNull():
            self.preview.set_clone(statue)
        else:
            self.preview.update_clone(statue)

    def _show_ready(self) -> None:
        self.save_button.setEnabled(not self.busy and self.onto() is not None)
        for one in (self.subject, self.material, self.pose):
            one.setEnabled(not self.busy)
