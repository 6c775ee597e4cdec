"""Rectified photos of walls, floors and paintings, as textures with a size in metres.

A flat surface and its photo are one homography apart, which four corners tell.

References: Hartley and Zisserman 2004, section 2.3.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.exporters.shared.files import png_bytes
from cloner.records.arrays import Array
from cloner.scenes.building.looks import Look, mean_albedo
from cloner.scenes.building.plan import Photographed, Plan
from cloner.vision.photographs.pictures import read_picture

#: A texel is the mean of at most so many places each way; and no larger picture is made on the way, pixels.
MOST_SAMPLES: Final = 6
LARGEST_SIDE_PX: Final = 8192


def rectify(rgb: NDArray[np.uint8], corners: Array, size: tuple[int, int]) -> NDArray[np.uint8]:
    """Return the region between four corners of a photo as a rectangle.

    Parameters
    ----------
    rgb : (H, W, 3) sRGB
    corners : (4, 2)
        Top left, top right, bottom right, bottom left, pixels; the first pixel's middle is 0, 0.
    size : (int, int)
        Width and height of what is returned, texels; each is the mean of what it covers.

    Returns
    -------
    (height, width, 3) sRGB
    """
    wide, tall = size
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1)
    dense = max(longest[[1, 3]].max() / wide, longest[[0, 2]].max() / tall)
    samples = max(min(math.ceil(dense), MOST_SAMPLES, LARGEST_SIDE_PX // max(size)), 1)
    fine = np.array([wide, tall], np.float32) * samples
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32) * fine - 0.5
    photo_from_fine = cv2.getPerspectiveTransform(square, corners.astype(np.float32))
    how = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    out = cv2.warpPerspective(rgb, photo_from_fine, tuple(int(one) for one in fine), flags=how,
                              borderMode=cv2.BORDER_REPLICATE)  # fmt: skip
    return np.asarray(out if samples == 1 else cv2.resize(out, size, interpolation=cv2.INTER_AREA))


def read_plan_photos(plan: Plan, folder: Path) -> dict[str, Look]:
    """Return the looks of a plan's photos, which lie beside it, rectified.

    Raises
    ------
    ClonerError
        If a photo cannot be read, or corners lie outside it.
    """
    return {one.name: _look(_read(one, folder / one.file), one) for one in plan.photos}


def read_stored_photos(plan: Plan, folder: Path) -> dict[str, Look]:
    """Return the looks of a plan's photos as `rectified_files` wrote them into a room's folder.

    Raises
    ------
    ClonerError
        If one is missing, damaged or of another size.
    """
    found = {}
    for one in plan.photos:
        pixels = read_picture(folder / rectified_path(one)).rgb
        if pixels.shape[1::-1] != one.texels:
            raise ClonerError(
                "a photo of the room has another size than its plan says", "Make the room again", one.name
            )
        found[one.name] = _look(pixels, one)
    return found


def rectified_files(plan: Plan, looks: dict[str, Look]) -> dict[str, bytes]:
    """Return rectified photos as files of a room's folder."""
    return {rectified_path(one): png_bytes(looks[one.name].pixels) for one in plan.photos}


def rectified_path(photo: Photographed) -> str:
    """Return the path of a rectified photo in a room's folder."""
    return f"photos/{photo.name}.png"


def _read(photo: Photographed, path: Path) -> NDArray[np.uint8]:
    picture = read_picture(path)
    wide, tall = picture.original_size
    corners = np.array(photo.corners)
    if (corners < -0.5).any() or (corners > np.array([wide, tall]) - 0.5).any():
        hint = f"It is {wide} x {tall} pixels; give corners inside it"
        raise ClonerError(f"corners of the photo {photo.name} lie outside it", hint, path.name)
    smaller = picture.rgb.shape[1] / wide
    return rectify(picture.rgb, (corners + 0.5) * smaller - 0.5, photo.texels)


def _look(pixels: NDArray[np.uint8], photo: Photographed) -> Look:
    return Look(pixels, photo.size, mean_albedo(pixels), fits=True)
