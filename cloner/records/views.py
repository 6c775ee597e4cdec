"""Cameras: one per photo."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.arrays import freeze


@dataclass(frozen=True, slots=True, eq=False)
class Camera:
    """A pinhole camera without distortion, principal point at the centre.

    Attributes
    ----------
    width_px, height_px : int
    focal_px : float
        Focal length; ignored when ``pixels_per_m`` is set.
    camera_from_model : (4, 4) float64
        Rigid; camera axes x right, y down, z forward; metres.
    pixels_per_m : float or None
        When set, the camera is orthographic with this scale: the limit of
        infinite distance, in which the paper's formulas are exact.
    """

    width_px: int
    height_px: int
    focal_px: float
    camera_from_model: NDArray[np.float64]
    pixels_per_m: float | None = None

    def __post_init__(self) -> None:
        freeze(self, camera_from_model=(np.float64, (4, 4)))

    @property
    def centre_px(self) -> NDArray[np.float64]:
        """Principal point, (2,) photo pixels."""
        return np.array([(self.width_px - 1) / 2, (self.height_px - 1) / 2])

    def to_camera(self, points_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return (N, 3) model points in the camera's frame, metres."""
        return points_m @ self.camera_from_model[:3, :3].T + self.camera_from_model[:3, 3]

    def project(self, points_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the (N, 2) photo pixels of (N, 3) model points."""
        inside = self.to_camera(np.asarray(points_m, dtype=np.float64))
        if self.pixels_per_m is not None:
            return self.centre_px + self.pixels_per_m * inside[:, :2]
        return self.centre_px + self.focal_px * inside[:, :2] / inside[:, 2:3]

    def metres_per_pixel(self, point_m: NDArray[np.float64]) -> float:
        """Return the size of one pixel at the depth of a (3,) model point, metres."""
        if self.pixels_per_m is not None:
            return 1.0 / self.pixels_per_m
        return float(self.to_camera(point_m[None])[0, 2] / self.focal_px)

    def back_project(self, points_px: NDArray[np.float64], near_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return model points on the pixels' rays at the depth of ``near_m``.

        Parameters
        ----------
        points_px : (N, 2) photo pixels
        near_m : (N, 3) model points whose camera depth is kept
        """
        depth = self.to_camera(near_m)[:, 2:3]
        scale = depth / self.focal_px if self.pixels_per_m is None else 1.0 / self.pixels_per_m
        inside = np.hstack([(points_px - self.centre_px) * scale, depth])
        rotation = self.camera_from_model[:3, :3]
        return (inside - self.camera_from_model[:3, 3]) @ rotation

    @property
    def position_m(self) -> NDArray[np.float64]:
        """Camera centre in the model frame, (3,) metres."""
        return -self.camera_from_model[:3, :3].T @ self.camera_from_model[:3, 3]


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """One photo's camera with the person in its rest place.

    Attributes
    ----------
    view : ViewId
    camera : Camera
    side_shown : str
        "front", "back", "left" or "right": the person's side that the camera sees.
    focal_known : bool
        True when the focal length came from the photo itself.
    """

    view: ViewId
    camera: Camera
    side_shown: str
    focal_known: bool


@dataclass(frozen=True, slots=True, eq=False)
class ViewSet:
    """First cameras of all photos, from focal lengths and stature."""

    views: Mapping[ViewId, View]

    def __post_init__(self) -> None:
        object.__setattr__(self, "views", MappingProxyType(dict(self.views)))
