"""Cut turned squares out of photos, as nets want them, and bring results back."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Crop:
    """A turned rectangle in a photo.

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
    shrink = min(crop.width_px / width, crop.height_px / height)
    source = image
    if shrink > 2.0:  # a bilinear warp reads four pixels only: average first
        factor = int(shrink)
        size = (max(1, image.shape[1] // factor), max(1, image.shape[0] // factor))
        source = cv2.resize(image, size, interpolation=cv2.INTER_AREA).astype(np.uint8)
        ratio = np.array([size[0] / image.shape[1], size[1] / image.shape[0]])
        photo_from_crop[:, 2] += 0.5
        photo_from_crop *= ratio[:, None]
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


def paste(values: NDArray[np.float32], crop: Crop, *, shape: tuple[int, int]) -> NDArray[np.float32]:
    """Lay a crop's (h, w) values back into a photo of `shape` (H, W); zero elsewhere."""
    height, width = values.shape
    photo_from_crop = photo_px_from_crop(crop, width=width, height=height)
    flags = cv2.INTER_CUBIC if crop.width_px > width else cv2.INTER_LINEAR
    out = cv2.warpAffine(
        values,
        photo_from_crop,
        (shape[1], shape[0]),
        flags=flags,
        borderMode=cv2.BORDER_CONSTANT,
        borderValue=0.0,
    )
    return np.clip(np.asarray(out, np.float32), 0.0, 1.0)


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
