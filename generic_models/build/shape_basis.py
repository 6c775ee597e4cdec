"""From many bodies to a mean and a few unit-variance shape coefficients."""

from __future__ import annotations

import numpy as np
from source import FloatArray, IntArray

STATURE_M = 1.70
HEAD_TOP = 881  # hm08 vertex on top of the skull


def normalise(
    vertices_m: FloatArray, joints_m: FloatArray, soles: IntArray, ankles: IntArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Scale each body to 1.70 m and stand it on y = 0, its ankles' middle at x = z = 0.

    Every step fixes a linear function of the body (skull-top vertex, mean of the sole vertices, ankle joints), so any
    mixture of normalised bodies is normalised too and has that stature exactly.

    Parameters
    ----------
    vertices_m : (N, V, 3); joints_m : (N, 94, 3); soles : vertex indices; ankles : joint indices.

    Returns
    -------
    vertices_m, joints_m, and each body's own stature before scaling, (N,).
    """
    floor = vertices_m[:, soles, 1].mean(axis=1)
    stature = vertices_m[:, HEAD_TOP, 1] - floor
    origin = joints_m[:, ankles].mean(axis=1)
    origin[:, 0], origin[:, 1] = 0.0, floor
    scale = (STATURE_M / stature)[:, None, None]
    return (vertices_m - origin[:, None]) * scale, (joints_m - origin[:, None]) * scale, stature


def symmetrise(points: FloatArray, mirror: IntArray) -> FloatArray:
    """Return (N, P, 3) averaged with its mirror image."""
    return (points + points[:, mirror] * np.array([-1, 1, 1], dtype=points.dtype)) / 2


def principal(samples: FloatArray, mean: FloatArray, count: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the leading directions of (N, D) samples about ``mean``.

    Returns
    -------
    basis : (count, D), scaled so that the samples' coefficients have unit mean square.
    coefficients : (N, count) of the samples.
    share : (count,) explained share of the total.
    """
    off = (samples - mean).astype(np.float32)
    gram = (off @ off.T).astype(np.float64)
    values, vectors = np.linalg.eigh(gram)
    order = np.argsort(values)[::-1][:count]
    values_kept, vectors = values[order], vectors[:, order]
    vectors *= np.sign(vectors[np.abs(vectors).argmax(axis=0), np.arange(count)])
    coefficients = vectors * np.sqrt(off.shape[0])
    basis = (vectors / np.sqrt(off.shape[0])).T @ off
    # basis = V^T off / sqrt(N); then off ~ coefficients @ basis
    return basis, coefficients, values_kept / values.clip(0).sum()


def regress(coefficients: FloatArray, targets: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return (P, C) and (P,): least-squares linear prediction of phenotypes from coefficients."""
    design = np.column_stack([coefficients, np.ones(coefficients.shape[0])])
    solution = np.linalg.lstsq(design, targets, rcond=None)[0]
    return solution[:-1].T, solution[-1]
