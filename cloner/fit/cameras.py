"""Cameras among the unknowns: motion since a start and a logarithm of zoom; and a camera alone, from known points."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from cloner.fit.evidence import Rows, points
from cloner.fit.problem import Block, Problem, Values
from cloner.geometry.cameras.motions import motion_twists, moved_camera, projection_derivatives
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: Longest turn in one step, radians, and shift as a share of the distance: what is seen stays before the camera.
MOST_TURN, MOST_SHIFT = 0.3, 0.5
#: Steps shorter than this change no pixel.
STILL: Final = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Aim:
    """A camera as unknowns: rotation vector and translation as `moved_camera` takes them, and perhaps a zoom.

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

    def seen(self, points_m: Array, motion: Array, zoom: float = 0.0) -> tuple[Array, Array, Array]:
        """Return pixels (N, 2), their change with the points (N, 2, 3) and with motion and zoom (N, 2, 7)."""
        camera, back = self.camera(motion, zoom), np.array([0.0, 0.0, np.exp(zoom) * self.depth_m])
        pixels, by_points, by_step = projection_derivatives(camera, points_m)
        by_motion = by_step @ motion_twists(motion, back - [0.0, 0.0, self.depth_m])
        by_zoom = pixels - camera.centre_px + by_step[:, :, 3:] @ back
        return pixels, by_points, np.concatenate([by_motion, by_zoom[..., None]], axis=2)


def resect(
    points_m: Array,
    points_px: Array,
    start: Camera,
    *,
    sigma_px: Array | float = 1.0,
    outlier: float = 3.0,
    turn_sigma: Array | None = None,
    iterations: int = 20,
) -> Camera:
    """Return the camera that sees the points where the photo shows them.

    Parameters
    ----------
    points_m : (N, 3), points_px : (N, 2)
    start : Camera
        A rough camera; its focal length is kept.
    sigma_px : float or (N,)
        Expected error of each point.
    outlier : float
        Errors beyond this many sigmas lose their weight (Cauchy), so that a wrong point cannot turn the head.
    turn_sigma : (3,) float64, optional
        Expected deviation (radians) of the rotation from the start's; needed where few points fix it badly.
    """
    aim = Aim(start)
    away_m = abs(float(start.to_camera(points_m.mean(axis=0)[None])[0, 2]))
    spread = np.full(6, np.inf)
    spread[:3] = np.inf if turn_sigma is None else turn_sigma
    longest = np.repeat([MOST_TURN, MOST_SHIFT * away_m], 3)

    def look(values: Values, turn: int) -> list[Rows]:
        seen, _, by_aim = aim.seen(points_m, values["camera"])
        return [points(("camera",), seen - points_px, by_aim[..., :6], sigma_px, outlier=outlier)]

    problem = Problem({"camera": Block(np.zeros(6), spread=spread, longest=longest)})
    return aim.camera(problem.solve(look, turns=iterations, still=STILL).values["camera"])
