"""The product's own label picture of every photo: the one door through which it is judged."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.baking.labelled import PERSON_LEVEL, vet_labels
from cloner.detectors import pose_rows as net
from cloner.frames import ViewId
from cloner.records.labels import LABELS
from cloner.records.photos import PhotoSet
from cloner.records.points import HAIR, Proposal, Proposals
from cloner.vision.plates import EYE_OPENINGS, SKIN_LABEL

Labels = NDArray[np.uint8]

#: Pixels this near to a border of the true labels are not judged (goals.md).
BAND_PX: Final = 3
#: Outline of the lips' inner edge in the face net (MediaPipe's own contour list).
_INNER_LIPS: Final = (78, 191, 80, 81, 82, 13, 312, 311, 310, 415, 308, 324, 318, 402, 317, 14, 87, 178, 88, 95)
#: From the nose to the mouth and as far again lies the chin, in the pose net's points.
_MOUTH: Final = (9, 10)
#: A shoe covers a foot from this share of the way from ankle to knee downwards; taste.
_SHOE_TOP: Final = 0.12


def photo_labels(photos: PhotoSet, proposals: Proposals) -> dict[ViewId, Labels]:
    """Return what the product takes every pixel of every photo for, (H, W) places in `LABELS`.

    Today the product labels skin, hair and cloth by colours; garments, eyes and mouth follow from where the nets'
    points lie. Beards and accessories it does not know.
    """
    vetted = vet_labels(photos, proposals)
    return {view: _labels(vetted.views[view]) for view in photos.photos if view in vetted.views}


def _labels(proposal: Proposal) -> Labels:
    """Return one photo's labels."""
    person = proposal.mask > PERSON_LEVEL
    height, width = person.shape
    rows = np.arange(height)[:, None]
    pose = proposal.pose_px
    hips, feet = float(pose[list(net.HIPS), 1].mean()), _shoe_row(pose)
    worn = np.where(rows < hips, LABELS.index("upper_clothes"), LABELS.index("lower_clothes"))
    if not proposal.barefoot:
        worn = np.where(rows > feet, LABELS.index("shoes"), worn)
    skin = np.where(rows < _chin_row(pose), LABELS.index("face_skin"), LABELS.index("skin"))
    found = np.where(person, np.broadcast_to(worn, (height, width)), 0)
    found = np.where(person & (proposal.labels == SKIN_LABEL), np.broadcast_to(skin, (height, width)), found)
    found = np.where(proposal.labels == HAIR, LABELS.index("hair"), found).astype(np.uint8)
    if proposal.face_presence > 0.0:
        for outline in EYE_OPENINGS:
            _fill(found, proposal.face_px[list(outline)], LABELS.index("eyes"))
        _fill(found, proposal.face_px[list(_INNER_LIPS)], LABELS.index("mouth"))
    return found


def _shoe_row(pose_px: NDArray[np.float64]) -> float:
    ankles, knees = (float(pose_px[list(pair), 1].mean()) for pair in (net.ANKLES, net.KNEES))
    return ankles - _SHOE_TOP * (ankles - knees)


def _chin_row(pose_px: NDArray[np.float64]) -> float:
    mouth = float(pose_px[list(_MOUTH), 1].mean())
    return 2.0 * mouth - float(pose_px[net.NOSE, 1])


def _fill(labels: Labels, outline_px: NDArray[np.float64], label: int) -> None:
    cv2.fillPoly(labels, [np.rint(outline_px).astype(np.int32)], (label,))


def label_ious(found: Labels, true: Labels) -> dict[str, float]:
    """Return the intersection over union of every label that the truth of a photo shows.

    Parameters
    ----------
    found, true : (H, W) uint8, places in `LABELS`

    Returns
    -------
    mapping of label to 0..1
        Without labels of which nothing is left beside the borders.
    """
    if found.shape != true.shape:
        raise ValueError(f"labels of {found.shape} against {true.shape}")
    judged = ~near_borders(true)
    ious = {}
    for label, name in enumerate(LABELS):
        own, right = (found == label) & judged, (true == label) & judged
        if right.any():
            ious[name] = float(np.count_nonzero(own & right) / np.count_nonzero(own | right))
    return ious


def near_borders(labels: Labels) -> NDArray[np.bool_]:
    """Return the (H, W) pixels within `BAND_PX` of another label."""
    reach = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * BAND_PX + 1, 2 * BAND_PX + 1))
    return np.asarray(cv2.dilate(labels, reach) != cv2.erode(labels, reach), bool)
