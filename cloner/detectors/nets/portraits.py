"""Crops for the pose net where the photo's lower edge cuts the person. No net here.

The pose detector was taught on whole bodies. On a head seen from the side that fills the picture it finds nobody, or a
little body in an ear (10 of 30 painted heads at 90 degrees); the person's mask, taught on near people, is right there.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.nets.placing import circle_crop
from cloner.records.arrays import Array
from cloner.vision.photographs.crops import Crop, paste

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.portraits")


_CUT_SHARE: Final = _CALIBRATED.number("cut_share", "share")
_RADIUS: Final = _CALIBRATED.number("radius", "factor")
_PERSON: Final = _CALIBRATED.number("person", "share")


def is_cut_below(person: Array) -> bool:
    """Return whether the photo's lower edge cuts a person close to the camera.

    Parameters
    ----------
    person : (h, w) float64
        Probability, 0..1, of the whole picture squeezed into the net's output.
    """
    return bool((person[-2:] > _PERSON).mean() > _CUT_SHARE)


def portrait_crop(person: Array, shape: tuple[int, int]) -> Crop:
    """Return the pose net's input for a person cut by the photo's lower edge: hips below it.

    Parameters
    ----------
    person : (h, w) float64
        Probability, 0..1, of the whole picture squeezed into the net's output; somebody is in its lowest row.
    shape : (H, W) of the photo
    """
    scale = np.array(shape) / person.shape
    top = float(np.flatnonzero((person > _PERSON).any(axis=1))[0]) * scale[0]
    across = float(np.flatnonzero((person[-2:] > _PERSON).any(axis=0)).mean()) * scale[1]
    radius = _RADIUS * (shape[0] - top)
    return circle_crop(np.array([across, top + radius]), np.array([across, top]), 1.25)


def mask_agreement(body: Array, crop: Crop, person: Array, shape: tuple[int, int]) -> float:
    """Return the intersection over union of a pose's own mask and the mask of the whole photo.

    Parameters
    ----------
    body : (S, S) float64
        Probability that the pose net gives of its crop.
    crop : Crop
        In photo px.
    person : (h, w) float64
        Probability of the whole picture.
    shape : (H, W) of the photo
    """
    down, right = person.shape[0] / shape[0], person.shape[1] / shape[1]
    # the picture's own proportions, made small: both axes by the same factor
    size = (person.shape[0], max(1, round(shape[1] * down)))
    small = Crop(crop.x_px * down, crop.y_px * down, crop.width_px * down, crop.height_px * down, crop.angle_rad)
    columns = np.minimum((np.arange(size[1]) / down * right).astype(np.intp), person.shape[1] - 1)
    found, seen = paste(body.astype(np.float32), small, shape=size) > _PERSON, person[:, columns] > _PERSON
    return float((found & seen).sum() / max(int((found | seen).sum()), 1))
