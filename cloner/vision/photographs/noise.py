"""Removal of sensor noise in dim photos, which would become grain on skin and cloth.

Non-local means (A. Buades, B. Coll, J.-M. Morel, A non-local algorithm for image denoising, 2005) as OpenCV has them;
photos with as little noise as those of a usual camera stay as they are.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.caching import cached_per_object
from cloner.records.photos import Photo, PhotoSet

#: Noise from which a photo is cleaned, levels at half its size: the samples' photos, JPEG included, have up to 1.9,
#: generated people's photos of weak light 2.6 to 7.5.
NOISY: Final = 2.5
#: Strength for brightness, and for colours, against the noise. Twelve photos of four people with noise of 4 and 8
#: levels, coarse and fine, through JPEG: root of the mean square error on the person 6.3 levels, cleaned 4.0; with
#: brightness 1.3, 1.5 and 2 4.4, 4.1 and 3.9, but 2 blurs folds (looked at). Colours at full size, as
#: ``fastNlMeansDenoisingColored`` takes them, with 1 and 1.4: 5.0 in twice the time, and red lines turn grey.
STRENGTH, COLOUR_STRENGTH = 1.7, 0.4
#: Colours are cleaned at this share of the photo's size, as JPEG keeps them.
COLOUR_SCALE = 0.5
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


@cached_per_object
def denoise_rgb(photo: Photo) -> NDArray[np.uint8]:
    """Return a photo's pixels (H, W, 3) without noise, unchanged where there is little."""
    level = noise_level(photo.rgb)
    if level < NOISY:
        return photo.rgb
    lab = cv2.cvtColor(photo.rgb, cv2.COLOR_RGB2Lab)
    small = cv2.resize(lab, None, fx=COLOUR_SCALE, fy=COLOUR_SCALE, interpolation=cv2.INTER_AREA)

    def cleaned(plane: NDArray[np.uint8], strength: float) -> NDArray[np.uint8]:
        found = cv2.fastNlMeansDenoising(plane, None, strength * level, PATCH_PX, SEARCH_PX)
        return np.asarray(found, np.uint8)

    bright = cleaned(cv2.extractChannel(lab, 0), STRENGTH)
    colours = [cleaned(cv2.extractChannel(small, k), COLOUR_STRENGTH) for k in (1, 2)]
    large = cv2.resize(np.dstack(colours), (lab.shape[1], lab.shape[0]), interpolation=cv2.INTER_LINEAR)
    return np.asarray(cv2.cvtColor(np.dstack([bright, large]), cv2.COLOR_Lab2RGB), np.uint8)


def denoised(photos: PhotoSet) -> PhotoSet:
    """Return the photos without noise, for painting."""
    return PhotoSet({view: replace(photo, rgb=denoise_rgb(photo)) for view, photo in photos.photos.items()})
