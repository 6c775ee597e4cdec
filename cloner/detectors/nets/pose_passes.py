"""The two passes of the pose net: at the detector's crop, then at the crop of its own points. No net here."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.nets.anchors import sigmoid
from cloner.detectors.nets.mask_crops import MaskNet
from cloner.detectors.nets.placing import circle_crop, full_crop
from cloner.detectors.nets.portraits import is_cut_below, mask_agreement, portrait_crop
from cloner.detectors.nets.results import Box, PoseResult
from cloner.vision.photographs.crops import Crop, move_points, photo_px_from_crop

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.pose_passes")

Photo = NDArray[np.uint8]
Floats = NDArray[np.float64]
PoseNet = Callable[[Photo, Crop], dict[int, NDArray[np.float32]]]
"""Give the pose net's outputs of a crop by their number of values."""

#: Side of the pose net's input, px.
POSE_SIDE: Final = 256
CONFIRMED: Final = _CALIBRATED.number("confirmed", "score")
_COVERED: Final = _CALIBRATED.number("covered", "share")
_INSIDE: Final = _CALIBRATED.number("inside", "share")


@dataclass(frozen=True, slots=True, eq=False)
class PosePass:
    """Output of the pose net for one crop of a photo."""

    out: dict[int, NDArray[np.float32]]
    crop: Crop

    @property
    def points_px(self) -> Floats:
        """Return the net's 39 points in photo px; 33 and 34 are the body's circle."""
        table = self.out[195].reshape(39, 5)[:, :2].astype(np.float64) - 0.5
        return np.asarray(move_points(table, photo_px_from_crop(self.crop, width=POSE_SIDE, height=POSE_SIDE)))

    @property
    def score(self) -> float:
        """Return the probability of a person, 0..1."""
        return float(self.out[1].ravel()[0])

    @property
    def mask(self) -> Floats:
        """Return the probability (256, 256) of the person in the crop."""
        return sigmoid(self.out[POSE_SIDE * POSE_SIDE].reshape(POSE_SIDE, POSE_SIDE))

    @property
    def next_crop(self) -> Crop:
        """Return the crop for the next pass."""
        points = self.points_px
        return circle_crop(points[33], points[34], 1.25)

    def box(self, score: float) -> Box:
        """Return the body's box."""
        points = self.points_px
        x, y = points[33].tolist()
        reach = float(np.hypot(*(points[34] - points[33])))
        half = 0.45 * reach  # measured: outstretched hands of the visitors
        keys = np.stack([points[33], points[34], (points[11] + points[12]) / 2, points[0]])
        return Box("person", x - half, y - reach, x + half, y + reach, score, keys)

    def result(self, mask: NDArray[np.float32]) -> PoseResult:
        """Return the pose with a mask of the whole photo."""
        table = self.out[195].reshape(39, 5)[:33]
        return PoseResult(
            points_px=self.points_px[:33],
            visibility=sigmoid(table[:, 3]),
            presence=sigmoid(table[:, 4]),
            score=self.score,
            mask=mask,
        )


def run_pose(photo: Photo, crop: Crop, net: PoseNet) -> PosePass:
    """Return one pass."""
    return PosePass(net(photo, crop), crop)


def run_pose_twice(photo: Photo, crop: Crop, net: PoseNet) -> PosePass:
    """Return the second pass, at the crop that the first points give."""
    return run_pose(photo, run_pose(photo, crop, net).next_crop, net)


def shows_hips(found: PosePass, photo: Photo) -> bool:
    """Return whether the photo shows the hips: a whole body, not a portrait."""
    return bool(found.points_px[23:25, 1].max() < _INSIDE * photo.shape[0])


def run_portrait_pose(photo: Photo, net: PoseNet, mask_net: MaskNet, doubted: PosePass | None) -> PosePass | None:
    """Return the pose of a person whom the lower edge cuts, or the doubted one.

    Parameters
    ----------
    photo : (H, W, 3) uint8
    net, mask_net
        The pose net, and one that gives near people's masks.
    doubted : Pass or None
        A pose with hips inside the photo; it stays when it covers the person better.
    """
    person = mask_net(photo, full_crop(photo))
    if not is_cut_below(person):
        return doubted
    shape = (photo.shape[0], photo.shape[1])
    found = run_pose_twice(photo, portrait_crop(person, shape), net)
    share = mask_agreement(found.mask, found.crop, person, shape)
    if found.score < CONFIRMED or share < _COVERED:
        return doubted
    before = 0.0 if doubted is None else doubted.score * mask_agreement(doubted.mask, doubted.crop, person, shape)
    return found if found.score * share > before else doubted
