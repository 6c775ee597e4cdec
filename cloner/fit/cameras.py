"""Cameras as unknowns: rotation and translation from an initial pose and log zoom; and resection of one camera."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from cloner.fit.evidence import Residuals, point_residuals
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.geometry.cameras.motions import motion_jacobian, moved_camera, projection_derivatives
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: Longest rotation in one step, radians, and translation as a share of the distance: points stay before the camera.
MAX_ROTATION_RAD, MAX_TRANSLATION = 0.3, 0.5
#: Steps shorter than this change no pixel.
TOLERANCE: Final = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class CameraUnknowns:
    """A camera as unknowns: rotation vector and translation as `moved_camera` takes them, and optionally a zoom.

    Attributes
    ----------
    start : Camera
    depth_m : float
        Distance at which things keep their size in the photo while the logarithm of the focal length changes.
    """

    start: Camera
    depth_m: float = 0.0

    def camera(self, motion: Array, zoom: float = 0.0) -> Camera:
        """Return the camera after a motion (6,) and with its focal length times exp(zoom)."""
        camera, factor = moved_camera(self.start, motion), float(np.exp(zoom))
        pose = np.array(camera.camera_from_model)
        pose[2, 3] += (factor - 1.0) * self.depth_m
        return replace(camera, focal_px=factor * camera.focal_px, camera_from_model=pose)

    def project(self, points_m: Array, motion: Array, zoom: float = 0.0) -> tuple[Array, Array, Array]:
        """Return pixels (N, 2) and their derivatives by the points (N, 2, 3) and by motion and zoom (N, 2, 7)."""
        camera, back = self.camera(motion, zoom), np.array([0.0, 0.0, np.exp(zoom) * self.depth_m])
        pixels, by_points, by_step = projection_derivatives(camera, points_m)
        by_motion = by_step @ motion_jacobian(motion, back - [0.0, 0.0, self.depth_m])
        by_zoom = pixels - camera.centre_px + by_step[:, :, 3:] @ back
        return pixels, by_points, np.concatenate([by_motion, by_zoom[..., None]], axis=2)


def resect(
    points_m: Array,
    points_px: Array,
    start: Camera,
    *,
    sigma_px: Array | float = 1.0,
    outlier: float = 3.0,
    rotation_sigma: Array | None = None,
    iterations: int = 20,
) -> Camera:
    """Return the camera of known points (resection), its focal length kept.

    Parameters
    ----------
    points_m : (N, 3), points_px : (N, 2)
    start : Camera
        A rough camera; its focal length is kept.
    sigma_px : float or (N,)
        Standard deviation of each point.
    outlier : float
        Cauchy scale in sigmas: a wrong point cannot turn the head.
    rotation_sigma : (3,) float64, optional
        Prior on the rotation from the start's, radians; needed where few points determine it badly.
    """
    unknowns = CameraUnknowns(start)
    distance_m = abs(float(start.to_camera(points_m.mean(axis=0)[None])[0, 2]))
    sigma = np.full(6, np.inf)
    sigma[:3] = np.inf if rotation_sigma is None else rotation_sigma
    max_step = np.repeat([MAX_ROTATION_RAD, MAX_TRANSLATION * distance_m], 3)

    def linearise(values: Values, iteration: int) -> list[Residuals]:
        pixels, _, by_unknowns = unknowns.project(points_m, values["camera"])
        return [point_residuals(("camera",), pixels - points_px, by_unknowns[..., :6], sigma_px, outlier=outlier)]

    problem = Problem({"camera": ParameterBlock(np.zeros(6), sigma=sigma, max_step=max_step)})
    return unknowns.camera(problem.solve(linearise, iterations=iterations, tolerance=TOLERANCE).values["camera"])
