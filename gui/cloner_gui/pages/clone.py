"""Fourth page: clone, and view the result."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QLabel, QProgressBar, QVBoxLayout, QWidget

from cloner.booth.visitors.versions import has_previous
from cloner.booth.visitors.visits import read_visit
from cloner.errors import ClonerError
from cloner.interactive.outline_gaps import outline_gaps_mm
from cloner_gui.background.worker import Task
from cloner_gui.canvas.clones.growth import Growth
from cloner_gui.canvas.clones.preview_panel import PreviewPanel
from cloner_gui.canvas.clones.reveal import Reveal
from cloner_gui.event.booth import Booth
from cloner_gui.event.leaving import has_front
from cloner_gui.language.told import stale_text, translated, translated_problem
from cloner_gui.language.words import step_text, translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.pieces import button, label, make_scrollable

#: Stages that the five parts of the work end with, in order; between them the operator sees which part is under way.
PARTS = ("points", "fine", "join", "hair", "report")


class ClonePage(QWidget):
    """Start the clone, watch it grow, turn it."""

    changed = Signal()

    def __init__(self, booth: Booth, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth, self._session = booth, booth.session
        self.clone_button, self.cancel_button, self.reveal_button = button(), button(), button()
        self.before_button = button()
        self.stale = label("warn")
        self.progress = QProgressBar()
        self.progress.setRange(0, 1000)
        self.status, self.warnings = label(wraps=False), label("dim")
        self.parts = [QLabel() for _ in PARTS]
        self.panel = PreviewPanel()
        self.preview = self.panel.preview
        self.reveal = Reveal(self.preview, self)
        self.growth = Growth(self)
        self._done_parts = 0
        self._measuring: Task | None = None
        self._lay_out()
        self._speak()
        self._connect()
        self._show()

    def why_not(self) -> str:
        """Return why the next page cannot come yet."""
        if self._session.outcome is not None:
            return ""
        waits = translate("clone", "The clone is being made; the next visitor can come.")
        return waits if self._session.cloning else translate("clone", "Clone first.")

    def _lay_out(self) -> None:
        top, parts, inside = Flow(), Flow(), QWidget()
        for widget in (self.clone_button, self.cancel_button, self.reveal_button, self.before_button, self.progress):
            top.addWidget(widget)
        top.addWidget(self.status)
        for part in self.parts:
            parts.addWidget(part)
        column = QVBoxLayout(inside)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(top)
        column.addLayout(parts)
        column.addWidget(self.stale)
        column.addWidget(self.panel, 1)
        column.addWidget(self.warnings)
        make_scrollable(self, inside)

    def _connect(self) -> None:
        session = self._session
        self.clone_button.clicked.connect(lambda: session.clone())
        self.cancel_button.clicked.connect(session.cancel)
        self.before_button.clicked.connect(self._bring_before)
        self.preview.failed.connect(session.failed)
        self.panel.gaps_wanted.connect(self._measure_gaps)
        session.opened.connect(self._show)
        session.cloned.connect(self._show)
        session.cloned.connect(self._begin_reveal)
        session.points_changed.connect(self._show_stale)
        self._booth.visits_changed.connect(self._show_stale)
        self._booth.event_changed.connect(self._calm_down)
        self.reveal_button.clicked.connect(self.reveal.begin)
        self.panel.used.connect(self.reveal.stop)
        session.refitted.connect(self._show_refit)
        session.grown.connect(self._show_growth)
        self.growth.shown.connect(self.panel.show_growing)
        session.busy_changed.connect(self._show_busy)
        session.progressed.connect(self._show_progress)

    def _speak(self) -> None:
        """Put all words into the window's language."""
        self.reveal_button.setText(translate("clone", "Sho&w it off"))
        self.cancel_button.setText(translate("clone", "Ca&ncel"))
        self.before_button.setText(translate("clone", "The clone be&fore"))
        self._names = (
            translate("clone", "Points"),
            translate("clone", "Body"),
            translate("clone", "Head"),
            translate("clone", "Hair"),
            translate("clone", "Texture and files"),
        )
        self.preview.say_when_empty(translate("clone", "Press Clone: after about a minute the person stands here."))
        self._show_warnings()
        self._show_parts()
        self._show_stale()

    def _show(self) -> None:
        """Show the finished clone, or an empty place for it."""
        session = self._session
        self.growth.forget()
        self.reveal.stop()
        self.panel.set_clone(session.clone_now(), session.photos.photos)
        self.status.setText("")
        self._show_busy()
        self._show_growth()
        self.changed.emit()

    def _show_growth(self) -> None:
        """Show the body as far as it has come, while somebody looks."""
        shape = self._session.shape_now()
        if shape is not None and self.isVisible():
            self.growth.take(shape)

    def showEvent(self, event: QShowEvent) -> None:
        """Show what has grown while nobody looked."""
        super().showEvent(event)
        self._show_growth()

    def _show_refit(self) -> None:
        if self.growth.active:
            return  # the clone under way obeys the corrections itself
        self.preview.update_clone(self._session.clone_now())
        if self.preview.mode == "gaps" and self.isVisible():
            self._measure_gaps()

    def _show_busy(self) -> None:
        busy = self._session.cloning
        self.clone_button.setVisible(not busy)
        self.clone_button.setEnabled(not busy and has_front(self._session))
        self.reveal_button.setVisible(not busy and self._session.outcome is not None)
        folder = self._session.folder
        self.before_button.setVisible(not busy and folder is not None and has_previous(folder))
        self.cancel_button.setVisible(busy)
        self._show_stale()
        self.cancel_button.setEnabled(busy)
        self.progress.setVisible(busy)
        if busy:
            self.progress.setValue(0)  # the bar still shows the work before this one
        else:
            self._end_growth()
        self._show_warnings()
        self._done_parts = 0 if busy or self._session.outcome is None else len(PARTS)
        self._show_parts()

    def _bring_before(self) -> None:
        if self._session.folder is not None:
            self._booth.bring_clone_before(self._session.folder)

    def _show_warnings(self) -> None:
        """Say what the clone lacks, or why there is none."""
        outcome, folder = self._session.outcome, self._session.folder
        said = [] if outcome is None else [translated(text) for text in outcome.warnings]
        if folder is not None and not self._session.cloning:
            said.insert(0, translated_problem(read_visit(folder).problem))
        self.warnings.setText("\n".join(f"• {text}" for text in said if text))
        self.warnings.setVisible(bool(self.warnings.text()))

    def _show_stale(self) -> None:
        """Say that the clone is not of the points and the height as they are now."""
        stale = self._session.is_stale() and not self._session.cloning
        self.stale.setText(stale_text() if stale else "")
        self.stale.setVisible(stale)
        again = self._session.outcome is not None
        self.clone_button.setText(translate("clone", "C&lone again") if again else translate("clone", "C&lone"))

    def _calm_down(self) -> None:
        """Let nothing move by itself any more where that is wanted."""
        if self._booth.settings.calm:
            self.reveal.rest()

    def _begin_reveal(self) -> None:
        """Let a new clone show itself, where somebody looks and nobody wants the screen to be still."""
        if self.isVisible() and not self._booth.settings.calm:
            self.reveal.begin()

    def _end_growth(self) -> None:
        """Show the clone there was before, if the one under way was stopped."""
        if self._session.outcome is None:
            self.status.setText("")
        if self.growth.active:
            self.growth.forget()
            self.panel.set_clone(self._session.clone_now(), self._session.photos.photos)

    def _show_progress(self, step: str, fraction: float) -> None:
        if not self._session.cloning:
            return  # points are sought: that is told where they are seen
        self.progress.setValue(round(1000 * fraction))
        self.status.setText(step_text(step))
        if step in PARTS:
            self._done_parts = max(self._done_parts, PARTS.index(step))
        self._show_parts()

    def _show_parts(self) -> None:
        """Show which parts of the work are done and which is under way."""
        busy = self._session.cloning
        for number, (part, text) in enumerate(zip(self.parts, self._names, strict=True)):
            mark = "✓" if number < self._done_parts else "▸" if busy and number == self._done_parts else "·"
            part.setText(f"{mark} {text}")

    def _measure_gaps(self) -> None:
        """Find how far the clone keeps from the photos' outlines, beside the window's own work."""
        outcome, person = self._session.outcome, self._session.person_now()
        if outcome is None or person is None or "obeyed_silhouettes" not in outcome.values:
            return
        if self._measuring is not None:
            return
        outlines = outcome.values["obeyed_silhouettes"].views
        task = Task(lambda _: outline_gaps_mm(person.vertices_m, person.joints_m, person.views, outlines))
        self._measuring = task
        task.succeeded.connect(self._take_gaps)
        task.failed.connect(self._tell_failed)
        task.start()

    def _take_gaps(self, gaps_mm: NDArray[np.float64]) -> None:
        self._measuring = None
        self.preview.set_gaps(gaps_mm)

    def _tell_failed(self, error: ClonerError) -> None:
        self._measuring = None
        self._session.failed.emit(error)

    def changeEvent(self, event: QEvent) -> None:
        """Speak another language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._speak()
