"""Motion of a camera and derivatives of projected points: the one camera and the one Jacobian of all fits.

Every way to tell where a camera stands - a small motion, the six numbers of a tripod - moves what is seen by a turn
about the camera and a shift. So pixels are differentiated once, by turn and shift, and a camera's own numbers by a
matrix that tells which turn and shift each of them makes (its twists).

References
----------
Murray, Li & Sastry 1994, A Mathematical Introduction to Robotic Manipulation: twists, the exponential's derivative.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cloner.geometry.articulation.skinning import rotation_axes, rotation_matrices, skew
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: Where a camera itself stands, in its own frame.
ORIGIN = np.zeros(3)


def moved_camera(camera: Camera, motion: Array, pivot: Array = ORIGIN) -> Camera:
    """Return the camera after a rotation and a translation of the world in front of it.

    Parameters
    ----------
    camera : Camera
    motion : (6,) float64
        Rotation vector (radians) and translation (metres), camera axes.
    pivot : (3,) float64
        Place in the camera's frame that the turn leaves where it is, metres.
    """
    pose = np.array(camera.camera_from_model)
    turn = rotation_matrices(np.asarray(motion[:3], dtype=np.float64)[None])[0]
    pose[:3, :3] = turn @ pose[:3, :3]
    pose[:3, 3] = turn @ (pose[:3, 3] - pivot) + pivot + motion[3:]
    return replace(camera, camera_from_model=pose)


def motion_jacobian(motion: Array, pivot: Array = ORIGIN) -> Array:
    """Return the (6, 6) derivatives of rotation and translation about the camera by `moved_camera`'s parameters."""
    turns = rotation_axes(motion[:3])
    return np.block([[turns, np.zeros((3, 3))], [skew(pivot + motion[3:]) @ turns, np.eye(3)]])


def projection_derivatives(camera: Camera, points_m: Array) -> tuple[Array, Array, Array]:
    """Return pixels (N, 2) and their derivatives by the points (N, 2, 3) and by camera rotation and translation (N, 2,
    6).
    """
    inside = camera.to_camera(points_m)
    by_inside = np.zeros((len(inside), 2, 3))
    if camera.pixels_per_m is not None:
        by_inside[:, [0, 1], [0, 1]] = camera.pixels_per_m
    else:
        scale = camera.focal_px / inside[:, 2:]
        by_inside[:, [0, 1], [0, 1]] = scale
        by_inside[:, :, 2] = -scale * inside[:, :2] / inside[:, 2:]
    by_step = np.concatenate([by_inside @ -skew(inside), by_inside], axis=2)
    return camera.project(points_m), by_inside @ camera.camera_from_model[:3, :3], by_step
