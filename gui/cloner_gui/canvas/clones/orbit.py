"""The camera on a clone: orbiting, zooming, or exactly a photo's camera."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.framing import standard_camera
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.views import Camera

Image = NDArray[np.uint8]

_TILT_MOST: Final = math.radians(80.0)
_ZOOM: Final = (0.5, 12.0)
_MARGIN_GREY: Final = 40  # beside a photo
_ASIDE_MOST: Final = 1.5  # pictures' heights that a clone can be moved aside


@dataclass(frozen=True, slots=True)
class Orbit:
    """A camera position.

    Attributes
    ----------
    framing : str
        A standard camera's name: "front" shows the whole person, "face" the face.
    turn, tilt : float
        About the vertical axis, and over; radians.
    zoom : float
    aside : (float, float)
        How far the clone stands right and below the middle, pictures' heights.
    """

    framing: str = "front"
    turn: float = 0.0
    tilt: float = 0.0
    zoom: float = 1.0
    aside: tuple[float, float] = (0.0, 0.0)

    def turned(self, turn: float, tilt: float) -> Orbit:
        """Return the orbit after the clone was turned."""
        return replace(self, turn=self.turn + turn, tilt=min(max(self.tilt + tilt, -_TILT_MOST), _TILT_MOST))

    def zoomed(self, factor: float) -> Orbit:
        """Return the orbit nearer by a factor; what is in the middle stays there."""
        zoom = min(max(self.zoom * factor, _ZOOM[0]), _ZOOM[1])
        x, y = (value * zoom / self.zoom for value in self.aside)
        return replace(self, zoom=zoom).moved(x - self.aside[0], y - self.aside[1])

    def moved(self, x: float, y: float) -> Orbit:
        """Return the orbit after the clone was moved in the picture."""
        most = _ASIDE_MOST * max(self.zoom, 1.0)
        right, below = (min(max(old + new, -most), most) for old, new in zip(self.aside, (x, y), strict=True))
        return replace(self, aside=(right, below))

    def camera(self, clone: Clone, width_px: int, height_px: int, root_m: Array) -> Camera:
        """Return the camera that sees the clone, whose root has moved by ``root_m`` (3,)."""
        first = standard_camera(clone, self.framing, width_px, height_px)
        pivot = _point_ahead(first)
        turned = _shift(pivot) @ _turned(self.turn, self.tilt) @ _shift(-pivot)
        seen = first.camera_from_model @ turned @ _shift(root_m)
        focal = first.focal_px * self.zoom
        depth = float((first.camera_from_model @ np.append(pivot, 1.0))[2])
        beside = np.array([*self.aside, 0.0]) * height_px * depth / focal
        return replace(first, camera_from_model=_shift(beside) @ seen, focal_px=focal)


def photo_view_camera(clone: Clone | None, view: ViewId) -> str:
    """Return the standard camera that sees a clone from a photo's direction."""
    side = "front"
    if clone is not None and view in clone.views:
        x, _, z = clone.views[view].camera.position_m
        side = ("left" if x > 0 else "right") if abs(x) > abs(z) else "front" if z > 0 else "back"
    return side if view.is_body else f"face_{side}"


def photo_camera(camera: Camera, photo: Image, width_px: int, height_px: int) -> tuple[Camera, Image]:
    """Return a photo's camera for a smaller picture, and that picture (h, w, 3) with the photo centred.

    Parameters
    ----------
    camera : Camera
        Of the photo.
    photo : (H, W, 3) uint8
    width_px, height_px : int
        Largest size; the picture may be a pixel smaller, so that both middles agree.
    """
    scale = min(width_px / camera.width_px, height_px / camera.height_px)
    width, height = max(round(camera.width_px * scale), 1), max(round(camera.height_px * scale), 1)
    left, top = max(width_px - width, 0) // 2, max(height_px - height, 0) // 2
    small = cv2.resize(np.asarray(photo), (width, height), interpolation=cv2.INTER_AREA)
    picture = np.full((height + 2 * top, width + 2 * left, 3), _MARGIN_GREY, np.uint8)
    picture[top : top + height, left : left + width] = small
    density = None if camera.pixels_per_m is None else camera.pixels_per_m * scale
    seen = camera.camera_from_model
    return Camera(picture.shape[1], picture.shape[0], camera.focal_px * scale, seen, density), picture


def _point_ahead(camera: Camera) -> Array:
    """Return the point of the model's vertical axis that the camera looks at, (3,) metres."""
    eye, forward = camera.position_m, camera.camera_from_model[2, :3]
    reach = -(eye[0] * forward[0] + eye[2] * forward[2]) / max(forward[0] ** 2 + forward[2] ** 2, 1e-9)
    return np.array([0.0, eye[1] + reach * forward[1], 0.0])


def _shift(by: Array) -> Array:
    matrix = np.eye(4)
    matrix[:3, 3] = by
    return matrix


def _turned(turn: float, tilt: float) -> Array:
    """Return a turn about the vertical axis, then a tilt about the picture's horizontal one."""
    cosine, sine = math.cos(turn), math.sin(turn)
    around = np.array([[cosine, 0, sine, 0], [0, 1, 0, 0], [-sine, 0, cosine, 0], [0, 0, 0, 1.0]])
    cosine, sine = math.cos(tilt), math.sin(tilt)
    over = np.array([[1, 0, 0, 0], [0, cosine, -sine, 0], [0, sine, cosine, 0], [0, 0, 0, 1.0]])
    return np.asarray(over @ around)
