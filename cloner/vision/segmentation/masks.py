"""Refinement of a person's probability along the photo's colours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.vision.photographs.crops import shrink_to
from cloner.vision.segmentation.colours import colour_ratio, quantise_colours
from cloner.vision.segmentation.limbs import add_feet, finger_zone

#: What each number is and where it comes from: ``cloner/calibration/vision.toml``.
_CALIBRATED: Final = calibrated("vision.masks")

__all__ = ["MaskParams", "refine_mask"]

Floats = NDArray[np.float32]
Bools = NDArray[np.bool_]
Picture = NDArray[np.uint8]

WORK_SIDE_PX: Final = 1000  # measured: 900 to 1300 give the same overlap
WEIGHTS: Final = _CALIBRATED.numbers("weights", "factor")
FINGER_WEIGHTS: Final = _CALIBRATED.numbers("finger_weights", "factor")
STEP_SHARE: Final = _CALIBRATED.number("step_share", "share")
LEAST_STEP = _CALIBRATED.number("least_step", "grey")
MOST_STEP = _CALIBRATED.number("most_step", "grey")
FACE_DEEP: Final = _CALIBRATED.number("face_deep", "share")
DEEP_SHARE: Final = _CALIBRATED.number("deep_share", "share")
PASSED_ON = _CALIBRATED.number("passed_on", "score")
KEPT = _CALIBRATED.number("kept", "score")


@dataclass(frozen=True, slots=True)
class MaskParams:
    """Settings of `refine_mask`, measured on visitors and painted people; none is delicate.

    Parameters
    ----------
    window : float
        Sigma of the window in which colours are counted, share of the long side.
    sure : float
        Probability beyond which a pixel teaches its colour.
    open_band : float
        Pixels within open_band and 1 - open_band are decided anew.
    around : float
        So are those this near to them, share of the long side.
    teachers : float
        Colours are learned this near to them, share of the long side.
    deep : float
        Colours of the person are learned this deep inside, share of the long side; less in thin limbs.
    spreading : float
        Weight of agreement between like neighbours; 400 reaches some 20 px across one colour.
    trust : float
        Weight of what spreads against a pixel's own evidence.
    """

    window: float = _CALIBRATED.number("window", "share")
    sure: float = _CALIBRATED.number("sure", "score")
    open_band: float = _CALIBRATED.number("open_band", "score")
    around: float = _CALIBRATED.number("around", "share")
    teachers: float = _CALIBRATED.number("teachers", "share")
    deep: float = _CALIBRATED.number("deep", "share")
    spreading: float = _CALIBRATED.number("spreading", "factor")
    trust: float = _CALIBRATED.number("trust", "factor")


def refine_mask(
    rgb: Picture,
    probability: Floats,
    pose_points: NDArray[np.float64] | None = None,
    *,
    params: MaskParams | None = None,
) -> Floats:
    """Refine a coarse person probability along the photo's own edges.

    Each undecided pixel weighs the given log-odds with how often its colour occurs on the
    sure person and behind, near and far. What it finds spreads to its neighbours of like
    colour, and halts at the steps of colour usual across this person's outline.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    probability : (H, W) float32, 0..1
        For example `PoseResult.mask`.
    pose_points : (33, 2) float64, optional
        Pose points of a whole body in photo px: feet the mask has lost are looked for, and fingers.
    params : MaskParams, optional

    Returns
    -------
    (H, W) float32, 0..1
        Threshold at 0.5 for a silhouette.
    """
    if rgb.shape[:2] != probability.shape:
        raise ValueError(f"photo {rgb.shape[:2]} and probability {probability.shape} differ")
    settings = params or MaskParams(deep=FACE_DEEP if pose_points is None else 0.0)
    small = shrink_to(rgb, longest=WORK_SIDE_PX)
    size = (small.shape[1], small.shape[0])
    coarse = np.asarray(cv2.resize(probability.astype(np.float32), size, interpolation=cv2.INTER_AREA), np.float32)
    around = np.zeros(coarse.shape, dtype=bool)
    fingers: Floats | None = None
    if pose_points is not None:
        placed = (pose_points[:, :2] + 0.5) * (size[0] / rgb.shape[1]) - 0.5
        coarse, around = add_feet(coarse, placed)
        fingers = finger_zone(coarse.shape, placed)
    odds = _person_log_odds(small, coarse, around, fingers, settings)
    whole = (rgb.shape[1], rgb.shape[0])
    out = cv2.resize(_main_component(odds), whole, interpolation=cv2.INTER_LINEAR)
    return np.asarray(1.0 / (1.0 + np.exp(-out)), np.float32)


def _person_log_odds(
    small: Picture, coarse: Floats, around: Bools, fingers: Floats | None, settings: MaskParams
) -> Floats:
    """Return log odds of the person; far from uncertain pixels those of the coarse probability."""
    side = max(coarse.shape)
    doubt = (coarse > settings.open_band) & (coarse < 1.0 - settings.open_band)
    prior = _log_odds(coarse, 0.005)
    if not doubt.any():
        return prior
    away = cv2.distanceTransform((~doubt).astype(np.uint8), cv2.DIST_L2, 3)
    open_ = (away <= settings.around * side) | (around & (coarse < 0.95))
    taught = (away <= settings.teachers * side) | around
    wide, near = _colour_evidence(small, coarse, taught, around, open_, settings)
    terms = (prior, wide, near, np.ones_like(prior))
    own = sum(weight * term for weight, term in zip(WEIGHTS, terms, strict=True))
    if fingers is not None:
        other = sum(weight * term for weight, term in zip(FINGER_WEIGHTS, terms, strict=True))
        own = own + fingers * (other - own)
    fixed = np.where(coarse > 0.5, PASSED_ON, -PASSED_ON)
    passed = np.where(open_, np.clip(own, -PASSED_ON, PASSED_ON), fixed).astype(np.float32)
    spread = cv2.ximgproc.createFastGlobalSmootherFilter(small, settings.spreading, outline_step(small, coarse))
    total = np.clip(own, -KEPT, KEPT) + settings.trust * spread.filter(passed)
    return np.where(open_, total, prior).astype(np.float32)


def _colour_evidence(
    small: Picture, coarse: Floats, taught: Bools, around: Bools, open_: Bools, settings: MaskParams
) -> tuple[Floats, Floats]:
    """Return log likelihood ratios (H, W) of the colours, global and local; 0 away from the open pixels."""
    kernel = np.ones((3, 3), np.uint8)
    person, behind = (
        cv2.erode(sure.astype(np.uint8), kernel) > 0
        for sure in (taught & (coarse > settings.sure), taught & ~around & (coarse < 1.0 - settings.sure))
    )
    person &= _deep_inside(coarse > settings.sure, settings.deep * max(coarse.shape))
    palette = quantise_colours(np.asarray(cv2.cvtColor(small, cv2.COLOR_RGB2Lab), np.uint8), taught | open_)
    # three pixels round the open ones: the blur below reads them
    wanted = cv2.dilate(open_.astype(np.uint8), kernel, iterations=3) > 0
    wanted &= taught | open_
    ratios = np.zeros((2, *coarse.shape), np.float32)
    window = settings.window * max(coarse.shape)
    ratios[:, wanted] = colour_ratio(palette, person, behind, wanted, window_px=window)
    wide, near = (np.asarray(cv2.GaussianBlur(part, (0, 0), 1.0), np.float32) for part in ratios)  # 1 px: camera noise
    return wide, near


def _deep_inside(sure: Bools, depth_px: float) -> Bools:
    """Return the pixels this deep inside, or `DEEP_SHARE` as deep as the thickest place nearby."""
    depth = cv2.distanceTransform(sure.astype(np.uint8), cv2.DIST_L2, 3)
    reach = 4 * int(np.ceil(depth_px)) + 1
    thickness = cv2.dilate(depth, np.ones((reach, reach), np.uint8))
    return np.asarray(depth > np.minimum(DEEP_SHARE * thickness, depth_px), bool)


def _log_odds(probability: Floats, least: float) -> Floats:
    """Return log odds, clipped to those of ``least`` and one minus it."""
    clipped = np.clip(probability, least, 1.0 - least)
    return np.asarray(np.log(clipped / (1.0 - clipped)), np.float32)


def outline_step(small: Picture, coarse: Floats) -> float:
    """Return the colour step that counts as an edge in this photo, grey levels per pixel.

    Parameters
    ----------
    small : (H, W, 3) uint8
    coarse : (H, W) float32
        Person probability, whose outline is a few px off.
    """
    soft = cv2.GaussianBlur(coarse, (0, 0), 2.0)
    slope = np.stack([cv2.Sobel(soft, cv2.CV_32F, 1, 0), cv2.Sobel(soft, cv2.CV_32F, 0, 1)], axis=-1)
    rim = (coarse > 0.5) & (cv2.erode((coarse > 0.5).astype(np.uint8), np.ones((3, 3), np.uint8)) == 0)
    rows, columns = np.nonzero(rim)
    if len(rows) == 0:
        return MOST_STEP
    inward = slope[rows, columns]
    inward /= np.maximum(np.linalg.norm(inward, axis=1, keepdims=True), 1e-9)
    blurred = cv2.GaussianBlur(small, (0, 0), 2.0).astype(np.float32)
    sides = []
    for reach in (5.0, -5.0):  # px: past the coarse outline's own error
        y = np.clip(np.rint(rows + reach * inward[:, 1]), 0, small.shape[0] - 1).astype(np.intp)
        x = np.clip(np.rint(columns + reach * inward[:, 0]), 0, small.shape[1] - 1).astype(np.intp)
        sides.append(blurred[y, x])
    step = np.abs(sides[0] - sides[1]).max(axis=1)
    return float(np.clip(STEP_SHARE * np.quantile(step, 0.25), LEAST_STEP, MOST_STEP))


def _main_component(odds: Floats) -> Floats:
    """Remove islands that touch no large part of the person, and pinholes."""
    person = (odds > 0.0).astype(np.uint8)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(person, connectivity=8)
    if count <= 1:
        return odds
    areas = stats[1:, cv2.CC_STAT_AREA]
    small = np.zeros(count, dtype=bool)
    small[1:] = areas < 0.01 * areas.max()  # keeps a hand cut off by a strap
    cleaned = np.where(small[labels], np.minimum(odds, -0.05), odds)
    holes = (cleaned <= 0.0).astype(np.uint8)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(holes, connectivity=4)
    pinhole = stats[:, cv2.CC_STAT_AREA] < 1e-5 * odds.size
    pinhole[0] = False
    return np.where(pinhole[labels], np.maximum(cleaned, 0.05), cleaned).astype(np.float32)
