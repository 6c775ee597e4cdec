"""Actions on many visitors at once: into the trash, restored, deleted; in a background thread."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

from PySide6.QtCore import QObject, Signal

from cloner.booth.events import retention, trash
from cloner.booth.events.event import Event
from cloner.booth.opened import Opened
from cloner.booth.visitors.names import KnownNames, display_name
from cloner.booth.visitors.versions import has_previous, swap_with_previous
from cloner.errors import ClonerError
from cloner.personal_data.holdings import Holding
from cloner.project.folder import safe_identifier
from cloner_gui.background.worker import Task
from cloner_gui.event.clone_queue import note_asked
from cloner_gui.event.desk import Desk
from cloner_gui.event.intake import Intake
from cloner_gui.event.session import Session
from cloner_gui.language.words import translate

_NAMED: Final = 5  # visitors or files that a sentence names
#: Folders where they lie now, and what went wrong with others.
_Moved = tuple[list[Path], list[ClonerError]]


class Everybody(Desk):
    """Deletes visitors, and clones them again.

    Parameters
    ----------
    session : Session
        The open visitor.
    """

    page_wanted = Signal(str)
    told = Signal(str)
    """Something that the operator should know and need not mend."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(session, parent)
        self.root: Path | None = None
        self.settings = Event()
        self.intake = Intake(session, self)
        self._names = KnownNames()

    def change(self, **settings: Any) -> None:
        """Change settings of the event and save them; nothing without an event."""

    def typed_name(self, folder: Path) -> str:
        """Return a visitor's name as it was typed."""
        return self._names.read(folder)

    def name_of(self, folder: Path) -> str:
        """Return what a visitor is called on the operator's screen."""
        return display_name(self._names.read(folder), folder, translate("visitor", "Visitor {n}"))

    def held_soon(self) -> Callable[[], tuple[Holding, ...]]:
        """Return work that gives what is held of everybody; it looks at every file and belongs on another thread."""
        root = self.root
        return lambda: () if root is None else retention.stored_data(root)

    def overdue_soon(self) -> Callable[[], tuple[Holding, ...]]:
        """Return work that gives whose time is over; as :meth:`held_soon`."""
        root, days = self.root, self.settings.retention_days
        return lambda: () if root is None else retention.overdue_data(root, days, datetime.now(UTC))

    def forget(self, *folders: Path) -> None:
        """Delete visitors with everything derived: nobody sees them from now on, and files go beside the window."""
        root = self.root
        for folder in folders:
            self._let_go(folder)
            if root is not None:
                self._guard(lambda folder=folder: retention.set_aside(folder))
        self._tell_gone()
        self._delete(
            lambda: retention.forget_visitors(folders, None) if root is None else retention.finish_deletions(root)
        )

    def tidy_up(self) -> None:
        """Finish deletions that a crash broke off, and delete who was in the trash for as long as was said."""
        root, days, now = self.root, self.settings.trash_days, datetime.now(UTC)
        if root is not None:
            self._delete(lambda: retention.tidy_up(root, days, now))

    def _delete(self, work: Callable[[], tuple[str, ...]]) -> None:
        """Delete beside the window's thread, and tell which files still speak of who went: all files are read."""
        self._beside(work, self._tell_left)

    def _beside(self, work: Callable[[], Any], then: Callable[[Any], None]) -> None:
        task = Task(lambda _: work())
        task.succeeded.connect(then)
        task.failed.connect(self.failed)
        task.finished.connect(self.tell_change)
        task.start()

    def _tell_left(self, left: tuple[str, ...]) -> None:
        if left:
            message, hint = "these files still tell of who was deleted", "Look at them: they may be copies"
            self.failed.emit(ClonerError(message, hint, _some(left)))

    def throw_away(self, *folders: Path) -> None:
        """Put visitors into the trash, from where they can be brought back for some days."""
        for folder in folders:
            self._let_go(folder)
        now = datetime.now(UTC)
        self._beside(lambda: _moved(lambda folder: trash.move_to_trash(folder, now), folders), self._tell_thrown)
        self._tell_gone()

    def _tell_thrown(self, moved: _Moved) -> None:
        self._tell_wrong(moved)
        lie = [self.name_of(folder) for folder in moved[0]]
        if lie:
            told = translate("window", "{name} lies in the trash for {n} days.")
            self.told.emit(told.format(name=_some(lie), n=self.settings.trash_days))

    def bring_back(self, *folders: Path) -> None:
        """Take visitors out of the trash."""
        self._beside(lambda: _moved(trash.restore, folders), self._tell_wrong)

    def clone_again(self, *folders: Path) -> None:
        """Put visitors, many perhaps, at the end of the queue."""
        queue = self.session.queue
        new = [folder for folder in folders if not queue.holds(folder)]

        def resume(asked: _Moved) -> None:
            self._tell_wrong(asked)
            queue.resume(tuple(asked[0]))

        self._beside(lambda: _moved(note_asked, new), resume)

    def bring_clone_before(self, *folders: Path) -> None:
        """Exchange visitors' clones and those before; done again it is as it was."""
        here, services = self.session.folder, self.session.services
        wanted = [folder for folder in folders if has_previous(folder) and not self.session.queue.holds(folder)]

        def exchange() -> tuple[_Moved, Opened | None]:
            moved = _moved(_exchanged, wanted)
            return moved, services.open(here) if here is not None and here in moved[0] else None

        def show(done: tuple[_Moved, Opened | None]) -> None:
            moved, opened = done
            self._tell_wrong(moved)
            if opened is not None and opened.folder == self.session.folder:
                self.session.take(opened)
            if moved[0]:
                told = translate("window", "{name}: the clone before is back. The other one is kept: the same again.")
                self.told.emit(told.format(name=_some([self.name_of(folder) for folder in moved[0]])))

        self._beside(exchange, show)

    def _tell_wrong(self, moved: _Moved) -> None:
        for error in moved[1]:
            self.failed.emit(error)

    def _let_go(self, folder: Path) -> None:
        """Stop everything that is done for a visitor, and close them."""
        self.session.queue.drop(folder)
        self.intake.drop(folder)
        if folder == self.session.folder:
            self.session.leave()
            self.change(open="")

    def _tell_gone(self) -> None:
        self.visits_changed.emit()
        if self.session.folder is None:
            self.page_wanted.emit("visitor")


def _moved(move: Callable[[Path], Path], folders: Sequence[Path]) -> _Moved:
    """Move visitors; one that cannot be moved keeps no other."""
    lie, wrong = [], []
    for folder in folders:
        try:
            lie.append(move(folder))
        except ClonerError as error:
            wrong.append(error)
    return lie, wrong


def _exchanged(folder: Path) -> Path:
    swap_with_previous(folder, safe_identifier(folder.name))
    return folder


def _some(names: Sequence[str]) -> str:
    return ", ".join(names[:_NAMED]) + (", …" if len(names) > _NAMED else "")
