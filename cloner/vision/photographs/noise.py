"""Noise of dim photos, which would become a grain on skin and cloth.

Non-local means (A. Buades, B. Coll, J.-M. Morel, A non-local algorithm for image denoising, 2005) as OpenCV has them;
photos with as little noise as those of a usual camera stay as they are.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.records.photos import Photo, PhotoSet
from cloner.remembered import once_each

#: Noise from which a photo is cleaned, levels at half its size: the samples' photos, JPEG included, have up to 1.9,
#: generated people's photos of weak light 2.6 to 7.5.
NOISY: Final = 2.5
#: Strength for brightness and for colours against the noise: less leaves grain, twice as much blurs folds (looked at).
STRENGTH, COLOUR_STRENGTH = 1.0, 1.4
#: Sides of the patches compared and of the window searched, px (OpenCV's own are 7 and 21: slower, no better here).
PATCH_PX, SEARCH_PX = 5, 15
#: Median of the absolute value of a normal error, in its standard deviation.
MEDIAN_OF_NORMAL: Final = 0.6745


def noise_level(rgb: NDArray[np.uint8]) -> float:
    """Return the standard deviation of a photo's noise, levels, at half its size: JPEG hides it at full size.

    From the median of the finest diagonal differences (D. Donoho, I. Johnstone, 1994).
    """
    half = cv2.resize(rgb, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA).astype(np.float32)
    height, width = half.shape[0] // 2 * 2, half.shape[1] // 2 * 2
    half = half[:height, :width]
    diagonal = (half[::2, ::2] - half[1::2, ::2] - half[::2, 1::2] + half[1::2, 1::2]) / 2.0
    return float(np.median(np.abs(diagonal), axis=(0, 1)).mean() / MEDIAN_OF_NORMAL)


@once_each
def quiet_rgb(photo: Photo) -> NDArray[np.uint8]:
    """Return a photo's pixels (H, W, 3) without its noise; its own where it has little."""
    level = noise_level(photo.rgb)
    if level < NOISY:
        return photo.rgb
    strengths = STRENGTH * level, COLOUR_STRENGTH * level
    cleaned = cv2.fastNlMeansDenoisingColored(photo.rgb, None, *strengths, PATCH_PX, SEARCH_PX)
    return np.asarray(cleaned, np.uint8)


def quieted(photos: PhotoSet) -> PhotoSet:
    """Return the photos without noise, for what is painted from them."""
    return PhotoSet({view: replace(photo, rgb=quiet_rgb(photo)) for view, photo in photos.photos.items()})
