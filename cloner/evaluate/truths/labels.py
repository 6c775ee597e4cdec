"""The product's label images, as they are judged."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.labels import Label
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals

Labels = NDArray[np.uint8]

#: Pixels this near to a border of the true labels are not judged (rulers).
BAND_PX: Final = 3


def photo_labels(photos: PhotoSet, proposals: Proposals) -> dict[ViewId, Labels]:
    """Return what the product takes every pixel of every photo for, (H, W) values of ``Label``."""
    return {view: proposals.views[view].labels for view in photos.photos if view in proposals.views}


def label_ious(found: Labels, true: Labels) -> dict[str, float]:
    """Return the intersection over union of every label that the truth of a photo shows.

    Parameters
    ----------
    found, true : (H, W) uint8, values of ``Label``

    Returns
    -------
    mapping of label to 0..1
        Without labels of which nothing is left beside the borders.
    """
    if found.shape != true.shape:
        raise ValueError(f"labels of {found.shape} against {true.shape}")
    judged = ~near_borders(true)
    ious = {}
    for label in Label:
        own, right = (found == label) & judged, (true == label) & judged
        if right.any():
            ious[label.name.lower()] = float(np.count_nonzero(own & right) / np.count_nonzero(own | right))
    return ious


def near_borders(labels: Labels) -> NDArray[np.bool_]:
    """Return the (H, W) pixels within `BAND_PX` of another label."""
    reach = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * BAND_PX + 1, 2 * BAND_PX + 1))
    return np.asarray(cv2.dilate(labels, reach) != cv2.erode(labels, reach), bool)
