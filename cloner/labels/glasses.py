"""The frame of glasses in photos."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.labels.states import State, eyes_span, read_states
from cloner.records.labels import Label, shows
from cloner.records.proposals import Proposal, Proposals
from cloner.vision.segmentation.pieces import connected_pieces, pieces_on

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.glasses")

Flags = NDArray[np.bool_]

_BAND: Final = _CALIBRATED.triple("band", "factor")
_OWN: Final = _CALIBRATED.number("own", "share")
_FACE_PIECE: Final = _CALIBRATED.number("face_piece", "share")


def wears_glasses(proposals: Proposals) -> bool:
    """Return whether the face's front photo shows glasses."""
    front = proposals.views.get(ViewId.FACE_FRONT)
    if front is None or front.face_presence == 0.0:
        return False
    return State.GLASSES in read_states({ViewId.FACE_FRONT: front.labels}, front.face_px)


def glasses_frame(proposal: Proposal) -> Flags:
    """Return the pixels (H, W) of the frame in a photo of somebody who wears glasses."""
    if proposal.face_presence > 0.0:
        return _frame_in_front(proposal.labels, proposal.face_px)
    if proposal.view is ViewId.FACE_SIDE:
        return _frame_from_side(proposal.labels)
    return np.zeros(proposal.labels.shape, np.bool_)


def _frame_in_front(labels: NDArray[np.uint8], face_px: NDArray[np.float64]) -> Flags:
    (x, y), apart = eyes_span(face_px)
    rows, columns = np.ogrid[: labels.shape[0], : labels.shape[1]]
    above, below, aside = (share * apart for share in _BAND)
    band = (rows > y - above) & (rows < y + below) & (np.abs(columns - x) < aside)
    return np.asarray((pieces_on(labels == Label.ACCESSORY, band, _OWN) | worn_before_face(labels)) & band, np.bool_)


def worn_before_face(labels: NDArray[np.uint8]) -> Flags:
    """Return the pixels (H, W) of what is worn before a face, without the scarf or the hat that it touches."""
    found = np.zeros(labels.shape, np.uint8)
    box, pieces, figures = connected_pieces(labels == Label.FACE_SKIN)
    area = figures[:, cv2.CC_STAT_AREA]
    if len(area) > 1:
        large = np.flatnonzero(area[1:] >= _FACE_PIECE * area[1:].max()) + 1
        down, across = np.nonzero(np.isin(pieces, large))
        around = np.column_stack([across + box[1].start, down + box[0].start]).astype(np.int32)
        cv2.fillConvexPoly(found, cv2.convexHull(around), 1)
    return np.asarray((found > 0) & (labels == Label.ACCESSORY), np.bool_)


def _frame_from_side(labels: NDArray[np.uint8]) -> Flags:
    worn = labels == Label.ACCESSORY
    own = shows(labels, Label.FACE_SKIN, Label.EYES)
    rim = (cv2.dilate(worn.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0) & ~worn
    _, pieces = cv2.connectedComponents((worn | rim).astype(np.uint8), connectivity=8)
    count = int(pieces.max()) + 1
    border = np.bincount(pieces[rim], minlength=count)
    skin = np.bincount(pieces[rim & own], minlength=count)
    kept = skin > _OWN * np.maximum(border, 1)
    kept[0] = False
    return np.asarray(kept[pieces] & worn, np.bool_)
