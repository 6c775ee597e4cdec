"""A webcam of this computer: live pictures and photos."""

from __future__ import annotations

from typing import Final, Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError

#: What is asked of the camera; it gives the nearest it has.
WANTED_PX: Final = (1920, 1080)
JPEG_QUALITY: Final = 95


class Camera(Protocol):
    """A source of pictures; tests bring their own."""

    def read(self) -> NDArray[np.uint8] | None:
        """Return the next (H, W, 3) uint8 sRGB picture; None at the end."""

    def shoot(self) -> bytes:
        """Take a photo and return the file's bytes.

        Raises
        ------
        ClonerError
            If the camera takes none.
        """

    def close(self) -> None:
        """Release the camera."""


def limit_height(rgb: NDArray[np.uint8], height_px: int) -> NDArray[np.uint8]:
    """Return a picture (H, W, 3), reduced to a height if it is larger."""
    share = height_px / rgb.shape[0]
    if share >= 1.0:
        return rgb
    size = (max(round(rgb.shape[1] * share), 1), height_px)
    return np.asarray(cv2.resize(rgb, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)


class Webcam:
    """A camera of this computer by its number.

    Raises
    ------
    ClonerError
        If there is no such camera.
    """

    def __init__(self, number: int = 0) -> None:
        self._capture = cv2.VideoCapture(number)
        if not self._capture.isOpened():
            self._capture.release()
            raise ClonerError("there is no camera", "Plug it in and allow its use, then try again", f"Camera {number}")
        self._capture.set(cv2.CAP_PROP_FRAME_WIDTH, WANTED_PX[0])
        self._capture.set(cv2.CAP_PROP_FRAME_HEIGHT, WANTED_PX[1])

    def read(self) -> NDArray[np.uint8] | None:
        """Return the next picture."""
        fine, bgr = self._capture.read()
        return np.asarray(cv2.cvtColor(bgr, cv2.COLOR_BGR2RGB)) if fine else None

    def shoot(self) -> bytes:
        """Return the next picture as a JPEG file."""
        picture = self.read()
        if picture is None:
            raise ClonerError("the camera gives no pictures any more", "Plug it in again", "Camera")
        return jpeg_bytes(picture)

    def close(self) -> None:
        """Release the camera."""
        self._capture.release()


def jpeg_bytes(rgb: NDArray[np.uint8]) -> bytes:
    """Return a picture as the bytes of a JPEG file."""
    fine, data = cv2.imencode(".jpg", cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR), [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    if not fine:
        raise ValueError("the picture cannot be encoded")
    return bytes(data)


def rotate_quarters(rgb: NDArray[np.uint8], quarters: int) -> NDArray[np.uint8]:
    """Return a picture rotated clockwise by quarters: webcams are placed on their side to see a whole body."""
    return np.ascontiguousarray(np.rot90(rgb, -quarters))


def rotate_file(data: bytes, quarters: int) -> bytes:
    """Return a photo's file rotated clockwise by quarters; unchanged bytes for 0."""
    if quarters % 4 == 0:
        return data
    bgr = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)
    if bgr is None:
        raise ClonerError("the camera gives no pictures any more", "Plug it in again", "Camera")
    return jpeg_bytes(rotate_quarters(np.asarray(cv2.cvtColor(bgr, cv2.COLOR_BGR2RGB)), quarters))
