"""Even out exposure, white balance and light between photos of one person."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LEVEL_OFFSET = 8.0  # grey levels; keeps the logarithm of dark cloth finite and its noise small
ROUNDS = 6  # reweighted least squares settles after 4-6 rounds (measured)
HUBER_LOG = 0.08  # differences above 8 % are other things than light: cloth moved, a limb in the way
_RIDGE_CONSTANT = 1.0  # taste: against pairs that weigh 20-50, exposure is nearly free
RIDGE_SLOPE = 20.0  # taste: misplaced cloth must not pass for light from one side
LARGEST_LOG = 0.15  # taste: a gain beyond 1.16 burns skin out; real lamps differ more, then a rest stays
REFERENCE_HOLD = 1e4  # a reference does not give way
SECOND_HOLD = 4.0  # taste: the other front photo gives way little


def log_levels(rgb: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return the logarithm of colours in levels, shifted to stay finite."""
    return np.asarray(np.log(np.maximum(rgb, 0.0) + LEVEL_OFFSET))


def light_basis(normals: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return (N, 4) first-order spherical harmonics 1, x, y, z of (N, 3) normals."""
    return np.concatenate([np.ones((len(normals), 1), normals.dtype), normals], axis=1)


def even_light(
    colours: Array, weights: Array, normals: Array, hold: Array, *, ridge_slope: float = RIDGE_SLOPE
) -> Array:
    """Return the log gains that bring photos together where they overlap.

    Each photo k gets log gain ``basis(n) @ result[k]``: one exposure per
    channel plus a first-order change of light with the surface's direction,
    because the lamp stands still while the person turns.

    Parameters
    ----------
    colours : (K, V, 3), levels
        The surface's colour in every photo (slightly blurred).
    weights : (K, V) >= 0, trust, 0 = not seen
    normals : (V, 3) unit
    hold : (K,) >= 1
        How much less than others each photo may change; large for the photos whose colours count.
    ridge_slope : float
        Reluctance against light that changes with direction; large = exposure only.

    Returns
    -------
    (K, 4, 3) coefficients; zero for photos without overlap and for those that evening would make worse.
    """
    count = len(colours)
    logs = np.asarray(log_levels(colours), np.float64)
    basis = np.asarray(light_basis(normals), np.float64)
    result: Array = np.zeros((count, 4, 3))
    pairs = [(a, b) for a in range(count) for b in range(a + 1, count)]
    for _ in range(ROUNDS):
        ridge = np.diag([_RIDGE_CONSTANT] + 3 * [ridge_slope])
        system: Array = np.asarray(np.kron(np.diag(hold), ridge), np.float64)
        right = np.zeros((count * 4, 3))
        for a, b in pairs:
            trust = np.minimum(weights[a], weights[b])
            rows = np.flatnonzero(trust > 0.0)
            if rows.size < 12:
                continue
            base = basis[rows]
            gap = logs[a, rows] - logs[b, rows] + base @ (result[a] - result[b])
            weight = trust[rows] / np.maximum(np.abs(gap).mean(axis=1) / HUBER_LOG, 1.0)
            # A long overlap must not silence a short one entirely: weights per pair, not per vertex.
            weight = weight / np.sqrt(trust.sum())
            gram = base.T @ (weight[:, None] * base)
            drive = base.T @ (weight[:, None] * (logs[b, rows] - logs[a, rows]))
            first, second = slice(4 * a, 4 * a + 4), slice(4 * b, 4 * b + 4)
            system[first, first] += gram
            system[second, second] += gram
            system[first, second] -= gram
            system[second, first] -= gram
            right[first] += drive
            right[second] -= drive
        result = np.asarray(np.linalg.solve(system, right), np.float64).reshape(count, 4, 3)
    return _without_harm(result, logs, weights, basis)


def _without_harm(gains: Array, logs: Array, weights: Array, basis: Array) -> Array:
    """Return the gains with those of a photo set to zero that agrees better without."""
    kept = gains.copy()
    for k in range(len(gains)):
        before, after = [], []
        for j in range(len(gains)):
            rows = np.minimum(weights[k], weights[j]) > 0.0
            if j == k or not rows.any():
                continue
            other = logs[j, rows] + _limited(basis[rows] @ kept[j])
            before.append(np.abs(logs[k, rows] - other).mean(axis=1))
            after.append(np.abs(logs[k, rows] + _limited(basis[rows] @ kept[k]) - other).mean(axis=1))
        if before and np.median(np.concatenate(after)) > np.median(np.concatenate(before)):
            kept[k] = 0.0
    return kept


def apply_light(rgb: NDArray[np.floating], log_gain: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return colours (N, 3) in levels after log gains (N, 3), clipped to 0..255."""
    gain = np.exp(_limited(log_gain))
    return np.asarray(np.clip((rgb + LEVEL_OFFSET) * gain - LEVEL_OFFSET, 0.0, 255.0))


def _limited(log_gain: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return log gains bent smoothly into +-LARGEST_LOG."""
    return np.asarray(LARGEST_LOG * np.tanh(log_gain / LARGEST_LOG))
