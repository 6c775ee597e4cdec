"""Nose and chin in a front photo at full resolution, where the face net (192 px) is imprecise."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from cloner.detectors.face.cascade import FeaturePose, FoundFeature, find_feature, load_cascades, side_names
from cloner.records.arrays import Array
from cloner.records.photos import Photo
from cloner.records.proposals import Proposal

#: Features looked for, on each half of the face. Of eyes and lips the net tells more (docs/decisions/).
HALVES: Final = ("front_nose", "front_chin")


def front_pose(pupils_px: Array, side: str) -> FeaturePose:
    """Return the pose of one half of a face, "L" or "R", in its photo; ``pupils_px`` (2, 2) are the
    left and the right.
    """
    across = pupils_px[0] - pupils_px[1]
    tilt = float(np.arctan2(across[1], across[0]))
    return FeaturePose(float(np.linalg.norm(across)), -tilt if side == "R" else tilt, side == "R")


def find_half(
    photo: Photo, proposal: Proposal, names: Sequence[str], points_px: Array, feature: str, side: str
) -> tuple[FoundFeature, FeaturePose]:
    """Return a feature of one half of the face near its named points, and its pose.

    Parameters
    ----------
    photo : Photo
    proposal : Proposal
        Mask of the same photo.
    names : sequence of str
    points_px : (K, 2) float64
        Among them both pupils and the feature's named points.
    feature : str
        One of ``HALVES``.
    side : "L" or "R"
    """
    at = {name: place for name, place in zip(names, points_px, strict=True)}
    pose = front_pose(np.array([at["pupil_L"], at["pupil_R"]]), side)
    guess = np.mean([at[name] for name in side_names(feature, side)], axis=0)
    return find_feature(load_cascades()[feature], photo.rgb, proposal.mask, guess, pose), pose


def find_halves(
    photo: Photo, proposal: Proposal, names: Sequence[str], points_px: Array, feature: str
) -> tuple[list[str], FoundFeature]:
    """Return names and positions of a feature on both halves of the face; midline points are where both agree.

    Parameters are those of ``find_half``.
    """
    found_by_name: dict[str, list[tuple[Array, float]]] = {}
    for side in "LR":
        found, _ = find_half(photo, proposal, names, points_px, feature, side)
        for name, place, error in zip(side_names(feature, side), found.points_px, found.error_iod, strict=False):
            found_by_name.setdefault(name, []).append((place, float(error)))
    places = np.array([np.mean([place for place, _ in both], axis=0) for both in found_by_name.values()])
    return list(found_by_name), FoundFeature(
        places, np.array([np.mean([error for _, error in both]) for both in found_by_name.values()])
    )
