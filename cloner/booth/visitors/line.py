"""The queue of visitors waiting for their clones: who is next, and the estimated time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from statistics import median
from typing import Final

from cloner.booth.visitors.visits import State, Visit

#: A clone's seconds as long as none is known (samples on two idle cores).
USUAL_S: Final = 40.0
#: Below this share the pace of the clone under way says nothing yet.
_TELLING: Final = 0.1


def waiting(visits: Mapping[Path, Visit]) -> tuple[Path, ...]:
    """Return the waiting visitors in order of request."""
    those = [(visit.queued, folder.name, folder) for folder, visit in visits.items() if visit.state is State.WAITING]
    return tuple(folder for _, _, folder in sorted(those))


def usual_seconds(visits: Mapping[Path, Visit]) -> float:
    """Return the usual duration of a clone here."""
    known = [visit.clone_seconds for visit in visits.values() if visit.clone_seconds > 0.0]
    return median(known) if known else USUAL_S


def seconds_left(fraction: float, spent_s: float, usual_s: float, before: int = 0) -> float:
    """Return a visitor's estimated waiting time.

    Parameters
    ----------
    fraction : float
        How much of the clone under way is done, 0..1.
    spent_s : float
        For how long it has been under way.
    usual_s : float
        How long a whole clone takes here.
    before : int
        How many whole clones come before this visitor's is finished, besides the one under way.
    """
    paced = spent_s / fraction if fraction > _TELLING else usual_s
    share = min(max(fraction, 0.0), 1.0)
    whole = share * paced + (1.0 - share) * usual_s  # the pace counts more the more of it was seen
    return max(whole - spent_s, 0.02 * whole) * (share < 1.0) + before * usual_s


def asked(visit: Visit, now: str) -> Visit:
    """Return the visit with a clone requested."""
    return replace(visit, state=State.WAITING, queued=now, finished="", problem="", declined=False)


def cloned(visit: Visit, seconds: float, now: str) -> Visit:
    """Return the visit with a clone that was finished now, after some seconds."""
    return replace(visit, state=State.CLONED, clone_seconds=seconds, finished=now, problem="")


def failed(visit: Visit, problem: str) -> Visit:
    """Return the visit with a clone that failed."""
    return replace(visit, state=State.FAILED, problem=problem)


def withdrawn(visit: Visit, has_clone: bool) -> Visit:
    """Return the visit without its place in the queue: somebody decided so, and is not asked again."""
    return replace(visit, state=State.CLONED if has_clone else State.NONE, queued="", declined=True)


def photos_changed(visit: Visit) -> Visit:
    """Return the visit after its photos were changed: what went wrong with the old ones counts no more."""
    if visit.state is State.FAILED or visit.declined:
        state = State.NONE if visit.state is State.FAILED else visit.state
        return replace(visit, state=state, problem="", declined=False)
    return visit


def is_owed(visit: Visit, *, has_front: bool, agreed: bool, is_current: bool) -> bool:
    """Return whether a visitor who is left now has to be put into the queue, lest nobody ever clones them.

    Parameters
    ----------
    visit : Visit
    has_front : bool
        Whether the photos are enough for a clone.
    agreed : bool
        Whether a consent is recorded.
    is_current : bool
        Whether there is a clone of the photos, points and height as they are now.
    """
    settled = visit.state in (State.WAITING, State.FAILED) or visit.declined
    return has_front and agreed and not is_current and not settled


def with_effort(visit: Visit, seconds: float, clicks: int, drags: int) -> Visit:
    """Return the visit with what it cost the operator since the last time."""
    return replace(visit, seconds=visit.seconds + seconds, clicks=visit.clicks + clicks, drags=visit.drags + drags)
