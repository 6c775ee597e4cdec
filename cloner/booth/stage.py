"""The visitors' screen: clones of visitors who agreed, and who is next, by first name or number."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from cloner.booth.handover.takeaway import has_result
from cloner.booth.visitors import waiting_line
from cloner.booth.visitors.cached_work import RESULTS
from cloner.booth.visitors.names import first_name, number_of
from cloner.booth.visitors.visits import State, Visit
from cloner.project.folder import safe_identifier


def shown_clones(visits: Mapping[Path, Visit]) -> tuple[Path, ...]:
    """Return the visitors whose finished clones may be shown because they agreed to it, the latest first."""
    return _cloned({folder: visit for folder, visit in visits.items() if visit.shown})


def scene_clones(visits: Mapping[Path, Visit]) -> tuple[Path, ...]:
    """Return the visitors whose finished clones may walk in the event's scene because they agreed to it, the latest
    first.
    """
    return _cloned({folder: visit for folder, visit in visits.items() if visit.inhabits})


def _cloned(visits: Mapping[Path, Visit]) -> tuple[Path, ...]:
    those = [
        (visit.queued, folder)
        for folder, visit in visits.items()
        if visit.state is State.CLONED and has_result(result_of(folder))
    ]
    return tuple(folder for _, folder in sorted(those, reverse=True))


def result_of(folder: Path) -> Path:
    """Return the folder of a visitor's clone."""
    return folder / RESULTS / safe_identifier(folder.name)


def public_name(folder: Path, visit: Visit, name: str) -> str:
    """Return a visitor's public name: the first name of those who agreed to be shown, else the number."""
    return (first_name(name) if visit.shown else "") or number_of(folder)


def queue_names(visits: Mapping[Path, Visit], name_of: Callable[[Path], str]) -> tuple[str, ...]:
    """Return the public names of those who wait for a clone, the next one first."""
    return tuple(public_name(folder, visits[folder], name_of(folder)) for folder in waiting_line.waiting(visits))
