"""Feature points: proposals made from nets and outlines, with corrections on top (method §3)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

import numpy as np

from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import Correction, Corrections, PointSet, Proposals, ViewPoints
from cloner.records.results import Residual, StageResult
from cloner.stages.photo_checks import check_photos

#: Points that set a body photo's scale.
ENDS = ("head_top", "sole_left", "sole_right")
#: A correction farther than this share of the figure's height from the proposal says that the proposal was wrong:
#: two spreads of the pose net's joints (facts.md: 5-40 px in 1,800 px).
FAR = 0.035


def corrected(points: ViewPoints, corrections: Mapping[str, Correction], photo: Photo) -> ViewPoints:
    """Return the points with an operator's corrections on top; corrections win.

    Raises
    ------
    ClonerError
        If a correction lies off the image.
    """
    if not corrections:
        return points
    names = list(points.names)
    positions, confidence, fixed = points.points_px.copy(), points.confidence.copy(), points.corrected.copy()
    for name, correction in corrections.items():
        if not (0 <= correction.x_px < photo.width_px and 0 <= correction.y_px < photo.height_px):
            raise ClonerError(
                f"{points.view}: the corrected point {name} lies off the image",
                "Drag it back on to the photo",
                photo.name,
            )
        if name not in names:
            names.append(name)
            positions, confidence = np.vstack([positions, [0.0, 0.0]]), np.append(confidence, 0.0)
            fixed = np.append(fixed, False)
        row = names.index(name)
        positions[row] = correction.x_px, correction.y_px
        confidence[row], fixed[row] = 1.0, True
    return ViewPoints(points.view, tuple(names), positions, confidence, fixed, points.proposed or points)


def for_fitting(points: ViewPoints, astray: Collection[str] = ()) -> ViewPoints:
    """Return the points that the fit of the whole body takes.

    Parameters
    ----------
    points : ViewPoints
        Points of a body photo, corrections on top.
    astray : collection of str
        Further points whose corrections count.

    Notes
    -----
    A correction is obeyed in the end, at its own place (``stages/obeyed.py``). Were it evidence for the whole body too,
    that body would move with it: a waist point dragged by 30 px moved other skin by 9 mm at the 95th percentile and
    by 32 mm at most. So the fit keeps the proposals, but for two kinds: head top and soles, which set the photo's
    scale, and joints so far off that the proposal must have been wrong. Points nobody proposed are left out,
    unless astray.
    """
    before = points.proposed
    if before is None:
        return points
    far = FAR * figure_height_px(before)
    rows = []
    for name, position, fixed in zip(points.names, points.points_px, points.corrected, strict=True):
        old = before.get(name)
        is_joint = name.startswith(("l_", "r_"))
        wrong = is_joint and old is not None and float(np.linalg.norm(position - old)) > far
        if fixed and (name in ENDS or name in astray or wrong):
            rows.append((name, position, 1.0, True))
        elif old is not None:
            rows.append((name, old, float(before.confidence[before.names.index(name)]), False))
    names, positions, confidence, kept = zip(*rows, strict=True) if rows else ((), np.zeros((0, 2)), (), ())
    return ViewPoints(before.view, names, np.array(positions), np.array(confidence), np.array(kept, dtype=np.bool_))


def figure_height_px(points: ViewPoints) -> float:
    """Return the distance from the head's top to the soles in a body photo; infinite where either is missing."""
    top, soles = points.get(ENDS[0]), [sole for sole in map(points.get, ENDS[1:]) if sole is not None]
    if top is None or not soles:
        return float("inf")
    return max(float(sole[1]) for sole in soles) - float(top[1])


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    corrections: Corrections,
    tick: Callable[[float], None],
    rng: np.random.Generator,
) -> StageResult:
    """Give the body's and the face's feature points.

    Raises
    ------
    ClonerError
        If a photo does not show what its name says or a correction lies off the image.
    """
    check_photos(proposals, photos)
    body: dict[ViewId, ViewPoints] = {}
    face: dict[ViewId, ViewPoints] = {}
    for view, proposal in proposals.views.items():
        photo = photos.photos[view]
        placed = corrections.points.get(view, {})
        if view.is_body:
            body[view] = DETECTORS.get("body_points")(proposal)
        if view.is_face or view is ViewId.BODY_FRONT:
            face[view] = DETECTORS.get("face_points")(photo, proposal)
        named_face = face[view].names if view in face else ()
        if view in body:
            body[view] = corrected(body[view], {n: c for n, c in placed.items() if n not in named_face}, photo)
        if view in face:
            face[view] = corrected(face[view], {n: c for n, c in placed.items() if n in named_face}, photo)
        tick(len(body) / len(proposals.views))
    sets = [*body.values(), *face.values()]
    sure = [float(points.confidence.mean()) for points in sets if len(points.names)]
    residuals = (Residual("confidence of proposed points", 100.0 * float(np.mean(sure or [0.0])), "percent"),)
    return StageResult({"body_points": PointSet(body), "face_points": PointSet(face)}, residuals)
