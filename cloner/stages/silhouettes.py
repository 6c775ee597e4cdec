"""Silhouettes by heuristic edge linking along the person's mask (paper §3.5)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import BodyPoints, Proposal, Proposals, ViewPoints
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.vision.outlines import Outline, OutlineLoop, extract_outline

#: Named points that lie on the outline and so bound feature segments.
ON_OUTLINE = (
    "head_top", "neck_base", "shoulder_end", "elbow_outer", "elbow_inner", "wrist_outer", "wrist_inner", "waist",
    "hip", "crotch", "knee", "ankle_outer", "ankle_inner", "neck_front", "neck_back", "chest_front", "back",
    "belly_front", "buttock", "thigh", "ankle_front", "ankle_back",
)  # fmt: skip


def outline_points(points: ViewPoints | None) -> NDArray[np.float64] | None:
    """Return the (N, 2) named points on the outline of a body photo, None for a face photo."""
    if points is None:
        return None
    rows = [k for k, name in enumerate(points.names) if name.startswith(ON_OUTLINE) and not name.startswith("ear")]
    return points.points_px[rows] if len(rows) >= 3 else None


def _segment_names(loop: OutlineLoop, number: int, names: list[str]) -> list[str]:
    labels = [names[row] if 0 <= row < len(names) else f"{number}.{k}" for k, row in enumerate(loop.feature_rows)]
    return [f"{labels[k]} - {labels[(k + 1) % len(labels)]}" for k in range(len(labels))]


def silhouette(photo: Photo, proposal: Proposal, points: ViewPoints | None) -> Silhouette:
    """Return one photo's outline.

    Raises
    ------
    ClonerError
        If no outline can be drawn around the person.
    """
    given = outline_points(points)
    outline: Outline = extract_outline(photo.rgb, proposal.mask.astype(np.float32) / 255.0, given)
    if not outline.loops:
        raise ClonerError(
            "the person's outline was not found", "Retake the photo before a plain background", photo.name
        )
    names = (
        [name for name in points.names if name.startswith(ON_OUTLINE) and not name.startswith("ear")]
        if points and given is not None
        else []
    )
    sources: list[tuple[str, str, float]] = []
    for number, loop in enumerate(outline.loops):
        labels = _segment_names(loop, number, names if number == 0 else [])
        sources += [(n, s, float(g)) for n, s, g in zip(labels, loop.sources, loop.goodness, strict=True)]
    return Silhouette(photo.view, tuple(loop.polygon for loop in outline.loops), outline.filled, tuple(sources))


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    body_points: BodyPoints,
    tick: Callable[[float], None],
    rng: np.random.Generator,
) -> StageResult:
    """Give one silhouette a photo; residual: share of the outline that lies on image edges."""
    views: dict[ViewId, Silhouette] = {}
    residuals = []
    for view, proposal in proposals.views.items():
        views[view] = silhouette(photos.photos[view], proposal, body_points.views.get(view))
        linked = [source == "edges" for _, source, _ in views[view].sources]
        residuals.append(Residual("outline on edges", 100.0 * float(np.mean(linked or [False])), "percent", view.value))
        tick(len(views) / len(proposals.views))
    return StageResult({"silhouettes": SilhouetteSet(views)}, tuple(residuals))
