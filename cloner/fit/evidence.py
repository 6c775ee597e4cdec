"""Evidence as rows: how far things are seen from where the unknowns put them, in spreads, and how that changes.

Five kinds suffice: points, outlines and curves (points of which one direction counts), told lengths (a tape), and
symmetry or sameness (ties between unknowns).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_matrix

from cloner.records.arrays import Array


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """Linearised evidence.

    Attributes
    ----------
    of : tuple of str
        Blocks of unknowns that it depends on.
    value : (R,) float64
        What it is away from what is wanted, in spreads.
    slopes : (R, n) float64, dense or sparse
        Its change with the blocks' unknowns, one block after the other.
    weight : float or (R,)
        How far it is believed, at these values.
    """

    of: tuple[str, ...]
    value: Array
    slopes: Array | csr_matrix
    weight: Array | float = 1.0


def cauchy(squared: Array, beyond: Array | float) -> Array:
    """Return weights (N,) of squared distances in spreads: a half at ``beyond``; one where that is infinite."""
    return np.asarray(1.0 / (1.0 + squared / np.asarray(beyond, dtype=np.float64) ** 2))


def points(
    of: tuple[str, ...],
    away: Array,
    slopes: Array,
    sigma: Array | float,
    *,
    outlier: Array | float = np.inf,
    along: Array | None = None,
) -> Rows:
    """Return the rows of points, or of outlines and curves: along them points may slide.

    Parameters
    ----------
    of : tuple of str
    away : (N, D)
        Where the unknowns put the points, less where they are seen.
    slopes : (N, D, n)
    sigma : float or (N,)
        Expected errors.
    outlier : float or (N,)
        A point that many sigmas away has lost half of its weight: a wrong one cannot turn the whole.
    along : (N, D), optional
        Unit directions; only errors along them count.
    """
    if along is not None:
        away = np.einsum("ni,ni->n", along, away)[:, None]
        slopes = np.einsum("ni,nif->nf", along, slopes)[:, None]
    scale = 1.0 / np.broadcast_to(np.asarray(sigma, dtype=np.float64), (len(away),))
    value = away * scale[:, None]
    weight = np.repeat(cauchy((value**2).sum(axis=1), outlier), value.shape[1])
    flat = (slopes * scale[:, None, None]).reshape(value.size, slopes.shape[-1])
    return Rows(of, value.ravel(), flat, weight)


def together(of: tuple[str, ...], away: Array, slopes: Array, whiten: Array, *, outlier: float) -> Rows:
    """Return the rows of points that err together and lose their weight together.

    Parameters
    ----------
    of : tuple of str
    away : (N, 2), slopes : (N, 2, n)
    whiten : (2 N, 2 N)
        Makes their errors, x and y after each other, independent and of size one.
    outlier : float
    """
    value = whiten @ away.ravel()
    alike = cauchy(2.0 * (value**2).mean(), outlier)
    return Rows(of, value, whiten @ slopes.reshape(len(value), -1), np.full(len(value), alike))


def tie(of: tuple[str, ...], apart: Array, slopes: Array, spread: Array | float, *, outlier: float) -> Rows:
    """Return the rows of unknowns (N,) ``apart`` that usually agree, each losing its weight alone: heavy tails."""
    return points(of, apart[:, None], slopes[:, None], spread, outlier=outlier)
