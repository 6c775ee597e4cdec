"""Camera placement by six parameters that photographers use."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

import numpy as np

from cloner.geometry.cameras.motions import projection_derivatives
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: azimuth: direction of the camera around the person, radians, 0 front, +90° the person's left. height: of the camera
#: above the model's floor, metres. distance: horizontal, from the model's origin, metres. facing: how far the view axis
#: turns away from the person, pitch: downwards, roll: about the view axis, radians.
STAND_NAMES: Final = ("azimuth", "height", "distance", "facing", "pitch", "roll")
AZIMUTH, HEIGHT, DISTANCE, FACING, PITCH, ROLL = range(6)


def _turns(stand: Array) -> tuple[Array, Array, Array]:
    """Return the (3, 3) roll, pitch and heading parts of camera_from_model."""
    turn, pitch, roll = stand[AZIMUTH] + stand[FACING], stand[PITCH], stand[ROLL]
    c, s = math.cos(turn), math.sin(turn)
    heading = np.array([[c, 0.0, -s], [0.0, -1.0, 0.0], [-s, 0.0, -c]])
    c, s = math.cos(pitch), math.sin(pitch)
    tilt = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
    c, s = math.cos(roll), math.sin(roll)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]), tilt, heading


def camera_from_stand(stand: Array, like: Camera) -> Camera:
    """Return the camera of a stand with the size and focal length of another.

    Parameters
    ----------
    stand : (6,) float64
        In the order of `STAND_NAMES`.
    """
    roll, tilt, heading = _turns(stand)
    matrix = np.eye(4)
    matrix[:3, :3] = roll @ tilt @ heading
    matrix[:3, 3] = -matrix[:3, :3] @ _place(stand)
    return replace(like, camera_from_model=matrix)


def _place(stand: Array) -> Array:
    azimuth, height, distance = stand[[AZIMUTH, HEIGHT, DISTANCE]]
    return np.array([distance * math.sin(azimuth), height, distance * math.cos(azimuth)])


def stand_from_camera(camera: Camera) -> Array:
    """Return the stand (6,) of a camera."""
    rotation, place = camera.camera_from_model[:3, :3], camera.position_m
    azimuth = math.atan2(place[0], place[2])
    forward = rotation[2]
    facing = math.atan2(-forward[0], -forward[2]) - azimuth
    facing = (facing + math.pi) % (2.0 * math.pi) - math.pi
    pitch = math.asin(float(np.clip(-forward[1], -1.0, 1.0)))
    level = _turns(np.array([azimuth, 0.0, 0.0, facing, pitch, 0.0]))
    rest = rotation @ (level[1] @ level[2]).T
    roll = math.atan2(rest[1, 0], rest[0, 0])
    return np.array([azimuth, float(place[1]), math.hypot(place[0], place[2]), facing, pitch, roll])


def project_from_stand(stand: Array, like: Camera, points_m: Array) -> tuple[Array, Array, Array]:
    """Return pixels (N, 2) and their derivatives by the points (N, 2, 3) and by the stand (N, 2, 6)."""
    camera = camera_from_stand(stand, like)
    pixels, by_points, by_step = projection_derivatives(camera, points_m)
    return pixels, by_points, by_step @ _stand_jacobian(stand, camera.camera_from_model[:3, :3])


def _stand_jacobian(stand: Array, rotation: Array) -> Array:
    """Return the (6, 6) derivatives of rotation and translation about the camera by the stand's parameters."""
    roll, tilt, _ = _turns(stand)
    azimuth, distance = stand[AZIMUTH], stand[DISTANCE]
    away, aside = (
        np.array([math.sin(azimuth), 0.0, math.cos(azimuth)]),
        np.array([math.cos(azimuth), 0.0, -math.sin(azimuth)]),
    )
    twists = np.zeros((6, 6))
    turns, shifts = twists[:3], twists[3:]
    turns[:, AZIMUTH] = turns[:, FACING] = (roll @ tilt)[:, 1]  # the model's up axis: heading leaves it upside down
    turns[:, PITCH] = roll[:, 0]
    turns[2, ROLL] = 1.0
    shifts[:, AZIMUTH] = -distance * (rotation @ aside)
    shifts[:, HEIGHT] = -rotation[:, 1]
    shifts[:, DISTANCE] = -rotation @ away
    return twists
