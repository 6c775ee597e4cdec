"""Sharpen a person's probability along the colours of the photo."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.crops import shrink_to
from cloner.vision.hair import head_hair_labels

__all__ = ["MaskParams", "head_hair_labels", "refine_mask"]

Floats = NDArray[np.float32]

WORK_SIDE_PX: Final = 1000  # measured: 900 to 1300 give the same overlap


@dataclass(frozen=True, slots=True)
class MaskParams:
    """Settings of `refine_mask`; all measured on the visitors, none is delicate.

    Parameters
    ----------
    reach : float
        Sigma of the window in which colours are learned, share of the long side.
    noise : float
        Standard deviation added to every colour model, Lab levels.
    trust : float
        Weight of the colours against the given probability.
    limit : float
        Largest log-likelihood ratio a single pixel may claim.
    rounds : int
        How often colours and probability are estimated in turn.
    sure : float
        Probability beyond which a pixel teaches its colour to a model.
    open_band : float
        Pixels within open_band and 1 - open_band are decided anew.
    """

    reach: float = 0.018
    noise: float = 3.0
    trust: float = 0.5
    limit: float = 5.0
    rounds: int = 3
    sure: float = 0.85
    open_band: float = 0.02


def refine_mask(rgb: NDArray[np.uint8], probability: Floats, params: MaskParams | None = None) -> Floats:
    """Sharpen a coarse person probability along the photo's own edges.

    Round each undecided pixel two Gaussian colour models are learned, from the sure
    person and the sure background near it; their log-likelihood ratio is added to the
    coarse log-odds. Colours are local, so a wall in the colour of the shirt harms
    only the places where the two touch.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    probability : (H, W) float32, 0..1
        For example `PoseResult.mask`.
    params : MaskParams, optional

    Returns
    -------
    (H, W) float32, 0..1
        Threshold at 0.5 for a silhouette.
    """
    if rgb.shape[:2] != probability.shape:
        raise ValueError(f"photo {rgb.shape[:2]} and probability {probability.shape} differ")
    settings = params or MaskParams()
    small = shrink_to(rgb, longest=WORK_SIDE_PX)
    size = (small.shape[1], small.shape[0])
    coarse = np.asarray(cv2.resize(probability.astype(np.float32), size, interpolation=cv2.INTER_AREA), np.float32)
    lab = cv2.cvtColor(small, cv2.COLOR_RGB2Lab).astype(np.float32)
    low = settings.open_band
    rows, columns = np.nonzero((coarse > low) & (coarse < 1.0 - low))
    prior = np.log(np.clip(coarse, low, 1 - low) / (1 - np.clip(coarse, low, 1 - low)))
    fine = coarse
    for _ in range(settings.rounds):
        evidence = np.zeros_like(coarse)
        evidence[rows, columns] = _colour_evidence(lab, fine, rows, columns, settings)
        smooth = cv2.GaussianBlur(evidence, (0, 0), 1.0)  # 1 px: camera noise
        fine = (1.0 / (1.0 + np.exp(-(prior + settings.trust * smooth)))).astype(np.float32)
    whole = (rgb.shape[1], rgb.shape[0])
    out = cv2.resize(_one_piece(fine), whole, interpolation=cv2.INTER_LINEAR)
    return np.asarray(np.clip(out, 0.0, 1.0), np.float32)


def _colour_evidence(
    lab: Floats, fine: Floats, rows: NDArray[np.intp], columns: NDArray[np.intp], settings: MaskParams
) -> Floats:
    """Return the log-likelihood ratio person : background at the given pixels."""
    kernel = np.ones((3, 3), np.uint8)
    sigma = settings.reach * max(fine.shape)
    colours = lab[rows, columns]
    fits, support = [], []
    for sure in (fine > settings.sure, fine < 1.0 - settings.sure):
        weight = cv2.erode(sure.astype(np.uint8), kernel).astype(np.float32)
        fit, amount = _gaussian_fit(lab, weight, rows, columns, colours, sigma, settings.noise)
        fits.append(fit)
        support.append(amount)
    known = (support[0] > 0.01) & (support[1] > 0.01)
    ratio = np.clip(fits[0] - fits[1], -settings.limit, settings.limit)
    return np.where(known, ratio, 0.0).astype(np.float32)


def _gaussian_fit(
    lab: Floats,
    weight: Floats,
    rows: NDArray[np.intp],
    columns: NDArray[np.intp],
    colours: Floats,
    sigma: float,
    noise: float,
) -> tuple[Floats, Floats]:
    """Return log density of each pixel's colour in the model round it, and its support."""
    coarser = max(1, int(sigma / 3.0))  # the blur leaves nothing finer
    small = (-(-weight.shape[1] // coarser), -(-weight.shape[0] // coarser))
    whole = (weight.shape[1], weight.shape[0])

    def near(values: NDArray[np.float32]) -> Floats:
        reduced = cv2.resize(values, small, interpolation=cv2.INTER_AREA)
        blurred = cv2.GaussianBlur(reduced, (0, 0), sigma / coarser)
        return np.asarray(cv2.resize(blurred, whole)[rows, columns], np.float32)

    amount = near(weight)
    scale = 1.0 / (amount + 1e-6)
    mean = [near(weight * lab[..., i]) * scale for i in range(3)]
    cov = {
        (i, j): near(weight * lab[..., i] * lab[..., j]) * scale - mean[i] * mean[j]
        for i in range(3)
        for j in range(i, 3)
    }
    a, d, g = (cov[i, i] + noise * noise for i in range(3))
    b, c, e = cov[0, 1], cov[0, 2], cov[1, 2]
    # cofactors of the symmetric covariance
    c00, c01, c02 = d * g - e * e, c * e - b * g, b * e - c * d
    c11, c12, c22 = a * g - c * c, b * c - a * e, a * d - b * b
    det = np.maximum(a * c00 + b * c01 + c * c02, 1.0)
    x, y, z = (colours[:, i] - mean[i] for i in range(3))
    square = c00 * x * x + c11 * y * y + c22 * z * z
    square += 2.0 * (c01 * x * y + c02 * x * z + c12 * y * z)
    return np.asarray(-0.5 * (square / det + np.log(det)), np.float32), amount


def _one_piece(fine: Floats) -> Floats:
    """Remove islands that touch no large part of the person, and pinholes in it."""
    person = (fine > 0.5).astype(np.uint8)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(person, connectivity=8)
    if count <= 1:
        return fine
    areas = stats[1:, cv2.CC_STAT_AREA]
    small = 1 + np.flatnonzero(areas < 0.01 * areas.max())  # keeps a hand cut off by a strap
    cleaned = np.where(np.isin(labels, small), np.minimum(fine, 0.49), fine)
    holes = (cleaned <= 0.5).astype(np.uint8)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(holes, connectivity=4)
    pinholes = np.flatnonzero(stats[:, cv2.CC_STAT_AREA] < 1e-5 * fine.size)
    pinholes = pinholes[pinholes > 0]
    return np.where(np.isin(labels, pinholes), np.maximum(cleaned, 0.51), cleaned).astype(np.float32)
