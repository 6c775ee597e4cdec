"""The open visitor: photos, points and corrections, the clone, and running work."""

from __future__ import annotations

import functools
import logging
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from cloner.booth.body_preview import Shape
from cloner.booth.opened import Cloned, Opened, TrayPhoto
from cloner.booth.photos.photo_problems import PhotoCheck
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.corrections import move_point, no_corrections, remove_point
from cloner.project.folder import write_corrections
from cloner.records.clones import Clone, Joined
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import Corrections, ViewPoints
from cloner_gui.background.newest import shared_latest
from cloner_gui.background.worker import Task
from cloner_gui.event.clone_queue import CloneQueue
from cloner_gui.event.commands import Swap
from cloner_gui.event.services import ProposedPoints, Services, points_by_view, refitted_clone
from cloner_gui.language.point_names import point_label
from cloner_gui.language.words import translate

if TYPE_CHECKING:
    from cloner.interactive.refitting import RefittedBody

log = logging.getLogger(__name__)


class Session(QObject):
    """The open visitor; pages listen to its signals and call its methods.

    Parameters
    ----------
    services : Services
        Reading, proposing, cloning.
    """

    opened = Signal()
    points_changed = Signal()
    busy_changed = Signal()
    progressed = Signal(str, float)
    cloned = Signal()
    refitted = Signal()
    grown = Signal()
    failed = Signal(object)

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.services = services
        self.queue = CloneQueue(services, self)
        self.folder: Path | None = None
        self.photos = PhotoSet({})
        self.person: Person | None = None
        self.height_cm: float | None = None
        self.consent = ""
        self.tray: tuple[TrayPhoto, ...] = ()
        self.checks: dict[str, PhotoCheck] = {}
        self.thumbnails: Mapping[ViewId, NDArray[np.uint8]] = {}
        self.corrections = no_corrections()
        self.proposed: ProposedPoints = {}
        self.outcome: Cloned | None = None
        self.moved: RefittedBody | None = None
        self._moved_clone: Clone | None = None
        self.warnings: tuple[str, ...] = ()
        self.undo_stack = QUndoStack(self)
        self.drags = 0
        self._task: Task | None = None
        self._left: list[Task] = []
        self.queue.finished.connect(self._take_finished)
        self.queue.failed.connect(self._tell_failed)
        self.queue.progressed.connect(self._tell_progress)
        self.queue.changed.connect(self.busy_changed)
        self.queue.grown.connect(lambda folder: self.grown.emit() if folder == self.folder else None)

    # --- the folder -------------------------------------------------------

    def open(self, folder: Path) -> None:
        """Read a visitor's folder and show it; an unusable one leaves the old one open."""
        try:
            opened = self.services.open(folder)
        except ClonerError as error:
            self.failed.emit(error)
            return
        self.take(opened)

    def take(self, opened: Opened) -> None:
        """Show a visitor who was read already; findings of the previous one are forgotten."""
        self._stop()
        same = opened.folder == self.folder
        self.folder, self.photos, self.person = opened.folder, opened.photos, opened.person
        self.corrections, self.warnings = opened.corrections, opened.warnings
        self.height_cm, self.consent = opened.height_cm, opened.consent
        self.tray, self.checks, self.thumbnails = opened.tray, dict(opened.checks), opened.thumbnails
        self.proposed = points_by_view(opened.proposed, opened.photos)
        self.outcome, self.moved = opened.cloned, None
        self.drags = self.drags if same else 0
        shared_latest().drop(self, "refit")
        self.undo_stack.clear()
        self.opened.emit()
        if self.outcome is not None and any(self.corrections.points.values()):
            self.refit()

    def leave(self) -> None:
        """Close the visitor: nobody is open."""
        self._stop()
        self.folder, self.photos, self.person, self.consent = None, PhotoSet({}), None, ""
        self.tray, self.checks, self.thumbnails = (), {}, {}
        self.height_cm, self.corrections, self.warnings = None, no_corrections(), ()
        self.proposed, self.outcome, self.moved, self.drags = {}, None, None, 0
        shared_latest().drop(self, "refit")
        self.undo_stack.clear()
        self.opened.emit()

    # --- points and corrections ----------------------------------------------

    def points(self, view: ViewId) -> ViewPoints | None:
        """Return the points of a view, corrections on top; None until they are proposed."""
        proposed = self.proposed.get(view)
        if proposed is None:
            return None
        from cloner.stages.points import apply_corrections  # with the fit's own libraries: not paid for at the start

        return apply_corrections(proposed, self.corrections.points.get(view, {}), self.photos.photos[view])

    def place_point(self, view: ViewId, name: str, x_px: float, y_px: float, gesture: str = "") -> None:
        """Correct one point; positions off the photo are clamped to it."""
        photo = self.photos.photos[view]
        x_px, y_px = min(max(x_px, 0.0), photo.width_px - 1.0), min(max(y_px, 0.0), photo.height_px - 1.0)
        after = move_point(self.corrections, view, name, x_px, y_px, photo.digest)
        self._push(after, translate("points", "moving %1").replace("%1", point_label(name)), gesture)

    def reset_point(self, view: ViewId, name: str) -> None:
        """Remove one correction, so that the proposal counts again."""
        if name in self.corrections.points.get(view, {}):
            self._push(
                remove_point(self.corrections, view, name),
                translate("points", "resetting %1").replace("%1", point_label(name)),
                "",
            )

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
        self.refit()

    def refit(self) -> None:
        """Move the body of the last clone to the corrections; if that fails the last one stays."""
        outcome = self.outcome
        if outcome is None or "joined" not in outcome.values:
            return
        work = functools.partial(refitted_clone, self.services.refit, outcome.values, self.corrections)
        shared_latest().ask(self, "refit", work, functools.partial(self._take_refit, outcome), self.failed.emit)

    def _take_refit(self, outcome: Cloned, found: tuple[RefittedBody, Clone]) -> None:
        if outcome is self.outcome:
            self.moved, self._moved_clone = found
            self.refitted.emit()

    def person_now(self) -> Joined | None:
        """Return the body of the last clone, moved points included; None before there is one."""
        if self.moved is not None:
            return self.moved.person
        return None if self.outcome is None else self.outcome.values.get("obeyed")

    def clone_now(self) -> Clone | None:
        """Return the clone with moved points included, None before there is one."""
        if self.outcome is None or self.moved is None:
            return None if self.outcome is None else self.outcome.values["clone"]
        return self._moved_clone

    def shape_now(self) -> Shape | None:
        """Return the present body of the running clone; None if none runs for this visitor."""
        return None if self.folder is None else self.queue.shape(self.folder)

    # --- long work -----------------------------------------------------------------

    @property
    def busy(self) -> bool:
        """Whether work for this visitor runs or waits."""
        return self.seeking or self.cloning

    @property
    def seeking(self) -> bool:
        """Whether points are being searched in the photos."""
        return self._task is not None

    @property
    def cloning(self) -> bool:
        """Whether the visitor is being cloned or waits for it."""
        return self.queue.holds(self.folder)

    def is_stale(self) -> bool:
        """Return whether points or height were changed since the clone was made."""
        outcome = self.outcome
        return outcome is not None and not (outcome.obeys(self.corrections) and outcome.has_height_of(self.height_cm))

    def propose(self) -> None:
        """Find the points of all photos in the background."""
        folder, photos = self.folder, self.photos
        if self.busy or self.proposed or folder is None or not photos.photos:
            return
        task = Task(lambda progress: self.services.propose(folder, photos, progress))
        self._task = task
        task.progressed.connect(self._tell_step)
        task.succeeded.connect(self._take_proposed)
        task.failed.connect(self._tell_failed_task)
        task.finished.connect(self._done)
        self.busy_changed.emit()
        task.start()

    def clone(self) -> None:
        """Clone the person in the background, after those who wait already; the search for points goes on."""
        if not self.cloning and self.folder is not None:
            log.info("%s: cloning after %d drags", self.folder.name, self.drags)
            self.queue.ask(self.folder)

    def cancel(self) -> None:
        """Stop the work for this visitor at once."""
        if self.folder is not None and self.cloning:
            self.queue.withdraw(self.folder)
        elif self._task is not None:
            self._task.cancel()

    def close(self) -> None:
        """Stop all work and wait for it; call before the window goes."""
        self._stop()
        for task in self._left:
            task.cancel()
            task.wait()
        self.queue.close()
        self.services.stop()

    def _stop(self) -> None:
        """Wait no more for the work for this visitor: what it finds lies in the visitor's folder."""
        if self._task is not None:
            self._left.append(self._task)
            self._task = None

    def _take_proposed(self, proposed: ProposedPoints) -> None:
        if self.sender() is self._task:
            self.proposed = proposed
            self.points_changed.emit()

    def _tell_failed_task(self, error: ClonerError) -> None:
        if self.sender() is self._task:
            self.failed.emit(error)

    def _tell_step(self, step: str, fraction: float) -> None:
        if self.sender() is self._task:
            self.progressed.emit(step, fraction)

    def _take_finished(self, folder: Path, outcome: Cloned) -> None:
        if folder == self.folder:
            self._take_clone(outcome)

    def _take_clone(self, outcome: Cloned) -> None:
        self.outcome, self.moved = outcome, None
        self.cloned.emit()

    def _tell_failed(self, folder: Path, error: ClonerError) -> None:
        if folder == self.folder:
            self.failed.emit(error)

    def _tell_progress(self, folder: Path, step: str, fraction: float) -> None:
        if folder == self.folder:
            self.progressed.emit(step, fraction)

    def _done(self) -> None:
        task = self.sender()
        if isinstance(task, Task):
            self._left = [one for one in self._left if one is not task]
            self._task = None if task is self._task else self._task
        self.busy_changed.emit()
