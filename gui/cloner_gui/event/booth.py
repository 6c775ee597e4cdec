"""The event that is open: its visitors and settings; everything is saved as it happens."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from cloner.booth.events import keeping, trash
from cloner.booth.events.agreed import agreed_terms
from cloner.booth.events.event import (
    Event,
    check_can_write,
    check_event_folder,
    is_untouched,
    is_visitor,
    new_visitor,
    open_event,
    visits,
    write_event,
)
from cloner.booth.opened import Opened
from cloner.booth.photos import arrivals
from cloner.booth.visitors import line
from cloner.booth.visitors.names import KnownNames, called
from cloner.booth.visitors.visits import KnownVisits, Visit, read_visit
from cloner.errors import ClonerError
from cloner.personal_data.holdings import Holding
from cloner_gui.background.worker import Task, stop_all_tasks
from cloner_gui.event.clone_queue import now_text
from cloner_gui.event.desk import Desk
from cloner_gui.event.intake import Intake
from cloner_gui.event.leaving import settle
from cloner_gui.event.session import Session
from cloner_gui.language.told import told as told_sentence
from cloner_gui.language.told import told_where
from cloner_gui.language.words import translate


class Booth(Desk):
    """The event and who of it is open; pages tell it what the operator did.

    Parameters
    ----------
    session : Session
        The open visitor.
    """

    event_changed = Signal()
    page_wanted = Signal(str)
    leaving = Signal()
    opening_changed = Signal()
    told = Signal(str)
    """Something that the operator should know and need not mend."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(session, parent)
        self.intake = Intake(session, self)
        self.root: Path | None = None
        self.allowed: Callable[[], bool] = lambda: True  # what is the operator's asks here; see `cloner_gui.kiosk`
        self.settings = Event()
        self._known, self._names = KnownVisits(), KnownNames()
        self._opening: Task | None = None
        self.opening: Path | None = None
        self.intake.failed.connect(self.failed)
        self.intake.arrivals_stored.connect(self._note_arrivals)
        session.failed.connect(self.failed)
        session.queue.changed.connect(self.visits_changed)
        session.queue.failed.connect(self._tell_failed)
        session.queue.finished.connect(self._tell_ready)

    # --- the event ----------------------------------------------------------

    def open(self, folder: Path) -> None:
        """Open an event's folder, or one visitor's."""
        try:
            told = ""
            if is_visitor(folder):
                check_can_write(folder)
                self.root, self.settings = None, Event()
            else:
                check_event_folder(folder)
                settings, told = open_event(folder)
                self.root, self.settings = folder, settings
        except (ClonerError, OSError) as error:
            self.failed.emit(error)
            return
        self.event_changed.emit()
        self._follow_settings()
        if told:
            self.told.emit(told_sentence(told))
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

    def typed_name(self, folder: Path) -> str:
        """Return a visitor's name as it was typed."""
        return self._names.read(folder)

    def empty_trash(self) -> None:
        """Delete for good who has been in the trash for so long that it was said."""
        if self.root is not None:
            for folder in trash.over(self.root, self.settings.trash_days, datetime.now(UTC)):
                self.forget(folder)

    def name_of(self, folder: Path) -> str:
        """Return what a visitor is called on the operator's screen."""
        return called(self._names.read(folder), folder, translate("visitor", "Visitor {n}"))

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
        self.visits_changed.emit()
        visit = read_visit(opened.folder)
        seen = visit.page if visit.started else "photos" if opened.photos.photos else "visitor"
        self.page_wanted.emit(seen)
        self.intake.look_again()

    def _opened(self) -> None:
        self._opening, self.opening = None, None
        self.opening_changed.emit()

    # --- what is held ---------------------------------------------------------

    def held_soon(self) -> Callable[[], tuple[Holding, ...]]:
        """Return work that gives what is held of everybody; it looks at every file and belongs on another thread."""
        root = self.root
        return lambda: () if root is None else keeping.held(root)

    def overdue_soon(self) -> Callable[[], tuple[Holding, ...]]:
        """Return work that gives whose time is over; as :meth:`held_soon`."""
        root, days = self.root, self.settings.retention_days
        return lambda: () if root is None else keeping.overdue(root, days, datetime.now(UTC))

    def forget(self, folder: Path) -> tuple[str, ...]:
        """Delete a visitor with everything derived; return the files that still speak of it."""
        self._let_go(folder)
        left = self._guard(lambda: keeping.forget_visitor(folder, self.root)) or ()
        self._tell_gone()
        return left

    def throw_away(self, folder: Path) -> None:
        """Put a visitor into the trash, from where it can be brought back for some days."""
        self._let_go(folder)
        if self._guard(lambda: trash.throw_away(folder, datetime.now(UTC))) is not None:
            told = translate("window", "{name} lies in the trash for {n} days.")
            self.told.emit(told.format(name=self.name_of(folder), n=self.settings.trash_days))
        self._tell_gone()

    def _let_go(self, folder: Path) -> None:
        """Stop everything that is done for a visitor, and close them."""
        self.session.queue.withdraw(folder)
        self.session.queue.wait_for(folder)
        self.intake.drop(folder)
        if folder == self.session.folder:
            self.session.leave()
            self.change(open="")

    def _tell_gone(self) -> None:
        self.visits_changed.emit()
        if self.session.folder is None:
            self.page_wanted.emit("visitor")

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
                ClonerError(error.message, error.hint, f"{self.name_of(folder)}, {told_where(error.where)}")
            )

    def _tell_ready(self, folder: Path) -> None:
        """Tell of a clone that is ready while another visitor is open; the open one's is seen."""
        if folder != self.session.folder:
            self.told.emit(translate("window", "{name}: the clone is ready.").format(name=self.name_of(folder)))
