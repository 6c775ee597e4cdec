"""The operator's window of statistics: the effort per visitor. Never on the visitors' screen by itself."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from cloner.booth.visitors.effort import effort_csv, effort_rows, median_effort
from cloner.booth.visitors.visits import State
from cloner.errors import ClonerError
from cloner.project.atomic import write_text
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import STATES, translate
from cloner_gui.widgets.pieces import label, set_accessible_name, set_window_size, show_whole_columns


class StatisticsWindow(QDialog):
    """Seconds, clicks and drags, one row per visitor."""

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.setWindowTitle(translate("statistics", "Operator's effort"))
        set_window_size(self, 820, 480)
        self.summary = label("heading")
        self.table = QTableWidget(0, 7)
        self.table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.table.verticalHeader().hide()
        show_whole_columns(self.table)
        set_accessible_name(self.table, translate("statistics", "Effort by visitor"))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        save = buttons.addButton(translate("statistics", "&Save as table…"), QDialogButtonBox.ButtonRole.ActionRole)
        save.clicked.connect(self._save)
        buttons.rejected.connect(self.close)
        column = QVBoxLayout(self)
        for one in (self.summary, self.table, buttons):
            column.addWidget(one)
        booth.visits_changed.connect(self.show_all)
        self.show_all()

    def show_all(self) -> None:
        """Fill the table."""
        self._booth.note_effort()
        visits = self._booth.visits()
        seconds, clicks, drags = median_effort(visits)
        told = translate("statistics", "{n} visitors; in the middle {s} s, {c} clicks, {d} drags each")
        self.summary.setText(told.format(n=len(visits), s=round(seconds), c=round(clicks), d=round(drags)))
        self.table.setHorizontalHeaderLabels(_titles())
        rows, folders = effort_rows(visits), list(visits)
        self.table.setRowCount(len(rows))
        for number, row in enumerate(rows):
            shown = (self._booth.name_of(folders[number]), row[1], STATES[State(row[2])], *row[3:])
            for column, text in enumerate(shown):
                self.table.setItem(number, column, QTableWidgetItem(text))

    def _save(self) -> None:
        target, _ = QFileDialog.getSaveFileName(self, translate("statistics", "Save as"), "effort.csv", "CSV (*.csv)")
        if target:
            try:
                write_text(Path(target), effort_csv(self._booth.visits()))
            except ClonerError as error:
                self._booth.failed.emit(error)


def _titles() -> list[str]:
    return [
        translate("statistics", "Visitor"),
        translate("statistics", "Came"),
        translate("statistics", "State"),
        translate("statistics", "Seconds"),
        translate("statistics", "Clicks"),
        translate("statistics", "Drags"),
        translate("statistics", "Clone, s"),
    ]
