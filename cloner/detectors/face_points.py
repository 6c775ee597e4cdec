"""Named feature points of the face: by calibrated rules from the net in front, by the profile at the side."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.face_net import FaceNet, load_face_net
from cloner.detectors.face_side import find_side_face
from cloner.frames import ViewId
from cloner.records.photos import Photo
from cloner.records.points import Proposal, ViewPoints, face_confidence

Array = NDArray[np.float64]

#: Points of a side photo that its outline tells; those inside the face are left to the front photo.
PROFILE: Final = (
    "glabella", "nasion", "nose_tip", "subnasale", "lip_top", "stomion", "lip_bottom", "chin_front", "chin_bottom",
)  # fmt: skip


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
