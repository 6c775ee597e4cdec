"""Photos on their way into a visitor's folder: stored, looked at, put into their place, one after the other."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from cloner.booth import arrivals
from cloner.booth.looks import keep_look
from cloner.booth.opened import Opened
from cloner.booth.photo_files import meant_view, place_new, remove, store_photo
from cloner.booth.worker import Progress
from cloner.errors import Cancelled, ClonerError
from cloner.frames import ViewId
from cloner_gui.services import Services
from cloner_gui.session import Session
from cloner_gui.worker import Task

log = logging.getLogger(__name__)

#: How often a camera's folder is looked at, milliseconds: two looks tell a whole photo.
WATCH_MS: Final = 600


@dataclass(frozen=True, slots=True)
class Incoming:
    """A photo that somebody brings: a file, or the bytes of one."""

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


def bring_in(services: Services, folder: Path, photo: Incoming, progress: Progress) -> Opened:
    """Store a photo, look at it, give it its place, and return the visitor anew."""
    path = store_photo(folder, photo.data(), photo.suffix)
    try:
        look = services.look(path, photo.meant, progress)
    except (ClonerError, Cancelled):
        remove(path)  # no photo, or nobody wants it any more
        raise
    keep_look(folder, look)
    place_new(folder, path, photo.meant or look.view)
    return services.open(folder)


def change(services: Services, folder: Path, edit: Callable[[], object], progress: Progress) -> Opened:
    """Do something to a visitor's photos, look at what is new, and return the visitor anew."""
    edit()
    opened = services.open(folder)
    fresh = [photo for photo in opened.photos.photos.values() if photo.digest not in opened.looks]
    for photo in fresh:
        keep_look(folder, services.look(folder / photo.name, photo.view, progress))
    return services.open(folder) if fresh else opened


class Intake(QObject):
    """Takes photos for the open visitor, off the window's thread.

    Parameters
    ----------
    session : Session
    """

    busy_changed = Signal()
    failed = Signal(object)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._waiting: deque[tuple[Path, Callable[[Progress], Opened]]] = deque()
        self._task: Task | None = None
        self._folder: Path | None = None
        self.camera_folder: Path | None = None
        self._known: dict[Path, int] = {}
        self._last: dict[Path, int] = {}
        self._timer = QTimer(self, interval=WATCH_MS)
        self._timer.timeout.connect(self.look_for_arrivals)

    def pending(self) -> int:
        """Return how many photos are on their way."""
        return len(self._waiting) + (self._task is not None)

    def add_files(self, paths: Sequence[Path], meant: ViewId | None = None) -> None:
        """Take photo files; the originals stay where they are."""
        for path in paths:
            self._bring(Incoming(path, path.suffix, meant or meant_view(path.name)))

    def add_bytes(self, data: bytes, suffix: str, meant: ViewId | None = None) -> None:
        """Take a photo that is no file yet."""
        self._bring(Incoming(data, suffix, meant))

    def edit(self, edit: Callable[[], object]) -> None:
        """Do something to the open visitor's photos."""
        folder = self._session.folder
        if folder is not None:
            self._add(folder, partial(change, self._session.services, folder, edit))

    def look_again(self) -> None:
        """Look at photos of the open visitor that were never looked at."""
        unseen = [one for one in self._session.photos.photos.values() if one.digest not in self._session.looks]
        if unseen and self.pending() == 0:
            self.edit(lambda: None)

    def watch(self, folder: Path | None) -> None:
        """Take every photo that appears in a folder from now on; None stops that."""
        self.camera_folder = folder
        self._known = {} if folder is None else arrivals.sizes(folder)
        self._last = dict(self._known)
        if folder is None:
            self._timer.stop()
        else:
            self._timer.start()

    def look_for_arrivals(self) -> None:
        """Take the photos that have appeared; without a visitor who agreed they wait in their folder."""
        if self.camera_folder is None or self._session.folder is None or not self._session.consent:
            return
        now = arrivals.sizes(self.camera_folder)
        fresh = arrivals.arrived(self._known, self._last, now)
        self._last = now
        self._known |= {path: now[path] for path in fresh}
        self.add_files(fresh)

    def drop(self, folder: Path) -> None:
        """Bring no more photos to a visitor who goes, and wait for the one under way."""
        self._waiting = deque(one for one in self._waiting if one[0] != folder)
        if self._task is not None and self._folder == folder:
            self._task.cancel()
            self._task.wait()

    def close(self) -> None:
        """Stop, and wait for the photo under way."""
        self._timer.stop()
        self._waiting.clear()
        if self._task is not None:
            self._task.cancel()
            self._task.wait()

    def _bring(self, photo: Incoming) -> None:
        folder = self._session.folder
        if folder is not None:
            self._add(folder, partial(bring_in, self._session.services, folder, photo))

    def _add(self, folder: Path, work: Callable[[Progress], Opened]) -> None:
        self._waiting.append((folder, work))
        self._next()

    def _next(self) -> None:
        if self._task is None and self._waiting:
            self._folder, work = self._waiting.popleft()
            self._task = Task(work, self)
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
        if self._task is not None:
            self._task.deleteLater()
        self._task = None
        self._next()
