"""The front contour of a side face, and the alignment of a known profile with it."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from skimage.measure import find_contours

from cloner.calibration.loader import calibrated
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.profile")


#: Tries around a first guess when the profile itself is known well: sizes, tilts, and how far the nose tip may be off.
KNOWN_SIZES = np.geomspace(0.75, 1.33, 19)
KNOWN_TILTS = np.radians(np.linspace(-14.0, 14.0, 9))
KNOWN_TIP_M = _CALIBRATED.number("known_tip_m", "m")


def outline(mask: NDArray[np.uint8]) -> Array:
    """Return the longest closed contour of a person's probability (0..255), (N, 2) subpixel px."""
    padded = np.pad(mask.astype(np.float32), 1)
    contours = find_contours(padded, 127.5)
    if not contours:
        return np.zeros((0, 2))
    longest = max(contours, key=len)
    return np.asarray(longest[:, ::-1] - 1.0, dtype=np.float64)


def front_contour(contour: Array, facing: int, bottom_px: float) -> Array:
    """Return the contour points with nothing of the person in front of them by more than a deep eye socket."""
    rows = np.round(contour[:, 1]).astype(int)
    ahead = facing * contour[:, 0]
    front = np.full(rows.max() + 1, -np.inf)
    np.maximum.at(front, np.maximum(rows, 0), ahead)
    depth = 0.03 * float(np.ptp(contour[:, 1]))
    keep = (ahead > front[np.maximum(rows, 0)] - depth) & (contour[:, 1] < bottom_px)
    return np.asarray(contour[keep])


def _similarity(facing: int, size: float, tilt: float, nose_px: Array) -> Array:
    """Return the (2, 3) map of (forward, up, 1) metres to px; tilt turns the face upwards."""
    c, s = np.cos(tilt), np.sin(tilt)
    forward, up = size * np.array([facing * c, -s]), size * np.array([-facing * s, -c])
    return np.column_stack([forward, up, nose_px])


def _trimmed_mean(distance: Array) -> Array:
    """Return the mean of the best four fifths along the last axis."""
    keep = int(0.8 * distance.shape[-1])
    return np.asarray(np.partition(distance, keep, axis=-1)[..., :keep].mean(axis=-1))


def _trimmed_icp(px_from_m: Array, tree: cKDTree, contour: Array, profile: Array, facing: int) -> tuple[Array, float]:
    """Return the similarity after some iterations of trimmed ICP."""
    flat = profile * [facing, -1.0]
    error = np.inf
    for _ in range(3):
        here = profile @ px_from_m[:, :2].T + px_from_m[:, 2]
        distance, index = tree.query(here)
        size = float(np.sqrt(abs(np.linalg.det(px_from_m[:, :2]))))
        error = float(_trimmed_mean(distance)) / size
        keep = distance <= max(np.quantile(distance, 0.85), 1e-9)
        source, target = flat[keep] @ [1, 1j], contour[index[keep]] @ [1, 1j]
        centred, aim = source - source.mean(), target - target.mean()
        factor = (np.conj(centred) @ aim) / (np.conj(centred) @ centred)
        shift = target.mean() - factor * source.mean()
        linear = np.array([[factor.real, -factor.imag], [factor.imag, factor.real]]) @ np.diag([facing, -1.0])
        px_from_m = np.column_stack([linear, [shift.real, shift.imag]])
    return px_from_m, error


def align_profile(contour: Array, profile_m: Array, nose_px: Array, *, size: float, facing: int) -> tuple[Array, float]:
    """Return the (2, 3) map (forward, up, 1) -> px that aligns a known profile with a contour, and its error in metres.

    Parameters
    ----------
    contour : (N, 2) px
    profile_m : (M, 2)
        Forward and up from the nose tip, metres.
    nose_px : (2,)
        The nose tip in the photo, roughly.
    size : float
        First guess, px per metre.
    """
    tree = cKDTree(contour)
    near = contour[np.linalg.norm(contour - nose_px, axis=1) < KNOWN_TIP_M * size]
    noses = near[:: max(1, len(near) // 13)] if len(near) else nose_px[None]
    best, found = np.inf, _similarity(facing, size, 0.0, nose_px)
    for tilt in KNOWN_TILTS:
        flat = profile_m @ _similarity(facing, 1.0, float(tilt), np.zeros(2))[:, :2].T
        sizes = size * KNOWN_SIZES
        tried = noses[:, None, None] + sizes[None, :, None, None] * flat
        distance, _ = tree.query(tried.reshape(-1, 2))
        error = _trimmed_mean(distance.reshape(len(noses), len(sizes), len(flat))) / sizes
        nose, which = np.unravel_index(int(np.argmin(error)), error.shape)
        if error[nose, which] < best:
            best, found = float(error[nose, which]), _similarity(facing, float(sizes[which]), float(tilt), noses[nose])
    return _trimmed_icp(found, tree, contour, profile_m, facing)
