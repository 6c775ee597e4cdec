"""Cascaded linear regression on gradient histograms for small features.

Face nets tell ears badly and fail at 90 degrees, and no outline shows what lies inside it. Each stage looks at the
picture and the person's mask around the present guess and says where a feature's points lie; the next looks from there,
later ones closer. What lies on the right is mirrored, so one model serves both sides. Taught on painted heads
(``calibrate_cascades.py``).
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.records.arrays import Array
from cloner.vision.photographs.gradients import gradient_histograms

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.cascade")

Picture = NDArray[np.float32]

#: Named points of the shipped models, without the side; models know further places that have no name.
FEATURES: Final = {
    "front_ear": ("ear_top", "ear_lobe", "ear_outer"),
    "front_nose": ("ala", "subnasale", "nose_tip"),
    "front_chin": ("chin_front", "chin_bottom"),
    "side_ear": ("ear_top", "ear_lobe", "ear_back", "ear_outer"),
    "side_eye": ("eye_outer",),
    "side_nose": ("ala",),
    "side_mouth": ("mouth_corner",),
    "side_bridge": ("nasion", "glabella"),
}
#: Points of the middle, which have no side.
MIDDLE: Final = ("subnasale", "nose_tip", "nasion", "glabella", "chin_front", "chin_bottom")
#: The looked-at window, px.
WINDOW_PX: Final = (64, 80)
MASK_WEIGHT: Final = _CALIBRATED.number("mask_weight", "factor")
ASTRAY: Final = _CALIBRATED.number("astray", "iod")
#: Guesses around the first one, shares of their reach: their agreement tells the error.
_GUESSES: Final = np.array([[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [0.8, 0.8], [-0.8, -0.8],
                            [0.8, -0.8], [-0.8, 0.8]])  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Cascade:
    """The stages for the K points of one feature.

    Attributes
    ----------
    names : tuple of str
        Names of the first points; the middle of these is the feature's middle.
    vertices : (2, K) int64
        The generic human's vertices that the points are, on the person's left and right.
    base : (K, 2) float64
        Mean places around the feature's middle, eye distances, right and down, on the person's left in an upright front
        photo, or of an upright head that looks to the image's left.
    reach : float
        How far around the first guess others are tried, eye distances.
    iods_px : (S,) float64
        Eye distance in each stage's window.
    means, weights, offsets : (S, D), (S, D, 2 K), (S, 2 K) float64
    error : (K, 2) float64
        A point's expected error is the first plus the second times the guesses' spread, eye distances.
    joint : (2 K, 2 K) float64
        Mean products of the points' errors, upright, x and y after each other, squared eye distances.
    """

    names: tuple[str, ...]
    vertices: NDArray[np.int64]
    base: Array
    reach: float
    iods_px: Array
    means: Array
    weights: Array
    offsets: Array
    error: Array
    joint: Array


@dataclass(frozen=True, slots=True, eq=False)
class FeaturePose:
    """Rotation and scale of a feature in a photo.

    Attributes
    ----------
    iod_px : float
        Eye distance at the head's depth.
    tilt : float
        How far the head is turned in the picture, radians: clockwise, in a mirrored look counterclockwise.
    mirrored : bool
        Whether it is the person's right.
    """

    iod_px: float
    tilt: float
    mirrored: bool

    def upright(self) -> Array:
        """Return the (2, 2) rotation, perhaps with mirroring, from the photo to the upright view."""
        c, s = np.cos(self.tilt), np.sin(self.tilt)
        return np.array([[c, s], [-s, c]]) @ np.diag([-1.0 if self.mirrored else 1.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class FoundFeature:
    """Points (K, 2) px in the cascade's order, and their sigmas (K,), eye distances."""

    points_px: Array
    error_iod: Array


@functools.cache
def load_cascades() -> dict[str, Cascade]:
    """Return the shipped models by the names of ``FEATURES`` (made by ``calibrate_cascades.py``)."""
    place = importlib.resources.files("cloner_models") / "cascades.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        data = {name: archive[name].astype(np.float64) for name in archive.files}
    return {
        feature: Cascade(
            names,
            data[f"{feature}_vertices"].astype(np.int64),
            data[f"{feature}_base"],
            float(data[f"{feature}_reach"].ravel()[0]),
            *(data[f"{feature}_{key}"] for key in ("iods_px", "means", "weights", "offsets", "error", "joint")),
        )
        for feature, names in FEATURES.items()
    }


def side_names(feature: str, side: str) -> tuple[str, ...]:
    """Return the names of a feature's points on the side "L" or "R"; those of the middle are the same on both."""
    return tuple(name if name in MIDDLE else f"{name}_{side}" for name in FEATURES[feature])


def prepare(rgb: NDArray[np.uint8], mask: NDArray[np.uint8], scale: float) -> tuple[Picture, Picture]:
    """Return the grey photo and mask (h, w), downscaled.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) uint8, 0..255
    scale : float
    """
    size = (max(8, round(rgb.shape[1] * min(scale, 1.0))), max(8, round(rgb.shape[0] * min(scale, 1.0))))
    grey = cv2.cvtColor(cv2.resize(rgb, size, interpolation=cv2.INTER_AREA), cv2.COLOR_RGB2GRAY)
    person = cv2.resize(mask, size, interpolation=cv2.INTER_AREA)
    smooth = cv2.GaussianBlur(grey.astype(np.float32), (0, 0), 0.7)
    return np.asarray(smooth, np.float32), np.asarray(cv2.GaussianBlur(person.astype(np.float32), (0, 0), 1.0))


def describe_window(
    pictures: tuple[Picture, Picture], middle_px: Array, pose: FeaturePose, window_iod_px: float
) -> Array:
    """Return the descriptor (D,) of the upright window around a point (2,) of grey photo and mask.

    ``middle_px`` and ``pose`` are in the photo's pixels of the pictures' own size.
    """
    linear = window_iod_px / pose.iod_px * pose.upright()
    centre = np.array(WINDOW_PX) / 2.0 - 0.5
    to_window = np.column_stack([linear, centre - linear @ middle_px])
    seen = [
        cv2.warpAffine(image, to_window, WINDOW_PX, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        for image in pictures
    ]
    return np.concatenate(
        [gradient_histograms(seen[0]), gradient_histograms(np.asarray(MASK_WEIGHT * seen[1], np.float32))]
    )


def run_cascade(
    cascade: Cascade, levels: dict[float, tuple[Picture, Picture, Array]], middle_px: Array, pose: FeaturePose
) -> Array:
    """Return the points (K, 2) px that the stages reach from a guess of the feature's middle.

    ``levels`` holds for each eye distance of the stages the photo and the mask at that size, and the factors (2,) of
    their sizes.
    """
    back = pose.iod_px * pose.upright().T
    points = middle_px + cascade.base @ back.T
    stages = zip(cascade.iods_px, cascade.means, cascade.weights, cascade.offsets, strict=True)
    for iod_px, mean, weights, offset in stages:
        grey, person, factor = levels[float(iod_px)]
        there = FeaturePose(pose.iod_px * float(factor[0]), pose.tilt, pose.mirrored)
        seen = describe_window((grey, person), (middle_px + 0.5) * factor - 0.5, there, float(iod_px))
        points = middle_px + (((seen - mean) @ weights + offset).reshape(-1, 2) + cascade.base) @ back.T
        middle_px = points[: len(cascade.names)].mean(axis=0)
    return np.asarray(points)


def find_feature(
    cascade: Cascade, rgb: NDArray[np.uint8], mask: NDArray[np.uint8], guess_px: Array, pose: FeaturePose
) -> FoundFeature:
    """Return a feature near a guess: the median of the results from several guesses.

    Parameters
    ----------
    cascade : Cascade
    rgb : (H, W, 3) uint8
    mask : (H, W) uint8, 0..255
    guess_px : (2,) the feature's middle, roughly
    pose : Pose
    """
    # Only what the windows may see is shrunk: a whole photo takes ten times as long.
    reach = pose.iod_px * (ASTRAY + float(np.hypot(*WINDOW_PX)) / 2.0 / float(cascade.iods_px.min()))
    low = np.clip(np.floor(guess_px - reach), 0.0, np.array(rgb.shape[1::-1]) - 2.0).astype(int)
    high = np.maximum(np.ceil(guess_px + reach).astype(int), low + 2)
    rgb, mask = rgb[low[1] : high[1], low[0] : high[0]], mask[low[1] : high[1], low[0] : high[0]]
    levels = {}
    for iod_px in sorted({float(one) for one in cascade.iods_px}):
        pictures = prepare(rgb, mask, iod_px / pose.iod_px)
        levels[iod_px] = (*pictures, np.array(pictures[0].shape[::-1]) / np.array(rgb.shape[1::-1]))
    starts = guess_px - low + cascade.reach * pose.iod_px * _GUESSES
    reached = np.stack([run_cascade(cascade, levels, start, pose) for start in starts])
    points = np.median(reached, axis=0)
    spread = float(np.median(np.linalg.norm(reached - points, axis=2))) / pose.iod_px
    # The last digits hang on where in memory the pictures lie: what follows would carry them into every byte.
    return FoundFeature(np.round(points + low, 3), np.round(cascade.error[:, 0] + cascade.error[:, 1] * spread, 6))
