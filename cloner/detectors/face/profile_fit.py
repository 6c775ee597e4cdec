"""Fit of a shape model of profiles to the person's outline in a side photo.

Face nets fail at 90 degrees, so the profile is found by its shape. The model (``profile_shapes.py``) holds outlines of
random turned heads together with their named points; a coarse search over places, sizes, tilts and a few shapes gives
starts, Gauss-Newton lays the model on the outline, and the best one tells where the named points are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.calibration.loader import calibrated
from cloner.detectors.face.profile_search import ProfileModel, curve_normals, scale_of, search_starts
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.profile_fit")

_SIGMA_M: Final = _CALIBRATED.number("sigma_m", "m")
_GATES_M: Final = _CALIBRATED.numbers("gates_m", "m")
_MISS_M: Final = _CALIBRATED.number("miss_m", "m")
_MISS_PRIOR: Final = _CALIBRATED.number("miss_prior", "share")
_NORMAL_M: Final = _CALIBRATED.number("normal_m", "m")


@dataclass(frozen=True, slots=True, eq=False)
class FittedProfile:
    """A profile model fitted to a photo.

    Attributes
    ----------
    px_from_m : (2, 3) float64
        Maps (forward, up, 1) to photo px.
    weights : (B,) float64
    cost : float
        Share of the model's outline that misses the photo's, 0..1, plus the prior's share.
    covariance : (4 + B, 4 + B) float64
        Of size and turn, place, and weights, as the last turn of Gauss-Newton leaves it.
    """

    px_from_m: Array
    weights: Array
    cost: float
    covariance: Array

    @property
    def size(self) -> float:
        """Pixels per metre."""
        return scale_of(self.px_from_m)

    def curve_px(self, model: ProfileModel) -> Array:
        """Return the outline (M, 2) of the fitted model, photo px."""
        return np.asarray(model.shape(self.weights)[: model.samples] @ self.px_from_m[:, :2].T + self.px_from_m[:, 2])


def fit_profile(outline_px: Array, model: ProfileModel, start: Array, weights: Array, size: float) -> FittedProfile:
    """Return the model fitted to an outline by Gauss-Newton from a start.

    Parameters
    ----------
    outline_px : (N, 4) float64
        Points of the person's outline and its outward normals.
    start : (2, 3), weights : (B,)
    size : float
        Px per metre expected, known to about a fifth.
    """
    px_from_m, weights = np.asarray(start), np.asarray(weights)
    covariance: Array = np.eye(4 + len(weights))
    for gate in _GATES_M:
        here, _, found, kept = _correspondences(outline_px, model, px_from_m, weights, gate)
        if kept.sum() < 20:
            break
        now = scale_of(px_from_m)
        normal = outline_px[found, 2:]
        gap = ((outline_px[found, :2] - here) * normal).sum(axis=1) / now
        share = 1.0 / (1.0 + (gap / (0.35 * gate)) ** 2) ** 2
        strength = np.where(kept, share, 0.0) / _SIGMA_M**2
        px_from_m, weights, covariance = _step(model, px_from_m, weights, normal, gap, strength, size)
    return FittedProfile(px_from_m, weights, _cost(outline_px, model, px_from_m, weights), covariance)


def _step(
    model: ProfileModel, px_from_m: Array, weights: Array, normal: Array, gap: Array, strength: Array, size: float
) -> tuple[Array, Array, Array]:
    """Return map, weights and covariance after one step of Gauss-Newton towards gaps (M,) metres along normals."""
    now = scale_of(px_from_m)
    slope = _jacobian(model, px_from_m, weights, normal, now)
    prior = np.concatenate([[25.0, 8.0, 0.0, 0.0], np.ones(len(weights))])
    pull = np.concatenate([[25.0 * np.log(size / now), 0.0, 0.0, 0.0], -weights])
    system = slope.T @ (strength[:, None] * slope) + np.diag(prior + 1e-9)
    step = np.linalg.solve(system, slope.T @ (strength * gap) + pull)
    moved = _updated(px_from_m, step[:4], model)
    return moved, np.asarray(weights + step[4:]), np.asarray(np.linalg.inv(system))


def _correspondences(
    outline_px: Array, model: ProfileModel, px_from_m: Array, weights: Array, gate: float
) -> tuple[Array, Array, NDArray[np.intp], NDArray[np.bool_]]:
    """Return model points and normals in px, their nearest outline points by position and slope, and which count."""
    size = scale_of(px_from_m)
    curve = model.shape(weights)[: model.samples]
    here = curve @ px_from_m[:, :2].T + px_from_m[:, 2]
    outwards = curve_normals(curve) @ px_from_m[:, :2].T / size
    tree = cKDTree(np.hstack([outline_px[:, :2], _NORMAL_M * size * outline_px[:, 2:]]))
    _, found = tree.query(np.hstack([here, _NORMAL_M * size * outwards]))
    near = np.linalg.norm(outline_px[found, :2] - here, axis=1) < gate * size
    alike = (outline_px[found, 2:] * outwards).sum(axis=1) > 0.5
    return here, outwards, found, near & alike


def _jacobian(model: ProfileModel, px_from_m: Array, weights: Array, normal: Array, size: float) -> Array:
    """Return the derivatives (M, 4 + B) along the normals, metres, by log scale, rotation, translation and weights."""
    centred = (model.shape(weights)[: model.samples] - model.mean[: model.samples].mean(axis=0)) @ px_from_m[:, :2].T
    turned = np.column_stack([-centred[:, 1], centred[:, 0]])
    bent = model.modes[:, : model.samples] @ px_from_m[:, :2].T
    return np.column_stack(
        [
            (centred * normal).sum(axis=1) / size,
            (turned * normal).sum(axis=1) / size,
            normal[:, 0],
            normal[:, 1],
            np.einsum("bma,ma->mb", bent, normal) / size,
        ]
    )


def _updated(px_from_m: Array, step: Array, model: ProfileModel) -> Array:
    """Return the map after a step of log scale, rotation (radians, clockwise as seen) and translation (metres)."""
    size = scale_of(px_from_m)
    step = step * min(1.0, 0.3 / max(abs(step[0]), abs(step[1]), 1e-9))
    c, s = np.cos(step[1]), np.sin(step[1])
    linear = np.exp(step[0]) * np.array([[c, -s], [s, c]]) @ px_from_m[:, :2]
    pivot = model.mean[: model.samples].mean(axis=0)
    shift = px_from_m[:, :2] @ pivot + px_from_m[:, 2] + size * step[2:] - linear @ pivot
    return np.column_stack([linear, shift])


def _cost(outline_px: Array, model: ProfileModel, px_from_m: Array, weights: Array) -> float:
    """Return the cost of a fitted model."""
    here, outwards, found, kept = _correspondences(outline_px, model, px_from_m, weights, _GATES_M[-1])
    size = scale_of(px_from_m)
    gap = ((outline_px[found, :2] - here) * outwards).sum(axis=1) / size
    missed = np.where(kept, gap**2 / (gap**2 + _MISS_M**2), 1.0)
    return float(missed.mean() + _MISS_PRIOR * float(weights @ weights) / model.samples)


def fit_from_all_starts(
    mask: NDArray[np.uint8],
    outline_px: Array,
    model: ProfileModel,
    noses_px: Array,
    facing: int,
    size: float,
    lean: float,
) -> list[FittedProfile]:
    """Return the model fitted to an outline from all starts of the search.

    Parameters
    ----------
    mask : (H, W) uint8
    outline_px : (N, 4) outline points and outward normals
    noses_px : (M, 2) where the nose tip may be
    facing : int
        +1 when the person looks to the image's right, -1 left.
    size, lean : float
        First guesses: px per metre, and the tilt in radians.
    """
    if len(noses_px) == 0:
        return []
    starts = search_starts(mask, model, noses_px, facing, size, lean)
    return [fit_profile(outline_px, model, start, weights, size) for start, weights in starts]


def named_px(model: ProfileModel, fitted: FittedProfile) -> tuple[Array, Array]:
    """Return the named points (K, 2) px and their sigmas (K,), metres, along one axis."""
    shape = model.shape(fitted.weights)
    points = shape[model.samples :] @ fitted.px_from_m[:, :2].T + fitted.px_from_m[:, 2]
    bent = model.modes[:, model.samples :].transpose(1, 2, 0)
    centred = shape[model.samples :] - model.mean[: model.samples].mean(axis=0)
    # upright frame: turning by a radian moves (forward, up) to (-up, forward); its sign does not matter for a spread
    fixed = np.stack([centred, np.column_stack([-centred[:, 1], centred[:, 0]])], axis=2)
    place = np.broadcast_to(np.eye(2), (len(centred), 2, 2))
    slope = np.concatenate([fixed, place, bent], axis=2)
    sigma = np.einsum("kai,ij,kaj->k", slope, fitted.covariance, slope) / 2.0
    return points, np.sqrt(np.maximum(sigma, 0.0) + model.rest_m[model.samples :] ** 2)
