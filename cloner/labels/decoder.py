"""The label net: a small decoder over features of the pose and selfie nets, for labels and for the body under clothes.

The two nets were taught by their makers on photographs of real people and stay as they are; the decoder's weights come
from ``generic_models/build/train_labels.py``. It is small enough to be computed with matrix products and OpenCV's
filters, so no second model format is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from importlib.resources import files
from typing import Final, NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated

#: What each number is and where it comes from: ``cloner/calibration/labels.toml``.
_CALIBRATED: Final = calibrated("labels.decoder")

Floats = NDArray[np.float32]

#: Side of the crop that the nets see and of the scores that come back, px.
SIDE_PX: Final = 256
#: Sides of the maps of points and of parts, px.
POINT_SIDE_PX: Final = 64
PART_SIDE_PX: Final = 128
WIDEST: Final = _CALIBRATED.number("widest", "sigmas")
#: Which features enter at which side of the pyramid, px; 9 and 10 are the person masks of both nets.
LEVELS: Final = ((16, (3, 8)), (32, (2, 7)), (64, (1, 4, 6)), (128, (0, 5)), (256, (9, 10)))


@lru_cache(maxsize=1)
def _weights() -> dict[str, Floats]:
    """Load the decoder's arrays once per process."""
    with (files("cloner_models") / "label_net.npz").open("rb") as file, np.load(file) as arrays:
        return {name: np.asarray(arrays[name], np.float32) for name in arrays.files}


class Scores(NamedTuple):
    """Output of the decoder for a crop, before any softmax.

    Attributes
    ----------
    classes : (11, 256, 256) float32
        The classes are ``cloner.records.labels.Label``.
    points : (21, 64, 64) float32
        Where each of ``cloner.generic.seen_points.NAMES`` lies.
    parts : (15, 128, 128) float32
        Of the naked body, in the order of ``cloner.labels.naked_edges``; 0 is none.
    """

    classes: Floats
    points: Floats
    parts: Floats


def decode(features: Sequence[Floats], rgb: NDArray[np.uint8]) -> Scores:
    """Return the logits of every class, of every point's heat map and of every part of the naked body for a crop.

    Parameters
    ----------
    features : sequence of 11 (h, w, C) float32
        Inner tensors and masks as ``cloner.detectors.nets.litert.label_features`` gives them.
    rgb : (256, 256, 3) uint8
        The crop.
    """
    weights = _weights()
    planes = [_standardise(weights, k, values) for k, values in enumerate(features)]
    picture = np.ascontiguousarray(rgb.transpose(2, 0, 1), np.float32) / np.float32(127.5) - np.float32(1.0)
    x: Floats | None = None
    points: Floats | None = None
    parts: Floats | None = None
    for side, entering in LEVELS:
        joined = [planes[k] for k in entering]
        if side >= SIDE_PX // 2:
            joined.append(_relu(_convolve(weights, f"r{side}", _downsample(picture, side))))
        new = np.concatenate(joined)
        mixed = _pointwise(weights, f"i{side}", new)
        if x is not None:  # mixed before it is enlarged: the same, for a quarter of the work
            mixed += _upsample(_mix_planes(weights[f"i{side}.weight"][:, len(new) :], x))
        x = _relu(mixed)
        block = 0
        while f"b{side}.{block}.dw.weight" in weights:
            x = _depthwise_block(weights, f"b{side}.{block}", x)
            block += 1
        if side == POINT_SIDE_PX:
            points = _pointwise(weights, "p64", x)
        if side == PART_SIDE_PX:
            parts = _pointwise(weights, "p128", x)
    assert x is not None
    assert points is not None
    assert parts is not None
    return Scores(_pointwise(weights, "o", x), points, parts)


def probabilities(scores: Floats, axis: int | tuple[int, int] = 0) -> Floats:
    """Return probabilities (C, h, w) from logits: softmax over the classes, or over each map's (1, 2)."""
    shares = np.exp(scores - scores.max(axis=axis, keepdims=True))
    return np.asarray(shares / shares.sum(axis=axis, keepdims=True), np.float32)


def _standardise(weights: dict[str, Floats], index: int, values: Floats) -> Floats:
    planes = np.ascontiguousarray(values.transpose(2, 0, 1), np.float32)
    if f"m{index}" not in weights:  # a mask is in 0..1 already
        return planes
    mean, scale = weights[f"m{index}"], weights[f"d{index}"]
    planes = (planes - mean[:, None, None]) * scale[:, None, None]
    return np.clip(planes, -WIDEST, WIDEST, out=planes)


def _relu(x: Floats) -> Floats:
    return np.maximum(x, np.float32(0.0), out=x)


def _pointwise(weights: dict[str, Floats], name: str, x: Floats) -> Floats:
    """Return a 1 x 1 convolution of planes (C, h, w) by the first C columns of a matrix."""
    return _mix_planes(weights[f"{name}.weight"][:, : len(x)], x) + weights[f"{name}.bias"][:, None, None]


def _mix_planes(matrix: Floats, x: Floats) -> Floats:
    """Return linear combinations (D, h, w) of planes (C, h, w) by a (D, C) matrix."""
    return np.asarray(matrix @ x.reshape(len(x), -1), np.float32).reshape(len(matrix), *x.shape[1:])


def _depthwise_block(weights: dict[str, Floats], name: str, x: Floats) -> Floats:
    """Return a residual depthwise-separable block."""
    filters, shift = weights[f"{name}.dw.weight"], weights[f"{name}.dw.bias"]
    each = [_filter_plane(plane, kernel) + offset for plane, kernel, offset in zip(x, filters, shift, strict=True)]
    return np.asarray(x + _pointwise(weights, f"{name}.pw", _relu(np.stack(each))), np.float32)


def _convolve(weights: dict[str, Floats], name: str, x: Floats) -> Floats:
    """Return a 3 x 3 convolution of planes (C, h, w)."""
    filters, shift = weights[f"{name}.weight"], weights[f"{name}.bias"]
    summed = [
        sum((_filter_plane(plane, kernel) for plane, kernel in zip(x, bank, strict=True)), np.zeros_like(x[0])) + offset
        for bank, offset in zip(filters, shift, strict=True)
    ]
    return np.stack(summed).astype(np.float32)


def _filter_plane(plane: Floats, kernel: Floats) -> Floats:
    return np.asarray(cv2.filter2D(plane, cv2.CV_32F, kernel, borderType=cv2.BORDER_CONSTANT), np.float32)


def _downsample(picture: Floats, side: int) -> Floats:
    """Return a (C, 256, 256) picture at a smaller side, averaged."""
    step = picture.shape[1] // side
    return np.asarray(picture.reshape(len(picture), side, step, side, step).mean(axis=(2, 4)), np.float32)


def _upsample(x: Floats) -> Floats:
    """Return planes (C, h, w) at twice their size, bilinear."""
    size = (2 * x.shape[2], 2 * x.shape[1])
    return np.stack([cv2.resize(plane, size, interpolation=cv2.INTER_LINEAR) for plane in x])
