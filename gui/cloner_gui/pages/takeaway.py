"""Last page: what the visitor takes home, and deletion."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, Qt, QUrl, Signal
from PySide6.QtGui import QDesktopServices, QPixmap
from PySide6.QtWidgets import (
    QCheckBox,
    QFileDialog,
    QGridLayout,
    QLabel,
    QLineEdit,
    QProgressBar,
    QSizePolicy,
    QWidget,
)

from cloner.booth.handover.sticks import Stick
from cloner.booth.handover.takeaway import free_name, link_text, qr_modules
from cloner.booth.stage import scene_clones
from cloner.booth.visitors.person_file import consent_when
from cloner.errors import ClonerError
from cloner_gui.canvas.photos.painting import to_pixmap
from cloner_gui.dialogs import ask_to_forget, ask_to_save_data
from cloner_gui.event.booth import Booth
from cloner_gui.event.handing import Handing
from cloner_gui.event.keepsakes import Keepsakes
from cloner_gui.event.phone import Phone
from cloner_gui.language.formats import FORMATS
from cloner_gui.language.told import stale_text
from cloner_gui.language.words import translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.pieces import GAP, Card, button, label, make_scrollable, set_accessible_name
from cloner_gui.widgets.stick_row import StickRow

_CODE_PX = 200


class TakeawayPage(QWidget):
    """Files, report, code and goodbye."""

    changed = Signal()

    def __init__(self, booth: Booth, phone: Phone, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth, self._phone = booth, phone
        self.phone_box, self.phone_note = QCheckBox(), label("dim")
        self.handing = Handing(booth.session, self)
        self.status, self.files_heading, self.code_heading, self.data_heading = (
            label("dim"), label("heading"), label("heading"), label("heading"),
        )  # fmt: skip
        self.stale = label("warn")
        self.formats = {kind: QCheckBox() for kind in FORMATS}
        self.folder_button, self.zip_button, self.report_button, self.show_button = (
            button(), button(), button(), button(),
        )  # fmt: skip
        self.sticks, self.bar, self.stop_button = StickRow(), QProgressBar(), button()
        self.keepsakes = Keepsakes(booth, self.code_text)
        self.link, self.code, self.code_note = QLineEdit(), QLabel(), label("dim")
        self.export_button, self.forget_button, self.held_label = button(), button("danger"), label("dim")
        self._lay_out()
        self._connect()
        self._speak()

    def why_not(self) -> str:
        """Return why no page comes after this one."""
        return ""

    def _lay_out(self) -> None:
        files, code, data = Card(), Card(), Card()
        files.column.addWidget(self.files_heading)
        files.column.addWidget(self.status)
        files.column.addWidget(self.stale)
        self.bar.setTextVisible(False)
        self.bar.setRange(0, 1000)
        files.column.addWidget(self.bar)
        files.column.addWidget(self.stop_button)
        files.column.addWidget(self.sticks)  # what is done most comes first, also where the text is large
        grid = QGridLayout()
        for number, box in enumerate(self.formats.values()):
            grid.addWidget(box, number, 0)
        files.column.addLayout(grid)
        for one in (self.folder_button, self.zip_button, self.report_button, self.show_button):
            files.column.addWidget(one)
        files.column.addStretch(1)
        code.column.addWidget(self.code_heading)
        self.code.setFixedSize(_CODE_PX, _CODE_PX)
        self.code.setAlignment(Qt.AlignmentFlag.AlignCenter)
        code.column.addWidget(self.code, 0, Qt.AlignmentFlag.AlignHCenter)
        code.column.addWidget(self.phone_box)
        code.column.addWidget(self.phone_note)
        code.column.addWidget(self.link)
        code.column.addWidget(self.code_note)
        code.column.addStretch(1)
        data.column.addWidget(self.data_heading)
        data.column.addWidget(self.held_label)
        data.column.addWidget(self.export_button)
        data.column.addWidget(self.forget_button)
        data.column.addStretch(1)
        inside = QWidget()
        row = Flow(inside)
        row.setSpacing(GAP)
        for card in (files, code, self.keepsakes, data):
            card.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
            row.addWidget(card)
        make_scrollable(self, inside)

    def _connect(self) -> None:
        session = self._booth.session
        self.folder_button.clicked.connect(self._to_folder)
        self.zip_button.clicked.connect(self._to_zip)
        self.stop_button.clicked.connect(self.handing.stop)
        self.sticks.copy_wanted.connect(self._to_stick)
        self.sticks.changed.connect(self.changed)
        self.sticks.failed.connect(self._booth.failed)
        self.report_button.clicked.connect(lambda: self._open("report.html"))
        self.show_button.clicked.connect(lambda: self._open(""))
        self.phone_box.clicked.connect(lambda on: self._booth.change(phone=on))
        self._phone.changed.connect(self._show)
        self.export_button.clicked.connect(self._export)
        self.forget_button.clicked.connect(self._forget)
        self.link.editingFinished.connect(lambda: self._booth.change(link=self.link.text().strip()))
        self.link.textChanged.connect(self._show_code)
        for box in self.formats.values():
            box.clicked.connect(self._take_formats)
        self.handing.changed.connect(self._show)
        self.handing.failed.connect(self._booth.failed)
        session.opened.connect(self.handing.forget)
        session.opened.connect(self._show)
        session.cloned.connect(self._show)
        session.points_changed.connect(self._show)
        session.busy_changed.connect(self._show)
        self._booth.visits_changed.connect(self._show)
        self._booth.event_changed.connect(self._show)

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
        super().changeEvent(event)

    def _speak(self) -> None:
        self.files_heading.setText(translate("takeaway", "Files"))
        self.code_heading.setText(translate("takeaway", "Code to scan"))
        self.data_heading.setText(translate("takeaway", "What is held"))
        self.folder_button.setText(translate("takeaway", "Copy to a f&older…"))
        self.zip_button.setText(translate("takeaway", "Save as one &zip file…"))
        self.stop_button.setText(translate("takeaway", "&Stop"))
        self.report_button.setText(translate("takeaway", "Show &report"))
        self.show_button.setText(translate("takeaway", "Show &folder"))
        self.phone_box.setText(translate("takeaway", "&Page for telephones on this network"))
        set_accessible_name(self.phone_box, translate("takeaway", "Page for telephones on this network"))
        self.export_button.setText(translate("takeaway", "Save &everything held…"))
        self.forget_button.setText(translate("takeaway", "&Delete this visitor…"))
        told = translate("takeaway", "Text or address in the code; {id} stands for the visitor")
        set_accessible_name(self.link, translate("takeaway", "Text of the code"), told)
        self.link.setPlaceholderText("https://…/{id}")
        set_accessible_name(self.code, translate("takeaway", "Code to scan"))
        set_accessible_name(self.bar, translate("takeaway", "How far the files are"))
        self.sticks.speak()
        self.keepsakes.speak()
        for kind, box in self.formats.items():
            box.setText(FORMATS[kind])
        self._show()

    def _show(self) -> None:
        """Show what can be taken."""
        session, settings = self._booth.session, self._booth.settings
        ready = session.outcome is not None and not self.handing.busy
        self.stale.setText(stale_text())
        self.stale.setVisible(session.is_stale() and not session.cloning)
        for one in (self.folder_button, self.zip_button, self.report_button, self.show_button):
            one.setEnabled(ready)
        self.sticks.allow(ready)
        for working in (self.bar, self.stop_button):
            working.setVisible(self.handing.busy)
        self.bar.setValue(round(1000 * self.handing.fraction))
        for one in (self.export_button, self.forget_button):
            one.setEnabled(session.folder is not None)
        for kind, box in self.formats.items():
            box.setChecked(kind in settings.formats)
        self.phone_box.setChecked(settings.phone)
        self.phone_box.setEnabled(self._booth.root is not None)
        self.phone_note.setText(self._told_phone())
        if not self.link.hasFocus():
            self.link.setText(settings.link)
        none = translate("takeaway", "There is no clone yet.")
        self.status.setText(none if session.outcome is None else self.handing.told())
        consent = translate("takeaway", "No consent is recorded.")
        if session.consent:
            consent = translate("takeaway", "Consent: {when}.").format(when=consent_when(session.consent))
        days = settings.retention_days
        kept = translate("takeaway", "Kept for {n} days.").format(n=days) if days else translate("takeaway", "Kept.")
        self.held_label.setText("\n".join([consent, kept, *self._told_scene()]) if session.folder is not None else "")
        self._show_code()
        self.changed.emit()

    def _show_code(self) -> None:
        text = self.code_text()
        try:
            modules = qr_modules(text) if text else None
        except ClonerError as error:
            modules, text = None, str(error)
        self.code.setVisible(modules is not None)
        self.code.setPixmap(QPixmap() if modules is None else _code_pixmap(modules))
        none = translate("takeaway", "Switch the page for telephones on, or type the address of a page of your own.")
        self.code_note.setText(text or none)
        self.keepsakes.show_card()

    def code_text(self) -> str:
        """Return what the visitor's code holds: the page for telephones, else the event's own; "" for none."""
        folder = self._booth.session.folder
        own = link_text(self.link.text().strip(), "" if folder is None else folder.name)
        return self._phone.link() or own

    def _told_scene(self) -> tuple[str, ...]:
        """Return in which scene the visitor's clone is, if it may be in one."""
        scene, folder = self._booth.settings.scene, self._booth.session.folder
        if not scene or folder is None or folder not in scene_clones(self._booth.visits()):
            return ()
        return (translate("takeaway", "In the scene “{scene}”, within seconds.").format(scene=scene),)

    def _told_phone(self) -> str:
        """Say who can see the page, and for how long."""
        settings = self._booth.settings
        if not settings.phone:
            return translate("takeaway", "Off: nothing leaves this computer.")
        if self._phone.busy:
            return translate("takeaway", "The page is being made…")
        if settings.phone_https:
            safe = translate("takeaway", "Telephones warn of the booth's own certificate once.")
        else:
            safe = translate("takeaway", "Not encrypted: use a hotspot of your own with a password.")
        lasts = translate("takeaway", "Each visitor's link works for {n} hours.").format(n=settings.phone_hours)
        return f"{lasts} {safe}"

    def close_all(self) -> None:
        """Stop copying and wait for it, and for a stick that is being let go."""
        self.handing.close()
        self.sticks.close_all()

    # --- what the operator does ----------------------------------------------------

    def _chosen(self) -> tuple[str, ...]:
        return tuple(kind for kind, box in self.formats.items() if box.isChecked())

    def _take_formats(self) -> None:
        self._booth.change(formats=self._chosen())

    def _to_stick(self, stick: Stick) -> None:
        folder = self._booth.session.folder
        if folder is not None:
            self.handing.start(free_name(stick.mount, folder.name), self._chosen())

    def _to_folder(self) -> None:
        place = QFileDialog.getExistingDirectory(self, translate("takeaway", "Stick or folder for the visitor's files"))
        folder = self._booth.session.folder
        if place and folder is not None:
            self.handing.start(free_name(Path(place), folder.name), self._chosen())

    def _to_zip(self) -> None:
        folder = self._booth.session.folder
        start = "" if folder is None else f"{folder.name}.zip"
        text = translate("takeaway", "Save as")
        target, _ = QFileDialog.getSaveFileName(self, text, start, "Zip (*.zip)")
        if target:
            path = Path(target).with_suffix(".zip")
            self.handing.start(free_name(path.parent, path.stem, ".zip"), self._chosen())

    def _open(self, which: str) -> None:
        """Show a file of the result with the desktop's own program."""
        outcome = self._booth.session.outcome
        if outcome is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str((outcome.folder / which).resolve())))

    def _export(self) -> None:
        if self._booth.session.folder is not None:
            ask_to_save_data(self._booth, self._booth.session.folder, self)

    def _forget(self) -> None:
        if self._booth.session.folder is not None:
            ask_to_forget(self._booth, (self._booth.session.folder,), self)


def _code_pixmap(modules: NDArray[np.bool_]) -> QPixmap:
    """Return the code with whole pixels a module, black on white whatever the window's colours: scanners want that."""
    each = max(1, _CODE_PX // len(modules))
    grey = np.where(modules, 0, 255).astype(np.uint8).repeat(each, axis=0).repeat(each, axis=1)
    return to_pixmap(np.repeat(grey[:, :, None], 3, axis=2))
