"""Normalisation of exposure, white balance and lighting between photos of one person."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.arrays import Array

#: Whose light cloth keeps: the first of these photos that shows it, on the body and on surfaces beside it.
CLOTH_REFERENCES = (ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.BODY_SIDE, ViewId.FACE_FRONT, ViewId.FACE_SIDE)
LUMA = np.array([0.299, 0.587, 0.114])  # ITU-R BT.601
LEVEL_OFFSET = 8.0  # grey levels; keeps the logarithm of dark cloth finite and its noise small
ROUNDS = 8  # reweighted least squares settles after 6-8 rounds (measured)
HUBER_LOG = 0.15  # differences above 15 % are mostly other things than light: cloth moved, a limb in the way
_RIDGE_CONSTANT = 1.5  # tried 0.2 to 2: less lets a shaded sleeve whiten a whole back, more leaves its cast
RIDGE_SLOPE = 4.0  # taste: misplaced cloth must not pass for light from one side
LARGEST_LOG = 0.8  # of gamma-coded levels, a factor of 5 in light: a bright side photo beside a dim front one has .65
_BEND = 6  # a gain of half the largest loses .3 %, of three quarters 3 %
REFERENCE_HOLD = 1e4  # a reference does not give way
SATURATED = (225.0, 252.0)  # levels from which on a channel is believed less, and not at all
CLIPPED = (238.0, 252.0)  # red levels between which it is taken for clipped; JPEG rings by some levels
LARGEST_RED = 330.0  # beyond this green is clipped as well
FLATTENED = 0.35  # taste: share of one-sided light on skin that is taken out; all of it makes faces look drawn
FLATTENED_CLOTH = 0.2  # taste: folds turn into light and dark sides too
SLOPE_HUBER = 0.05  # beyond 5 % the two halves of a person differ by more than light
LEAST_PAIRS = 60  # fewer vertices on both halves tell nothing
LIGHT_LOG = 0.8  # taste: a hard lamp makes the same dark cloth twice as bright in one photo as in another
HUE_LOG = 0.1  # light of one place changes the channels alike to some 10 %


def log_levels(rgb: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return the logarithm of colours in levels, shifted to stay finite."""
    return np.asarray(np.log(np.maximum(rgb, 0.0) + LEVEL_OFFSET))


def light_basis(normals: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return (N, 4) first-order spherical harmonics 1, x, y, z of (N, 3) normals."""
    return np.concatenate([np.ones((len(normals), 1), normals.dtype), normals], axis=1)


def even_light(
    colours: Array, weights: Array, normals: Array, hold: Array, *, ridge_slope: float = RIDGE_SLOPE
) -> Array:
    """Return the log gains that match photos where they overlap.

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
    return _reject_harmful(result, logs, weights, basis)


def reference_index(shown: Iterable[tuple[ViewId, bool]], references: Sequence[ViewId]) -> int:
    """Return the photo with the largest colour weight, as (view, whether mirrored): own photos before mirrored ones."""
    places = [(references.index(view), mirrored) for view, mirrored in shown]
    return places.index(min(places))


def common_balance(colours: Array, light: Array, weights: Array, own: NDArray[np.bool_]) -> Array:
    """Return the log gains (3,) that replace the reference's exposure and white balance by those of all photos.

    Every camera guesses how bright and of what colour its room's light is; the mean of the guesses is nearer to the
    truth than any single one.  A guess of the colour (luma, ITU-R BT.601, apart) counts by how bright it shows the
    surface: veils and noise take the colour out of what is dark.

    Parameters
    ----------
    colours : (K, V, 3) levels
    light : (K, V, 3) log gains that bring the photos to their reference
    weights : (K, V) >= 0, 0 = not seen
    own : (K,) the photos that count, each once
    """
    counted = own & (weights.sum(axis=1) > 0.0)
    if not counted.any():
        return np.zeros(3)
    exposures, casts, bright = [], [], []
    for seen, gain, weight in zip(colours[counted], light[counted], weights[counted], strict=True):
        away = log_levels(seen) - log_levels(apply_light(seen, gain))
        luma, share = away @ LUMA, weight / weight.sum()
        exposures.append(share @ luma)
        casts.append(share * (seen @ LUMA) @ (away - luma[:, None]))
        bright.append(share @ (seen @ LUMA))
    return np.asarray(np.mean(exposures) + np.sum(casts, axis=0) / max(np.sum(bright), 1.0))


def beyond_light(gap: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return how far differences of log levels (..., 3) exceed what lighting does to one surface; 1 is the limit.

    Lamps and shade change all channels nearly alike, another thing has another hue or is far darker.
    """
    grey = gap.mean(axis=-1)
    hue = np.abs(gap - grey[..., None]).mean(axis=-1)
    return np.asarray(np.hypot(grey / LIGHT_LOG, hue / HUE_LOG))


def light_coordinates(rgb: NDArray[np.floating]) -> Array:
    """Return brightness and hues (N, 4) of colours (N, 3), in units of what lighting does to one surface.

    Mean distances of two rows are about those of `beyond_light`.
    """
    logs = np.asarray(log_levels(rgb), np.float64)
    grey = logs.mean(axis=1, keepdims=True)
    return np.asarray(np.concatenate([4.0 * grey / LIGHT_LOG, 4.0 / 3.0 * (logs - grey) / HUE_LOG], axis=1))


def exposure_confidence(rgb: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return the confidence 1..0 (...,) in colours (..., 3), levels: saturated ones tell neither light nor colour.

    The middle channel decides: skin with only red clipped is restored from the others (:func:`restore_clipped_hue`).
    """
    low, high = SATURATED
    return np.asarray(np.clip((high - np.median(rgb, axis=-1)) / (high - low), 0.0, 1.0))


def restore_clipped_hue(
    rgb: NDArray[np.floating], shares: tuple[float, float], skin: NDArray[np.floating]
) -> NDArray[np.floating]:
    """Return colours (N, 3) with the hue that bright skin lost put back, levels; red goes up to LARGEST_RED.

    Skin burns out in red first: darkened again it would be green. Where green is at its end too, only
    white is left, and shine is white anyway: there blue comes down to the skin's share.

    Parameters
    ----------
    shares : (float, float)
        Red and blue against green of this skin.
    skin : (N,) in 0..1
    """
    rows = np.flatnonzero(rgb[:, 0] > CLIPPED[0])
    if rows.size == 0:
        return rgb
    found = np.array(rgb, copy=True)
    some, own = found[rows], skin[rows]
    burnt = own * np.clip((some[:, :2].T - CLIPPED[0]) / (CLIPPED[1] - CLIPPED[0]), 0.0, 1.0)
    found[rows, 0] += burnt[0] * np.maximum(np.minimum(some[:, 1] * shares[0], LARGEST_RED) - some[:, 0], 0.0)
    found[rows, 2] += burnt[1] * np.minimum(some[:, 1] * shares[1] - some[:, 2], 0.0)
    return found


def one_sided_light(logs: Array, weight: Array, normals: Array, twin: NDArray[np.integer]) -> Array:
    """Return the slopes b (3,) of the lighting across one photo: its log level rises by ``b * n_x``.

    People are painted alike on both halves, so what differs between a vertex
    and its twin, as far as it goes with the surface's direction, is light.

    Parameters
    ----------
    logs : (V, 3) log levels
    weight : (V,) >= 0, 0 = not seen
    normals : (V, 3) unit, x to the person's left
    twin : (V,) each vertex's mirror image

    Returns
    -------
    (3,) per channel; zero when too few vertices are seen on both halves.
    """
    trust = np.minimum(weight, weight[twin])
    rows = np.flatnonzero((trust > 0.0) & (normals[:, 0] > 0.0) & (normals[twin, 0] < 0.0))
    if rows.size < LEAST_PAIRS:
        return np.zeros(3)
    lean = normals[rows, 0] - normals[twin[rows], 0]
    gap = logs[rows] - logs[twin[rows]]
    slope = np.zeros(3)
    for _ in range(ROUNDS):
        rest = np.abs(gap - lean[:, None] * slope).mean(axis=1)
        strength = trust[rows] / np.maximum(rest / SLOPE_HUBER, 1.0)
        slope = (strength * lean) @ gap / max(float(strength @ lean**2), 1e-9)
    return np.asarray(slope)


def _reject_harmful(gains: Array, logs: Array, weights: Array, basis: Array) -> Array:
    """Return the gains, with zeros for a photo that agrees better without."""
    kept = gains.copy()
    for k in range(len(gains)):
        before, after = [], []
        for j in range(len(gains)):
            rows = np.minimum(weights[k], weights[j]) > 0.0
            if j == k or not rows.any():
                continue
            other = logs[j, rows] + _soft_limit(basis[rows] @ kept[j])
            before.append(np.abs(logs[k, rows] - other).mean(axis=1))
            after.append(np.abs(logs[k, rows] + _soft_limit(basis[rows] @ kept[k]) - other).mean(axis=1))
        if before and np.median(np.concatenate(after)) > np.median(np.concatenate(before)):
            kept[k] = 0.0
    return kept


def apply_light(rgb: NDArray[np.floating], log_gain: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return colours (N, 3) in levels after log gains (N, 3), clipped to 0..255."""
    gain = np.exp(_soft_limit(log_gain))
    return np.asarray(np.clip((rgb + LEVEL_OFFSET) * gain - LEVEL_OFFSET, 0.0, 255.0))


def _soft_limit(log_gain: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return log gains compressed into +-LARGEST_LOG, unchanged well within."""
    share = np.abs(log_gain) / LARGEST_LOG
    return np.asarray(log_gain / (1.0 + share**_BEND) ** (1.0 / _BEND))
