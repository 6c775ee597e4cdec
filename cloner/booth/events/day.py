"""Statistics of a day at the booth: visitors, waiting times, refusals and their reasons. No names."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from statistics import median
from typing import Final

from cloner.booth.photos.photo_problems import PhotoCheck, PhotoProblem
from cloner.booth.visitors.visits import State, Visit

COLUMNS: Final = ("day", "what", "reason", "number")


@dataclass(frozen=True, slots=True)
class Day:
    """Statistics of one day.

    Attributes
    ----------
    date : str
        "2026-11-22", by this computer's clock; "" for visitors of whom nothing says when they came.
    visitors, clones, trashed : int
        Who lies in the trash came too, and is counted in all of it.
    waited_min : tuple of float
        Minutes from the wish for a clone to the clone, of everybody of whom both are known.
    photos : mapping of PhotoProblem to int
        Photos that the operator was advised to take again; one photo may have several reasons.
    failures : mapping of str to int
        Why visitors were not cloned, as the library's own sentence.
    """

    date: str
    visitors: int
    clones: int
    trashed: int
    waited_min: tuple[float, ...]
    photos: Mapping[PhotoProblem, int]
    failures: Mapping[str, int]

    @property
    def median_min(self) -> float:
        """Median waiting time, minutes; 0 where nobody waited."""
        return median(self.waited_min) if self.waited_min else 0.0

    @property
    def longest_min(self) -> float:
        """Longest waiting time, minutes; 0 where nobody waited."""
        return max(self.waited_min, default=0.0)


def statistics_by_day(
    visits: Mapping[Path, Visit], checks: Callable[[Path], Mapping[str, PhotoCheck]]
) -> tuple[Day, ...]:
    """Return the statistics of every day, the latest day first.

    Parameters
    ----------
    visits : mapping of Path to Visit
    checks : callable
        Returns what was found of a visitor's photos.
    """
    found: dict[str, list[Path]] = {}
    for folder, visit in visits.items():
        found.setdefault(_date(visit.started), []).append(folder)
    return tuple(
        _day(date, {folder: visits[folder] for folder in folders}, checks)
        for date, folders in sorted(found.items(), reverse=True)
    )


def _day(date: str, visits: Mapping[Path, Visit], checks: Callable[[Path], Mapping[str, PhotoCheck]]) -> Day:
    photos = Counter(trouble for folder in visits for check in checks(folder).values() for trouble in check.troubles)
    failures = Counter(_reason(visit.problem) for visit in visits.values() if visit.state is State.FAILED)
    waited = [_minutes(visit.queued, visit.finished) for visit in visits.values()]
    cloned = sum(visit.state is State.CLONED for visit in visits.values())
    return Day(
        date,
        len(visits),
        cloned,
        sum(bool(visit.trashed) for visit in visits.values()),
        tuple(one for one in waited if one is not None),
        dict(photos.most_common()),
        dict(failures.most_common()),
    )


def _date(started: str) -> str:
    """Return the local date of a time."""
    try:
        return f"{datetime.fromisoformat(started).astimezone():%Y-%m-%d}"
    except ValueError:
        return ""


def _minutes(begin: str, end: str) -> float | None:
    """Return the minutes between two times; None where one is unknown or they are in the wrong order."""
    try:
        spent = (datetime.fromisoformat(end) - datetime.fromisoformat(begin)).total_seconds() / 60.0
    except (ValueError, TypeError):
        return None
    return spent if spent >= 0.0 else None


def _reason(problem: str) -> str:
    """Return a clone's error message without the visitor's name: ``visitor-003: message. hint`` gives the message."""
    where, colon, rest = problem.partition(": ")
    return (rest if colon else where).partition(". ")[0]


def days_csv(days: tuple[Day, ...]) -> str:
    """Return the days' statistics as CSV, one row per number."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(COLUMNS)
    for day in days:
        rows = [
            ("visitors", "", str(day.visitors)),
            ("clones", "", str(day.clones)),
            ("in the trash", "", str(day.trashed)),
            ("minutes in the queue, median", "", f"{day.median_min:.1f}"),
            ("minutes in the queue, longest", "", f"{day.longest_min:.1f}"),
            *(("photos to take again", str(trouble), str(count)) for trouble, count in day.photos.items()),
            *(("not cloned", reason, str(count)) for reason, count in day.failures.items()),
        ]
        writer.writerows((day.date, *row) for row in rows)
    return stream.getvalue()
