"""Cameras that frame a body from a given side, or that match points in a photo."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from cloner.records.arrays import Array
from cloner.records.views import Camera

#: Azimuth of every named side in degrees: 0 in front of the person, 90 at the person's left.
#: "side" is the samples' side: the camera at the person's right.
AZIMUTH_DEG: Final = {
    "front": 0.0,
    "left": 90.0,
    "right": -90.0,
    "side": -90.0,
    "back": 180.0,
    "three_quarter": 45.0,
}
FOCAL_PER_LONG_SIDE: Final = 2.0  # taste: a 72 mm lens, little perspective, as in a portrait
MARGIN: Final = 1.06  # taste: air around the figure


def look_at(eye_m: Array, target_m: Array) -> Array:
    """Return the (4, 4) ``camera_from_model`` of a level camera at ``eye_m`` aimed at ``target_m``.

    Raises
    ------
    ValueError
        If the camera would look straight up or down.
    """
    forward = np.asarray(target_m, dtype=np.float64) - eye_m
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0.0, 1.0, 0.0])
    if np.linalg.norm(right) < 1e-6:
        raise ValueError("the camera looks straight up or down")
    right /= np.linalg.norm(right)
    rows = np.vstack([right, np.cross(forward, right), forward])
    camera_from_model = np.eye(4)
    camera_from_model[:3, :3] = rows
    camera_from_model[:3, 3] = -rows @ eye_m
    return camera_from_model


def framing_camera(points_m: Array, azimuth_deg: float, width_px: int, height_px: int) -> Camera:
    """Return a level camera on the given side that just frames all points.

    Parameters
    ----------
    points_m : (N, 3), model frame
    azimuth_deg : float
        0 in front of the person, 90 at the person's left.
    """
    return framing_cameras(points_m, [azimuth_deg], width_px, height_px)[0]


def framing_cameras(
    points_m: Array, azimuths_deg: Sequence[float], width_px: int, height_px: int
) -> tuple[Camera, ...]:
    """Return level cameras on the given sides, at the one distance from which each of them frames all points."""
    target = (points_m.min(axis=0) + points_m.max(axis=0)) / 2.0
    focal = FOCAL_PER_LONG_SIDE * max(width_px, height_px)
    half = np.array([width_px, height_px]) / (2.0 * MARGIN)
    outwards = [np.array([np.sin(azimuth), 0.0, np.cos(azimuth)]) for azimuth in np.radians(azimuths_deg)]
    distances = []
    for outward in outwards:
        inside = (points_m - target) @ look_at(target + outward, target)[:3, :3].T
        # a point at depth z before the target fills |x| f / (d + z) pixels: solve for the distance of each
        distances.append(float((np.abs(inside[:, :2]) * focal / half - inside[:, 2:3]).max()))
    places = [target + max(distances) * outward for outward in outwards]
    return tuple(Camera(width_px, height_px, focal, look_at(place, target)) for place in places)


def facing_camera(
    points_m: Array, points_px: Array, *, azimuth: float, focal_px: float, width_px: int, height_px: int
) -> Camera:
    """Return an upright camera that sees the points at their size and centre in the photo.

    Parameters
    ----------
    points_m : (N, 3), points_px : (N, 2)
        The same points in the model frame and in the photo.
    azimuth : float
        Direction of the camera around the person, radians: 0 front, positive towards the person's left.
    """
    across = np.array([np.cos(azimuth), 0.0, -np.sin(azimuth)])
    towards = np.array([np.sin(azimuth), 0.0, np.cos(azimuth)])
    rotation = np.stack([across, [0.0, -1.0, 0.0], -towards])
    middle_m, middle_px = points_m.mean(axis=0), points_px.mean(axis=0)
    flat = (points_m - middle_m) @ rotation.T[:, :2]
    seen = points_px - middle_px
    size_m, size_px = np.sqrt((flat**2).sum()), np.sqrt((seen**2).sum())
    depth = focal_px * float(size_m / max(size_px, 1e-6))
    centre = np.array([(width_px - 1) / 2.0, (height_px - 1) / 2.0])
    offset = np.append((middle_px - centre) * depth / focal_px, depth)
    pose = np.eye(4)
    pose[:3, :3] = rotation
    pose[:3, 3] = offset - rotation @ middle_m
    return Camera(width_px, height_px, focal_px, pose)
