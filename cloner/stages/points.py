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

#: Shoulder breadth over body height in the picture: below it nobody stands square to the camera
#: (sample visitors: front and back 0.19-0.22, side 0.01-0.05).
SQUARE_TO_CAMERA = 0.11


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


def check_order(body: Mapping[ViewId, ViewPoints], proposals: Proposals, photos: PhotoSet) -> None:
    """Refuse photos that were exchanged.

    Raises
    ------
    ClonerError
        If a front or back photo shows the side, the side photo shows the front, or
        front and back are exchanged.
    """
    for view in body:
        proposal = proposals.views[view]
        rows = np.flatnonzero((proposal.mask > 127).any(axis=1))
        height = max(float(rows[-1] - rows[0]), 1.0) if len(rows) else 1.0
        left, right = proposal.pose_px[11], proposal.pose_px[12]
        square = abs(float(left[0] - right[0])) / height > SQUARE_TO_CAMERA
        name = photos.photos[view].name
        hint = "Rename or retake the photos so that each shows what its name says"
        if view is ViewId.BODY_SIDE and square:
            raise ClonerError("this photo shows the person from the front or back, not from the side", hint, name)
        if view is not ViewId.BODY_SIDE and not square:
            raise ClonerError(f"this photo shows the person from the side, not the {view.value[5:]}", hint, name)
        if view is ViewId.BODY_FRONT and left[0] < right[0] and proposal.face_presence == 0.0:
            raise ClonerError("this photo shows the person's back, not the front", hint, name)


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
        If photos were exchanged or a correction lies off the image.
    """
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
    check_order(body, proposals, photos)
    sets = [*body.values(), *face.values()]
    sure = [float(points.confidence.mean()) for points in sets if len(points.names)]
    residuals = (Residual("confidence of proposed points", 100.0 * float(np.mean(sure or [0.0])), "percent"),)
    return StageResult({"body_points": PointSet(body), "face_points": PointSet(face)}, residuals)
