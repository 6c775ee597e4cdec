"""Pyramid blend: images merged band by band, and gaps filled by push-pull.

References
----------
Burt and Adelson 1983, "A multiresolution spline with application to image mosaics".
Gortler et al. 1996, "The lumigraph", section 3.4 (push-pull).
method §9 (Laplacian blend of front and side).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.float32]


def push_pull(values: Image, weight: Image) -> Image:
    """Return an image that keeps ``values`` where the weight is 1 and is smooth elsewhere.

    Parameters
    ----------
    values : (H, W, C) float32
    weight : (H, W) float32 in 0..1; 0 = unknown

    Returns
    -------
    (H, W, C) float32; all zero when nothing is known.
    """
    count = values.shape[2]
    colours, weights = [values * _per_channel(weight, count)], [weight]
    while min(weights[-1].shape) > 1:
        size = ((weights[-1].shape[1] + 1) // 2, (weights[-1].shape[0] + 1) // 2)
        colour = cv2.resize(colours[-1], size, interpolation=cv2.INTER_AREA)
        known = cv2.resize(weights[-1], size, interpolation=cv2.INTER_AREA)
        # Four times the mean weight, at most one: a single known child is enough to decide its parent.
        gain = np.minimum(known * 4.0, 1.0) / np.maximum(known, 1e-12)
        colours.append(_with_channel_axis(colour) * _per_channel(gain, count))
        weights.append(known * gain)
    filled = colours[-1] / _per_channel(np.maximum(weights[-1], 1e-12), count)
    for colour, known in zip(colours[-2::-1], weights[-2::-1], strict=True):
        above = _with_channel_axis(cv2.resize(filled, known.shape[::-1], interpolation=cv2.INTER_LINEAR))
        filled = colour + _per_channel(1.0 - known, count) * above
    return np.asarray(filled, np.float32)


def _with_channel_axis(image: NDArray[np.float32]) -> Image:
    """Restore the channel axis that OpenCV drops from one-channel images."""
    return image if image.ndim == 3 else image[..., None]


def _per_channel(weight: Image, channels: int) -> Image:
    """Return a weight (H, W) repeated for all channels, (H, W, C): multiplies three times as fast."""
    return _with_channel_axis(cv2.merge([weight] * channels))


@dataclass(frozen=True, slots=True, eq=False)
class Layer:
    """One image of a blend, or a crop of it.

    Attributes
    ----------
    image : (h, w, C) float32
        Must hold sensible colours also where the weight is zero, else those leak over the border.
    weight : (h, w) float32 >= 0; weights of several layers need not sum to one
    corner : (int, int)
        Row and column of the crop's first pixel in the whole; multiples of 2**levels, like h and w.
    """

    image: Image
    weight: Image
    corner: tuple[int, int] = (0, 0)


def blend_pyramids(layers: Iterable[Layer], shape: tuple[int, int, int], levels: int) -> Image:
    """Blend images by their Laplacian pyramids, weighted by Gaussian pyramids.

    Every frequency band gets a border as wide as itself: broad light
    differences melt over many pixels while fine detail never ghosts.

    Parameters
    ----------
    layers : iterable of Layer
        Taken one by one, so a generator keeps the peak memory at one layer.
    shape : (H, W, C) of the result; H and W multiples of 2**levels
    levels : int
        Number of halvings; 0 is a plain weighted mean.

    Returns
    -------
    (H, W, C) float32; zero where no layer has any weight nearby.
    """
    height, width, channels = shape
    sums = [np.zeros((height >> k, width >> k, channels), np.float32) for k in range(levels + 1)]
    totals = [np.zeros((height >> k, width >> k), np.float32) for k in range(levels + 1)]
    for layer in layers:
        row, column = layer.corner
        for k, (band, share) in enumerate(_bands(layer.image, layer.weight, levels)):
            place = np.s_[row >> k : (row >> k) + share.shape[0], column >> k : (column >> k) + share.shape[1]]
            band *= _per_channel(share, channels)
            sums[k][place] += band
            totals[k][place] += share
    result: Image | None = None
    for total, band in zip(totals[::-1], sums[::-1], strict=True):
        band /= _per_channel(np.maximum(total, 1e-12), channels)
        result = band if result is None else band + _upsample(result, band.shape)
    assert result is not None
    return result


def _bands(image: Image, weight: Image, levels: int) -> Iterable[tuple[Image, Image]]:
    """Yield Laplacian bands with the weights of the same size, fine to coarse."""
    for _ in range(levels):
        smaller = _with_channel_axis(cv2.pyrDown(image))
        yield image - _upsample(smaller, image.shape), weight
        image, weight = smaller, cv2.pyrDown(weight)
    yield image.copy(), weight


def _upsample(image: Image, shape: tuple[int, ...]) -> Image:
    return _with_channel_axis(cv2.pyrUp(image, dstsize=(shape[1], shape[0])))
