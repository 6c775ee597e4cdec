"""The day's statistics in one or two sentences, computed in a background thread; and all of them as a table."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from cloner.booth.events import trash
from cloner.booth.events.day import Day, days_csv, statistics_by_day
from cloner.booth.photos.check_cache import read_checks
from cloner.booth.visitors.visits import Visit, read_visit
from cloner.errors import ClonerError
from cloner.project.atomic import write_text
from cloner_gui.background.newest import shared_latest
from cloner_gui.event.booth import Booth
from cloner_gui.language.told import translated
from cloner_gui.language.words import TROUBLES, translate


class DayLabel(QObject):
    """The statistics of the event's last day in the gallery.

    Parameters
    ----------
    booth : Booth
    """

    changed = Signal()

    def __init__(self, booth: Booth, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.days: tuple[Day, ...] = ()

    def refresh(self) -> None:
        """Work the numbers out anew, soon."""
        work = functools.partial(_counted, dict(self._booth.visits()), self._booth.root)
        shared_latest().ask(self, "numbers", work, self._take, self._booth.failed.emit)

    def _take(self, found: tuple[Day, ...]) -> None:
        self.days = found
        self.changed.emit()

    def save(self, parent: QWidget) -> None:
        """Ask for a file and write all days into it."""
        text = translate("statistics", "Save as")
        target, _ = QFileDialog.getSaveFileName(parent, text, "numbers.csv", "CSV (*.csv)")
        if target:
            try:
                write_text(Path(target), days_csv(self.days))
            except ClonerError as error:
                self._booth.failed.emit(error)

    def told(self) -> str:
        """Return the last day's numbers in the window's language."""
        if not self.days:
            return ""
        day = self.days[0]
        parts = [
            translate("day", "{day}: {n} visitors, {m} clones.").format(day=day.date, n=day.visitors, m=day.clones)
        ]
        if day.trashed:
            parts.append(translate("day", "{n} of them lie in the trash.").format(n=day.trashed))
        if day.waited_min:
            waits = translate("day", "In the queue {m} minutes in the middle, {l} at most.")
            parts.append(waits.format(m=f"{day.median_min:.1f}", l=f"{day.longest_min:.1f}"))
        reasons = [f"{count} × {TROUBLES[trouble].partition(':')[0]}" for trouble, count in day.photos.items()]
        reasons += [f"{count} × {translated(reason)}" for reason, count in day.failures.items()]
        if reasons:
            parts.append(translate("day", "Refused: {reasons}.").format(reasons="; ".join(reasons)))
        return " ".join(parts)


def _counted(visits: Mapping[Path, Visit], root: Path | None) -> tuple[Day, ...]:
    """Return the days' numbers of everybody who came, those in the trash too: what was refused then counts as well.

    Who was thrown away since the visits were listed counts once.
    """
    thrown = () if root is None else trash.trashed_visitors(root)
    names = {folder.name for folder in thrown}
    stayed = {folder: visit for folder, visit in visits.items() if folder.name not in names or folder.is_dir()}
    return statistics_by_day({**stayed, **{folder: read_visit(folder) for folder in thrown}}, read_checks)
