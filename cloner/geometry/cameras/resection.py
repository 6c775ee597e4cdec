"""Where a camera stands: projection derivatives, and pose from known points by damped Gauss-Newton."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from cloner.geometry.articulation.skinning import rotation_matrices
from cloner.records.arrays import Array
from cloner.records.views import Camera


def moved_camera(camera: Camera, step: Array) -> Camera:
    """Return the camera after a small turn and shift of the world in front of it.

    Parameters
    ----------
    step : (6,) float64
        Rotation vector (radians, camera axes, around the camera) and translation (metres, camera axes).
    """
    pose = np.array(camera.camera_from_model)
    turn = rotation_matrices(np.asarray(step[:3], dtype=np.float64)[None])[0]
    pose[:3, :3] = turn @ pose[:3, :3]
    pose[:3, 3] = turn @ pose[:3, 3] + step[3:]
    return replace(camera, camera_from_model=pose)


def pixels_by_inside(camera: Camera, inside: Array) -> Array:
    """Return (N, 2, 3) how pixels change with points (N, 3) of the camera's frame, px a metre."""
    x, y, z = inside.T
    zero = np.zeros_like(z)
    if camera.pixels_per_m is not None:
        scale = np.full_like(z, camera.pixels_per_m)
        return np.stack([np.stack([scale, zero, zero], 1), np.stack([zero, scale, zero], 1)], axis=1)
    f = camera.focal_px
    return np.stack([np.stack([f / z, zero, -f * x / z**2], 1), np.stack([zero, f / z, -f * y / z**2], 1)], 1)


def projection_derivatives(camera: Camera, points_m: Array) -> tuple[Array, Array, Array]:
    """Return pixels (N, 2), their change with the points (N, 2, 3) and with the camera's step (N, 2, 6)."""
    inside = camera.to_camera(points_m)
    by_inside = pixels_by_inside(camera, inside)
    x, y, z = inside.T
    zero = np.zeros_like(z)
    # d(turned point)/d(rotation vector) = -[point]_x
    cross = np.stack([np.stack([zero, z, -y], 1), np.stack([-z, zero, x], 1), np.stack([y, -x, zero], 1)], axis=1)
    by_step = np.concatenate([by_inside @ cross, by_inside], axis=2)
    return camera.project(points_m), by_inside @ camera.camera_from_model[:3, :3], by_step


def facing_camera(
    points_m: Array, points_px: Array, *, azimuth: float, focal_px: float, width_px: int, height_px: int
) -> Camera:
    """Return an upright camera that sees the points at their size and middle in the photo.

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


@dataclass(frozen=True, slots=True, eq=False)
class Resection:
    """A camera found from points.

    Attributes
    ----------
    camera : Camera
    error_px : (N,) float64
        Distance of each projected point from its place in the photo.
    """

    camera: Camera
    error_px: Array


def resect(
    points_m: Array,
    points_px: Array,
    start: Camera,
    *,
    sigma_px: Array | float = 1.0,
    outlier: float = 3.0,
    turn_sigma: Array | None = None,
    iterations: int = 20,
) -> Resection:
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
    camera = start
    sigma = np.broadcast_to(np.asarray(sigma_px, dtype=np.float64), (len(points_m),))
    turned = np.zeros(3)
    pull = np.zeros(3) if turn_sigma is None else 1.0 / np.asarray(turn_sigma) ** 2
    pivot = camera.to_camera(points_m.mean(axis=0)[None])[0]
    for _ in range(iterations):
        seen, _, by_step = projection_derivatives(camera, points_m)
        error = (points_px - seen) / sigma[:, None]
        weight = 1.0 / (1.0 + (error**2).sum(1) / outlier**2)
        rows = by_step / sigma[:, None, None]
        normal = np.einsum("n,nia,nib->ab", weight, rows, rows)
        right = np.einsum("n,nia,ni->a", weight, rows, error)
        normal[:3, :3] += np.diag(pull)
        right[:3] -= pull * turned
        normal += 1e-9 * np.trace(normal) / 6.0 * np.eye(6)
        step = np.linalg.solve(normal, right)
        step[:3] = np.clip(step[:3], -0.3, 0.3)
        turned = turned + step[:3]
        # Keep the head before the camera: a step may not move it by more than half its distance.
        limit = 0.5 * abs(pivot[2])
        step[3:] = np.clip(step[3:], -limit, limit)
        camera = moved_camera(camera, step)
        if np.abs(step).max() < 1e-9:
            break
    return Resection(camera, np.linalg.norm(points_px - camera.project(points_m), axis=1))
