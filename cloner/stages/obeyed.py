"""Stage: corrections enforced on the joined person, as the last step of the body.

Points on the outline bend the skin around them until the clone's outline passes through them (``obeyed_skin.py``);
joints, and features of head and feet, turn that photo's pose (``obeyed_pose.py``), and the skin in rest pose stays.
Head top and soles set the photo's scale: they are evidence of the fit. Nothing else moves, so that moving a point
again needs this step alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from cloner.detectors.body.body_points import ENDS
from cloner.editing.outline_constraints import posed_photo
from cloner.editing.pose import obey_pose
from cloner.editing.skin import obey_skin
from cloner.editing.targets import PointConstraint
from cloner.frames import ViewId
from cloner.generic.features import named_features
from cloner.generic.load import load_generic
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.points import ANCHOR, FAR, BodyPoints, ObeyedPoint
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.stages.silhouettes import ON_OUTLINE
from cloner.vision.contours.fixed_points import bend_through
from cloner.vision.contours.loops import fill_polygon

#: What is told of points that set the scale.
SCALE_NOTE = "it sets the scale of its photo; hair and soles are no skin that could be laid on it"


def obey(joined: Joined, body_points: BodyPoints, silhouettes: SilhouetteSet) -> tuple[Joined, tuple[ObeyedPoint, ...]]:
    """Return the person with all corrections enforced, and how well each one is met.

    Parameters
    ----------
    joined : Joined
        As fitted; never one that was bent before.
    body_points : BodyPoints
        Only corrected points count.
    silhouettes : SilhouetteSet
        Where loose clothing makes the outline, points move the outline alone: no skin is there.
    """
    placed = [
        (view, name, points.points_px[row])
        for view, points in body_points.views.items()
        if view in joined.views
        for row, name in enumerate(points.names)
        if points.corrected[row]
    ]
    if not placed:
        return joined, ()
    views = {view: posed for view, posed in joined.views.items() if view.is_body}
    scales = [_stature_message(joined, views[view], name, point) for view, name, point in placed if name in ENDS]
    outlines = [PointConstraint(*one) for one in placed if one[1] not in ENDS and _is_on_outline(one[1])]
    on_skin = [target for target in outlines if not _is_on_cloth(silhouettes.views.get(target.view), target.target_px)]
    cloths = [ObeyedPoint(w.view, w.name, "cloth", 0.0, 0.0) for w in outlines if w not in on_skin]
    on_pose = [PointConstraint(*one) for one in placed if one[1] not in ENDS and _is_pose_point(one[1])]
    joints, views, poses = obey_pose(joined.vertices_m, joined.joints_m, views, on_pose)
    vertices, skins = obey_skin(joined.vertices_m, joints, views, on_skin, joined.stature_m)
    vertices = vertices.copy()
    vertices[:, 1] = np.maximum(vertices[:, 1], np.minimum(joined.vertices_m[:, 1], 0.0))  # the floor holds
    features = named_features(load_generic(), vertices)
    person = replace(joined, vertices_m=vertices, joints_m=joints, views={**joined.views, **views}, features_m=features)
    return person, (*scales, *poses, *skins, *cloths)


def _is_on_cloth(silhouette: Silhouette | None, point_px: Array) -> bool:
    if silhouette is None:
        return False
    margin = FAR * float(np.count_nonzero(silhouette.mask.any(axis=1)))
    return any(bool(region.covers(point_px[None], margin_px=margin)[0]) for region in silhouette.loose)


def _is_on_outline(name: str) -> bool:
    return name.startswith(ANCHOR) or (name in load_generic().feature_names and name.startswith(ON_OUTLINE))


def _is_pose_point(name: str) -> bool:
    generic = load_generic()
    return name in generic.joint_names or (name in generic.feature_names and not name.startswith(ON_OUTLINE))


def _stature_message(joined: Joined, posed: PosedView, name: str, point_px: Array) -> ObeyedPoint:
    """Return the message for a head top or sole: how much higher or lower the person's own is in the photo."""
    generic = load_generic()
    part = "head" if name == ENDS[0] else f"{name.removeprefix('sole_')}_foot"
    own = posed_photo(joined.vertices_m, joined.joints_m, posed).pixels[generic.segment(part), 1]
    edge = float(own.min() - 0.5 if name == ENDS[0] else own.max() + 0.5)
    away = abs(edge - float(point_px[1]))
    return ObeyedPoint(posed.view, name, "scale", away, away, 0.0, SCALE_NOTE)


def bend_silhouettes(
    silhouettes: SilhouetteSet, body_points: BodyPoints, obeyed: tuple[ObeyedPoint, ...]
) -> SilhouetteSet:
    """Return the outlines bent through the corrected points on them; the others are the same objects."""
    followed = {(one.view, one.name) for one in obeyed if one.kind in ("outline", "cloth") and one.after_px <= 1.0}
    views: dict[ViewId, Silhouette] = dict(silhouettes.views)
    for view, points in body_points.views.items():
        rows = [k for k, name in enumerate(points.names) if (view, name) in followed]
        if rows and view in views:
            views[view] = _bend_outline(views[view], points.points_px[rows])
    return SilhouetteSet(views)


def _bend_outline(silhouette: Silhouette, fixed_px: Array) -> Silhouette:
    """Return an outline through the points, each on the contour nearest to it."""
    distances = np.stack([cKDTree(contour).query(fixed_px)[0] for contour in silhouette.contours_px])
    whose = np.argmin(distances, axis=0)
    contours, mask = list(silhouette.contours_px), silhouette.mask.copy()
    size = (mask.shape[0], mask.shape[1])
    for number in np.unique(whose):
        before = contours[number]
        contours[number] = bend_through(before, fixed_px[whose == number])
        mask ^= fill_polygon(before, size) ^ fill_polygon(contours[number], size)
    return replace(silhouette, contours_px=tuple(contours), mask=mask)


def run(
    *,
    body_points: BodyPoints,
    joined: Joined,
    silhouettes: SilhouetteSet,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the person and the outlines with corrections enforced, and how well each one is met.

    Residual: the worst distance of the clone from a corrected point, px.
    """
    person, outcomes = obey(joined, body_points, silhouettes)
    tick(0.8)
    outlines = bend_silhouettes(silhouettes, body_points, outcomes) if outcomes else silhouettes
    worst = [one.after_px for one in outcomes if one.kind in ("outline", "pose")]
    residuals = (Residual("corrected point, worst", max(worst), "px"),) if worst else ()
    values: Mapping[str, object] = {"obeyed": person, "obeyed_silhouettes": outlines, "obeyed_points": outcomes}
    return StageResult(values, residuals, warnings_of(outcomes))


def warnings_of(points: tuple[ObeyedPoint, ...]) -> tuple[str, ...]:
    """Return a sentence for every corrected point that could not be met."""
    return tuple(
        f"{one.view}: the corrected point {one.name} could not be obeyed: {one.note}" for one in points if one.is_missed
    )
