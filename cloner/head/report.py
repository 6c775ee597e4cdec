"""Report of the head fit: missing evidence and residuals in the photos."""

from __future__ import annotations

import numpy as np

from cloner.frames import ViewId, mm_from_m
from cloner.geometry.outlines.contour_match import match_contour
from cloner.head.evidence import FitLog, FrontEvidence, SideEvidence
from cloner.head.fit import FittedHead, profile_candidates, silhouette_vertices
from cloner.head.jaw import FRONT, SIDE, with_open_jaw
from cloner.head.model import HeadModel
from cloner.records.arrays import Array
from cloner.records.points import FacePoints
from cloner.records.proposals import Proposals
from cloner.records.results import Residual

#: Names that front and side photos both propose.
SHARED = ("nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom")


def warn_missing(front: FrontEvidence | None, side: SideEvidence | None, proposals: Proposals, log: FitLog) -> None:
    """Warn about missing face photos and the consequences."""
    if front is None:
        log.warnings.append("no photo shows the face from the front: the head is the generic one of this build")
    elif front.view is ViewId.BODY_FRONT:
        log.warnings.append("no usable front photo of the face: the face comes from the small one in the body photo")
    if side is None:
        missing = ViewId.FACE_SIDE not in proposals.views
        why = "there is no side photo of the face" if missing else "no profile was found in the side photo of the face"
        log.warnings.append(f"{why}: depths of the face are those of a usual face of this shape")


def report_front(
    model: HeadModel, fitted: FittedHead, front: FrontEvidence | None, points: FacePoints, jaws_rad: Array, log: FitLog
) -> None:
    """Log the residuals of the front photo's points."""
    if front is None or fitted.front is None:
        return
    whole = with_open_jaw(model.generic, model.whole(fitted.head_m), model.joints_m, jaws_rad[FRONT])
    eyes = fitted.front.project(whole[[model.generic.feature(f"pupil_{side}") for side in "LR"]])
    distance = max(float(np.linalg.norm(eyes[0] - eyes[1])), 1e-6)
    error = np.linalg.norm(fitted.front.project(model.net.places.at(whole)) - front.net_px, axis=1)
    view = str(front.view)
    log.residuals.append(Residual("front net points", float(error.mean()), "px", view))
    log.residuals.append(Residual("front net points", 100.0 * float(error.mean()) / distance, "percent", view))
    named = points.views.get(front.view)
    known = [] if named is None else [
        k for k, n in enumerate(named.names) if n in model.generic.feature_names and not n.startswith("ear")
    ]  # fmt: skip
    if named is not None and known:
        vertices = [model.generic.feature(named.names[k]) for k in known]
        error = np.linalg.norm(fitted.front.project(whole[vertices]) - named.points_px[known], axis=1)
        error = 100.0 * error / distance
        log.residuals.append(Residual("front named points", float(error.mean()), "percent", view))
        log.residuals.append(Residual("front named points, worst", float(error.max()), "percent", view))


def report_side(
    model: HeadModel, fitted: FittedHead, side: SideEvidence | None, points: FacePoints, jaws_rad: Array, log: FitLog
) -> None:
    """Log the residuals of the side photo's profile, and how far both photos disagree."""
    if side is None or fitted.side is None:
        return
    whole = with_open_jaw(model.generic, model.whole(fitted.head_m), model.joints_m, jaws_rad[SIDE])
    vertices = silhouette_vertices(whole, profile_candidates(model), fitted.side, side.facing)
    metres = fitted.side.metres_per_pixel(whole[model.generic.feature("nasion")])
    seen = fitted.side.project(whole[vertices])
    kept, target, normal = match_contour(seen, side.contour_px, side.normals_px, gate_px=0.015 / metres)
    error = np.abs(((seen[kept] - target) * normal).sum(axis=1)) * metres
    view = str(ViewId.FACE_SIDE)
    log.residuals.append(Residual("profile", mm_from_m(float(error.mean())) if len(kept) else 0.0, "mm", view))
    apart = height_disagreement_m(model, fitted, side, points, jaws_rad)
    if apart is not None:
        log.residuals.append(Residual("height disagreement", mm_from_m(apart), "mm", view))


def height_disagreement_m(
    model: HeadModel, fitted: FittedHead, side: SideEvidence | None, points: FacePoints, jaws_rad: Array
) -> float | None:
    """Return the mean difference in height of `SHARED` points between the photos, None where one is missing.

    A profile that was laid on hair or a hood agrees with its own outline, and not with the front photo.
    """
    front = points.views.get(ViewId.FACE_FRONT)
    if side is None or front is None or fitted.front is None or fitted.side is None:
        return None
    whole = with_open_jaw(model.generic, model.whole(fitted.head_m), model.joints_m, jaws_rad[SIDE])
    beside = dict(zip(side.names, side.points_px, strict=True))
    heights = []
    for name in SHARED:
        from_front, from_side = front.get(name), beside.get(name)
        if from_front is not None and from_side is not None:
            near = whole[[model.generic.feature(name)]]
            pair = [c.back_project(p[None], near)[0, 1] for c, p in
                    ((fitted.front, from_front), (fitted.side, from_side))]  # fmt: skip
            heights.append(abs(pair[0] - pair[1]))
    return float(np.mean(heights)) if heights else None
