"""What the window requests from the library, as plain functions; tests pass in their own."""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from cloner.booth.opened import Cloned, Opened, open_visitor, read_cloned
from cloner.booth.photos.photo_files import placed_photos
from cloner.booth.photos.photo_problems import PhotoCheck
from cloner.booth.visitors.cached_work import proposed_points
from cloner.booth.worker import Progress, Show, Worker, ignore
from cloner.errors import Cancelled, ClonerError
from cloner.frames import ViewId
from cloner.records.photos import PhotoSet
from cloner.records.points import Corrections, ViewPoints

if TYPE_CHECKING:
    from cloner.interactive.refitting import RefittedBody
    from cloner.records.clones import Clone

ProposedPoints = dict[ViewId, ViewPoints]
Studio = Callable[..., object]
#: What the studio's process loads; it starts with the studio's first job.
STUDIO: Final = "cloner.booth.studio.jobs:StudioJobs"


def refit_person(values: Mapping[str, object], corrections: Corrections) -> RefittedBody:
    """Return the last clone's body with corrections applied; see `cloner.interactive.refitting.refit_body`."""
    from cloner.interactive.refitting import (
        refit_body,  # the whole fit: not paid for before there is something to refit
    )

    return refit_body(values, corrections)


def refitted_clone(
    refit: Callable[[Mapping[str, object], Corrections], RefittedBody],
    values: Mapping[str, object],
    corrections: Corrections,
) -> tuple[RefittedBody, Clone]:
    """Return the last clone's body with corrections applied, and the clone with that body."""
    from cloner.interactive.refitting import clone_after

    moved = refit(values, corrections)
    return moved, clone_after(values, moved.person)


def pack_parcel(folder: Path, result: Path, progress: Progress) -> Path:
    """Make what the page for phones shows; see `cloner.booth.phone.parcel.pack`."""
    from cloner.booth.phone.parcel import pack  # drawing: not paid for before there is a page

    return pack(folder, result, progress)


def draw_walk_pictures(folder: Path, result: Path, progress: Progress) -> Path:
    """Draw a visitor's walk for the visitors' screen; see `cloner.booth.walk_pictures`."""
    from cloner.booth import walk_pictures

    return walk_pictures.draw_walk_pictures(folder, result, progress)


def nothing(*_: object) -> None:
    """Do nothing."""


def no_studio(method: str, arguments: tuple[object, ...], progress: Progress, show: Show) -> object:
    """Do no job of the studio: there is no process for it."""
    raise Cancelled


@dataclass(frozen=True, slots=True)
class Services:
    """The long jobs of the window, and the short one after a drag.

    Attributes
    ----------
    open : callable
        Reads a visitor's folder.
    check_photo : callable
        Takes a photo's path and the view it is meant for, or None, and says what it shows.
    propose : callable
        Takes a visitor's folder and its photos and gives the points of every photo.
    clone : callable
        Takes a visitor's folder and the formats and gives the finished clone and its seconds; shows the body's `Shape`
        as it grows.
    pack : callable
        Takes a visitor's folder and the result and makes what the page for telephones shows.
    draw_walk : callable
        Takes a visitor's folder and the result and draws the clone walking, for the visitors' screen.
    hand_over : callable
        Takes a result, a target and the formats and gives what was written.
    refit : callable
    studio : callable
        Does a job of the studio by its name, with its arguments, a progress and a way to show; see
        `cloner.booth.studio.jobs.StudioJobs`.
    start, stop : callable
        Called when the window opens and closes.
    """

    check_photo: Callable[[Path, ViewId | None, Progress], PhotoCheck]
    propose: Callable[[Path, PhotoSet, Progress], ProposedPoints]
    clone: Callable[[Path, Sequence[str], Progress, Show], tuple[Cloned, float]]
    hand_over: Callable[[Path, Path, Sequence[str], Progress], Path]
    open: Callable[[Path], Opened] = open_visitor
    pack: Callable[[Path, Path, Progress], Path] = pack_parcel
    draw_walk: Callable[[Path, Path, Progress], Path] = draw_walk_pictures
    refit: Callable[[Mapping[str, object], Corrections], RefittedBody] = refit_person
    studio: Studio = no_studio
    start: Callable[[], None] = nothing
    stop: Callable[[], None] = nothing


def process_services() -> Services:
    """Return the services in their processes: for the present visitor, for background clones, and for the studio."""
    desk, bench, ovens = Worker(), Worker(STUDIO), ClonePool()
    return Services(
        check_photo=functools.partial(_check_photo, desk),
        propose=functools.partial(_propose, desk),
        clone=functools.partial(_clone, ovens),
        hand_over=functools.partial(_hand_over, desk),
        pack=functools.partial(_pack, desk),
        draw_walk=functools.partial(_draw_walk, ovens),
        studio=functools.partial(_studio, bench),
        start=desk.start,
        stop=functools.partial(_stop, desk, ovens, bench),
    )


def _check_photo(worker: Worker, path: Path, wanted: ViewId | None, progress: Progress) -> PhotoCheck:
    told: PhotoCheck = worker.call("check_photo", path, wanted, progress=progress)
    return told


def _propose(worker: Worker, folder: Path, photos: PhotoSet, progress: Progress) -> ProposedPoints:
    worker.call("propose", folder, progress=progress)
    return points_by_view(proposed_points(folder, photos), photos)


class ClonePool:
    """Processes for clones: as many as may run at once, each started when all others are busy."""

    def __init__(self) -> None:
        self._free: list[Worker] = []
        self._all: list[Worker] = []
        self._lock = threading.Lock()

    def call(self, method: str, *arguments: object, progress: Progress, show: Show = ignore) -> Any:
        """Do a job in an idle process; see `Worker.call`."""
        with self._lock:
            if not self._free:
                self._free.append(Worker())
                self._all += self._free
            worker = self._free.pop()
        try:
            return worker.call(method, *arguments, progress=progress, show=show)
        finally:
            with self._lock:
                self._free.append(worker)

    def stop(self) -> None:
        """End all processes."""
        for worker in self._all:
            worker.stop()


def _clone(
    worker: ClonePool, folder: Path, formats: Sequence[str], progress: Progress, show: Show
) -> tuple[Cloned, float]:
    seconds = float(worker.call("clone", folder, tuple(formats), progress=progress, show=show))
    photos = placed_photos(folder)
    cloned = read_cloned(folder, photos)
    if cloned is None:
        raise ClonerError("the photos changed while they were cloned", "Clone again", folder.name)
    return cloned, seconds


def _hand_over(worker: Worker, result: Path, target: Path, formats: Sequence[str], progress: Progress) -> Path:
    try:
        written: Path = worker.call("hand_over", result, target, tuple(formats), progress=progress)
    except Cancelled:  # the process was killed wherever it was
        from cloner.booth.handover.handing import clean_up  # all exporters: not paid for at the start

        clean_up(result, target)
        raise
    return written


def _pack(worker: Worker, folder: Path, result: Path, progress: Progress) -> Path:
    made: Path = worker.call("pack", folder, result, progress=progress)
    return made


def _draw_walk(worker: ClonePool, folder: Path, result: Path, progress: Progress) -> Path:
    made: Path = worker.call("draw_walk", folder, result, progress=progress)
    return made


def _studio(worker: Worker, method: str, arguments: tuple[object, ...], progress: Progress, show: Show) -> object:
    return worker.call(method, *arguments, progress=progress, show=show)


def points_by_view(values: Mapping[str, object], photos: PhotoSet) -> ProposedPoints:
    """Return face and body points together, by view; empty if unknown."""
    sets = [values[name] for name in ("face_points", "body_points") if name in values]
    found = {view: [one.views[view] for one in sets if view in one.views] for view in photos.photos}  # type: ignore[attr-defined]
    return {view: merge_points(parts) for view, parts in found.items() if parts}


def merge_points(parts: list[ViewPoints]) -> ViewPoints:
    """Return the points of one view from several sets; the first set that names a point wins."""
    rows = {name: (part, row) for part in reversed(parts) for row, name in enumerate(part.names)}
    return ViewPoints(
        parts[0].view,
        tuple(rows),
        np.array([part.points_px[row] for part, row in rows.values()]).reshape(-1, 2),
        np.array([part.confidence[row] for part, row in rows.values()]),
        np.array([part.corrected[row] for part, row in rows.values()], dtype=bool),
    )


def _stop(*workers: Worker | ClonePool) -> None:
    for worker in workers:
        worker.stop()
