"""What the window asks of the rest: proposing points and cloning. Tests hand in their own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import cast

import numpy as np

from cloner import pipeline
from cloner.cloning import CloneOutcome, Progress, clone_folder
from cloner.frames import ViewId
from cloner.project.corrections import no_corrections
from cloner.records.photos import PhotoSet
from cloner.records.points import Corrections, PointSet, ViewPoints
from cloner.refitting import Refitted, refit

ProposedPoints = dict[ViewId, ViewPoints]


@dataclass(frozen=True, slots=True, eq=False)
class Proposed:
    """What proposing found.

    Attributes
    ----------
    points : dict of ViewId to ViewPoints
        Body and face points together.
    known : mapping
        Values of the pipeline that cloning need not find again.
    """

    points: ProposedPoints
    known: Mapping[str, object] = field(default_factory=dict)


def propose_points(photos: PhotoSet, progress: Progress) -> Proposed:
    """Return the proposed points of every photo.

    Parameters
    ----------
    photos : PhotoSet
    progress : callable
        Called with a step's name and a fraction 0..1; may raise Cancelled.

    Raises
    ------
    ClonerError
        If a photo does not show one person as its name says.
    """
    stages = tuple(stage for stage in pipeline.STAGES if stage.name in ("proposals", "points"))
    values, _ = pipeline.run({"photos": photos, "corrections": no_corrections()}, stages=stages, progress=progress)
    body, face = cast(PointSet, values["body_points"]), cast(PointSet, values["face_points"])
    points = {
        view: together([points.views[view] for points in (face, body) if view in points.views])
        for view in photos.photos
    }
    return Proposed(points, {"photos": photos, "proposals": values["proposals"]})


def together(parts: list[ViewPoints]) -> ViewPoints:
    """Return the points of one view from several sets; the first set that names a point wins."""
    rows = {name: (part, row) for part in reversed(parts) for row, name in enumerate(part.names)}
    return ViewPoints(
        parts[0].view,
        tuple(rows),
        np.array([part.points_px[row] for part, row in rows.values()]).reshape(-1, 2),
        np.array([part.confidence[row] for part, row in rows.values()]),
        np.array([part.corrected[row] for part, row in rows.values()], dtype=bool),
    )


def clone_person(
    photos_dir: Path, out_dir: Path, height_cm: float | None, known: Mapping[str, object], progress: Progress
) -> CloneOutcome:
    """Clone the folder as the command line does, without finding again what is known."""
    return clone_folder(photos_dir, out_dir, height_cm=height_cm, known=known, progress=progress)


@dataclass(frozen=True, slots=True)
class Services:
    """The two long jobs of the window, and the short one after a drag."""

    propose: Callable[[PhotoSet, Progress], Proposed] = propose_points
    clone: Callable[[Path, Path, float | None, Mapping[str, object], Progress], CloneOutcome] = clone_person
    refit: Callable[[Mapping[str, object], Corrections], Refitted] = refit
