"""What all windows of the studio share: controls beside a picture, one job at a time, and a progress bar."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QDialog, QFileDialog, QHBoxLayout, QLabel, QProgressBar, QVBoxLayout, QWidget

from cloner.errors import ClonerError
from cloner_gui.background.worker import Task
from cloner_gui.event.booth import Booth
from cloner_gui.language.words import step_text, translate
from cloner_gui.widgets.letters import assign_to_dialog, without_mnemonic
from cloner_gui.widgets.notice import Notice
from cloner_gui.widgets.pieces import GAP, Scrolled, button, label, set_accessible_name, set_window_size

#: Width of the controls beside the picture, lines of text; taste.
_CONTROLS_LINES = 19


class Bench(QDialog):
    """A window of the studio; ``controls`` takes its fields, ``stage`` its picture, ``deeds`` its buttons."""

    busy_changed = Signal()

    def __init__(self, booth: Booth, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.booth = booth
        self.setWindowTitle(title)
        set_window_size(self, 1000, 680)
        self.controls, self.stage, self.deeds = QVBoxLayout(), QVBoxLayout(), QHBoxLayout()
        self.status, self.bar, self.cancel_button, self.written = QLabel(), QProgressBar(), button(), label("good")
        self.cancel_button.setText(translate("studio", "Ca&ncel"))
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        set_accessible_name(self.bar, translate("studio", "How far the work is"))
        self._task: Task | None = None
        self._quiet = False
        self._show_work: Callable[[Any], None] = _unseen
        self._closed = False
        self.whole = QWidget()
        self._lay_out()
        self.notice = Notice(self.whole)
        self.cancel_button.clicked.connect(self.cancel)
        self._tell_busy()

    def _lay_out(self) -> None:
        inside, room = QWidget(), Scrolled()
        self.controls.setContentsMargins(0, 0, GAP, 0)
        self.controls.setSpacing(GAP // 2)
        inside.setLayout(self.controls)
        room.setWidget(inside)
        room.setWidgetResizable(True)
        room.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        room.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        room.setFixedWidth(_CONTROLS_LINES * self.fontMetrics().height())
        beside, bottom, column = QHBoxLayout(), QHBoxLayout(), QVBoxLayout(self.whole)
        beside.addWidget(room)
        beside.addLayout(self.stage, 1)
        for widget, stretch in ((self.status, 0), (self.bar, 1), (self.cancel_button, 0), (self.written, 1)):
            bottom.addWidget(widget, stretch)
        bottom.addLayout(self.deeds)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(beside, 1)
        column.addLayout(bottom)
        outer = QVBoxLayout(self)
        outer.addWidget(self.whole)

    # --- work ------------------------------------------------------------------------

    @property
    def busy(self) -> bool:
        """Whether a job is under way."""
        return self._task is not None

    def work(
        self,
        method: str,
        *arguments: object,
        then: Callable[[Any], None],
        shows: Callable[[Any], None] | None = None,
        failed: Callable[[ClonerError], None] | None = None,
        quiet: bool = False,
    ) -> bool:
        """Ask the studio's process for a job; False where one is under way.

        Parameters
        ----------
        method : str
            Of `cloner.booth.studio.jobs.StudioJobs`.
        then, shows : callable
            Called with the job's value, and with what it shows meanwhile.
        failed : callable or None
            Called with what went wrong; None tells it in the bar.
        quiet : bool
            The job is over before anybody would look at its progress.
        """
        if self._task is not None:
            return False
        studio = self.booth.session.services.studio
        task = Task(lambda progress: studio(method, arguments, progress, task.show))
        self._task, self._show_work = task, shows or _unseen
        self._task.shown.connect(self._see)
        self._task.progressed.connect(self._tell)
        self._task.succeeded.connect(functools.partial(self._take, then))
        self._task.failed.connect(failed or self.notice.tell)
        self._task.finished.connect(self._done)
        self._quiet = quiet
        self.bar.setValue(0)
        self.status.setText("")
        self._task.start()
        self._tell_busy()
        return True

    def cancel(self) -> None:
        """Stop the job that is under way, at once."""
        if self._task is not None:
            self._task.cancel()

    def _take(self, then: Callable[[Any], None], value: Any) -> None:
        if not self._closed:
            then(value)

    def _see(self, value: Any) -> None:
        if self._task is not None and not self._closed:
            self._show_work(value)

    def _tell(self, step: str, fraction: float) -> None:
        self.bar.setValue(round(1000 * fraction))
        self.status.setText(step_text(step) if step else "")

    def _done(self) -> None:
        self._task = None
        self._tell_busy()

    def _tell_busy(self) -> None:
        seen = self.busy and not self._quiet
        for one in (self.bar, self.cancel_button, self.status):
            one.setVisible(seen)
        self.written.setVisible(not seen)
        self.busy_changed.emit()

    def tell_written(self, path: Path) -> None:
        """Say where a file or a folder was written."""
        place = f"{path.parent.name}/{path.name}"
        self.written.setText(translate("studio", "Written: {place}").format(place=place))

    def closeEvent(self, event: QCloseEvent) -> None:
        """Stop the work before the window goes."""
        self._closed = True
        if self._task is not None:
            self._task.cancel()
            self._task.wait()
        super().closeEvent(event)

    def settle(self) -> None:
        """Give every control a letter of its own; call when all stand."""
        assign_to_dialog(self)

    # --- pieces ------------------------------------------------------------------------

    def field(self, text: str, widget: QWidget, told: str = "") -> None:
        """Put a field with its label under the others."""
        above = QLabel(text)
        above.setBuddy(widget)
        set_accessible_name(widget, without_mnemonic(text), told)
        self.controls.addWidget(above)
        self.controls.addWidget(widget)


class Subject(QWidget):
    """The edited clone: the open visitor's, or another folder's.

    Parameters
    ----------
    booth : Booth
    """

    changed = Signal()

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self.who, self.other_button = label(), button()
        self.other_button.setText(translate("studio", "&Another clone…"))
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.who)
        column.addWidget(self.other_button)
        self.other_button.clicked.connect(self._choose)
        booth.visits_changed.connect(self._look)
        outcome, folder = booth.session.outcome, booth.session.folder
        self.path: Path | None = None
        self.choose(None if outcome is None else outcome.folder, "" if folder is None else booth.name_of(folder))

    def choose(self, path: Path | None, called: str = "") -> None:
        """Work on the clone of a folder; None on nobody's."""
        self.path = path
        nobody = translate("studio", "No clone is chosen.")
        self.who.setText(nobody if path is None else called or path.name)
        self.changed.emit()

    def _look(self) -> None:
        """Let a clone go that was deleted."""
        if self.path is not None and not self.path.exists():
            self.choose(None)

    def _choose(self) -> None:
        text = translate("studio", "Folder of a clone")
        folder = QFileDialog.getExistingDirectory(self, text)
        if folder:
            self.choose(Path(folder))


def _unseen(_: Any) -> None:
    """See nothing of a job."""
