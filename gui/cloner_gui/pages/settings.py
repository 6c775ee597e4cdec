"""Settings for every visitor of the event: its name, retention, and the consent."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLineEdit,
    QPlainTextEdit,
    QScrollArea,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from cloner.booth.events.event import LANGUAGES, MOST_AT_ONCE
from cloner.booth.events.pin import hash_pin
from cloner.records.terms import LICENCES
from cloner_gui.event.booth import Booth
from cloner_gui.language.languages import LANGUAGE_NAMES, consent_text
from cloner_gui.language.words import translate
from cloner_gui.widgets.letters import assign_to_dialog
from cloner_gui.widgets.licence_field import LicenceField
from cloner_gui.widgets.logo_field import LogoField
from cloner_gui.widgets.pieces import label, set_accessible_name, set_window_size


class SettingsWindow(QDialog):
    """The event's settings; they take effect when saved."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth, settings = booth, booth.settings
        self._consents = dict(settings.consents)
        self.setWindowTitle(translate("settings", "This event"))
        set_window_size(self, 640, 620)
        self.title, self.consent, self.language = QLineEdit(settings.title), QPlainTextEdit(), QComboBox()
        self.logo, self.scene = LogoField(settings.logo), QLineEdit(settings.scene)
        self.days, self.trash, self.licence = QSpinBox(), QSpinBox(), LicenceField()
        self.calm = QCheckBox(translate("settings", "Nothing &moves by itself"))
        self.at_once = QSpinBox()
        self.hours, self.https = QSpinBox(), QCheckBox(translate("settings", "&Encrypt the page for telephones"))
        self._note = label("dim")
        self.pin, self.asks = QLineEdit(), QCheckBox(translate("settings", "The kiosk &asks for a number"))
        self._fill()
        self._lay_out()
        self._show_language()
        self.language.currentIndexChanged.connect(self._show_language)
        self.days.valueChanged.connect(self._show_usual)
        self.consent.textChanged.connect(self._take_text)
        assign_to_dialog(self)

    def _fill(self) -> None:
        settings = self._booth.settings
        for code in LANGUAGES:
            self.language.addItem(LANGUAGE_NAMES[code], code)
        self.language.setCurrentIndex(list(LANGUAGES).index(settings.language))
        for box, most, value in ((self.days, 3650, settings.retention_days), (self.trash, 365, settings.trash_days)):
            box.setRange(0, most)
            box.setSuffix(translate("settings", " days"))
            box.setValue(value)
        self.days.setSpecialValueText(translate("settings", "kept until deleted"))
        self.trash.setSpecialValueText(translate("settings", "not at all"))
        self.licence.offer(LICENCES, settings.language, settings.licence)
        self.title.setPlaceholderText("" if self._booth.root is None else self._booth.root.name)
        self.calm.setChecked(settings.calm)
        self.hours.setRange(1, 720)
        self.hours.setSuffix(translate("settings", " hours"))
        self.hours.setValue(settings.phone_hours)
        self.https.setChecked(settings.phone_https)
        self.at_once.setRange(1, MOST_AT_ONCE)
        self.at_once.setValue(settings.at_once)
        self.at_once.setToolTip(translate("settings", "Each takes a core of this computer and 1 GB of its memory."))
        self.consent.setTabChangesFocus(True)
        self.pin.setEchoMode(QLineEdit.EchoMode.Password)
        self.asks.setChecked(bool(settings.pin))
        self.pin.setPlaceholderText(translate("settings", "unchanged") if settings.pin else "")
        self.scene.setPlaceholderText(translate("settings", "none; for example: museum"))
        self.pin.textEdited.connect(lambda: self.asks.setChecked(True))
        self._note.setText(translate("settings", "{days} in the text stands for the days that visitors are kept."))

    def _lay_out(self) -> None:
        form, inside, room = QFormLayout(), QWidget(), QScrollArea()
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapAllRows)
        form.addRow(translate("settings", "&Name of the event"), self.title)
        form.addRow(translate("settings", "Logo"), self.logo)
        form.addRow(translate("settings", "&Keep visitors for"), self.days)
        form.addRow(translate("settings", "Bring &back thrown away ones for"), self.trash)
        form.addRow(translate("settings", "&Language of the text"), self.language)
        form.addRow(translate("settings", "&Consent"), self.consent)
        form.addRow("", self._note)
        form.addRow(translate("settings", "Visitors may let &use the files"), self.licence)
        form.addRow(translate("settings", "Links for &telephones work for"), self.hours)
        form.addRow("", self.https)
        form.addRow(translate("settings", "&Scene that clones may walk in"), self.scene)
        form.addRow(translate("settings", "&Visitors cloned at the same time"), self.at_once)
        form.addRow("", self.calm)
        form.addRow("", self.asks)
        form.addRow(translate("settings", "N&umber of the operator"), self.pin)
        for widget, text in (
            (self.title, translate("settings", "Name of the event")),
            (self.days, translate("settings", "Days that visitors are kept")),
            (self.trash, translate("settings", "Days that thrown away visitors can be brought back")),
            (self.hours, translate("settings", "Hours that links for telephones work")),
            (self.scene, translate("settings", "Scene that clones may walk in")),
            (self.at_once, translate("settings", "Visitors cloned at the same time")),
            (self.language, translate("settings", "Language of the text")),
            (self.licence.choice, translate("settings", "Who visitors may let use the files, at the most")),
            (self.pin, translate("settings", "Number of the operator")),
            (self.consent, translate("settings", "What visitors agree to")),
        ):
            set_accessible_name(widget, text)
        inside.setLayout(form)
        room.setWidget(inside)
        room.setWidgetResizable(True)
        room.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Save | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.addWidget(room, 1)
        column.addWidget(buttons)

    def _code(self) -> str:
        return str(self.language.currentData())

    def _show_language(self) -> None:
        """Show the consent in one language."""
        self.consent.blockSignals(True)
        self.consent.setPlainText(self._consents.get(self._code(), ""))
        self.consent.blockSignals(False)
        self._show_usual()

    def _show_usual(self) -> None:
        self.consent.setPlaceholderText(consent_text(self._code(), self.days.value(), {}))

    def _take_text(self) -> None:
        self._consents[self._code()] = self.consent.toPlainText().strip()

    def accept(self) -> None:
        """Save the settings."""
        number, kept = self.pin.text().strip(), self._booth.settings.pin
        self._booth.change(
            title=self.title.text().strip(),
            retention_days=self.days.value(),
            trash_days=self.trash.value(),
            consents={code: text for code, text in self._consents.items() if text},
            logo=self.logo.path,
            scene=self.scene.text().strip(),
            at_once=self.at_once.value(),
            licence=self.licence.chosen(),
            phone_hours=self.hours.value(),
            phone_https=self.https.isChecked(),
            calm=self.calm.isChecked(),
            pin="" if not self.asks.isChecked() else hash_pin(number) if number else kept,
        )
        super().accept()
