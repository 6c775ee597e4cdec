"""Shape coefficients and camera poses, fitted together to points and curves in photos."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.fit.cameras import MAX_TRANSLATION, CameraUnknowns
from cloner.fit.evidence import Residuals, correlated_residuals, point_residuals
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: Cauchy scale of the prior on a camera's rotation, sigmas: most people stand as they were asked, some do not.
ROTATION_OUTLIER: Final = 1.5
#: Longest steps of a coefficient in sigmas, of a camera's rotation, and of the logarithm of the focal length.
MAX_SHAPE, MAX_ROTATION_RAD, MAX_LOG_ZOOM = 1.0, 0.1, 0.2


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """Points of the model with their observed pixels in one photo.

    Attributes
    ----------
    camera : int
        Index of the photo's camera.
    base_m : (N, 3)
        The points at zero coefficients, metres.
    basis_m : (F, N, 3)
        Their derivatives by the coefficients.
    target_px : (N, 2)
    sigma_px : (N,)
        Standard deviations.
    normal_px : (N, 2) or None
        Unit normals of a curve: only the error along them counts.
    outlier : float
        Cauchy scale in sigmas.
    common_error_px : (M, N, 2) or None
        Modes of the errors that all targets share; their amplitudes are unknowns behind the shape coefficients.
    shape_error_px : (F, N, 2) or None
        Derivatives of the targets' systematic errors by the shape coefficients.
    whiten : (2 N, 2 N) or None
        Whitening matrix of correlated errors (x0, y0, x1, ...), in place of ``sigma_px``; one robust weight for all.
    """

    camera: int
    base_m: Array
    basis_m: Array
    target_px: Array
    sigma_px: Array
    normal_px: Array | None = None
    outlier: float = 3.0
    common_error_px: Array | None = None
    shape_error_px: Array | None = None
    whiten: Array | None = None

    def places_m(self, coefficients: Array) -> Array:
        """Return the points (N, 3) for some coefficients, metres."""
        return np.asarray(self.base_m + np.tensordot(coefficients[: len(self.basis_m)], self.basis_m, axes=1))

    def residuals(
        self, coefficients: Array, camera: CameraUnknowns, motion: Array, zoom: Array | None = None
    ) -> Residuals:
        """Return the residuals and their Jacobian by coefficients, camera and, where it is estimated, zoom."""
        shapes, number = len(self.basis_m), f"camera {self.camera}"
        seen, by_point, by_camera = camera.project(
            self.places_m(coefficients), motion, 0.0 if zoom is None else float(zoom[0])
        )
        by_shape = np.zeros((*seen.shape, len(coefficients)))
        by_shape[..., :shapes] = np.einsum("nia,fna->nif", by_point, self.basis_m)
        if self.shape_error_px is not None:
            by_shape[..., :shapes] += self.shape_error_px.transpose(1, 2, 0)
            seen = seen + np.tensordot(coefficients[:shapes], self.shape_error_px, axes=1)
        if self.common_error_px is not None:
            by_shape[..., shapes:] = self.common_error_px.transpose(1, 2, 0)
            seen = seen + np.tensordot(coefficients[shapes:], self.common_error_px, axes=1)
        of = ("shape", number) if zoom is None else ("shape", number, "zoom")
        jacobian = np.concatenate([by_shape, by_camera[..., : 6 if zoom is None else 7]], axis=2)
        offset = seen - self.target_px
        if self.whiten is not None:
            return correlated_residuals(of, offset, jacobian, self.whiten, outlier=self.outlier)
        return point_residuals(of, offset, jacobian, self.sigma_px, outlier=self.outlier, normal=self.normal_px)


@dataclass(frozen=True, slots=True, eq=False)
class ShapeFit:
    """Shape coefficients (F,), or with common errors (F + M,), the cameras, and their offsets from the prior.

    ``rotation_offset`` (K, 3) are rotations from the expected poses, radians; ``log_zoom`` is the logarithm of the
    common factor of all focal lengths, with distances that keep the head's size in the photos.
    """

    coefficients: Array
    cameras: tuple[Camera, ...]
    rotation_offset: Array
    log_zoom: float = 0.0


def fit_shape(
    start: ShapeFit,
    gather: Callable[[ShapeFit, int], Sequence[Evidence]],
    *,
    lower: Array | float = -np.inf,
    decay_rate: Array | float = 0.0,
    rotation_sigma: Array | None = None,
    zoom_sigma: float = 0.0,
    iterations: int = 10,
) -> ShapeFit:
    """Return the most likely coefficients and cameras.

    Parameters
    ----------
    start : ShapeFit
    gather : callable
        ``gather(fit, iteration)`` returns the evidence for the present fit: curves are matched afresh each time.
    lower : float or (F,)
        Lower bound of the coefficients.
    decay_rate : float or (F,)
        Rate of an exponential prior beside the normal one, for what is mostly absent.
    rotation_sigma : (K, 3), optional
        Prior on each camera's ``ShapeFit.rotation_offset``, radians (Cauchy, ``ROTATION_OUTLIER``); infinite for none.
    zoom_sigma : float
        Prior on ``log_zoom``; 0 keeps the focal lengths.
    """
    fit = start
    for iteration in range(iterations):  # each step starts from the present poses, so rotation offsets add up
        fit = _gauss_newton_step(fit, gather(fit, iteration), lower, decay_rate, rotation_sigma, zoom_sigma)
    return fit


def _gauss_newton_step(
    fit: ShapeFit,
    found: Sequence[Evidence],
    lower: Array | float,
    decay_rate: Array | float,
    rotation_sigma: Array | None,
    zoom_sigma: float,
) -> ShapeFit:
    """Return the fit after one Gauss-Newton step."""
    names = [f"camera {k}" for k in range(len(fit.cameras))]
    depths = _mean_depths_m(fit, found)
    blocks = {"shape": ParameterBlock(fit.coefficients, 0.0, 1.0, np.inf, decay_rate, lower, max_step=MAX_SHAPE)}
    for number, name in enumerate(names):
        sigma, mean = np.full(6, np.inf), np.zeros(6)
        mean[:3] = -fit.rotation_offset[number]
        sigma[:3] = np.inf if rotation_sigma is None else rotation_sigma[number]
        max_step = np.repeat([MAX_ROTATION_RAD, MAX_TRANSLATION * depths[number]], 3)
        blocks[name] = ParameterBlock(np.zeros(6), mean, sigma, ROTATION_OUTLIER, max_step=max_step)
    if zoom_sigma > 0.0:
        blocks["zoom"] = ParameterBlock(np.zeros(1), -fit.log_zoom, zoom_sigma, max_step=MAX_LOG_ZOOM)
    unknowns = [CameraUnknowns(camera, float(depth)) for camera, depth in zip(fit.cameras, depths, strict=True)]

    def linearise(values: Values, iteration: int) -> list[Residuals]:
        zoom = values.get("zoom")
        return [one.residuals(values["shape"], unknowns[one.camera], values[names[one.camera]], zoom) for one in found]

    values = Problem(blocks).solve(linearise, iterations=1).values
    zoom, motions = float(values["zoom"][0]) if "zoom" in values else 0.0, np.array([values[name] for name in names])
    cameras = tuple(one.camera(motion, zoom) for one, motion in zip(unknowns, motions, strict=True))
    return ShapeFit(values["shape"], cameras, fit.rotation_offset + motions[:, :3], fit.log_zoom + zoom)


def _mean_depths_m(fit: ShapeFit, found: Sequence[Evidence]) -> Array:
    """Return the mean depth (K,) of each photo's points, metres."""
    first = [next(item for item in found if item.camera == number) for number in range(len(fit.cameras))]
    inside = [fit.cameras[item.camera].to_camera(item.places_m(fit.coefficients)) for item in first]
    return np.array([places[:, 2].mean() for places in inside])


def misfit(fit: ShapeFit, evidence: Sequence[Evidence], rotation_sigma: Array) -> float:
    """Return twice the negative log likelihood (Cauchy errors, normal priors): smaller is likelier.

    Comparable only among fits to the same places and targets, as when several starts are tried.
    """
    rotations = np.log1p((fit.rotation_offset / rotation_sigma) ** 2 / ROTATION_OUTLIER**2)
    total = float((fit.coefficients**2).sum() + ROTATION_OUTLIER**2 * rotations.sum())
    for item in evidence:
        terms = item.residuals(fit.coefficients, CameraUnknowns(fit.cameras[item.camera]), np.zeros(6))
        group = 2 if item.normal_px is None else 1
        total -= item.outlier**2 * float(np.log(np.asarray(terms.weight)[::group]).sum())
    return total
