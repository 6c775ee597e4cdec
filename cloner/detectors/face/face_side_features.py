"""Features inside a side photo's outline: ear, outer eye, wing and bridge of the nose, corner of the mouth."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.cascade import FeaturePose, FoundFeature, find_feature, load_cascades, side_names
from cloner.detectors.face.face_side import IOD_M, SideFace
from cloner.records.arrays import Array
from cloner.records.labels import Label
from cloner.records.photos import Photo
from cloner.records.proposals import Proposal

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.face_side_features")


#: Features looked for, the ear in photos of the face alone.
INNER: Final = ("side_eye", "side_nose", "side_mouth", "side_bridge")
EAR: Final = "side_ear"
LOST_EAR: Final = _CALIBRATED.number("lost_ear", "iod")
FAR: Final = _CALIBRATED.table("far", "iod")
EAR_PATCH: Final = _CALIBRATED.number("ear_patch", "iod")


def side_pose(found: SideFace) -> FeaturePose:
    """Return the pose of the head of a fitted profile in its photo."""
    mirrored = found.facing > 0
    linear = -IOD_M * found.fitted.px_from_m[:, :2]
    across = -linear[0, 0] if mirrored else linear[0, 0]
    return FeaturePose(IOD_M * found.fitted.size, float(np.arctan2(linear[1, 0], across)), mirrored)


def find_inner_feature(
    photo: Photo, proposal: Proposal, found: SideFace, feature: str
) -> tuple[list[str], FoundFeature]:
    """Return names and positions of a feature's points near where the fitted profile expects them.

    Parameters
    ----------
    photo : Photo
    proposal : Proposal
        Mask and labels of the same photo.
    found : SideFace
    feature : str
        One of ``INNER`` or ``EAR``.
    """
    side = "R" if found.facing > 0 else "L"
    names = list(side_names(feature, side))
    guess = found.points_px[[found.names.index(name) for name in names]].mean(axis=0)
    pose = side_pose(found)
    seen = find_feature(load_cascades()[feature], photo.rgb, proposal.mask, guess, pose)
    named = slice(0, len(names))
    middle = seen.points_px[named].mean(axis=0)
    lost = float(np.linalg.norm(middle - guess)) > FAR[feature] * pose.iod_px
    lost |= feature == EAR and is_covered_by_hair(proposal.labels, middle, EAR_PATCH * pose.iod_px)
    least = max(float(found.error_iod.min()), LOST_EAR if lost else 0.0)
    return names, FoundFeature(seen.points_px[named], np.maximum(seen.error_iod[named], least))


def is_covered_by_hair(labels: NDArray[np.uint8], middle_px: Array, reach_px: float) -> bool:
    """Return whether hair covers most of a square around a point, or the point lies outside the photo.

    Parameters
    ----------
    labels : (H, W) uint8
        As in ``Proposal``.
    middle_px : (2,) float64
    reach_px : float
        Half the square's width.
    """
    low, high = np.round(middle_px - reach_px).astype(int), np.round(middle_px + reach_px).astype(int) + 1
    patch = labels[max(low[1], 0) : max(high[1], 0), max(low[0], 0) : max(high[0], 0)]
    return patch.size == 0 or float((patch == Label.HAIR).mean()) > 0.5
