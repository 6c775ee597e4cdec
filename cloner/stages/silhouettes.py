"""Stage: silhouettes by heuristic edge linking along the person's mask (paper §3.5)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.generic.seen_points import combined_pose
from cloner.parallel import parallel_map
from cloner.records.loose import LooseRegion
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import ANCHOR, FAR, BodyPoints, ViewPoints
from cloner.records.proposals import Proposal, Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.stages.points import figure_height_px, points_for_fit, shows_crotch
from cloner.vision.contours.outlines import Outline, OutlineLoop, extract_outline
from cloner.vision.segmentation.loose_outline import find_loose

#: Named points that lie on the outline and so bound feature segments.
ON_OUTLINE = (
    "head_top", "neck_base", "shoulder_end", "armpit", "elbow_outer", "elbow_inner", "wrist_outer", "wrist_inner",
    "waist", "hip", "crotch", "knee", "ankle_outer", "ankle_inner", "neck_front", "neck_back", "chest_front", "back",
    "belly_front", "buttock", "thigh", "ankle_front", "ankle_back", ANCHOR,
)  # fmt: skip


def outline_points(points: ViewPoints | None) -> tuple[tuple[str, ...], NDArray[np.float64], NDArray[np.bool_]]:
    """Return names, positions (N, 2) and corrected flags of a body photo's points on the outline; none
    of a face photo.
    """
    if points is None:
        return (), np.zeros((0, 2)), np.zeros(0, dtype=np.bool_)
    rows = [k for k, name in enumerate(points.names) if name.startswith(ON_OUTLINE)]
    return tuple(points.names[k] for k in rows), points.points_px[rows], points.corrected[rows]


def missed_points(contours_px: Sequence[NDArray[np.float64]], points: ViewPoints | None) -> tuple[str, ...]:
    """Return the names of corrected points that an outline misses by more than its uncertainty explains."""
    names, positions, corrected = outline_points(points)
    if points is None or not corrected.any():
        return ()
    nearest, _ = cKDTree(np.concatenate(contours_px)).query(positions)
    far = FAR * figure_height_px(points.proposed or points)
    return tuple(n for n, gap, own in zip(names, nearest, corrected, strict=True) if own and gap > far)


def _segment_names(loop: OutlineLoop, number: int, names: tuple[str, ...]) -> list[str]:
    unnamed = f"gap {number}" if loop.is_hole else f"outline {number}"
    labels = [names[row] if row >= 0 else f"{unnamed} point {k + 1}" for k, row in enumerate(loop.feature_rows)]
    return [f"{labels[k]} - {labels[(k + 1) % len(labels)]}" for k in range(len(labels))]


def silhouette(photo: Photo, proposal: Proposal, points: ViewPoints | None) -> Silhouette:
    """Return one photo's outline for the fit.

    It is traced by the proposed points. Only where an operator's point lies so far off that the outline must have
    been wrong, it is traced again through that point; nearer ones bend it in the end (``stages/obeyed.py``).

    Raises
    ------
    ClonerError
        If no outline can be drawn around the person.
    """
    names, positions, fixed = outline_points(None if points is None else points_for_fit(points))
    mask = proposal.mask.astype(np.float32) / np.float32(255.0)
    outline: Outline = extract_outline(photo.rgb, mask, positions, fixed=fixed)
    if not outline.loops:
        raise ClonerError(
            "the person's outline was not found", "Retake the photo before a plain background", photo.name
        )
    astray = missed_points([loop.polygon for loop in outline.loops], points)
    if points is not None and astray:
        names, positions, fixed = outline_points(points_for_fit(points, astray))
        outline = extract_outline(photo.rgb, mask, positions, fixed=fixed)
    sources: list[tuple[str, str, float]] = []
    for number, loop in enumerate(outline.loops, start=1):
        labels = _segment_names(loop, number, names)
        sources += [(n, s, float(g)) for n, s, g in zip(labels, loop.sources, loop.goodness, strict=True)]
    contours = tuple(loop.polygon for loop in outline.loops)
    return Silhouette(photo.view, contours, outline.filled, tuple(sources), through=astray)


def with_cloth(silhouette: Silhouette, regions: tuple[LooseRegion, ...]) -> Silhouette:
    """Return a silhouette with its loose clothing, holes filled."""
    mask = silhouette.mask.copy()
    for region in regions:
        mask |= region.cloth(mask.shape)
    return replace(silhouette, loose=regions, mask=mask)


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    body_points: BodyPoints,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce one silhouette per photo; the residual is the share of the outline on image edges."""
    views: dict[ViewId, Silhouette] = {}
    residuals = []

    def outlined(view: ViewId) -> Silhouette:
        return silhouette(photos.photos[view], proposals.views[view], body_points.views.get(view))

    for view, found in zip(proposals.views, parallel_map(outlined, proposals.views), strict=True):
        views[view] = found
        linked = [source == "edges" for _, source, _ in views[view].sources]
        residuals.append(Residual("outline on edges", 100.0 * float(np.mean(linked or [False])), "percent", view.value))
        tick(len(views) / len(proposals.views))
    shown = {v: (s.mask, *combined_pose(proposals.views[v])) for v, s in views.items()}
    loose = {} if shows_crotch(body_points.views) else find_loose(shown)
    views |= {view: with_cloth(views[view], regions) for view, regions in loose.items()}
    return StageResult({"silhouettes": SilhouetteSet(views)}, tuple(residuals))
