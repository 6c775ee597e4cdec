"""The page for visitors' phones: on and off with the event's setting, and its content for the open visitor."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from cloner.booth.events.event import visitor_folders
from cloner.booth.phone.certificate import make_certificate
from cloner.booth.phone.parcel import is_packed
from cloner.booth.phone.server import PORT, PhoneServer, local_addresses
from cloner.booth.phone.tickets import issue_ticket
from cloner.errors import ClonerError
from cloner_gui.background.worker import Task
from cloner_gui.event.booth import Booth


class Phone(QObject):
    """Serves the page while it is switched on; nothing listens otherwise.

    Parameters
    ----------
    booth : Booth
    """

    changed = Signal()

    def __init__(self, booth: Booth, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._booth = booth
        self._server: PhoneServer | None = None
        self._key: tuple[object, ...] = ()
        self._packing: Task | None = None
        self._packed_for: Path | None = None
        booth.event_changed.connect(self.follow)
        booth.session.opened.connect(self.prepare)
        booth.session.cloned.connect(self.prepare)

    @property
    def is_on(self) -> bool:
        """Whether the page is served."""
        return self._server is not None

    def follow(self) -> None:
        """Start or stop serving according to the event's settings."""
        root, settings = self._booth.root, self._booth.settings
        wanted = (root, settings.phone_https, settings.language) if root is not None and settings.phone else ()
        if wanted == self._key:
            return
        self.close()
        self._key = wanted
        if root is not None and wanted:
            self._start(root)
        self.changed.emit()
        self.prepare()

    def _start(self, root: Path) -> None:
        settings, address = self._booth.settings, local_addresses()[0]

        def visitors() -> tuple[Path, ...]:
            return visitor_folders(root)

        try:
            keys = make_certificate(root, address) if settings.phone_https else None
            try:
                self._server = PhoneServer(visitors, settings.language, address, PORT, keys)
            except ClonerError:
                self._server = PhoneServer(visitors, settings.language, address, 0, keys)  # any port that is free
        except ClonerError as error:
            self._booth.failed.emit(error)

    def link(self) -> str:
        """Return the address of the open visitor's page; "" if there is none."""
        session = self._booth.session
        if self._server is None or session.folder is None or session.outcome is None:
            return ""
        if not is_packed(session.folder, session.outcome.folder):
            return ""
        try:
            ticket = issue_ticket(session.folder, datetime.now(UTC), self._booth.settings.phone_hours)
        except ClonerError:
            return ""
        return self._server.link(ticket.token)

    @property
    def busy(self) -> bool:
        """Whether the open visitor's page is being made."""
        return self._packing is not None

    def prepare(self) -> None:
        """Make the content of the open visitor's page, once there is a clone."""
        session = self._booth.session
        folder, outcome = session.folder, session.outcome
        if self._server is None or folder is None or outcome is None or self._packing is not None:
            return
        if is_packed(folder, outcome.folder):
            self.changed.emit()
            return
        services = session.services
        task = Task(lambda progress: services.pack(folder, outcome.folder, progress))
        self._packing, self._packed_for = task, folder
        task.failed.connect(self._booth.failed)
        task.finished.connect(self._packed)
        task.start()
        self.changed.emit()

    def close(self) -> None:
        """Stop serving."""
        self._key = ()
        if self._server is not None:
            self._server.stop()
            self._server = None

    def _packed(self) -> None:
        self._packing = None
        self.changed.emit()
        session = self._booth.session
        if session.folder is not None and session.outcome is not None:
            if session.folder != self._packed_for:  # another visitor was opened meanwhile
                self.prepare()
