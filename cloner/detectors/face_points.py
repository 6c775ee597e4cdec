"""Named feature points of the face: by calibrated rules from the net in front, by the profile at the side."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.face_net import FaceNet, load_face_net
from cloner.detectors.face_side import find_side_face
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.completion import complete_points, fit_affine
from cloner.records.photos import Photo
from cloner.records.points import Proposal, ViewPoints, face_confidence

Array = NDArray[np.float64]

#: Points of a side photo that its outline tells; those inside the face are left to the front photo.
PROFILE: Final = (
    "glabella", "nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front", "chin_bottom",
)  # fmt: skip

#: Expected error of points completed from a few key points alone, share of the eye distance (taste).
COMPLETED_ERROR: Final = 0.12
#: Key points from which a front and a side face are completed.
FRONT_KEYS, SIDE_KEYS = 2, 3


def propose_face_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    """Return the named face points of a front or side photo, with a confidence each.

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
    if photo.view in (ViewId.FACE_SIDE, ViewId.BODY_SIDE):
        return _side_points(photo, proposal)
    return _front_points(photo, proposal)


def _none(view: ViewId) -> ViewPoints:
    return ViewPoints(view, (), np.zeros((0, 2)), np.zeros(0), np.zeros(0, dtype=bool))


def _front_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    if proposal.face_presence < 0.5:
        return _none(photo.view)
    net = load_face_net()
    points, error = net.rules @ proposal.face_px, net.rule_error.copy()
    rows = [net.names.index(f"pupil_{side}") for side in "LR"]
    if proposal.irises_px.any():
        points[rows], error[rows] = _pupils(net, points, proposal.irises_px), net.iris_error_iod
    confidence = proposal.face_presence * face_confidence(error)
    return ViewPoints(photo.view, net.names, points, np.clip(confidence, 0.0, 1.0), np.zeros(len(points), dtype=bool))


def _pupils(net: FaceNet, points: Array, irises_px: Array) -> Array:
    """Return the pupils (2, 2) px, left first, from the irises' centres: the net's lie a little beside."""
    across = points[net.names.index("eye_outer_L")] - points[net.names.index("eye_outer_R")]
    unit = across / max(float(np.linalg.norm(across)), 1e-6) * float(np.linalg.norm(irises_px[0] - irises_px[1]))
    down = np.array([-unit[1], unit[0]])
    aside, below = net.iris_offset_iod
    return np.asarray(irises_px - np.stack([aside * unit + below * down, below * down - aside * unit]))


def _side_points(photo: Photo, proposal: Proposal) -> ViewPoints:
    found = find_side_face(proposal, load_face_net().profile)
    if found is None:
        return _none(photo.view)
    kept = [row for row, name in enumerate(found.names) if name in PROFILE]
    confidence = face_confidence(found.error_iod[kept])
    names = tuple(found.names[row] for row in kept)
    return ViewPoints(photo.view, names, found.points_px[kept], confidence, np.zeros(len(kept), dtype=bool))


def complete_face(view: ViewId, keys: Mapping[str, Array]) -> ViewPoints:
    """Return all named points of a face that nobody found, from the few that an operator placed.

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
        return _none(view)
    rest = generic.vertices_m[[generic.feature(name) for name in names]].astype(np.float64)
    rows, goals = np.array([names.index(name) for name in known]), np.array([keys[name] for name in known])
    if view is ViewId.FACE_SIDE:
        flats = [rest[:, [2, 1]] * [facing, -1.0] for facing in (1.0, -1.0)]
    else:
        flats = [rest[:, :2] * [1.0, -1.0]]
    flat = min(flats, key=lambda tried: _turn(tried[rows], goals))
    points = complete_points(flat, rows, goals)
    confidence = face_confidence(np.full(len(names), COMPLETED_ERROR))
    return ViewPoints(view, names, points, confidence, np.zeros(len(names), dtype=bool))


def _turn(flat: Array, goals: Array) -> float:
    """Return how far from upright and unmirrored a map is that lays points on others: 0 for a pure scale."""
    linear = fit_affine(flat, goals)[:2]
    return float(np.linalg.norm(linear / max(float(np.linalg.norm(linear)), 1e-12) - np.eye(2) / np.sqrt(2.0)))
