"""Crops for a mask net, and the merging of its results. No net here."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cloner.detectors.nets.placing import full_crop, mirror_crop
from cloner.vision.photographs.crops import Crop, paste

Photo = NDArray[np.uint8]
MaskNet = Callable[[Photo, Crop], NDArray[np.float64]]
"""Give the person probability (h, w), 0..1, of a crop."""


def mean_mask(photo: Photo, crop: Crop, run: Callable[[Photo, Crop], NDArray[np.float64]]) -> NDArray[np.float32]:
    """Return the mean of a mask net's answers for a crop and its mirror image."""
    shape = (photo.shape[0], photo.shape[1])
    straight = paste(run(photo, crop).astype(np.float32), crop, shape=shape)
    flipped, turned = mirror_crop(photo, crop)
    mirrored = paste(run(flipped, turned).astype(np.float32), turned, shape=shape)
    return (straight + mirrored[:, ::-1]) * np.float32(0.5)


def body_mask(photo: Photo, crop: Crop, run: MaskNet) -> NDArray[np.float32]:
    """Return the mask of a whole body.

    The mean of three answers: of a close crop, and of a narrower one around what that shows with its mirror image.
    Measured mean overlap on 18 photos: one crop 0.963, the closer 0.85 crop 0.967, that and the narrower one, both
    mirrored, 0.974. On 24 of generated people both mirrored and these three give 0.969 and 0.970, refined 0.981 both.
    """
    close = Crop(crop.x_px, crop.y_px, 0.85 * crop.width_px, 0.85 * crop.height_px, crop.angle_rad)
    first = paste(run(photo, close).astype(np.float32), close, shape=(photo.shape[0], photo.shape[1]))
    rows, columns = np.nonzero(first > 0.5)
    if not len(rows):
        return first
    height = float(np.ptp(rows)) * 1.1
    # narrower than high: the net then spends more of its 256 columns on the body
    width = max(float(np.ptp(columns)) * 1.2, 0.68 * height)
    middle = (float(columns.min() + columns.max()) / 2, float(rows.min() + rows.max()) / 2)
    second = mean_mask(photo, Crop(*middle, width, height), run)
    return np.asarray((first + 2.0 * second) / 3.0, np.float32)


def portrait_mask(photo: Photo, run: MaskNet) -> NDArray[np.float32]:
    """Return the mask of a person cut by the lower edge (selfie net, whole photo)."""
    return mean_mask(photo, full_crop(photo), run)
