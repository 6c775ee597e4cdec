"""What the event stores of whom: listed, exported for a visitor, deleted."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from cloner.booth.visitors.person_file import consent_when
from cloner.personal_data.holdings import Holding
from cloner_gui.background.newest import shared_latest
from cloner_gui.dialogs import ask_to_forget, ask_to_save_data
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import translate
from cloner_gui.widgets.pieces import button, label, set_accessible_name, set_window_size, show_whole_columns


class HeldWindow(QDialog):
    """Everybody of whom something is stored."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.setWindowTitle(translate("privacy", "What is held"))
        set_window_size(self, 820, 520)
        self.summary = label("heading")
        self.table = QTableWidget(0, 5)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.verticalHeader().hide()
        show_whole_columns(self.table)
        set_accessible_name(self.table, translate("privacy", "What is held, by visitor"))
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
        """Count what is held of everybody, beside the window's thread: that is every file of the event."""
        shared_latest().ask(self, "held", self._booth.held_soon(), self._fill, self._booth.failed.emit)

    def _fill(self, held: tuple[Holding, ...]) -> None:
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
            called = self._booth.name_of(one.photos[0])
            texts = (called, str(one.files), f"{one.size_bytes / 1e6:.1f}", f"{one.newest:%Y-%m-%d %H:%M}")
            agreed = consent_when(one.consent) or translate("privacy", "not recorded")
            items = [QTableWidgetItem(text) for text in (*texts, agreed)]
            items[-1].setToolTip(one.consent)
            items[0].setData(Qt.ItemDataRole.UserRole, one.photos[0])
            for column, item in enumerate(items):
                self.table.setItem(row, column, item)

    def marked(self) -> tuple[Path, ...]:
        """Return the folders of the marked rows."""
        rows = sorted({index.row() for index in self.table.selectedIndexes()})
        items = [self.table.item(row, 0) for row in rows]
        return tuple(item.data(Qt.ItemDataRole.UserRole) for item in items if item is not None)

    def _save(self) -> None:
        for folder in self.marked()[:1]:
            ask_to_save_data(self._booth, folder, self)
