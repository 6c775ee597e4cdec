"""Calibration of the pose net's points on a body: ``body_net.npz``, made by generic_models/build/calibrate_body_net.py.

A net point that is called "wrist" lies near a wrist, not in it, and elsewhere when seen from behind. The file holds
for every point its mean place beside a joint of the skeleton and its spread, found on painted people in clothes.
"""

from __future__ import annotations

import functools
import importlib.resources
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from cloner.generic import seen_points
from cloner.generic.load import GenericHuman
from cloner.records.arrays import Array, freeze
from cloner.records.proposals import Proposal

#: How a landmark is seen: in a front or back photo, or on the near or far side of the body in a side photo.
SIDES: Final = ("front", "back", "near", "far")
#: The net errs on photographs a little more than on paintings; taste.
_REAL: Final = 1.3


@dataclass(frozen=True, slots=True)
class Landmark:
    """A net point of the left and of the right side.

    Attributes
    ----------
    name : str
    rows : (left, right) rows of the net's 33 points (BlazePose order); equal for points in the middle
    anchor : str
        Joint without its side ("l_", "r_"), or feature with "{}" for its side; "" of a side for the middle.
    point : str
        Name of the feature point that an operator would correct, with "{}" for its side, or "".
    """

    name: str
    rows: tuple[int, int]
    anchor: str
    point: str

    def base(self, left: bool) -> str:
        """Return the joint or feature that carries the landmark on one side."""
        return self.anchor.format("LR"[not left]) if self._of_feature else f"{'lr'[not left]}_{self.anchor}"

    def corrected_as(self, left: bool) -> str:
        """Return the feature point's name on one side."""
        word, letter = ("left", "L") if left else ("right", "R")
        return self.point.format(letter, word, letter.lower())

    @property
    def _of_feature(self) -> bool:
        return "{" in self.anchor or self.rows[0] == self.rows[1]


#: BlazePose's points by their row, left and right.
LANDMARKS: Final = (
    Landmark("nose", (0, 0), "nose_tip", "nose_tip"),
    Landmark("eye", (2, 5), "pupil_{0}", "pupil_{0}"),
    Landmark("ear", (7, 8), "ear_outer_{0}", "ear_outer_{0}"),
    Landmark("shoulder", (11, 12), "shoulder", "{2}_shoulder"),
    Landmark("elbow", (13, 14), "elbow", "{2}_elbow"),
    Landmark("wrist", (15, 16), "wrist", "{2}_wrist"),
    Landmark("pinky", (17, 18), "pinky1", ""),
    Landmark("index", (19, 20), "index1", ""),
    Landmark("thumb", (21, 22), "thumb2", ""),
    Landmark("hip", (23, 24), "hip", "{2}_hip"),
    Landmark("knee", (25, 26), "knee", "{2}_knee"),
    Landmark("ankle", (27, 28), "ankle", "{2}_ankle"),
    Landmark("heel", (29, 30), "ankle", "heel_{1}"),
    Landmark("toe", (31, 32), "metatarsal", "toe_{1}"),
)


@dataclass(frozen=True, slots=True, eq=False)
class BodyNet:
    """The calibration, for the left side of the body.

    Attributes
    ----------
    offset : (4, M, 3) float64
        Place beside the base in rest pose, model axes, shares of the stature; sides in the order of `SIDES`.
    sigma : (4, M) float64
        Spread along one picture axis, shares of the stature.
    """

    offset: Array
    sigma: Array

    def __post_init__(self) -> None:
        count = len(LANDMARKS)
        freeze(self, offset=(np.float64, (len(SIDES), count, 3)), sigma=(np.float64, (len(SIDES), count)))


@dataclass(frozen=True, slots=True, eq=False)
class NetPoints:
    """A photo's net points and their expected positions.

    Attributes
    ----------
    points_px : (N, 2)
    bases : tuple of str
        The joint or feature that carries each point.
    offset : (N, 3)
        Place beside the base in rest pose, model axes, shares of the stature.
    sigma : (N,)
        Expected error along one picture axis, shares of the stature.
    """

    points_px: Array
    bases: tuple[str, ...]
    offset: Array
    sigma: Array


def base_position(generic: GenericHuman, base: str, vertices_m: Array, joints_m: Array) -> Array:
    """Return the position (3,) of a joint or feature among a body's joints and vertices."""
    if base in generic.joint_names:
        return np.asarray(joints_m[generic.joint(base)], dtype=np.float64)
    return np.asarray(vertices_m[generic.feature(base)], dtype=np.float64)


@functools.cache
def load_body_net() -> BodyNet:
    """Return the shipped calibration.

    Raises
    ------
    ValueError
        If the file was made for other landmarks.
    """
    place = importlib.resources.files("cloner_models") / "body_net.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as data:
        if tuple(data["names"]) != tuple(mark.name for mark in LANDMARKS) or tuple(data["sides"]) != SIDES:
            raise ValueError("body_net.npz was made for other landmarks: run calibrate_body_net.py")
        return BodyNet(data["offset"].astype(np.float64), data["spread"].astype(np.float64))


def net_points(proposal: Proposal, side_shown: str, *, without: Collection[str] = ()) -> NetPoints:
    """Return the calibrated points of one photo; none where the net found no pose.

    Points under clothes are the label net's where it looked for them, the others the pose net's.

    Parameters
    ----------
    side_shown : str
        "front", "back", "left" or "right": the person's side that the camera sees.
    without : collection of str
        Feature points that an operator corrected: the net's opinion of them is left out.
    """
    rows = (
        []
        if not proposal.pose_visibility.any()
        else [*_pose_net_rows(proposal, side_shown), *_label_net_rows(proposal, side_shown)]
    )
    given = [row for row in rows if row.corrected_as not in without]
    return NetPoints(
        np.array([row.point_px for row in given]).reshape(-1, 2),
        tuple(row.base for row in given),
        np.array([row.offset for row in given]).reshape(-1, 3),
        np.array([row.sigma for row in given]),
    )


class _Row(NamedTuple):
    """One point of `NetPoints`, and the name by which an operator corrects it."""

    point_px: Array
    base: str
    offset: Array
    sigma: float
    corrected_as: str


def _pose_net_rows(proposal: Proposal, side_shown: str) -> Iterator[_Row]:
    """Yield the pose net's points, without those that the label net replaces."""
    net = load_body_net()
    for row, mark in enumerate(LANDMARKS):
        middle = mark.rows[0] == mark.rows[1]
        for left in (True,) if middle else (True, False):
            if len(proposal.seen_px) and mark.corrected_as(left) in seen_points.NAMES:
                continue
            own = "" if middle else "left" if left else "right"
            place = SIDES.index(seen_points.visible_aspect(own, side_shown))
            mirrored = side_shown == "right" if middle else not left
            offset = net.offset[place, row] * ((-1.0, 1.0, 1.0) if mirrored else 1.0)
            sigma = _REAL * float(net.sigma[place, row])
            yield _Row(proposal.pose_px[mark.rows[not left]], mark.base(left), offset, sigma, mark.corrected_as(left))


def _label_net_rows(proposal: Proposal, side_shown: str) -> Iterator[_Row]:
    """Yield the label net's points."""
    for point, name in zip(proposal.seen_px, seen_points.NAMES, strict=False):
        yield _Row(point, name, np.zeros(3), seen_points.point_sigma(name, side_shown), name)
