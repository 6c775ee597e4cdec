"""Named points of the face: by calibrated rules from the net in front, by the profile at the side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.face.cascade import FEATURES, FoundFeature, find_feature, load_cascades
from cloner.detectors.face.face_front_features import HALVES, find_halves, front_pose
from cloner.detectors.face.face_net import FaceNet, load_face_net
from cloner.detectors.face.face_side import WRONG_ERROR, missing_edge_share, side_face_of
from cloner.detectors.face.face_side_features import (
    EAR,
    EAR_PATCH,
    INNER,
    LOST_EAR,
    find_inner_feature,
    is_covered_by_hair,
)
from cloner.detectors.face.hairline import trace_hairline
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.deformation.completion import complete_points, fit_affine
from cloner.records.arrays import Array
from cloner.records.photos import Photo
from cloner.records.points import ViewPoints, face_confidence
from cloner.records.proposals import Proposal

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.face_points")


#: Where the hair begins over the forehead (MPEG-4 11.1), and its expected error: locks and fringes make it vague.
HAIRLINE: Final = "hairline_top"
HAIRLINE_ERROR: Final = _CALIBRATED.number("hairline_error", "iod")
#: Points of a side photo that its outline tells; those inside the face are left to the front photo.
PROFILE: Final = (
    "glabella", "nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front", "chin_bottom",
)  # fmt: skip

FAR_EAR: Final = _CALIBRATED.number("far_ear", "iod")
OWN_ERROR = _CALIBRATED.table("own_error", "factor")
COMPLETED_ERROR: Final = _CALIBRATED.number("completed_error", "iod")
#: Key points from which a front and a side face are completed.
FRONT_KEYS, SIDE_KEYS = 2, 3


def propose_face_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    """Return the named face points of a front or side photo, each with a confidence.

    Parameters
    ----------
    photo : Photo
    proposal : Proposal
        The nets' points and mask of the same photo.

    Returns
    -------
    ViewPoints
        Without points where no face was found. Confidence is exp(-expected error / 10 % of the eye distance).
    """
    if photo.view.is_side:
        return _side_points(photo, proposal)
    return _front_points(photo, proposal)


def _no_points(view: ViewId) -> ViewPoints:
    return ViewPoints(view, (), np.zeros((0, 2)), np.zeros(0), np.zeros(0, dtype=bool))


def _front_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    if proposal.face_presence < 0.5:
        return _no_points(photo.view)
    net = load_face_net()
    points, error = net.rules @ proposal.face_px, net.rule_error.copy()
    rows = [net.names.index(f"pupil_{side}") for side in "LR"]
    if proposal.irises_px.any():
        points[rows], error[rows] = _pupils(net, points, proposal.irises_px), net.iris_error_iod
    iod = float(np.linalg.norm(points[rows[0]] - points[rows[1]]))
    for feature in HALVES if photo.view.is_face else ():
        inside, found = find_halves(photo, proposal, net.names, points, feature)
        at = [net.names.index(name) for name in inside]
        points[at], error[at] = found.points_px, found.error_iod
    for side in "LR":
        ears = [net.names.index(f"{name}_{side}") for name in FEATURES["front_ear"]]
        ear = _front_ear(photo, proposal, points[ears].mean(axis=0), points[rows], side)
        points[ears], error[ears] = ear.points_px, ear.error_iod
    names = net.names
    if photo.view.is_face:
        top = _hairline_top(net, points, proposal, iod)
        if top is not None:
            names, points, error = (*names, HAIRLINE), np.vstack([points, top]), np.append(error, HAIRLINE_ERROR)
    confidence = proposal.face_presence * face_confidence(error)
    return ViewPoints(photo.view, names, points, np.clip(confidence, 0.0, 1.0), np.zeros(len(points), dtype=bool))


def _hairline_top(net: FaceNet, points: Array, proposal: Proposal, iod_px: float) -> Array | None:
    """Return where hair begins above the glabella, None on a bald or covered forehead."""
    glabella, chin = (points[net.names.index(name)] for name in ("glabella", "chin_bottom"))
    up = (glabella - chin) / max(float(np.linalg.norm(glabella - chin)), 1e-6)
    return trace_hairline(proposal.labels, glabella, up, iod_px).top()


def _pupils(net: FaceNet, points: Array, irises_px: Array) -> Array:
    """Return the pupils (2, 2) px, left first, from the irises' centres, corrected for their mean offset."""
    across = points[net.names.index("eye_outer_L")] - points[net.names.index("eye_outer_R")]
    unit = across / max(float(np.linalg.norm(across)), 1e-6) * float(np.linalg.norm(irises_px[0] - irises_px[1]))
    down = np.array([-unit[1], unit[0]])
    aside, below = net.iris_offset_iod
    return np.asarray(irises_px - np.stack([aside * unit + below * down, below * down - aside * unit]))


def _side_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    model = load_face_net().profile
    found = side_face_of(proposal)
    if found is None:
        return _no_points(photo.view)
    doubt = WRONG_ERROR * missing_edge_share(photo.rgb, model, found.fitted)
    kept = [row for row, name in enumerate(found.names) if name in PROFILE]
    names = [found.names[row] for row in kept]
    places = dict(
        zip(names, zip(found.points_px[kept], found.error_iod[kept] * _error_factors(names), strict=True), strict=True)
    )
    for feature in (*INNER, EAR) if photo.view.is_face else ():
        inside, seen = find_inner_feature(photo, proposal, found, feature)
        places |= zip(inside, zip(seen.points_px, seen.error_iod, strict=True), strict=True)
    points = np.array([place for place, _ in places.values()])
    error = np.array([error for _, error in places.values()]) + doubt
    return ViewPoints(photo.view, tuple(places), points, face_confidence(error), np.zeros(len(places), dtype=bool))


def _error_factors(names: Sequence[str]) -> Array:
    """Return the factor of each point's error over the error of all of them."""
    return np.array([OWN_ERROR.get(name, 1.0) for name in names])


def _front_ear(photo: Photo, proposal: Proposal, guess_px: Array, pupils_px: Array, side: str) -> FoundFeature:
    """Return an ear near a guess, with a large sigma where hair covers it or it lies far off.

    ``pupils_px`` (2, 2) are the left and the right one.
    """
    pose = front_pose(pupils_px, side)
    ear = find_feature(load_cascades()["front_ear"], photo.rgb, proposal.mask, guess_px, pose)
    middle = ear.points_px.mean(axis=0)
    far = float(np.linalg.norm(middle - guess_px)) > FAR_EAR * pose.iod_px
    lost = far or is_covered_by_hair(proposal.labels, middle, EAR_PATCH * pose.iod_px)
    return FoundFeature(ear.points_px, np.maximum(ear.error_iod, LOST_EAR if lost else 0.0))


def complete_face(view: ViewId, keys: Mapping[str, Array]) -> ViewPoints:
    """Return all named points of a face that was not found, from the few that an operator placed.

    Parameters
    ----------
    view : ViewId
        FACE_FRONT or FACE_SIDE.
    keys : mapping of str to (2,) float64
        Key points by name, photo px; others than the known names are ignored.

    Returns
    -------
    ViewPoints
        Without points where too few are given: two for a front, three for a side photo.
    """
    generic, net = load_generic(), load_face_net()
    names = PROFILE if view is ViewId.FACE_SIDE else net.names
    known = [name for name in keys if name in names]
    if len(known) < (SIDE_KEYS if view is ViewId.FACE_SIDE else FRONT_KEYS):
        return _no_points(view)
    rest = generic.vertices_m[[generic.feature(name) for name in names]].astype(np.float64)
    rows, goals = np.array([names.index(name) for name in known]), np.array([keys[name] for name in known])
    if view is ViewId.FACE_SIDE:
        flats = [rest[:, [2, 1]] * [facing, -1.0] for facing in (1.0, -1.0)]
    else:
        flats = [rest[:, :2] * [1.0, -1.0]]
    flat = min(flats, key=lambda tried: _rotation_and_mirroring(tried[rows], goals))
    points = complete_points(flat, rows, goals)
    confidence = face_confidence(np.full(len(names), COMPLETED_ERROR))
    return ViewPoints(view, names, points, confidence, np.zeros(len(names), dtype=bool))


def _rotation_and_mirroring(flat: Array, goals: Array) -> float:
    """Return how far a similarity between two point sets is from an upright, unmirrored one: 0 for a pure scale."""
    linear = fit_affine(flat, goals)[:2]
    return float(np.linalg.norm(linear / max(float(np.linalg.norm(linear)), 1e-12) - np.eye(2) / np.sqrt(2.0)))
