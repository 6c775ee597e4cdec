"""The open event: its visitors and settings; everything is saved as it happens."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from cloner.booth.events.agreed import agreed_terms
from cloner.booth.events.event import (
    Event,
    check_can_write,
    check_event_folder,
    is_visitor,
    new_visitor,
    open_event,
    visits,
    write_event,
)
from cloner.booth.opened import Opened
from cloner.booth.photos import arrivals
from cloner.booth.visitors import waiting_line
from cloner.booth.visitors.person_file import is_untouched
from cloner.booth.visitors.visits import KnownVisits, Visit, read_visit
from cloner.errors import ClonerError
from cloner_gui.background.worker import Task, stop_all_tasks
from cloner_gui.event.clone_queue import now_text
from cloner_gui.event.everybody import Everybody
from cloner_gui.event.leaving import settle
from cloner_gui.event.session import Session
from cloner_gui.language.told import translated, translated_where
from cloner_gui.language.words import translate


class Booth(Everybody):
    """The event and its open visitor; pages report the operator's actions to it.

    Parameters
    ----------
    session : Session
        The open visitor.
    """

    event_changed = Signal()
    leaving = Signal()
    opening_changed = Signal()

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(session, parent)
        self.allowed: Callable[[], bool] = lambda: True  # what is the operator's asks here; see `cloner_gui.kiosk`
        self._known = KnownVisits()
        self._opening: Task | None = None
        self.opening: Path | None = None
        self.intake.failed.connect(self.failed)
        self.intake.arrivals_stored.connect(self._note_arrivals)
        session.failed.connect(self.failed)
        session.queue.changed.connect(self.tell_change)
        session.queue.failed.connect(self._tell_failed)
        session.queue.finished.connect(self._tell_ready)

    # --- the event ----------------------------------------------------------

    def open(self, folder: Path) -> None:
        """Open an event's folder, or one visitor's."""
        try:
            message = ""
            if is_visitor(folder):
                check_can_write(folder)
                self.root, self.settings = None, Event()
            else:
                check_event_folder(folder)
                settings, message = open_event(folder)
                self.root, self.settings = folder, settings
        except (ClonerError, OSError) as error:
            self.failed.emit(error)
            return
        self.event_changed.emit()
        self._follow_settings()
        if message:
            self.told.emit(translated(message))
        if self.root is None:
            self.open_visitor(folder)
            return
        known = self.visits()
        self.session.queue.resume(waiting_line.waiting(known))
        self.tell_change()
        last = folder / self.settings.open
        if self.settings.open and last in known:
            self.open_visitor(last)
        else:
            self.session.leave()

    def visits(self) -> Mapping[Path, Visit]:
        """Return how far every visitor has come; nobody where the event's folder went, as with a stick."""
        if self.root is not None:
            return visits(self.root, self._known.read) if self.root.is_dir() else {}
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
        self.session.queue.clone_at_once(self.settings.at_once)
        self.session.queue.usual_s = waiting_line.typical_seconds(self.visits())
        camera = Path(self.settings.camera_folder) if self.settings.camera_folder else None
        if camera != self.intake.camera_folder:
            root = self.root
            self.intake.watch(camera, None if root is None or camera is None else arrivals.read_note(root, camera))

    def _note_arrivals(self, known: Mapping[Path, int]) -> None:
        """Note which of the camera's photos are stored: those that come while this program crashes are taken later."""
        root, camera = self.root, self.intake.camera_folder
        if root is not None and camera is not None:
            self._guard(lambda: arrivals.write_note(root, camera, known))

    def terms(self, language: str, licence: str = "") -> Mapping[str, str]:
        """Return the event's title, and the licence that was chosen, or that the event's own text speaks of."""
        return {} if self.root is None else agreed_terms(self.settings, self.root, language, licence)

    # --- visitors -----------------------------------------------------------

    def new_visitor(self) -> None:
        """Begin with the next visitor; one of whom nothing is known yet is the next one already."""
        root = self.root
        if root is None or self._opening is not None:
            return
        self.leaving.emit()
        folder = self.session.folder
        if folder is not None and folder.parent == root and is_untouched(folder):
            self.page_wanted.emit("visitor")
            return
        made = self._guard(lambda: new_visitor(root, now_text()))
        if made is not None:
            self.open_visitor(made)

    def open_visitor(self, folder: Path) -> None:
        """Read a visitor in the background and go on where the work was left."""
        if self._opening is not None:
            return
        self.leaving.emit()
        self.note_effort()
        settle(self)
        services = self.session.services
        self.opening = folder
        self._opening = Task(lambda progress: services.open(folder))
        self._opening.succeeded.connect(self._take)
        self._opening.failed.connect(self._opened)
        self._opening.failed.connect(self.failed)
        self._opening.start()
        self.opening_changed.emit()

    def _take(self, opened: Opened) -> None:
        self._opened()  # what is told below may be answered by opening somebody else
        self.session.take(opened)
        self.begin_effort()
        if self.root is not None:
            self.change(open=opened.folder.name)
        self.tell_change()
        visit = read_visit(opened.folder)
        seen = visit.page if visit.started else "photos" if opened.photos.photos else "visitor"
        self.page_wanted.emit(seen)
        self.intake.look_again()

    def _opened(self) -> None:
        self._opening, self.opening = None, None
        self.opening_changed.emit()

    def close(self) -> None:
        """Save and stop everything; call before the window goes."""
        self.note_effort()
        if self.root is not None and self.intake.camera_folder is not None:
            arrivals.drop_note(self.root)  # closed as it should be: what comes meanwhile is somebody else's
        if self._opening is not None:
            self._opening.wait()
        self.intake.close()
        self.session.close()
        stop_all_tasks()

    def _tell_failed(self, folder: Path, error: ClonerError) -> None:
        """Tell of a clone that failed while another visitor is open."""
        if folder != self.session.folder:
            self.failed.emit(
                ClonerError(error.message, error.hint, f"{self.name_of(folder)}, {translated_where(error.where)}")
            )

    def _tell_ready(self, folder: Path) -> None:
        """Tell of a clone that is ready while another visitor is open; the open one's is seen."""
        if folder != self.session.folder:
            self.told.emit(translate("window", "{name}: the clone is ready.").format(name=self.name_of(folder)))
