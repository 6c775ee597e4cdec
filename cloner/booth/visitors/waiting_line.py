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
    """Return the waiting visitors in the order of their requests."""
    those = [(visit.queued, folder.name, folder) for folder, visit in visits.items() if visit.state is State.WAITING]
    return tuple(folder for _, _, folder in sorted(those))


def typical_seconds(visits: Mapping[Path, Visit]) -> float:
    """Return the median duration of a clone at this booth."""
    known = [visit.clone_seconds for visit in visits.values() if visit.clone_seconds > 0.0]
    return median(known) if known else USUAL_S


def seconds_left(fraction: float, spent_s: float, usual_s: float, before: int = 0) -> float:
    """Return the estimated time until a visitor's clone is finished.

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


def with_request(visit: Visit, now: str) -> Visit:
    """Return the visit with a clone requested."""
    return replace(visit, state=State.WAITING, queued=now, finished="", problem="", declined=False)


def with_clone(visit: Visit, seconds: float, now: str) -> Visit:
    """Return the visit with a clone finished now, after some seconds."""
    return replace(visit, state=State.CLONED, clone_seconds=seconds, finished=now, problem="")


def with_failure(visit: Visit, problem: str) -> Visit:
    """Return the visit with a clone that failed."""
    return replace(visit, state=State.FAILED, problem=problem)


def without_request(visit: Visit, has_clone: bool) -> Visit:
    """Return the visit removed from the queue by the operator; it is not queued again automatically."""
    return replace(visit, state=State.CLONED if has_clone else State.NONE, queued="", declined=True)


def with_changed_photos(visit: Visit) -> Visit:
    """Return the visit after its photos were changed: earlier failures no longer count."""
    if visit.state is State.FAILED or visit.declined:
        state = State.NONE if visit.state is State.FAILED else visit.state
        return replace(visit, state=state, problem="", declined=False)
    return visit


def should_queue(visit: Visit, *, has_front: bool, agreed: bool, is_current: bool) -> bool:
    """Return whether a visitor whose page is left must be queued automatically, as nobody else would request the clone.

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
    """Return the visit with the operator's effort since the last time added."""
    return replace(visit, seconds=visit.seconds + seconds, clicks=visit.clicks + clicks, drags=visit.drags + drags)
