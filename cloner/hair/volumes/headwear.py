"""Headwear with volume: caps, hats, headscarves."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.labels import Label

CAP_OVER_FACE, CAP_OVER_HAIR = 0.1, 0.5  # a cap's middle lies above this share of the face's rows, or of the hair's


def headwear(labels: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of headwear with volume, unlike glasses and scarves.

    Its pieces lie above nearly all of the face, or above the middle of the hair where a photo shows no face.
    """
    worn: NDArray[np.bool_] = labels == Label.ACCESSORY
    if not worn.any():
        return worn
    face, hair = (np.nonzero(labels == label)[0] for label in (Label.FACE_SKIN, Label.HAIR))
    rows, share = (face, CAP_OVER_FACE) if len(face) else (hair, CAP_OVER_HAIR)
    if not len(rows):
        return np.zeros(labels.shape, np.bool_)
    count, pieces, _, middles = cv2.connectedComponentsWithStats(worn.astype(np.uint8), connectivity=8)
    high = [piece for piece in range(1, count) if middles[piece, 1] < np.quantile(rows, share)]
    return np.asarray(np.isin(pieces, high))
