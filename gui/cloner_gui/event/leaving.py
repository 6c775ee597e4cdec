"""What happens to the visitor whom the operator leaves: nobody goes without a clone by mistake."""

from __future__ import annotations

from typing import TYPE_CHECKING

from cloner.booth.visitors import waiting_line
from cloner.booth.visitors.visits import read_visit
from cloner.frames import ViewId
from cloner_gui.language.words import translate

if TYPE_CHECKING:
    from cloner_gui.event.booth import Booth
    from cloner_gui.event.session import Session


def has_front(session: Session) -> bool:
    """Return whether the photos of the open visitor are enough for a clone."""
    return ViewId.BODY_FRONT in session.photos.photos or ViewId.FACE_FRONT in session.photos.photos


def should_queue(session: Session) -> bool:
    """Return whether the open visitor should be queued; see `cloner.booth.visitors.waiting_line.should_queue`."""
    folder = session.folder
    if folder is None or not folder.is_dir():
        return False
    current = session.outcome is not None and not session.is_stale()
    agreed = bool(session.consent)
    return waiting_line.should_queue(
        read_visit(folder), has_front=has_front(session), agreed=agreed, is_current=current
    )


def settle(booth: Booth) -> None:
    """Queue the open visitor, whose page is left now, if nobody has done so, and say it."""
    session = booth.session
    if session.folder is not None and booth.root is not None and should_queue(session):
        name = booth.name_of(session.folder)
        session.clone()
        booth.told.emit(translate("window", "{name} waits for the clone now: it was not asked for.").format(name=name))
