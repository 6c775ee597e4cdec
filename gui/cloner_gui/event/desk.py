"""The visitor at the desk: entered data, progress and the operator's effort, saved as it happens."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from datetime import UTC, datetime
from types import MappingProxyType
from typing import Any, Final

from PySide6.QtCore import QObject, QTimer, Signal

from cloner.booth.visitors import waiting_line
from cloner.booth.visitors.person_file import consent_given, person_facts, write_person
from cloner.booth.visitors.visits import read_visit
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.folder import read_terms
from cloner.records.terms import Terms
from cloner_gui.event.clone_queue import now_text, update_visit
from cloner_gui.event.session import Session

#: How often the operator's effort is written down, milliseconds.
EFFORT_MS: Final = 5000


class Desk(QObject):
    """Keeps the open visitor's files up to date.

    Parameters
    ----------
    session : Session
        The open visitor.
    """

    visits_changed = Signal()
    """Whoever lists the visitors reads all of them: where much may happen at once, say `tell_change`."""
    failed = Signal(object)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self._soon = QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self.visits_changed)
        self.clicks, self._counted, self._since = 0, 0, time.monotonic()
        effort = QTimer(self, interval=EFFORT_MS)
        effort.timeout.connect(self.note_effort)
        effort.start()

    def tell_change(self) -> None:
        """Say soon, and once however much happens, that something is different with the visitors."""
        self._soon.start()

    def save_person(self, name: str, height_cm: float | None) -> None:
        """Save name and height of the open visitor."""
        consent = self.session.consent
        self._save(name, height_cm, consent)

    def agree(self, text: str, language: str, licence: str = "") -> None:
        """Record that the open visitor agrees to a text, now, and who may use the files; "" takes the usual."""
        given = consent_given(text, datetime.now(UTC), language)
        self._save(*self.person()[:2], given, self.terms(language, licence))

    def terms(self, language: str, licence: str = "") -> Mapping[str, str]:
        """Return what a consent given now, in a language, says besides its text; nothing without an event."""
        return {}

    def licence(self) -> str:
        """Return who may use the open visitor's files, one of `LICENCES`; "" before there is a consent."""
        folder = self.session.folder
        terms: Terms | None = None if folder is None else self._guard(lambda: read_terms(folder))
        return "" if terms is None else terms.licence

    def withdraw_consent(self) -> None:
        """Record that the open visitor agrees no more; what is stored already is deleted on the last page."""
        self._save(*self.person()[:2], "")

    def person(self) -> tuple[str, float | None, str]:
        """Return name, height and consent of the open visitor."""
        folder = self.session.folder
        return ("", None, "") if folder is None else self._guard(lambda: person_facts(folder)) or ("", None, "")

    def _save(
        self, name: str, height_cm: float | None, consent: str, agreed: Mapping[str, str] = MappingProxyType({})
    ) -> None:
        folder = self.session.folder
        if folder is not None and (name, height_cm, consent) != self.person():
            self._guard(lambda: write_person(folder, name=name, height_cm=height_cm, consent=consent, agreed=agreed))
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
        self._guard(lambda: update_visit(folder, lambda v: waiting_line.with_effort(v, spent, clicks, max(more, 0))))

    def begin_effort(self) -> None:
        """Count from now on for another visitor."""
        self._since, self._counted, self.clicks = time.monotonic(), 0, 0

    def set_shown(self, shown: bool) -> None:
        """Record whether the visitor agrees to be seen on the visitors' screen."""
        folder = self.session.folder
        if folder is not None and read_visit(folder).shown != shown:
            self._guard(lambda: update_visit(folder, lambda visit: replace(visit, shown=shown)))
            self.visits_changed.emit()

    def set_inhabits(self, inhabits: bool) -> None:
        """Record whether the visitor agrees to walk in the event's scene."""
        folder = self.session.folder
        if folder is not None and read_visit(folder).inhabits != inhabits:
            self._guard(lambda: update_visit(folder, lambda visit: replace(visit, inhabits=inhabits)))
            self.visits_changed.emit()

    def _guard(self, work: Any) -> Any:
        """Do something that may fail, and tell it if it does."""
        try:
            return work()
        except ClonerError as error:
            self.failed.emit(error)
            return None
