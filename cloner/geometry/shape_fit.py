"""Shape coefficients and camera poses together, from points and curves in photos (damped Gauss-Newton)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.resection import moved_camera, projection_derivatives
from cloner.records.views import Camera

Array = NDArray[np.float64]


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
    """

    camera: int
    base_m: Array
    basis_m: Array
    target_px: Array
    sigma_px: Array
    normal_px: Array | None = None
    outlier: float = 3.0
    drift_px: Array | None = None


@dataclass(frozen=True, slots=True, eq=False)
class ShapeFit:
    """Coefficients (F,) or with drifts (F + M,), cameras, and each turn from its starting pose (radians, (K, 3))."""

    coefficients: Array
    cameras: tuple[Camera, ...]
    turned: Array


def _rows(item: Evidence, coefficients: Array, camera: Camera) -> tuple[Array, Array, Array, Array]:
    """Return whitened errors (M,), their rows for shape (M, F) and pose (M, 6), and robust weights (M,)."""
    shapes = len(item.basis_m)
    points = item.base_m + np.tensordot(coefficients[:shapes], item.basis_m, axes=1)
    seen, by_point, by_step = projection_derivatives(camera, points)
    by_shape = np.zeros((*seen.shape, len(coefficients)))
    by_shape[..., :shapes] = np.einsum("nia,fna->nif", by_point, item.basis_m)
    if item.drift_px is not None:
        by_shape[..., shapes:] = item.drift_px.transpose(1, 2, 0)
        seen = seen + np.tensordot(coefficients[shapes:], item.drift_px, axes=1)
    error = item.target_px - seen
    if item.normal_px is not None:
        error = (error * item.normal_px).sum(1, keepdims=True)
        by_shape = np.einsum("ni,nif->nf", item.normal_px, by_shape)[:, None]
        by_step = np.einsum("ni,nip->np", item.normal_px, by_step)[:, None]
    scale = 1.0 / item.sigma_px[:, None]
    error = error * scale
    weight = 1.0 / (1.0 + (error**2).sum(1) / item.outlier**2)
    weight = np.repeat(weight, error.shape[1])
    return (
        error.ravel(),
        (by_shape * scale[..., None]).reshape(error.size, len(coefficients)),
        (by_step * scale[..., None]).reshape(error.size, 6),
        weight,
    )


def fit_shape(
    start: ShapeFit,
    gather: Callable[[ShapeFit, int], Sequence[Evidence]],
    *,
    prior_sigma: Array | float = 1.0,
    turn_sigma: Array | None = None,
    iterations: int = 10,
) -> ShapeFit:
    """Return the most likely coefficients and cameras.

    Parameters
    ----------
    start : ShapeFit
    gather : callable
        ``gather(fit, iteration)`` returns the evidence for the present fit: curves are matched afresh each time.
    prior_sigma : float or (F,)
        Expected size of the coefficients around zero.
    turn_sigma : (K, 3), optional
        Expected turn of each camera from its start, radians; infinite where the evidence alone decides.
    """
    fit = start
    count = len(fit.coefficients)
    prior = 1.0 / np.broadcast_to(np.asarray(prior_sigma, dtype=np.float64), (count,)) ** 2
    pull = np.zeros((len(fit.cameras), 3)) if turn_sigma is None else 1.0 / turn_sigma**2
    for iteration in range(iterations):
        size = count + 6 * len(fit.cameras)
        normal, right = np.zeros((size, size)), np.zeros(size)
        normal[:count, :count] += np.diag(prior)
        right[:count] -= prior * fit.coefficients
        for index in range(len(fit.cameras)):
            turn = slice(count + 6 * index, count + 6 * index + 3)
            normal[turn, turn] += np.diag(pull[index])
            right[turn] -= pull[index] * fit.turned[index]
        for item in gather(fit, iteration):
            error, by_shape, by_step, weight = _rows(item, fit.coefficients, fit.cameras[item.camera])
            columns = np.r_[np.arange(count), count + 6 * item.camera + np.arange(6)]
            rows = np.hstack([by_shape, by_step])
            normal[np.ix_(columns, columns)] += rows.T @ (weight[:, None] * rows)
            right[columns] += rows.T @ (weight * error)
        normal += 1e-9 * np.diag(np.diag(normal)) + 1e-12 * np.eye(size)
        step = np.linalg.solve(normal, right)
        step[:count] = np.clip(step[:count], -1.0, 1.0)
        poses = np.asarray(step[count:].reshape(-1, 6), dtype=np.float64)
        poses[:, :3] = np.clip(poses[:, :3], -0.1, 0.1)
        fit = ShapeFit(
            fit.coefficients + step[:count],
            tuple(moved_camera(c, p) for c, p in zip(fit.cameras, poses, strict=True)),
            fit.turned + poses[:, :3],
        )
    return fit


def misfit(fit: ShapeFit, evidence: Sequence[Evidence], turn_sigma: Array) -> float:
    """Return twice the negative log likelihood (Cauchy errors, normal priors): smaller is likelier.

    Comparable only among fits to the same places and targets, as when several starts are tried.
    """
    total = float((fit.coefficients**2).sum() + ((fit.turned / turn_sigma) ** 2).sum())
    for item in evidence:
        _, _, _, weight = _rows(item, fit.coefficients, fit.cameras[item.camera])
        group = 2 if item.normal_px is None else 1
        total -= item.outlier**2 * float(np.log(weight[::group]).sum())
    return total
