"""Canny edges of a colour photograph, with thresholds read from the photograph itself.

The thresholds are multiples of the photo's own noise.  In a flat region the gradient of noise
has a Rayleigh-distributed length, whose median is ``1.1774 sigma``; most pixels of a photo are
flat, so the median over the region estimates sigma.  Hysteresis starts at ``HIGH_SIGMAS`` and
continues down to ``LOW_SIGMAS``: low enough to see a dark suit before a dark wall, because the
linking after it, not the threshold, decides which edge is the body's.

References
----------
J. Canny, "A computational approach to edge detection", PAMI 1986, sections IV (gradient, ridge)
and VI (noise estimation).
W.-S. Lee, J. Gu, N. Magnenat-Thalmann, "Generating Animatable 3D Virtual Humans from
Photographs", Eurographics 2000, section 3.5.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.photographs.gradients import magnitudes

Floats = NDArray[np.float64]
Image = NDArray[np.float32]
Bools = NDArray[np.bool_]

#: Median of a Rayleigh distribution of unit scale: sqrt(2 ln 2).
RAYLEIGH_MEDIAN = 1.17741
#: Hysteresis thresholds in noise sigmas.  Origin: measurement on the visitors; a Rayleigh
#: variable exceeds 3 sigma once in 90 pixels and 6 sigma never.
LOW_SIGMAS = 3.0
HIGH_SIGMAS = 6.0
#: Least noise, grey levels per pixel: eight-bit rounding after the blur.  Origin: a noise-free
#: drawing would otherwise have a zero threshold and every rounding step would be an edge.
LEAST_NOISE = 0.25
#: Most noise, grey levels per pixel: a crowded background is texture, not noise.  Origin: the
#: noisiest visitor (sigma 4 of 255) reads 1.2.
MOST_NOISE = 1.5
#: Blur before the derivative, px.  Sensor noise and JPEG blocks live on the pixel grid, so this
#: is one of the few lengths which do not scale with the figure.
BLUR_PX = 1.0
#: Sobel 3x3 answers 8 grey levels for a ramp of 1 level per pixel.
SOBEL_GAIN = 8.0
#: Fixed point of the derivatives given to cv2.Canny, which takes int16: 255 levels per pixel
#: times 8 times 16 still fits.
FIXED_POINT = 16.0


@dataclass(frozen=True, slots=True, eq=False)
class EdgeMap:
    """Edges of one photo.

    Attributes
    ----------
    edges : ndarray, shape (H, W), bool
        Thin edge pixels.
    gradient : ndarray, shape (H, W, 2), float32
        Gradient (x, y) of the strongest colour channel, grey levels per px.
    magnitude : ndarray, shape (H, W), float32
        Its length, grey levels per px.
    low, high : float
        The hysteresis thresholds used, grey levels per px.
    """

    edges: Bools
    gradient: Image
    magnitude: Image
    low: float
    high: float


def strongest_gradient(rgb: NDArray[np.uint8], *, blur_px: float = BLUR_PX) -> Image:
    """Return per pixel the gradient of the colour channel that changes most.

    Parameters
    ----------
    rgb : ndarray, shape (H, W, 3), uint8
    blur_px : float
        Sigma of the Gaussian before the derivative, px; 0 leaves the photo as it is.

    Returns
    -------
    ndarray, shape (H, W, 2), float32
        (x, y) in grey levels per px.  The strongest channel sees a red shirt before a green
        wall of equal brightness, which a grey photo would not.
    """
    smooth = rgb.astype(np.float32)
    if blur_px > 0:
        smooth = cv2.GaussianBlur(smooth, (0, 0), blur_px, borderType=cv2.BORDER_REPLICATE)
    gain = 1.0 / SOBEL_GAIN
    slopes = [
        cv2.Sobel(smooth, cv2.CV_32F, *order, ksize=3, scale=gain, borderType=cv2.BORDER_REPLICATE)
        for order in ((1, 0), (0, 1))
    ]
    (best_x, best_y), *others = zip(*map(cv2.split, slopes), strict=True)
    best = magnitudes(best_x, best_y)
    for x, y in others:
        length = magnitudes(x, y)
        wins = cv2.compare(length, best, cv2.CMP_GT)
        for source, target in ((x, best_x), (y, best_y), (length, best)):
            cv2.copyTo(source, wins, target)
    return np.asarray(cv2.merge([best_x, best_y]), dtype=np.float32)


def noise_level(magnitude: Image, *, region: Bools | None = None) -> float:
    """Return the noise of a gradient, grey levels per px.

    Parameters
    ----------
    magnitude : ndarray, shape (H, W), float32
        Gradient length, grey levels per px.
    region : ndarray, shape (H, W), bool, optional
        Where to look; everywhere by default.

    Returns
    -------
    float
        Median / 1.1774, the sigma of a Rayleigh distribution, between ``LEAST_NOISE`` and
        ``MOST_NOISE``.
    """
    values = magnitude[::2, ::2] if region is None else magnitude[region]
    if values.size == 0:
        return LEAST_NOISE
    return float(np.clip(np.median(values) / RAYLEIGH_MEDIAN, LEAST_NOISE, MOST_NOISE))


def detect_edges(
    rgb: NDArray[np.uint8],
    *,
    blur_px: float = BLUR_PX,
    low_sigmas: float = LOW_SIGMAS,
    high_sigmas: float = HIGH_SIGMAS,
) -> EdgeMap:
    """Find the edges of a colour photo.

    Parameters
    ----------
    rgb : ndarray, shape (H, W, 3), uint8
    blur_px : float
        Gaussian sigma before the derivative, px.
    low_sigmas, high_sigmas : float
        Hysteresis thresholds in units of the photo's own gradient noise.

    Returns
    -------
    EdgeMap
    """
    gradient = strongest_gradient(rgb, blur_px=blur_px)
    magnitude = magnitudes(gradient[..., 0], gradient[..., 1])
    noise = noise_level(magnitude)
    low, high = low_sigmas * noise, high_sigmas * noise
    fixed = np.rint(gradient * np.float32(SOBEL_GAIN * FIXED_POINT)).astype(np.int16)
    scale = SOBEL_GAIN * FIXED_POINT
    edges = cv2.Canny(
        np.ascontiguousarray(fixed[..., 0]),
        np.ascontiguousarray(fixed[..., 1]),
        low * scale,
        high * scale,
        L2gradient=True,
    )
    return EdgeMap(edges > 0, gradient, magnitude, low, high)


def sample(image: Image, points_px: Floats) -> Floats:
    """Read an image at fractional positions, bilinearly.

    Parameters
    ----------
    image : ndarray, shape (H, W) or (H, W, C), float32
    points_px : ndarray, shape (N, 2), float64
        Positions (x, y); outside the image the border's value holds.

    Returns
    -------
    ndarray, shape (N,) or (N, C), float64
    """
    if len(points_px) == 0:
        return np.zeros((0, *image.shape[2:]))
    rows, columns = image.shape[:2]
    x = np.clip(points_px[:, 0], 0, columns - 1)
    y = np.clip(points_px[:, 1], 0, rows - 1)
    left = np.minimum(x.astype(np.intp), max(columns - 2, 0))
    top = np.minimum(y.astype(np.intp), max(rows - 2, 0))
    right, below = np.minimum(left + 1, columns - 1), np.minimum(top + 1, rows - 1)
    fx, fy = x - left, y - top
    if image.ndim == 3:
        fx, fy = fx[:, None], fy[:, None]
    upper = image[top, left] * (1 - fx) + image[top, right] * fx
    lower = image[below, left] * (1 - fx) + image[below, right] * fx
    return np.asarray(upper * (1 - fy) + lower * fy, dtype=np.float64)


def refine_subpixel(edge_map: EdgeMap, pixels_px: Floats) -> Floats:
    """Move edge pixels along their gradient on to the ridge of its magnitude.

    A parabola through the magnitude at -1, 0 and +1 px along the gradient gives the ridge.
    Where the three values do not bulge (corners, crossings) the pixel stays.

    Parameters
    ----------
    edge_map : EdgeMap
    pixels_px : ndarray, shape (N, 2), float64
        Edge pixel centres (x, y).

    Returns
    -------
    ndarray, shape (N, 2), float64
        Positions, moved by at most 0.5 px ... 0.71 px on a diagonal.
    """
    columns, rows = pixels_px[:, 0].astype(np.intp), pixels_px[:, 1].astype(np.intp)
    slope = edge_map.gradient[rows, columns].astype(np.float64)
    length = np.maximum(np.linalg.norm(slope, axis=1), 1e-9)
    direction = slope / length[:, None]
    before = sample(edge_map.magnitude, pixels_px - direction)
    here = edge_map.magnitude[rows, columns].astype(np.float64)
    after = sample(edge_map.magnitude, pixels_px + direction)
    bulge = 2.0 * here - before - after
    ridge = (bulge > 0.02 * here) & (here >= before) & (here >= after)
    shift = np.where(ridge, 0.5 * (after - before) / np.where(ridge, bulge, 1.0), 0.0)
    return np.asarray(pixels_px + np.clip(shift, -0.7, 0.7)[:, None] * direction)
