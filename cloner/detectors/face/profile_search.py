"""The shape model of profiles, and the coarse search along a person's outline."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array
from cloner.records.proposals import PERSON_LEVEL

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.profile_search")

Field = NDArray[np.float32]

#: Rows of the picture in which the search looks; a face then has a pixel a millimetre or so.
_SEARCH_ROWS: Final = 600
#: Sizes around the guess, and tilts in radians.
_SIZES: Final = np.geomspace(0.66, 1.5, 12)
_TILTS: Final = np.radians(np.linspace(-27.0, 27.0, 10))
#: Modes of which both ends are tried, and how far they go, standard deviations.
_TRIED_MODES: Final = 3
_TRIED_SIGMA: Final = _CALIBRATED.number("tried_sigma", "sigmas")
_FEEL_M: Final = _CALIBRATED.number("feel_m", "m")
_CAP_M: Final = _CALIBRATED.number("cap_m", "m")
_UNUSUAL_SIZE: Final = _CALIBRATED.number("unusual_size", "cost")
_UNUSUAL_TILT: Final = _CALIBRATED.number("unusual_tilt", "cost")
STARTS: Final = 10


@dataclass(frozen=True, slots=True, eq=False)
class ProfileModel:
    """Outlines of side faces with named points.

    Attributes
    ----------
    mean : (M + K, 2) float64
        Forward and up, metres; first the outline from over the glabella to behind the chin, then the named points.
    modes : (B, M + K, 2) float64
        Times a standard normal number each.
    rest_m : (M + K,) float64
        Spread that the modes leave.
    names : tuple of str, K of them
        Those without a side; paired ones are of the side that is seen.
    """

    mean: Array
    modes: Array
    rest_m: Array
    names: tuple[str, ...]

    @property
    def samples(self) -> int:
        """Number of outline points M."""
        return len(self.mean) - len(self.names)

    def shape(self, weights: Array) -> Array:
        """Return the (M + K, 2) shape of some weights (B,)."""
        return np.asarray(self.mean + np.tensordot(weights, self.modes, axes=1))


def similarity(facing: int, size: float, tilt: float, nose_px: Array, nose_m: Array) -> Array:
    """Return the (2, 3) map of (forward, up, 1) metres to px that puts a point on another; tilt turns faces upwards."""
    c, s = size * np.cos(tilt), size * np.sin(tilt)
    linear = np.array([[facing * c, -facing * s], [-s, -c]])
    return np.column_stack([linear, nose_px - linear @ nose_m])


def scale_of(px_from_m: Array) -> float:
    """Return the pixels per metre of a similarity (2, 3)."""
    return float(np.sqrt(abs(np.linalg.det(px_from_m[:, :2]))))


def curve_normals(curve: Array) -> Array:
    """Return unit normals (N, 2) of an open curve: to the left of its direction in an x-right, y-up frame."""
    along = np.gradient(curve, axis=0)
    along = unit(along, 1e-12)
    return np.column_stack([-along[:, 1], along[:, 0]])


def signed_distance(mask: NDArray[np.uint8], scale: float) -> Field:
    """Return the (h, w) distance to the outline of a person's probability, inside positive, scaled px."""
    size = (max(1, round(mask.shape[1] * scale)), max(1, round(mask.shape[0] * scale)))
    inside = (cv2.resize(mask, size, interpolation=cv2.INTER_AREA) > PERSON_LEVEL).astype(np.uint8)
    within = cv2.distanceTransform(inside, cv2.DIST_L2, 5)
    return np.asarray(within - cv2.distanceTransform(1 - inside, cv2.DIST_L2, 5), np.float32)


def search_starts(
    mask: NDArray[np.uint8], model: ProfileModel, noses_px: Array, facing: int, size: float, lean: float
) -> list[tuple[Array, Array]]:
    """Return starts, best first: (2, 3) maps and weights.

    Parameters
    ----------
    mask : (H, W) uint8
    model : ProfileModel
    noses_px : (N, 2) outline points that may be the nose tip
    size : float
        First guess, px per metre.
    lean : float
        First guess of the tilt, radians.
    """
    scale = min(1.0, _SEARCH_ROWS / mask.shape[0])
    field = signed_distance(mask, scale)
    shapes = [np.zeros(len(model.modes))]
    for mode in range(_TRIED_MODES):
        for sign in (-1.0, 1.0):
            weights = np.zeros(len(model.modes))
            weights[mode] = sign * _TRIED_SIGMA
            shapes.append(weights)
    rated: list[tuple[float, Array, Array]] = []
    for weights in shapes:
        for tilt in _TILTS:
            cost, sizes = _mean_distances(field, model, weights, noses_px * scale, facing, size * scale, float(tilt))
            cost = cost + _UNUSUAL_TILT * (tilt - 0.5 * lean) ** 2 + _UNUSUAL_SIZE * np.log(_SIZES)[None] ** 2
            for row in np.argsort(cost, axis=None)[:STARTS]:
                nose, which = np.unravel_index(row, cost.shape)
                tip = model.shape(weights)[model.samples + model.names.index("nose_tip")]
                start = similarity(facing, sizes[which] / scale, float(tilt), noses_px[nose], tip)
                rated.append((float(cost[nose, which]), start, weights))
    rated.sort(key=lambda r: r[0])
    return _distinct_starts(rated, model)


def _mean_distances(
    field: Field, model: ProfileModel, weights: Array, noses: Array, facing: int, size: float, tilt: float
) -> tuple[Array, Array]:
    """Return (noses, sizes) mean capped distances in metres, and the sizes tried in the field's px per metre."""
    shape = model.shape(weights)
    curve = shape[: model.samples]
    tip = shape[model.samples + model.names.index("nose_tip")]
    outwards = curve_normals(curve)[::3]
    sizes = size * _SIZES
    felt = np.stack([curve[::3] + away * outwards for away in (-_FEEL_M, 0.0, _FEEL_M)]) - tip
    want = np.array([_FEEL_M, 0.0, -_FEEL_M])[:, None]
    turned = felt @ similarity(facing, 1.0, tilt, np.zeros(2), np.zeros(2))[:, :2].T
    reach = sizes[:, None, None, None] * turned
    column, row = (
        np.clip(np.rint(noses[:, axis, None, None, None] + reach[..., axis]).astype(np.int32), 0, end - 1)
        for axis, end in ((0, field.shape[1]), (1, field.shape[0]))
    )
    felt_px = field.ravel().take(row * np.int32(field.shape[1]) + column)  # a third of an index's time
    gap = np.abs(felt_px / sizes[None, :, None, None] - want)
    return np.minimum(gap, _CAP_M).mean(axis=(2, 3)), sizes


def _distinct_starts(rated: list[tuple[float, Array, Array]], model: ProfileModel) -> list[tuple[Array, Array]]:
    """Return the best starts without near duplicates."""
    kept: list[tuple[Array, Array]] = []
    places: list[Array] = []
    for _, start, weights in rated:
        knots = model.shape(weights)[[0, model.samples // 2, model.samples - 1]] @ start[:, :2].T + start[:, 2]
        reach = 0.008 * scale_of(start)
        if all(np.abs(knots - other).max() > reach for other in places):
            kept.append((start, weights))
            places.append(knots)
        if len(kept) == STARTS:
            break
    return kept
