"""Incoming photos of a visitor: all stored at once, then checked and assigned to views one by one."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from cloner.booth.opened import Opened
from cloner.booth.photos import arrivals
from cloner.booth.photos.check_cache import read_checks, store_check
from cloner.booth.photos.photo_files import intended_view, new_photos, place_new, remove, store_photo, view_of_name
from cloner.booth.visitors import waiting_line
from cloner.booth.worker import Progress
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.results import file_digest
from cloner_gui.background.worker import Task
from cloner_gui.event.clone_queue import update_visit
from cloner_gui.event.services import Services
from cloner_gui.event.session import Session

log = logging.getLogger(__name__)

#: How often a camera's folder is looked at, milliseconds: two looks tell a whole photo.
WATCH_MS: Final = 600


@dataclass(frozen=True, slots=True)
class Incoming:
    """An incoming photo: a file, or the bytes of one."""

    source: Path | bytes
    suffix: str
    meant: ViewId | None

    def data(self) -> bytes:
        """Return the bytes.

        Raises
        ------
        ClonerError
            If the file cannot be read.
        """
        if isinstance(self.source, bytes):
            return self.source
        try:
            return self.source.read_bytes()
        except OSError as error:
            hint = "Is the card or the cable still in its place?"
            raise ClonerError("the photo cannot be read", hint, self.source.name) from error


def check_and_place(services: Services, folder: Path, path: Path, progress: Progress) -> Opened:
    """Check a stored photo, assign its view, and return the visitor as read again; files that are no photos are
    removed.
    """
    if path.exists():  # it may have been taken out of the tray by hand meanwhile
        known = read_checks(folder).get(file_digest(path))
        try:
            check = known or services.check_photo(path, intended_view(path), progress)
        except ClonerError:
            remove(path)
            raise
        store_check(folder, check)
        place_new(folder, path, intended_view(path) or check.view)
        update_visit(folder, waiting_line.with_changed_photos)
    return services.open(folder)


def change(services: Services, folder: Path, edit: Callable[[], object], progress: Progress) -> Opened:
    """Edit a visitor's photos, check new ones, and return the visitor as read again."""
    edit()
    opened = services.open(folder)
    fresh = [photo for photo in opened.photos.photos.values() if photo.digest not in opened.checks]
    for photo in fresh:
        store_check(folder, services.check_photo(folder / photo.name, photo.view, progress))
    update_visit(folder, waiting_line.with_changed_photos)
    return services.open(folder) if fresh else opened


class Intake(QObject):
    """Takes photos for the open visitor, in a background thread.

    Parameters
    ----------
    session : Session
    """

    busy_changed = Signal()
    failed = Signal(object)
    arrivals_stored = Signal(object)
    """The camera's photos that are known by now, with their sizes; all of them are stored."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._waiting: deque[tuple[Path, Callable[[Progress], Opened]]] = deque()
        self._task: Task | None = None
        self._storing: dict[Task, tuple[Path, int]] = {}
        self._folder: Path | None = None
        self._ended = False
        self.camera_folder: Path | None = None
        self._known: dict[Path, int] = {}
        self._last: dict[Path, int] = {}
        self._timer = QTimer(self, interval=WATCH_MS)
        self._timer.timeout.connect(self.look_for_arrivals)

    def pending(self) -> int:
        """Return how many photos are on their way."""
        stored = sum(count for _, count in self._storing.values())
        return stored + len(self._waiting) + (self._task is not None)

    def add_files(self, paths: Sequence[Path], meant: ViewId | None = None) -> None:
        """Take photo files; the originals stay where they are. One alone may be meant for a view."""
        if len(paths) != 1:
            meant = None  # several let go on one card find their own places
        self._store([Incoming(path, path.suffix, meant or view_of_name(path.name)) for path in paths])

    def add_bytes(self, data: bytes, suffix: str, meant: ViewId | None = None) -> None:
        """Take a photo that is no file yet."""
        self._store([Incoming(data, suffix, meant)])

    def edit(self, edit: Callable[[], object]) -> None:
        """Do something to the open visitor's photos."""
        folder = self._session.folder
        if folder is not None:
            self._add(folder, partial(change, self._session.services, folder, edit))

    def look_again(self) -> None:
        """Look at photos of the open visitor that were never looked at."""
        folder = self._session.folder
        if folder is None or self.pending():
            return
        self._judge_all(folder, new_photos(folder))
        if any(one.digest not in self._session.checks for one in self._session.photos.photos.values()):
            self.edit(lambda: None)

    def watch(self, folder: Path | None, known: dict[Path, int] | None = None) -> None:
        """Take every photo that appears in a folder from now on, or since ``known``; None stops that."""
        self.camera_folder = folder
        self._known = {} if folder is None else arrivals.photo_sizes(folder) if known is None else known
        self._last = dict(self._known)
        if folder is None:
            self._timer.stop()
        else:
            self._timer.start()
            self.arrivals_stored.emit(dict(self._known))

    def look_for_arrivals(self) -> None:
        """Take the photos that have appeared; without a visitor who agreed they wait in their folder."""
        if self.camera_folder is None or self._session.folder is None or not self._session.consent:
            return
        now = arrivals.photo_sizes(self.camera_folder)
        fresh = arrivals.complete_photos(self._known, self._last, now)
        self._last = now
        self._known |= {path: now[path] for path in fresh}
        self._store([Incoming(path, path.suffix, view_of_name(path.name)) for path in fresh])

    def drop(self, folder: Path) -> None:
        """Bring no more photos to a visitor who goes, and wait for those under way."""
        self._waiting = deque(one for one in self._waiting if one[0] != folder)
        for task in [task for task, (place, _) in self._storing.items() if place == folder]:
            task.wait()
        if self._task is not None and self._folder == folder:
            self._task.cancel()
            self._task.wait()

    def close(self) -> None:
        """Stop, and wait for the photos under way: those that nobody has looked at are looked at next time."""
        self._ended = True
        self._timer.stop()
        self._waiting.clear()
        for task in list(self._storing):
            task.wait()
        if self._task is not None:
            self._task.cancel()
            self._task.wait()

    def _store(self, photos: Sequence[Incoming]) -> None:
        """Store photos beside the window's work, then look at each."""
        folder = self._session.folder
        if folder is None or not photos:
            return
        task = Task(lambda _: _stored(folder, photos))
        self._storing[task] = folder, len(photos)
        task.succeeded.connect(partial(self._take_stored, folder))
        task.finished.connect(partial(self._end_storing, task))
        task.start()
        self.busy_changed.emit()

    def _take_stored(self, folder: Path, stored: tuple[list[Path], list[ClonerError]]) -> None:
        for error in stored[1]:
            self.failed.emit(error)
        self._judge_all(folder, stored[0])

    def _end_storing(self, task: Task) -> None:
        self._storing.pop(task, None)
        if self.camera_folder is not None and not self._storing:
            self.arrivals_stored.emit(dict(self._known))
        self.busy_changed.emit()

    def _judge_all(self, folder: Path, paths: Sequence[Path]) -> None:
        for path in paths if folder.is_dir() else ():  # the visitor may be forgotten by now
            self._add(folder, partial(check_and_place, self._session.services, folder, path))

    def _add(self, folder: Path, work: Callable[[Progress], Opened]) -> None:
        self._waiting.append((folder, work))
        self._next()

    def _next(self) -> None:
        if self._task is None and self._waiting and not self._ended:
            self._folder, work = self._waiting.popleft()
            self._task = Task(work)
            self._task.succeeded.connect(self._take)
            self._task.failed.connect(self.failed)
            self._task.finished.connect(self._done)
            self._task.start()
        self.busy_changed.emit()

    def _take(self, opened: Opened) -> None:
        """Show the visitor anew, unless another one is open meanwhile."""
        if opened.folder == self._session.folder:
            self._session.take(opened)

    def _done(self) -> None:
        self._task = None
        self._next()


def _stored(folder: Path, photos: Sequence[Incoming]) -> tuple[list[Path], list[ClonerError]]:
    """Store photos and return where they lie, and what is wrong with those that could not be read."""
    found, wrong = [], []
    for photo in photos:
        try:
            found.append(store_photo(folder, photo.data(), photo.suffix, photo.meant))
        except ClonerError as error:
            wrong.append(error)
            if error.where == "Consent":
                break  # said once
    return found, wrong
