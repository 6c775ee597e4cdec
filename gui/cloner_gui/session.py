"""What the window knows: the open folder, its points and corrections, and the work under way."""

from __future__ import annotations

import logging
import time
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QUndoStack

from cloner.cloning import CloneOutcome
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.corrections import check_against, move_point, no_corrections, remove_point
from cloner.project.folder import load_photos, read_corrections, read_person, write_corrections
from cloner.records.clones import Clone
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import Corrections, ViewPoints
from cloner.refitting import Refitted, clone_after, outline_px
from cloner.stages.points import corrected
from cloner_gui.commands import Swap
from cloner_gui.services import Proposed, ProposedPoints, Services
from cloner_gui.words import spoken
from cloner_gui.worker import Task

log = logging.getLogger(__name__)

RESULTS = "clones"
#: A drag that rests so long is shown on the clone, milliseconds (taste: no work while the hand moves).
REFIT_AFTER_MS = 60


class Session(QObject):
    """The open folder; pages listen to its signals and call its methods.

    Parameters
    ----------
    services : Services
        Proposing and cloning.
    """

    opened = Signal()
    points_changed = Signal()
    busy_changed = Signal()
    progressed = Signal(str, float)
    cloned = Signal()
    refitted = Signal()
    failed = Signal(object)

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.services = services
        self.folder: Path | None = None
        self.photos = PhotoSet({})
        self.person: Person | None = None
        self.height_cm: float | None = None
        self.corrections = no_corrections()
        self.proposed: ProposedPoints = {}
        self.known: Mapping[str, object] = {}
        self.outcome: CloneOutcome | None = None
        self.moved: Refitted | None = None
        self.warnings: tuple[str, ...] = ()
        self.undo_stack = QUndoStack(self)
        self.drags = 0
        self._since = time.monotonic()
        self._task: Task | None = None
        self._refit = QTimer(self, singleShot=True, interval=REFIT_AFTER_MS)
        self._refit.timeout.connect(self.refit)

    # --- the folder -------------------------------------------------------

    def open(self, folder: Path) -> None:
        """Read the photos of a folder; a folder that cannot be used leaves the old one open."""
        if self.busy:
            return
        try:
            photos, person, corrections = load_photos(folder), read_person(folder), read_corrections(folder)
            warnings = check_against(corrections, photos)
        except ClonerError as error:
            self.failed.emit(error)
            return
        self.folder, self.photos, self.person = folder, photos, person
        self.corrections, self.warnings = corrections, warnings
        self.height_cm = 100.0 * person.stature_m if person.stature_is_known else None
        self.proposed, self.known, self.outcome, self.drags = {}, {}, None, 0
        self.moved = None
        self._refit.stop()
        self._since = time.monotonic()
        self.undo_stack.clear()
        self.opened.emit()

    # --- points and corrections ----------------------------------------------

    def points(self, view: ViewId) -> ViewPoints | None:
        """Return the points of a view, corrections on top; None until they are proposed."""
        proposed = self.proposed.get(view)
        if proposed is None:
            return None
        return corrected(proposed, self.corrections.points.get(view, {}), self.photos.photos[view])

    def place_point(self, view: ViewId, name: str, x_px: float, y_px: float, gesture: str = "") -> None:
        """Correct one point; places off the photo are pulled back on to it."""
        photo = self.photos.photos[view]
        x_px, y_px = min(max(x_px, 0.0), photo.width_px - 1.0), min(max(y_px, 0.0), photo.height_px - 1.0)
        after = move_point(self.corrections, view, name, x_px, y_px, photo.digest)
        self._push(after, f"moving {spoken(name)}", gesture)

    def reset_point(self, view: ViewId, name: str) -> None:
        """Take one correction back, so that the proposal counts again."""
        if name in self.corrections.points.get(view, {}):
            self._push(remove_point(self.corrections, view, name), f"resetting {spoken(name)}", "")

    def _push(self, after: Corrections, label: str, gesture: str) -> None:
        self.drags += not gesture or gesture != getattr(self, "_gesture", "")
        self._gesture = gesture
        self.undo_stack.push(Swap(self.corrections, after, label, self._adopt, gesture))

    def _adopt(self, corrections: Corrections) -> None:
        """Make corrections count and save them; a folder that cannot be written is told, not fatal."""
        self.corrections = corrections
        if self.folder is not None:
            try:
                write_corrections(self.folder, corrections)
            except ClonerError as error:
                self.failed.emit(error)
        self.points_changed.emit()
        if self.outcome is not None:
            self._refit.start()

    def refit(self) -> None:
        """Move the body of the last clone to the corrections; a body that cannot follow leaves the last one."""
        if self.outcome is None or "joined" not in self.outcome.values:
            return
        try:
            self.moved = self.services.refit(self.outcome.values, self.corrections)
        except ClonerError as error:
            self.failed.emit(error)
            return
        self.refitted.emit()

    def clone_outline(self, view: ViewId) -> tuple[NDArray[np.float64], ...]:
        """Return the borders of the clone's body in a photo, moved points included; none before there is a clone."""
        person = None if self.outcome is None else self.outcome.values.get("obeyed")
        person = person if self.moved is None else self.moved.person
        return () if person is None else outline_px(person, view)

    def clone_now(self) -> Clone | None:
        """Return the clone with moved points included, None before there is one."""
        if self.outcome is None or self.moved is None:
            return None if self.outcome is None else self.outcome.values["clone"]
        return clone_after(self.outcome.values, self.moved.person)

    # --- long work -----------------------------------------------------------------

    @property
    def busy(self) -> bool:
        """Whether work is under way."""
        return self._task is not None

    def propose(self) -> None:
        """Find the points of all photos in the background."""
        photos = self.photos
        if self.busy or self.proposed or not photos.photos:
            return
        self._start(Task(lambda progress: self.services.propose(photos, progress), self), self._take_proposed)

    def clone(self, out_dir: Path | None = None) -> None:
        """Clone the person in the background."""
        folder, height_cm, known = self.folder, self.height_cm, self.known
        if self.busy or folder is None:
            return
        out = out_dir if out_dir is not None else folder / RESULTS
        log.info("cloning after %d drags and %.0f s", self.drags, time.monotonic() - self._since)
        self._start(
            Task(lambda progress: self.services.clone(folder, out, height_cm, known, progress), self), self._take_clone
        )

    def cancel(self) -> None:
        """Ask the work under way to stop."""
        if self._task is not None:
            self._task.cancel()

    def close(self) -> None:
        """Stop the work and wait for it; call before the window goes."""
        task = self._task
        if task is not None:
            task.cancel()
            task.wait()

    def _start(self, task: Task, take: object) -> None:
        self._task = task
        task.progressed.connect(self.progressed)
        task.succeeded.connect(take)
        task.failed.connect(self.failed)
        task.finished.connect(self._done)
        self.busy_changed.emit()
        task.start()

    def _take_proposed(self, proposed: Proposed) -> None:
        self.proposed, self.known = proposed.points, {**self.known, **proposed.known}
        self.points_changed.emit()

    def _take_clone(self, outcome: CloneOutcome) -> None:
        self.outcome, self.known, self.moved = outcome, outcome.values, None
        self.cloned.emit()

    def _done(self) -> None:
        if self._task is not None:
            self._task.deleteLater()
        self._task = None
        self.busy_changed.emit()
