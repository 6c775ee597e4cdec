"""Rotated crops of photos for nets, and their results mapped back."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Crop:
    """A rotated rectangle in a photo.

    Parameters
    ----------
    x_px, y_px : float
        Its centre in the photo; (0, 0) is the centre of the top-left pixel.
    width_px, height_px : float
        Its sides in photo px.
    angle_rad : float
        How far it is turned from upright, clockwise as seen.
    """

    x_px: float
    y_px: float
    width_px: float
    height_px: float
    angle_rad: float = 0.0


def photo_px_from_crop(crop: Crop, *, width: int, height: int) -> NDArray[np.float64]:
    """Return the (2, 3) map from pixel centres of a cut (width, height) to photo px."""
    across = crop.width_px / width
    down = crop.height_px / height
    cos, sin = np.cos(crop.angle_rad), np.sin(crop.angle_rad)
    linear = np.array([[cos * across, -sin * down], [sin * across, cos * down]])
    middle = np.array([(width - 1) / 2.0, (height - 1) / 2.0])
    shift = np.array([crop.x_px, crop.y_px]) - linear @ middle
    return np.column_stack([linear, shift])


def cut(image: NDArray[np.uint8], crop: Crop, *, width: int, height: int, fill: int = 0) -> NDArray[np.uint8]:
    """Return the crop as a (height, width, 3) image, averaged where it shrinks.

    Parameters
    ----------
    image : (H, W, 3) uint8
    crop : Crop
    width, height : int
        Size of the result in px.
    fill : int
        Grey level outside the photo.
    """
    photo_from_crop = photo_px_from_crop(crop, width=width, height=height)
    factor = int(min(crop.width_px / width, crop.height_px / height))
    source = image
    if factor > 1:  # a bilinear warp reads four pixels only: average first, no more than it reads
        corner, end = _covered_window(photo_from_crop, (width, height), image.shape)
        corner -= corner % factor
        part = image[corner[1] : end[1], corner[0] : end[0]]
        down, across = (-side % factor for side in part.shape[:2])
        part = cv2.copyMakeBorder(part, 0, down, 0, across, cv2.BORDER_REPLICATE)
        size = (part.shape[1] // factor, part.shape[0] // factor)
        source = np.asarray(cv2.resize(part, size, interpolation=cv2.INTER_AREA), np.uint8)
        photo_from_crop[:, 2] += 0.5 - corner
        photo_from_crop /= factor
        photo_from_crop[:, 2] -= 0.5
    warped = cv2.warpAffine(
        source,
        photo_from_crop,
        (width, height),
        flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP,
        borderMode=cv2.BORDER_CONSTANT,
        borderValue=(fill, fill, fill),
    )
    return np.asarray(warped, np.uint8)


def _covered_window(
    photo_from_crop: NDArray[np.float64], size: tuple[int, int], shape: tuple[int, ...]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return first and end of the photo's columns and rows under a crop (width, height), at least one each.

    Two crop pixels around it belong to it: interpolation reads them.
    """
    width, height = size
    corners = np.array([[-2.0, -2.0], [width + 1, -2.0], [-2.0, height + 1], [width + 1, height + 1]])
    places, sides = move_points(corners, photo_from_crop), np.array([shape[1], shape[0]])
    first = np.clip(np.floor(places.min(axis=0)), 0, sides - 1).astype(np.int64)
    return first, np.clip(np.ceil(places.max(axis=0)) + 1, first + 1, sides).astype(np.int64)


def paste(values: NDArray[np.float32], crop: Crop, *, shape: tuple[int, int]) -> NDArray[np.float32]:
    """Return a crop's values (h, w) mapped into a photo of `shape` (H, W); zero elsewhere."""
    height, width = values.shape
    photo_from_crop = photo_px_from_crop(crop, width=width, height=height)
    flags = cv2.INTER_CUBIC if crop.width_px > width else cv2.INTER_LINEAR
    corner, end = _covered_window(photo_from_crop, (width, height), shape)
    photo_from_crop[:, 2] -= corner
    part = cv2.warpAffine(
        values,
        photo_from_crop,
        (end - corner).tolist(),
        flags=flags,
        borderMode=cv2.BORDER_CONSTANT,
        borderValue=0.0,
    )
    out = np.zeros(shape, np.float32)
    out[corner[1] : end[1], corner[0] : end[0]] = np.clip(part, 0.0, 1.0)
    return out


def move_points(points: NDArray[np.float64], photo_from_crop: NDArray[np.float64]) -> NDArray[np.float64]:
    """Map (N, 2) points through a (2, 3) affine map."""
    return points @ photo_from_crop[:, :2].T + photo_from_crop[:, 2]


def shrink_to(image: NDArray[np.uint8], *, longest: int) -> NDArray[np.uint8]:
    """Return the image with a long side of at most `longest` px, averaged."""
    height, width = image.shape[:2]
    scale = longest / max(height, width)
    if scale >= 1.0:
        return image
    size = (max(1, round(width * scale)), max(1, round(height * scale)))
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.uint8)
