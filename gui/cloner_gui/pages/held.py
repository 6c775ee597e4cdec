"""What the event holds of whom: listed, saved for a visitor who asks, deleted; and the event's own settings."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHeaderView,
    QPlainTextEdit,
    QSpinBox,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from cloner_gui.booth import Booth
from cloner_gui.dialogs import ask_to_forget, ask_to_save_data
from cloner_gui.languages import consent_text
from cloner_gui.pieces import button, label, name
from cloner_gui.words import translate


class HeldWindow(QDialog):
    """Everybody of whom something is held."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.setWindowTitle(translate("privacy", "What is held"))
        self.resize(820, 520)
        self.summary = label("heading")
        self.table = QTableWidget(0, 5)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.verticalHeader().hide()
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        name(self.table, translate("privacy", "What is held, by visitor"))
        self.save_button, self.forget_button = button(), button("danger")
        self.save_button.setText(translate("privacy", "&Save everything held…"))
        self.forget_button.setText(translate("privacy", "&Delete the marked visitors…"))
        column = QVBoxLayout(self)
        for one in (self.summary, self.table, self.save_button, self.forget_button):
            column.addWidget(one)
        self.save_button.clicked.connect(self._save)
        self.forget_button.clicked.connect(lambda: self.marked() and ask_to_forget(booth, self.marked(), self))
        booth.visits_changed.connect(self.show_all)
        self.show_all()

    def show_all(self) -> None:
        """Fill the table."""
        held = self._booth.held()
        size = sum(one.size_bytes for one in held) / 1e6
        told = translate("privacy", "{n} visitors, {size} MB; nothing leaves this computer")
        self.summary.setText(told.format(n=len(held), size=round(size)))
        self.table.setHorizontalHeaderLabels(
            [
                translate("privacy", "Visitor"),
                translate("privacy", "Files"),
                translate("privacy", "MB"),
                translate("privacy", "Last change"),
                translate("privacy", "Consent"),
            ]
        )
        self.table.setRowCount(len(held))
        for row, one in enumerate(held):
            texts = (one.identifier, str(one.files), f"{one.size_bytes / 1e6:.1f}", f"{one.newest:%Y-%m-%d %H:%M}")
            for column, text in enumerate((*texts, one.consent or translate("privacy", "not recorded"))):
                self.table.setItem(row, column, QTableWidgetItem(text))

    def marked(self) -> tuple[Path, ...]:
        """Return the folders of the marked rows."""
        rows = sorted({index.row() for index in self.table.selectedIndexes()})
        root = self._booth.root
        items = [self.table.item(row, 0) for row in rows]
        return () if root is None else tuple(root / item.text() for item in items if item is not None)

    def _save(self) -> None:
        for folder in self.marked()[:1]:
            ask_to_save_data(self._booth, folder, self)


class SettingsWindow(QDialog):
    """What holds for every visitor of the event: how long they are kept, and what they agree to."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.setWindowTitle(translate("settings", "This event"))
        self.resize(560, 380)
        self.days, self.consent = QSpinBox(), QPlainTextEdit()
        self.days.setRange(0, 3650)
        self.days.setSpecialValueText(translate("settings", "kept until deleted"))
        self.days.setSuffix(translate("settings", " days"))
        self.days.setValue(booth.settings.retention_days)
        self.consent.setPlainText(booth.settings.consent)
        self.consent.setPlaceholderText(consent_text(booth.settings.language))
        self.consent.setTabChangesFocus(True)
        name(self.days, translate("settings", "Days that visitors are kept"))
        name(self.consent, translate("settings", "What visitors agree to"))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Save | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        form.addRow(translate("settings", "&Keep visitors for"), self.days)
        form.addRow(translate("settings", "&Consent"), self.consent)
        form.addRow(buttons)

    def accept(self) -> None:
        """Save the settings."""
        self._booth.change(retention_days=self.days.value(), consent=self.consent.toPlainText().strip())
        super().accept()
