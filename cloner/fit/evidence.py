"""Residuals of the fit with their Jacobians, in standard deviations.

Five kinds suffice: points, outlines and curves (points of which only the distance along a normal counts), measured
lengths (a tape), and symmetry or sameness (parameters that agree).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_matrix

from cloner.records.arrays import Array


@dataclass(frozen=True, slots=True, eq=False)
class Residuals:
    """Residuals, linearised at the present values.

    Attributes
    ----------
    of : tuple of str
        Names of the parameter blocks that they depend on.
    value : (R,) float64
        Model minus observation, in sigmas.
    jacobian : (R, n) float64, dense or sparse
        Derivatives by the parameters of these blocks, one block after the other.
    weight : float or (R,)
        Robust weights at these values.
    """

    of: tuple[str, ...]
    value: Array
    jacobian: Array | csr_matrix
    weight: Array | float = 1.0


def cauchy_weights(squared: Array, scale: Array | float) -> Array:
    """Return the weights (N,) of squared residuals under a Cauchy loss: a half at ``scale``, one if it is infinite."""
    return np.asarray(1.0 / (1.0 + squared / np.asarray(scale, dtype=np.float64) ** 2))


def point_residuals(
    of: tuple[str, ...],
    offset: Array,
    jacobian: Array,
    sigma: Array | float,
    *,
    outlier: Array | float = np.inf,
    normal: Array | None = None,
) -> Residuals:
    """Return the residuals of points, or of points on outlines and curves, which may slide along them.

    Parameters
    ----------
    of : tuple of str
        Names of the parameter blocks.
    offset : (N, D)
        Projected minus observed points.
    jacobian : (N, D, n)
        Derivatives of the projected points.
    sigma : float or (N,)
        Expected errors, in the unit of ``offset``.
    outlier : float or (N,)
        Cauchy scale in sigmas: a point that far away has lost half of its weight.
    normal : (N, D), optional
        Unit directions; only the error along them counts.
    """
    if normal is not None:
        offset = np.einsum("ni,ni->n", normal, offset)[:, None]
        jacobian = np.einsum("ni,nif->nf", normal, jacobian)[:, None]
    scale = 1.0 / np.broadcast_to(np.asarray(sigma, dtype=np.float64), (len(offset),))
    value = offset * scale[:, None]
    weight = np.repeat(cauchy_weights((value**2).sum(axis=1), outlier), value.shape[1])
    flat = (jacobian * scale[:, None, None]).reshape(value.size, jacobian.shape[-1])
    return Residuals(of, value.ravel(), flat, weight)


def correlated_residuals(
    of: tuple[str, ...], offset: Array, jacobian: Array, whiten: Array, *, outlier: float
) -> Residuals:
    """Return the residuals of points with correlated errors, which share one robust weight.

    Parameters
    ----------
    of : tuple of str
        Names of the parameter blocks.
    offset : (N, 2), jacobian : (N, 2, n)
        As in :func:`point_residuals`.
    whiten : (2 N, 2 N)
        Whitening matrix of the errors (x0, y0, x1, ...).
    outlier : float
        Cauchy scale of the root mean square error, in sigmas.
    """
    value = whiten @ offset.ravel()
    shared = cauchy_weights(2.0 * (value**2).mean(), outlier)
    return Residuals(of, value, whiten @ jacobian.reshape(len(value), -1), np.full(len(value), shared))


def agreement_residuals(
    of: tuple[str, ...], difference: Array, jacobian: Array, sigma: Array | float, *, outlier: float
) -> Residuals:
    """Return the residuals of parameters that usually agree; each ``difference`` (N,) has its own robust weight."""
    return point_residuals(of, difference[:, None], jacobian[:, None], sigma, outlier=outlier)
