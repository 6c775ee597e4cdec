"""The label image of one photo."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.labels.evidence import Floats, LabelEvidence, Photo, Points, resized_to
from cloner.labels.own_skin import relabel_foreign_skin
from cloner.records.labels import Label, shows
from cloner.vision.photographs.head_frame import HeadFrame
from cloner.vision.retouching.repair import nearest_known
from cloner.vision.segmentation.hair_edge import draw_edge
from cloner.vision.segmentation.pieces import connected_pieces

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.photo")


SPECK: Final = _CALIBRATED.number("speck", "factor")
SMALL_BY_NATURE: Final = (Label.EYES, Label.MOUTH)


def label_photo(
    rgb: Photo,
    person: NDArray[np.bool_],
    looks: LabelEvidence,
    face_points: Points | None = None,
    *,
    faced: bool = True,
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return the label of every pixel and its probability.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    person : (H, W) bool
        The person; everything else is background.
    looks : LabelEvidence
        Of the same photo.
    face_points : (468, 2) float64, optional
        Face mesh in px.
    faced : bool
        False of a back.

    Returns
    -------
    labels : (H, W) uint8
        Values of ``cloner.records.labels.Label``.
    confidence : (H, W) uint8
        Probability of the label, 255 is certain.
    """
    labels, sure = _most_likely(looks.whole, person.shape)
    if looks.near is not None and looks.box is not None:
        box = looks.box
        labels[box], sure[box] = _most_likely(looks.near, labels[box].shape)
        _draw_hair(labels, looks.near[Label.HAIR], rgb, person, box, looks.head, face_points)
    labels[~person] = Label.BACKGROUND
    labels = without_collars(labels, looks.head.chin_px)
    labels = without_specks(labels, SPECK * looks.head.head_px**2)
    return (relabel_foreign_skin(rgb, labels, looks.seen_px, faced=faced) if len(looks.seen_px) else labels), sure


def _most_likely(shares: Floats, shape: tuple[int, ...]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return the person's most likely class at the photo's size, and its share of all classes but background."""
    own = shares[1:]
    best = (own.argmax(axis=0) + 1).astype(np.uint8)
    sure = np.round(255 * own.max(axis=0) / np.maximum(own.sum(axis=0), 1e-6)).astype(np.uint8)
    size = (shape[1], shape[0])
    return (
        np.asarray(cv2.resize(best, size, interpolation=cv2.INTER_NEAREST), np.uint8),
        np.asarray(cv2.resize(sure, size, interpolation=cv2.INTER_LINEAR), np.uint8),
    )


def _draw_hair(
    labels: NDArray[np.uint8],
    hair: Floats,
    rgb: Photo,
    person: NDArray[np.bool_],
    box: tuple[slice, slice],
    head: HeadFrame,
    face_points: Points | None,
) -> None:
    """Redraw the hair's edge in the head's box along the photo's own colours, in place."""
    part = labels[box]
    if not (part == Label.HAIR).any():
        return
    coarse = resized_to(hair, part.shape)
    shift = np.array([box[1].start, box[0].start], np.float64)
    face = None if face_points is None else face_points[:, :2] - shift
    fine = draw_edge(rgb[box], coarse, person[box], face, head.head_px, head.ear_px - shift[1])
    lost = (part == Label.HAIR) & ~fine
    part[lost] = _nearest(part, ~lost & (part != Label.HAIR) & person[box], lost)
    part[fine & ~np.isin(part, (Label.EYES, Label.ACCESSORY, Label.BEARD))] = Label.HAIR


def without_collars(labels: NDArray[np.uint8], chin_px: float) -> NDArray[np.uint8]:
    """Return a label image without hair that begins below the chin: hair hangs from the scalp, collars do not.

    Parameters
    ----------
    labels : (H, W) uint8
    chin_px : float
        Row of the chin.
    """
    # a band or a scarf may cross a tail, a beard may join it
    box, pieces, figures = connected_pieces(shows(labels, Label.HAIR, Label.ACCESSORY, Label.BEARD))
    low = figures[:, cv2.CC_STAT_TOP] > chin_px
    low[0] = False
    collar = np.zeros(labels.shape, np.bool_)
    collar[box] = low[pieces] & (labels[box] == Label.HAIR)
    if not collar.any():
        return labels
    cleaned = labels.copy()
    known = ~shows(labels, Label.BACKGROUND, Label.HAIR)
    cleaned[collar] = _nearest(labels, known, collar)
    return cleaned


def without_specks(labels: NDArray[np.uint8], least_px: float) -> NDArray[np.uint8]:
    """Return a label image whose small components have the label of what is nearest to them.

    Parameters
    ----------
    labels : (H, W) uint8
    least_px : float
        Pieces of fewer pixels go, unless they are `SMALL_BY_NATURE` or background.
    """
    small = np.zeros(labels.shape, np.bool_)
    for label in np.unique(labels):
        if label == Label.BACKGROUND or label in SMALL_BY_NATURE:
            continue
        box, pieces, figures = connected_pieces(labels == label)
        few = figures[:, cv2.CC_STAT_AREA] < least_px
        few[0] = False
        small[box] |= few[pieces]
    if not small.any():
        return labels
    cleaned = labels.copy()
    cleaned[small] = _nearest(labels, ~small & (labels != Label.BACKGROUND), small)
    return cleaned


def _nearest(labels: NDArray[np.uint8], known: NDArray[np.bool_], wanted: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the nearest known label of each wanted pixel."""
    if not known.any():
        return np.full(int(wanted.sum()), Label.FACE_SKIN, np.uint8)
    return nearest_known(labels, known, wanted)
