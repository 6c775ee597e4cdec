"""Feature points: proposals made from nets and outlines, with corrections on top (method §3)."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import Correction, Corrections, PointSet, Proposals, ViewPoints
from cloner.records.results import Residual, StageResult
from cloner.stages.photo_checks import check_photos


def corrected(points: ViewPoints, corrections: Mapping[str, Correction], photo: Photo) -> ViewPoints:
    """Return the points with an operator's corrections on top; corrections win.

    Raises
    ------
    ClonerError
        If a correction names no point of the view or lies off the image.
    """
    names = list(points.names)
    positions, confidence, fixed = points.points_px.copy(), points.confidence.copy(), points.corrected.copy()
    for name, correction in corrections.items():
        if not (0 <= correction.x_px < photo.width_px and 0 <= correction.y_px < photo.height_px):
            raise ClonerError(
                f"the corrected point {name} lies off the image", "Drag it back on to the photo", photo.name
            )
        if name not in names:
            names.append(name)
            positions, confidence = np.vstack([positions, [0.0, 0.0]]), np.append(confidence, 0.0)
            fixed = np.append(fixed, False)
        row = names.index(name)
        positions[row] = correction.x_px, correction.y_px
        confidence[row], fixed[row] = 1.0, True
    return ViewPoints(points.view, tuple(names), positions, confidence, fixed)


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
