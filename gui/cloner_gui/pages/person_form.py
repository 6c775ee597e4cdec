"""The open visitor's data: name or number, height, language and consent; saved as it is entered."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QLineEdit, QSizePolicy, QWidget

from cloner.booth.events.agreed import default_licence, offered_licences
from cloner.booth.events.event import LANGUAGES
from cloner.booth.visitors.person_file import consent_when, consent_words
from cloner.booth.visitors.visits import read_visit
from cloner.project.folder import DEFAULT_HEIGHT_CM
from cloner.records.terms import LICENCES
from cloner_gui.event.booth import Booth
from cloner_gui.language.languages import LANGUAGE_NAMES, consent_text
from cloner_gui.language.words import translate
from cloner_gui.widgets.height_field import HeightField
from cloner_gui.widgets.letters import escape_mnemonic, without_mnemonic
from cloner_gui.widgets.licence_field import LicenceField
from cloner_gui.widgets.pieces import GAP, Card, box_with_label, button, label, set_accessible_name

#: Typing that rests so long is saved, milliseconds.
_SAVE_AFTER_MS = 400


class PersonForm(Card):
    """The open visitor's data."""

    changed = Signal()
    photos_wanted = Signal()
    """The visitor has agreed: on to the photos."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self._showing = False
        self._folder: Path | None = None
        self.heading = label("title")
        self.name_field, self.height_field = QLineEdit(), HeightField()
        self.language = QComboBox()
        self.consent_text, self.consent_box, self.consent_note = label(), QCheckBox(), label("dim")
        self.shown_box, self.agree_button = QCheckBox(), button("main")
        self.inhabits_box, self.inhabits_words = QCheckBox(), label()
        self.name_why, self.shown_why = label("dim"), label("dim")
        self.consent_words, self.shown_words = label(), label()
        self.name_label, self.height_label, self.language_label, self.licence_label = (
            label(wraps=False) for _ in range(4)
        )
        self.licence = LicenceField()
        self.height_hint = label("dim")
        self.name_field.returnPressed.connect(self.focusNextChild)
        for code in LANGUAGES:
            self.language.addItem(LANGUAGE_NAMES[code], code)
        self._save_soon = QTimer(self, singleShot=True, interval=_SAVE_AFTER_MS)
        self._save_soon.timeout.connect(self.save)
        self._lay_out()
        self.name_field.textEdited.connect(self._save_soon.start)
        self.height_field.changed.connect(self._take_height)
        self.language.currentIndexChanged.connect(self._show_consent)
        self.consent_box.clicked.connect(self._take_consent)
        self.shown_box.clicked.connect(booth.set_shown)
        self.inhabits_box.clicked.connect(booth.set_inhabits)
        self.agree_button.clicked.connect(self._agree_and_go)
        booth.leaving.connect(self.save)
        booth.session.opened.connect(self._show)
        booth.event_changed.connect(self._show_consent)
        self._speak()

    def why_not(self) -> str:
        """Return why the next page cannot come yet."""
        session = self._booth.session
        if session.consent or session.photos.photos:
            return ""
        return translate("visitor", "The visitor has to agree before photos are taken.")

    def asked(self) -> str:
        """Return what the visitor is asked to agree to."""
        settings = self._booth.settings
        return consent_text(str(self.language.currentData()), settings.retention_days, settings.consents)

    def save(self) -> None:
        """Save what is typed, now."""
        self._save_soon.stop()
        if self._booth.session.folder is not None:
            self._booth.save_person(self.name_field.text().strip(), self.height_field.height_cm())
            self._show_heading()
        self.changed.emit()

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.setVerticalSpacing(GAP // 2)
        form.setLabelAlignment(Qt.AlignmentFlag.AlignVCenter)
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapAllRows)
        for text, field in (
            (self.name_label, self.name_field),
            (self.height_label, self.height_field.first_field()),
            (self.language_label, self.language),
            (self.licence_label, self.licence.choice),
        ):
            text.setBuddy(field)
            text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
            text.setContentsMargins(0, 0, GAP // 2, 0)  # the last letter was cut where the text is large
        form.addRow(self.name_label, self.name_field)
        form.addRow("", self.name_why)
        form.addRow(self.height_label, self.height_field)
        form.addRow("", self.height_hint)
        form.addRow(self.language_label, self.language)
        self.column.addWidget(self.heading)
        self.column.addLayout(form)
        self.column.addWidget(self.consent_text)
        self.column.addWidget(self.licence_label)
        self.column.addWidget(self.licence)
        self.column.addLayout(box_with_label(self.consent_box, self.consent_words))
        self.column.addWidget(self.consent_note)
        self.column.addLayout(box_with_label(self.shown_box, self.shown_words))
        self.column.addWidget(self.shown_why)
        self.column.addLayout(box_with_label(self.inhabits_box, self.inhabits_words))
        self.column.addWidget(self.agree_button)

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
        super().changeEvent(event)

    def _speak(self) -> None:
        self.name_label.setText(translate("visitor", "N&ame or number"))
        self.height_label.setText(translate("visitor", "&Height without shoes"))
        self.language_label.setText(translate("visitor", "&Language of the consent"))
        self.licence_label.setText(translate("visitor", "Who may use the &files"))
        self.consent_words.setText(translate("visitor", "The visitor has read this and &agrees"))
        self.shown_words.setText(translate("visitor", "May be seen on the &screen for visitors"))
        self.agree_button.setText(translate("visitor", "Agrees: on to the &photos"))
        self.name_why.setText(translate("visitor", "To find each other again; a number will do, or nothing at all."))
        self.shown_why.setText(translate("visitor", "With the first name, among the others of today; asked apart."))
        for field, text in (
            (self.name_field, translate("visitor", "Name or number of the visitor")),
            (self.language, translate("visitor", "Language of the consent")),
            (self.licence.choice, translate("visitor", "Who may use the files")),
            (self.consent_box, translate("visitor", "The visitor agrees")),
            (self.shown_box, translate("visitor", "May be seen on the screen for visitors")),
        ):
            set_accessible_name(field, text)
        self.height_field.speak()
        self._show()

    def _show(self) -> None:
        """Show the open visitor."""
        folder = self._booth.session.folder
        person, height_cm, _ = self._booth.person()
        self._showing = True
        self._show_heading()
        if folder != self._folder or not self._save_soon.isActive():  # never over what is being typed
            self._save_soon.stop()
            self.name_field.setText(person)
            self.height_field.set_height(height_cm)
        if folder != self._folder:
            self.licence.forget()
        self._folder = folder
        at = self.language.findData(self._booth.settings.language)
        self.language.setCurrentIndex(max(at, 0))
        self._showing = False
        self._show_hint()
        self._show_consent()

    def _show_hint(self) -> None:
        why = translate("visitor", "It gives the clone its true size; everything else is measured in the photos.")
        unknown = translate("visitor", "Unknown: {n} cm is assumed, and every length is unscaled.")
        known = self.height_field.height_cm() is not None
        self.height_hint.setText(why if known else unknown.format(n=round(DEFAULT_HEIGHT_CM)))

    def _show_consent(self) -> None:
        consent, folder = self._booth.session.consent, self._booth.session.folder
        self.consent_text.setText(consent_words(consent) if consent_when(consent) != consent else self.asked())
        self._show_licence()
        self.consent_box.setChecked(bool(consent))
        self.shown_box.setChecked(folder is not None and read_visit(folder).shown)
        self.shown_box.setEnabled(bool(consent))
        self._show_scene(folder, bool(consent))
        self.agree_button.setVisible(not consent)
        self.language.setEnabled(not consent)  # what was agreed to is shown as it was read
        recorded = translate("visitor", "Recorded: {text}")
        self.consent_note.setText(recorded.format(text=consent_when(consent)) if consent else "")
        self.consent_note.setVisible(bool(consent))
        self.changed.emit()

    def _show_scene(self, folder: Path | None, consents: bool) -> None:
        """Ask whether the clone may walk in the event's scene, where there is one."""
        scene = self._booth.settings.scene
        told = translate("visitor", "The clone may &walk in the scene “{scene}”")
        self.inhabits_words.setText(told.format(scene=escape_mnemonic(scene)))
        set_accessible_name(self.inhabits_box, without_mnemonic(told).format(scene=scene))
        self.inhabits_box.setChecked(folder is not None and read_visit(folder).inhabits)
        self.inhabits_box.setEnabled(consents)
        for one in (self.inhabits_box, self.inhabits_words):
            one.setVisible(bool(scene))

    def _show_licence(self) -> None:
        """Ask who may use the files, as far as the event asks for more than nobody else; or show what was agreed."""
        settings, code, consent = self._booth.settings, str(self.language.currentData()), self._booth.session.consent
        offered, recorded = offered_licences(settings), self._booth.licence() if consent else ""
        self.licence.offer((recorded,) if recorded else offered, code, recorded or default_licence(settings, code))
        self.licence.choice.setEnabled(not recorded)
        for one in (self.licence_label, self.licence):
            one.setVisible(len(offered) > 1 or recorded not in ("", LICENCES[0]))

    def _take_height(self) -> None:
        self._show_hint()
        if not self._showing:
            self._save_soon.start()

    def _take_consent(self, agrees: bool) -> None:
        """Record the consent with its text and time, or that it was withdrawn."""
        self.save()
        if agrees:
            self._booth.agree(self.asked(), str(self.language.currentData()), self.licence.chosen())
        else:
            self._booth.withdraw_consent()
            self._booth.set_shown(False)
            self._booth.set_inhabits(False)
        self._show_consent()

    def _agree_and_go(self) -> None:
        """Record the consent, and go on."""
        self._take_consent(True)
        if self._booth.session.consent:
            self.photos_wanted.emit()

    def _show_heading(self) -> None:
        folder = self._booth.session.folder
        self.heading.setText("" if folder is None else self._booth.name_of(folder))
