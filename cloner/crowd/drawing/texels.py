"""Downsampling of baked samples to an impostor's texels."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[np.uint8]

SAMPLES: Final = 6  # a texel's side: 3 cost .002 of SSIM at the switch
_GROWN: Final = 3  # texels that colours go on beyond the outline
_UNCOVERED: Final = 255  # no code is as large


def downsample_tiles(colour: Pixels, shape: Pixels, every: int = 2) -> tuple[Pixels, Pixels]:
    """Return the page's texels from its samples; colours and shapes are extended a little beyond the outline.

    A texel of shapes is as large as ``every`` ones of colours; codes are as every second one.
    """
    cover = colour[..., 3:].astype(np.float32) / 255.0
    rgba = _blocks(np.dstack([colour[..., :3] * cover, cover]), SAMPLES)
    solid = _extended(rgba)
    colours = np.dstack([solid, 255.0 * rgba[..., 3:]])
    form = _blocks(np.dstack([shape[..., :3] * cover, cover]), every * SAMPLES)
    codes = _majority_codes(shape[..., 3], cover[..., 0] > 0.5).repeat(2 // every, axis=0).repeat(2 // every, axis=1)
    shapes = np.dstack([_extended(form), codes])
    return tuple(np.clip(np.round(one), 0, 255).astype(np.uint8) for one in (colours, shapes))  # type: ignore[return-value]


def _majority_codes(codes: Pixels, covered: NDArray[np.bool_]) -> Pixels:
    """Return the commonest code of the covered samples of each block of half a page's texel; every third one votes."""
    tall, wide, votes = codes.shape[0] // (2 * SAMPLES), codes.shape[1] // (2 * SAMPLES), 2 * SAMPLES // 3
    picked = np.where(covered, codes, _UNCOVERED)[1::3, 1::3]
    voters = picked.reshape(tall, votes, wide, votes).swapaxes(1, 2).reshape(tall, wide, votes * votes)
    best, most = np.zeros((tall, wide), np.uint8), np.zeros((tall, wide), np.int64)
    for code in np.setdiff1d(picked, [_UNCOVERED]):
        count = (voters == code).sum(axis=2)
        best, most = np.where(count > most, code, best), np.maximum(count, most)
    return best


def _blocks(values: NDArray[np.float32], side: int) -> NDArray[np.float32]:
    """Return means of side x side blocks of (H, W, k)."""
    height, width, parts = values.shape
    out = cv2.resize(values, (width // side, height // side), interpolation=cv2.INTER_AREA)
    return np.asarray(out, np.float32).reshape(height // side, width // side, parts)


def _extended(premultiplied: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (H, W, 3) values of (H, W, 3 + 1) premultiplied ones, extended beyond their coverage."""
    total, weight = premultiplied[..., :3].copy(), premultiplied[..., 3].copy()
    out = np.zeros_like(total)
    filled = weight > 1.0 / 255.0
    out[filled] = total[filled] / weight[filled][:, None]
    for _ in range(_GROWN):
        mass = filled.astype(np.float32)
        near = cv2.blur(mass, (3, 3))
        new = ~filled & (near > 0.01)
        mean = cv2.blur(out * mass[..., None], (3, 3))
        out[new] = mean[new] / near[new][:, None]
        filled = filled | new
    return out
