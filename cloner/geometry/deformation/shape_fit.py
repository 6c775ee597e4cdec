"""Shape coefficients and camera poses together, from points and curves in photos (damped Gauss-Newton)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from cloner.geometry.cameras.resection import moved_camera, projection_derivatives
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: A camera turned beyond so many expected turns is held ever less: most people stand as they were asked, some do not.
TURN_OUTLIER: Final = 1.5


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """What one photo says about places on the model.

    Attributes
    ----------
    camera : int
        Index of the photo's camera.
    base_m : (N, 3)
        Places at zero coefficients, metres.
    basis_m : (F, N, 3)
        Their change with each coefficient.
    target_px : (N, 2)
    sigma_px : (N,)
        Expected error.
    normal_px : (N, 2) or None
        When given, only the error along this unit direction counts: a point may slide on a curve.
    outlier : float
        Errors beyond this many sigmas lose their weight (Cauchy).
    drift_px : (M, N, 2) or None
        Errors that the targets make together; their sizes are solved for and follow the shape coefficients.
    skew_px : (F, N, 2) or None
        Errors of the targets that follow from the shape.
    whiten : (2 N, 2 N) or None
        Stands for ``sigma_px`` where points err together: makes their errors, x and y after each other, independent and
        of size one. Such points lose their weight together.
    """

    camera: int
    base_m: Array
    basis_m: Array
    target_px: Array
    sigma_px: Array
    normal_px: Array | None = None
    outlier: float = 3.0
    drift_px: Array | None = None
    skew_px: Array | None = None
    whiten: Array | None = None


@dataclass(frozen=True, slots=True, eq=False)
class ShapeFit:
    """Coefficients (F,) or with drifts (F + M,), cameras, and what they moved.

    ``turned`` is each turn from its expected pose (radians, (K, 3)), ``zoomed`` the logarithm of the common change of
    their focal lengths, with distances that keep the head's size in the photos.
    """

    coefficients: Array
    cameras: tuple[Camera, ...]
    turned: Array
    zoomed: float = 0.0


def zoomed_camera(camera: Camera, by: float, depth_m: float) -> Camera:
    """Return the camera with its focal length times exp(by), as much farther from what lies ``depth_m`` before it."""
    factor = float(np.exp(by))
    pose = np.array(camera.camera_from_model)
    pose[2, 3] += (factor - 1.0) * depth_m
    return replace(camera, focal_px=factor * camera.focal_px, camera_from_model=pose)


def _rows(item: Evidence, coefficients: Array, camera: Camera) -> tuple[Array, Array, Array, Array]:
    """Return whitened errors (M,), their rows for shape (M, F), pose and zoom (M, 7), and robust weights (M,)."""
    shapes = len(item.basis_m)
    points = item.base_m + np.tensordot(coefficients[:shapes], item.basis_m, axes=1)
    seen, by_point, by_step = projection_derivatives(camera, points)
    by_shape = np.zeros((*seen.shape, len(coefficients)))
    by_shape[..., :shapes] = np.einsum("nia,fna->nif", by_point, item.basis_m)
    by_step = np.concatenate([by_step, _by_zoom(camera, seen, by_step, points)], axis=2)
    if item.skew_px is not None:
        by_shape[..., :shapes] += item.skew_px.transpose(1, 2, 0)
        seen = seen + np.tensordot(coefficients[:shapes], item.skew_px, axes=1)
    if item.drift_px is not None:
        by_shape[..., shapes:] = item.drift_px.transpose(1, 2, 0)
        seen = seen + np.tensordot(coefficients[shapes:], item.drift_px, axes=1)
    error = item.target_px - seen
    if item.normal_px is not None:
        error = (error * item.normal_px).sum(1, keepdims=True)
        by_shape = np.einsum("ni,nif->nf", item.normal_px, by_shape)[:, None]
        by_step = np.einsum("ni,nip->np", item.normal_px, by_step)[:, None]
    if item.whiten is not None:
        white, flat = item.whiten @ error.ravel(), (2 * len(error), -1)
        alike = 1.0 / (1.0 + 2.0 * float((white**2).mean()) / item.outlier**2)
        by_shape, by_step = (item.whiten @ rows.reshape(flat) for rows in (by_shape, by_step))
        return white, by_shape, by_step, np.full(len(white), alike)
    scale = 1.0 / item.sigma_px[:, None]
    error = error * scale
    weight = 1.0 / (1.0 + (error**2).sum(1) / item.outlier**2)
    weight = np.repeat(weight, error.shape[1])
    return (
        error.ravel(),
        (by_shape * scale[..., None]).reshape(error.size, len(coefficients)),
        (by_step * scale[..., None]).reshape(error.size, 7),
        weight,
    )


def _by_zoom(camera: Camera, seen: Array, by_step: Array, points: Array) -> Array:
    """Return the pixels' change (N, 2, 1) with the logarithm of the focal length, the head's size kept."""
    depth = float(camera.to_camera(points)[:, 2].mean()) if len(points) else 0.0
    return np.asarray((seen - camera.centre_px + depth * by_step[:, :, 5])[..., None])


def fit_shape(
    start: ShapeFit,
    gather: Callable[[ShapeFit, int], Sequence[Evidence]],
    *,
    at_least: Array | float = -np.inf,
    rarity: Array | float = 0.0,
    turn_sigma: Array | None = None,
    zoom_sigma: float = 0.0,
    iterations: int = 10,
) -> ShapeFit:
    """Return the most likely coefficients and cameras.

    Parameters
    ----------
    start : ShapeFit
    gather : callable
        ``gather(fit, iteration)`` returns the evidence for the present fit: curves are matched afresh each time.
    at_least : float or (F,)
        No coefficient becomes smaller.
    rarity : float or (F,)
        Decline of the expected coefficients' logarithm beside the normal prior: for what is mostly absent.
    turn_sigma : (K, 3), optional
        Expected turn of each camera (``ShapeFit.turned``), radians, with heavy tails (Cauchy beyond ``TURN_OUTLIER``);
        infinite where the evidence alone decides.
    zoom_sigma : float
        Expected relative error of the cameras' common focal length; 0 keeps it.
    """
    fit, count = start, len(start.coefficients)
    pull = np.zeros((len(fit.cameras), 3)) if turn_sigma is None else 1.0 / turn_sigma**2
    for iteration in range(iterations):
        normal, right = _priors(fit, rarity, pull, zoom_sigma)
        found = gather(fit, iteration)
        for item in found:
            error, by_shape, by_step, weight = _rows(item, fit.coefficients, fit.cameras[item.camera])
            columns = np.r_[np.arange(count), count + 6 * item.camera + np.arange(6), len(right) - 1]
            rows = np.hstack([by_shape, by_step])
            normal[np.ix_(columns, columns)] += rows.T @ (weight[:, None] * rows)
            right[columns] += rows.T @ (weight * error)
        normal += 1e-9 * np.diag(np.diag(normal)) + 1e-12 * np.eye(len(right))
        room = np.broadcast_to(at_least, (count,)) - fit.coefficients
        step = _step(normal, right, np.append(room, np.full(len(right) - count, -np.inf)))
        step[-1] = step[-1] if zoom_sigma > 0.0 else 0.0
        fit = _stepped(fit, step, found)
    return fit


def _priors(fit: ShapeFit, rarity: Array | float, pull: Array, zoom_sigma: float) -> tuple[Array, Array]:
    """Return the normal equations of what is expected before any evidence: coefficients, cameras' turns, zoom."""
    count = len(fit.coefficients)
    size = count + 6 * len(fit.cameras) + 1
    normal, right = np.zeros((size, size)), np.zeros(size)
    normal[:count, :count] += np.eye(count)  # coefficients are spreads
    right[:count] -= fit.coefficients + rarity
    for index in range(len(fit.cameras)):
        turn = slice(count + 6 * index, count + 6 * index + 3)
        held = pull[index] / (1.0 + pull[index] * fit.turned[index] ** 2 / TURN_OUTLIER**2)
        normal[turn, turn] += np.diag(held)
        right[turn] -= held * fit.turned[index]
    normal[-1, -1] += 1.0 / max(zoom_sigma, 1e-6) ** 2
    right[-1] -= fit.zoomed / max(zoom_sigma, 1e-6) ** 2
    return normal, right


def _stepped(fit: ShapeFit, step: Array, found: Sequence[Evidence]) -> ShapeFit:
    """Return the fit after a step of coefficients, poses and zoom, each no longer than the linear model is good."""
    shape = np.clip(step[: len(fit.coefficients)], -1.0, 1.0)
    poses = np.array(step[len(shape) : -1].reshape(-1, 6), dtype=np.float64)
    poses[:, :3] = np.clip(poses[:, :3], -0.1, 0.1)
    zoom = float(np.clip(step[-1], -0.2, 0.2))
    depths = [_depth(next(item for item in found if item.camera == k), fit) for k in range(len(fit.cameras))]
    cameras = (moved_camera(zoomed_camera(c, zoom, d), p) for c, d, p in zip(fit.cameras, depths, poses, strict=True))
    return ShapeFit(fit.coefficients + shape, tuple(cameras), fit.turned + poses[:, :3], fit.zoomed + zoom)


def _step(normal: Array, right: Array, at_least: Array) -> Array:
    """Return the unknowns of normal equations of which none is smaller than its bound; those at it stay there."""
    bound = np.zeros(len(right), dtype=bool)
    step = np.asarray(np.linalg.solve(normal, right), dtype=np.float64)
    while (step < at_least - 1e-12).any():
        bound |= step < at_least
        held, free = np.where(bound, at_least, 0.0), ~bound
        step = held.copy()
        step[free] = np.linalg.solve(normal[np.ix_(free, free)], (right - normal @ held)[free])
    return step


def _depth(item: Evidence, fit: ShapeFit) -> float:
    """Return the mean depth of one photo's places, metres."""
    points = item.base_m + np.tensordot(fit.coefficients[: len(item.basis_m)], item.basis_m, axes=1)
    return float(fit.cameras[item.camera].to_camera(points)[:, 2].mean())


def misfit(fit: ShapeFit, evidence: Sequence[Evidence], turn_sigma: Array) -> float:
    """Return twice the negative log likelihood (Cauchy errors, normal priors): smaller is likelier.

    Comparable only among fits to the same places and targets, as when several starts are tried.
    """
    turns = np.log1p((fit.turned / turn_sigma) ** 2 / TURN_OUTLIER**2)
    total = float((fit.coefficients**2).sum() + TURN_OUTLIER**2 * turns.sum())
    for item in evidence:
        _, _, _, weight = _rows(item, fit.coefficients, fit.cameras[item.camera])
        group = 2 if item.normal_px is None else 1
        total -= item.outlier**2 * float(np.log(weight[::group]).sum())
    return total
