"""The outline of a face photo's mask for the head fit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.body.outlined import mask_outline_field
from cloner.calibration.loader import calibrated
from cloner.records.arrays import Array
from cloner.records.proposals import Proposal

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.outline")

BORDER: Final = _CALIBRATED.number("border", "share")
#: Fewer samples are no outline.
FEWEST: Final = 20


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
    """An outline: pixels (N, 2), unit outward normals (N, 2), and where hair makes it (N,)."""

    places_px: Array
    normals: Array
    veiled: NDArray[np.bool_]
    tree: cKDTree

    def nearest(self, points_px: Array) -> tuple[Array, NDArray[np.int64]]:
        """Return the distance (N,) px from points to the outline, and the index of its nearest pixel (N,)."""
        gap, which = self.tree.query(points_px)
        return np.asarray(gap), np.asarray(which, dtype=np.int64)


def mask_outline(proposal: Proposal) -> Outline | None:
    """Return the outline of a face photo's mask without what the photo's border cuts, None where there is none."""
    field = mask_outline_field(proposal)
    height, width = proposal.mask.shape
    near, far = BORDER * width, np.array([width, height]) - BORDER * width
    kept = ((field.samples_px > near) & (field.samples_px < far)).all(axis=1)
    if kept.sum() < FEWEST:
        return None
    places = field.samples_px[kept]
    return Outline(places, field.normals[kept], field.veiled[kept], cKDTree(places))
