"""The event that is open: its visitors and settings; everything is saved as it happens."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

from PySide6.QtCore import QObject, QTimer, Signal

from cloner.booth import keeping, line
from cloner.booth.event import Event, check_event_folder, is_visitor, new_visitor, read_event, visits, write_event
from cloner.booth.opened import Opened
from cloner.booth.person_file import consent_given, person_facts, write_person
from cloner.booth.visits import KnownVisits, Visit, read_visit
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.holdings import Holding
from cloner_gui.clone_queue import now_text, update_visit
from cloner_gui.intake import Intake
from cloner_gui.session import Session
from cloner_gui.worker import Task, stop_all_tasks

#: How often the operator's effort is written down, milliseconds.
EFFORT_MS: Final = 5000


class Booth(QObject):
    """The event and who of it is open; pages tell it what the operator did.

    Parameters
    ----------
    session : Session
        The open visitor.
    """

    event_changed = Signal()
    visits_changed = Signal()
    page_wanted = Signal(str)
    leaving = Signal()
    failed = Signal(object)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.intake = Intake(session, self)
        self.root: Path | None = None
        self.settings = Event()
        self.clicks = 0
        self._known = KnownVisits()
        self._opening: Task | None = None
        self._since = time.monotonic()
        self._counted = 0
        effort = QTimer(self, interval=EFFORT_MS)
        effort.timeout.connect(self.note_effort)
        effort.start()
        self.intake.failed.connect(self.failed)
        session.failed.connect(self.failed)
        session.queue.changed.connect(self.visits_changed)
        session.queue.failed.connect(self._tell_failed)

    # --- the event ----------------------------------------------------------

    def open(self, folder: Path) -> None:
        """Open an event's folder, or one visitor's."""
        try:
            if is_visitor(folder):
                self.root, self.settings = None, Event()
            else:
                check_event_folder(folder)
                self.root, self.settings = folder, read_event(folder)
        except (ClonerError, OSError) as error:
            self.failed.emit(error)
            return
        self.event_changed.emit()
        self._follow_settings()
        if self.root is None:
            self.open_visitor(folder)
            return
        known = self.visits()
        self.session.queue.resume(line.waiting(known))
        self.visits_changed.emit()
        last = folder / self.settings.open
        if self.settings.open and last in known:
            self.open_visitor(last)
        else:
            self.session.leave()

    def visits(self) -> Mapping[Path, Visit]:
        """Return how far every visitor has come."""
        if self.root is not None:
            return visits(self.root, self._known.read)
        folder = self.session.folder
        return {} if folder is None else {folder: read_visit(folder)}

    def change(self, **settings: Any) -> None:
        """Change settings of the event and save them."""
        event = replace(self.settings, **settings)
        if event != self.settings:
            self.settings = event
            self._guard(lambda: None if self.root is None else write_event(self.root, event))
            self.event_changed.emit()
            self._follow_settings()

    def _follow_settings(self) -> None:
        self.session.queue.formats = self.settings.formats
        self.session.queue.usual_s = line.usual_seconds(self.visits())
        camera = Path(self.settings.camera_folder) if self.settings.camera_folder else None
        if camera != self.intake.camera_folder:
            self.intake.watch(camera)

    # --- visitors -----------------------------------------------------------

    def new_visitor(self) -> None:
        """Begin with the next visitor."""
        if self.root is not None:
            root = self.root
            made = self._guard(lambda: new_visitor(root, now_text()))
            if made is not None:
                self.open_visitor(made)

    def open_visitor(self, folder: Path) -> None:
        """Read a visitor in the background and go on where the work was left."""
        if self._opening is not None:
            return
        self.leaving.emit()
        self.note_effort()
        services = self.session.services
        self._opening = Task(lambda progress: services.open(folder), self)
        self._opening.succeeded.connect(self._take)
        self._opening.failed.connect(self.failed)
        self._opening.finished.connect(self._opened)
        self._opening.start()

    def _take(self, opened: Opened) -> None:
        self.session.take(opened)
        self._since, self._counted, self.clicks = time.monotonic(), 0, 0
        if self.root is not None:
            self.change(open=opened.folder.name)
        self.visits_changed.emit()
        visit = read_visit(opened.folder)
        seen = visit.page if visit.started else "photos" if opened.photos.photos else "visitor"
        self.page_wanted.emit(seen)
        self.intake.look_again()

    def _opened(self) -> None:
        if self._opening is not None:
            self._opening.deleteLater()
        self._opening = None

    def save_person(self, name: str, height_cm: float | None) -> None:
        """Save name and height of the open visitor."""
        consent = self.session.consent
        self._save(name, height_cm, consent)

    def agree(self, text: str, language: str) -> None:
        """Record that the open visitor agrees to a text, now."""
        self._save(*self.person()[:2], consent_given(text, datetime.now(UTC), language))

    def withdraw_consent(self) -> None:
        """Record that the open visitor agrees no more; what is stored already is deleted on the last page."""
        self._save(*self.person()[:2], "")

    def person(self) -> tuple[str, float | None, str]:
        """Return name, height and consent of the open visitor."""
        folder = self.session.folder
        return ("", None, "") if folder is None else self._guard(lambda: person_facts(folder)) or ("", None, "")

    def _save(self, name: str, height_cm: float | None, consent: str) -> None:
        folder = self.session.folder
        if folder is not None and (name, height_cm, consent) != self.person():
            self._guard(lambda: write_person(folder, name=name, height_cm=height_cm, consent=consent))
            self.session.height_cm, self.session.consent = height_cm, self.person()[2]
            self.visits_changed.emit()

    def note_page(self, page: str) -> None:
        """Remember the page that the open visitor's work is at."""
        folder = self.session.folder
        if folder is not None and read_visit(folder).page != page:
            started = now_text()
            self._guard(lambda: update_visit(folder, lambda v: replace(v, page=page, started=v.started or started)))

    def note_view(self, view: ViewId | None) -> None:
        """Remember the photo whose points are seen."""
        folder = self.session.folder
        if folder is not None and view is not None and read_visit(folder).view != view:
            self._guard(lambda: update_visit(folder, lambda visit: replace(visit, view=str(view))))

    def last_view(self) -> ViewId | None:
        """Return the photo whose points were seen last, if it is still there."""
        folder = self.session.folder
        seen = "" if folder is None else read_visit(folder).view
        return next((view for view in self.session.photos.photos if view == seen), None)

    def note_effort(self) -> None:
        """Add seconds, clicks and drags since the last time to the open visitor's."""
        folder, drags = self.session.folder, self.session.drags
        spent, self._since = time.monotonic() - self._since, time.monotonic()
        clicks, self.clicks = self.clicks, 0
        if folder is None or not (clicks or drags > self._counted):
            return
        more, self._counted = drags - self._counted, drags
        self._guard(lambda: update_visit(folder, lambda v: line.with_effort(v, spent, clicks, max(more, 0))))

    # --- what is held ---------------------------------------------------------

    def held(self) -> tuple[Holding, ...]:
        """Return what is held of everybody."""
        return () if self.root is None else keeping.held(self.root)

    def overdue(self) -> tuple[Holding, ...]:
        """Return whose time is over."""
        if self.root is None:
            return ()
        return keeping.overdue(self.root, self.settings.retention_days, datetime.now(UTC))

    def forget(self, folder: Path) -> tuple[str, ...]:
        """Delete a visitor with everything derived; return the files that still speak of it."""
        self.session.queue.withdraw(folder)
        self.session.queue.wait_for(folder)
        self.intake.drop(folder)
        if folder == self.session.folder:
            self.session.leave()
            self.change(open="")
        left = self._guard(lambda: keeping.forget_visitor(folder, self.root)) or ()
        self.visits_changed.emit()
        if self.session.folder is None:
            self.page_wanted.emit("visitor")
        return left

    def close(self) -> None:
        """Save and stop everything; call before the window goes."""
        self.note_effort()
        if self._opening is not None:
            self._opening.wait()
        self.intake.close()
        self.session.close()
        stop_all_tasks()

    def _tell_failed(self, folder: Path, error: ClonerError) -> None:
        """Tell of a clone that failed while another visitor is open."""
        if folder != self.session.folder:
            self.failed.emit(ClonerError(error.message, error.hint, f"{folder.name}, {error.where}"))

    def _guard(self, work: Any) -> Any:
        """Do something that may fail, and tell it if it does."""
        try:
            return work()
        except ClonerError as error:
            self.failed.emit(error)
            return None
