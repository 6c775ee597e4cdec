"""Stage: feature points, proposed from nets and outlines, with corrections on top (method §3)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import Final, cast

import numpy as np

from cloner.body.bone_checks import check_bones
from cloner.calibration.loader import calibrated
from cloner.detectors.body.body_points import ENDS
from cloner.detectors.propagation import propagate_corrections
from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.generic.seen_points import combined_pose
from cloner.parallel import parallel_map
from cloner.records.labels import Label, shows
from cloner.records.loose import LooseRegion
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import FAR, Correction, Corrections, PhotoState, PointSet, StateKind, ViewPoints
from cloner.records.proposals import Proposal, Proposals
from cloner.records.results import Residual, StageResult
from cloner.stages.photo_checks import check_photos
from cloner.vision.segmentation.loose_outline import find_loose

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.points")

#: A point that all faces have, and no body.
FACE_MARK = "nose_tip"
CLOTH_MARGIN = _CALIBRATED.number("cloth_margin", "figure")
CLOTH_TRUST = _CALIBRATED.number("cloth_trust", "factor")
LEAST_FACE = _CALIBRATED.number("least_face", "share")
LEAST_NOSE_TRUST = _CALIBRATED.number("least_nose_trust", "factor")


def apply_corrections(points: ViewPoints, corrections: Mapping[str, Correction], photo: Photo) -> ViewPoints:
    """Return the points with an operator's corrections, which also correct a face's other points.

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
    if FACE_MARK in points.names:
        own = slice(len(points.names))
        positions[own], confidence[own] = propagate_corrections(points, fixed[own], positions[own][fixed[own]])
    return ViewPoints(points.view, tuple(names), positions, confidence, fixed, points.proposed or points, points.states)


def points_for_fit(points: ViewPoints, astray: Collection[str] = ()) -> ViewPoints:
    """Return the points that the fit of the whole body uses.

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
    return ViewPoints(
        before.view,
        names,
        np.array(positions),
        np.array(confidence),
        np.array(kept, dtype=np.bool_),
        None,
        before.states,
    )


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
) -> StageResult:
    """Produce the body's and the face's feature points.

    Raises
    ------
    ClonerError
        If a photo does not show what its name says or a correction lies off the image.
    """
    check_photos(proposals, photos)
    body, face = propose_points(photos, proposals, corrections)
    for view in proposals.views:
        photo = photos.photos[view]
        placed = corrections.points.get(view, {})
        named_face = face[view].names if view in face else ()
        if view in body:
            body[view] = apply_corrections(body[view], {n: c for n, c in placed.items() if n not in named_face}, photo)
        if view in face:
            face[view] = apply_corrections(face[view], {n: c for n, c in placed.items() if n in named_face}, photo)
    tick(1.0)
    sets = [*body.values(), *face.values()]
    sure = [float(points.confidence.mean()) for points in sets if len(points.names)]
    residuals = (Residual("confidence of proposed points", 100.0 * float(np.mean(sure or [0.0])), "percent"),)
    return StageResult({"body_points": PointSet(body), "face_points": PointSet(face)}, residuals, point_warnings(body))


def propose_points(
    photos: PhotoSet, proposals: Proposals, corrections: Corrections
) -> tuple[dict[ViewId, ViewPoints], dict[ViewId, ViewPoints]]:
    """Return the proposed points of the body in every body photo, and of the face where it may be seen."""
    faces = [view for view in proposals.views if view.is_face or view is ViewId.BODY_FRONT]
    faces.sort(key=lambda view: view is not ViewId.FACE_SIDE)  # a profile takes longest: what is short fills the rest

    def propose(view: ViewId | None) -> dict[ViewId, ViewPoints]:
        if view is None:
            return body_proposals(proposals)
        return {view: face_proposals(photos.photos[view], proposals.views[view], corrections)}

    *found, body = parallel_map(propose, [*faces, None])
    face = {view: points for one in found for view, points in one.items()}
    return body, {view: face[view] for view in proposals.views if view in face}


def face_proposals(photo: Photo, proposal: Proposal, corrections: Corrections) -> ViewPoints:
    """Return the proposed points of a face; in a face photo without a detected face, those that corrections tell."""
    found = cast(ViewPoints, DETECTORS.get("face_points")(photo, proposal))
    if photo.view is ViewId.FACE_SIDE and found.names and not (_shows_nose(found) and _shows_face(proposal)):
        found = ViewPoints(photo.view, (), np.zeros((0, 2)), np.zeros(0), np.zeros(0, dtype=np.bool_))
    if photo.view.is_face and not found.names:
        placed = corrections.points.get(photo.view, {})
        keys = {name: np.array([point.x_px, point.y_px]) for name, point in placed.items()}
        found = cast(ViewPoints, DETECTORS.get("complete_face")(photo.view, keys))
    return found


def _shows_nose(points: ViewPoints) -> bool:
    """Return whether a nose tip is reliable at all: all other points of a profile depend on it."""
    return FACE_MARK in points.names and bool(points.confidence[points.names.index(FACE_MARK)] > LEAST_NOSE_TRUST)


def _shows_face(proposal: Proposal) -> bool:
    """Return whether a side photo shows a face beside hair and what is worn: of the tip of a nose alone any line on
    the hair makes a profile.
    """
    face, other = (
        np.count_nonzero(shows(proposal.labels, *kinds))
        for kinds in ((Label.FACE_SKIN, Label.BEARD), (Label.HAIR, Label.ACCESSORY))
    )
    return bool(face >= LEAST_FACE * (face + other))


def body_proposals(proposals: Proposals) -> dict[ViewId, ViewPoints]:
    """Return the proposed points of all body photos, checked against each other."""
    shown = {view: proposal for view, proposal in proposals.views.items() if view.is_body}
    body: dict[ViewId, ViewPoints] = {view: DETECTORS.get("body_points")(proposal) for view, proposal in shown.items()}
    body = check_bones(body, {view: figure_height_px(points) for view, points in body.items()})
    if shows_crotch(body):
        return body
    loose = find_loose({v: (p.person(), *combined_pose(p)) for v, p in shown.items()})
    return body | {view: without_cloth_points(body[view], regions) for view, regions in loose.items()}


def shows_crotch(body: Mapping[ViewId, ViewPoints]) -> bool:
    """Return whether front and back photo show background up to the crotch: then no skirt or coat surrounds the legs.

    Wide thighs that touch look much like a short skirt; a crotch at its usual level tells them apart. An open coat
    shows it in the front photo only.
    """
    flat = [points for view, points in body.items() if view is not ViewId.BODY_SIDE]
    return bool(flat) and all("crotch" in points.names for points in flat)


def without_cloth_points(points: ViewPoints, regions: Sequence[LooseRegion]) -> ViewPoints:
    """Return the points without confidence in those on the outline of loose clothing, with its rows as a state.

    Legs that a skirt hides do not stand together, so nothing is told of that.
    """
    margin = CLOTH_MARGIN * figure_height_px(points)
    hidden = np.zeros(len(points.names), dtype=bool)
    for region in regions:
        hidden |= region.covers(points.points_px, margin_px=margin)
    hidden &= ~np.array([name.startswith(("l_", "r_")) for name in points.names], dtype=bool)
    states = [state for state in points.states if state.kind is not StateKind.LEGS_TOGETHER]
    states += [
        PhotoState(StateKind.LOOSE_OUTLINE, "", "", region.confidence, (float(region.top_px), float(region.bottom_px)))
        for region in regions
    ]
    trust = np.where(hidden & ~points.corrected, CLOTH_TRUST * points.confidence, points.confidence)
    return replace(points, confidence=trust, states=tuple(states))


def point_warnings(body: Mapping[ViewId, ViewPoints]) -> tuple[str, ...]:
    """Return a sentence for each state worth reporting, with its photo's name."""
    return tuple(
        f"{view}: {state.sentence}" for view, points in body.items() for state in points.states if state.sentence
    )
