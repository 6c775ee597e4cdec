"""A back photo shows the front photo's figure in the mirror: a pose misread in one of both is taken from the other.

The net was taught on people who face the camera. Long hair behind a head can make it read a back as a side, with both
knees between the legs and elbows on the trunk, while the outline is as clear as in front.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.nets import pose_rows as net
from cloner.frames import ViewId
from cloner.records.arrays import Array
from cloner.records.points import Proposal
from cloner.vision.segmentation.outline_walk import Figure, figure_of

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.pose_twin")

DOUBTED: Final = _CALIBRATED.number("doubted", "share")
APART: Final = _CALIBRATED.number("apart", "figure")
#: Places along every bone that are asked, shares of its length.
_ALONG: Final = np.linspace(0.0, 1.0, 5)
#: Limbs as chains of joints, left and right.
_CHAINS: Final = ((net.SHOULDERS, net.ELBOWS, net.WRISTS), (net.HIPS, net.KNEES, net.ANKLES))


def twins_put_right(views: Mapping[ViewId, Proposal]) -> dict[ViewId, Proposal]:
    """Return the proposals, a front or back pose that its own outline contradicts replaced by the other's mirror image.

    Parameters
    ----------
    views : mapping
        Proposals of all photos; of one body photo alone nothing is changed.
    """
    out = dict(views)
    for view, other in ((ViewId.BODY_FRONT, ViewId.BODY_BACK), (ViewId.BODY_BACK, ViewId.BODY_FRONT)):
        if view in views and other in views:
            out[view] = _with_better_pose(views[view], views[other])
    return out


def _with_better_pose(own: Proposal, twin: Proposal) -> Proposal:
    figure, seen = figure_of(own.mask), figure_of(twin.mask)
    if figure is None or seen is None or figure.cut or seen.cut:
        return own
    moved = mirrored_onto(twin.pose_px, seen, figure)
    facing = 1.0 if own.view is ViewId.BODY_FRONT else -1.0
    if fits(own.pose_px, figure, facing) >= DOUBTED or fits(moved, figure, facing) < DOUBTED:
        return own
    return replace(own, pose_px=moved, pose_visibility=twin.pose_visibility, barefoot=twin.barefoot)


def mirrored_onto(pose_px: Array, seen: Figure, figure: Figure) -> Array:
    """Return (33, 2) where joints lie in a figure seen from the other side, whose outline is the mirror image.

    Heights go with the figures' heights, columns with their middles; left stays the person's left.
    """
    scale = figure.height_px / seen.height_px
    middle, here = (float(np.average(np.arange(each.level.shape[1]), weights=each.level.sum(axis=0)))
                    for each in (seen, figure))  # fmt: skip
    column = here - scale * (pose_px[:, 0] - middle)
    row = figure.top_px[1] + scale * (pose_px[:, 1] - seen.top_px[1])
    return np.column_stack([column, row])


def fits(pose_px: Array, figure: Figure, facing: float) -> float:
    """Return how much of the limbs lies on the person, left and right on their own sides, 0..1.

    Parameters
    ----------
    pose_px : (33, 2) float64
    figure : Figure
    facing : float
        1 where the person's left lies to the image's right, -1 where it lies to its left.
    """
    told = []
    for chain in _CHAINS:
        left, right = (_along([pose_px[pair[side]] for pair in chain]) for side in (net.LEFT, net.RIGHT))
        apart = facing * (left[:, 0] - right[:, 0]) > APART * figure.height_px
        told.append(apart & figure.inside(left) & figure.inside(right))
    return float(np.concatenate(told).mean())


def _along(joints: list[Array]) -> Array:
    """Return (N, 2) places along a chain of joints."""
    return np.concatenate([first + _ALONG[:, None] * (second - first) for first, second in pairwise(joints)])
