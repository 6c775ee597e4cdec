"""Nonlinear least squares over named parameter blocks with priors: robust, bounded Gauss-Newton.

The objective is the negative log posterior. Robust residuals are reweighted at every iteration (IRLS), bounds are kept
by an active set, and the normal equations of the last iteration give the covariance.

References
----------
Triggs et al. 2000, Bundle adjustment - a modern synthesis; Levenberg 1944; Holland & Welsch 1977 for the weights.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import diags_array, issparse

from cloner.fit.evidence import Residuals, cauchy_weights
from cloner.records.arrays import Array

Values = dict[str, Array]
#: ``linearise(values, iteration)`` returns the residuals and their Jacobians at the present values.
Linearise = Callable[[Values, int], Iterable[Residuals]]


@dataclass(frozen=True, slots=True, eq=False)
class ParameterBlock:
    """Unknowns that belong together, with their prior and their bounds.

    Attributes
    ----------
    initial : (n,) float64
        Values to start from.
    mean, sigma : float or (n,)
        Normal prior; an infinite sigma means no prior.
    cauchy_scale : float
        A value that many sigmas from its mean feels half of the prior's pull (Cauchy); infinite keeps it normal.
    decay_rate : float or (n,)
        Rate of an exponential prior beside the normal one, for parameters that are mostly zero.
    lower, upper : float or (n,)
        Bounds of the values.
    max_sigmas : float
        Values farther than this from their mean are clipped: a guard against outliers.
    max_step : float or (n,)
        Longest step in one iteration: the range in which the linear model is good.
    """

    initial: Array
    mean: Array | float = 0.0
    sigma: Array | float = np.inf
    cauchy_scale: float = np.inf
    decay_rate: Array | float = 0.0
    lower: Array | float = -np.inf
    upper: Array | float = np.inf
    max_sigmas: Array | float = np.inf
    max_step: Array | float = np.inf

    def per_parameter(self, name: str) -> Array:
        """Return an attribute broadcast to all parameters of the block, (n,)."""
        return np.broadcast_to(np.asarray(getattr(self, name), dtype=np.float64), self.initial.shape)


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """The most likely values, and the undamped information matrix (X, X) at them, priors included."""

    values: Values
    information: Array
    slices: Mapping[str, slice]

    def covariance(self, *names: str) -> Array:
        """Return the joint covariance (n, n) of some blocks, in the order of their names."""
        rows = _indices(self.slices, names)
        return np.asarray(np.linalg.inv(self.information)[np.ix_(rows, rows)])


def _indices(slices: Mapping[str, slice], names: Iterable[str]) -> NDArray[np.int64]:
    """Return the places (n,) of some blocks in the stacked parameter vector."""
    return np.concatenate([np.arange(slices[name].start, slices[name].stop) for name in names])


class Problem:
    """Parameter blocks that are solved together.

    Parameters
    ----------
    blocks : mapping of str to ParameterBlock
    """

    def __init__(self, blocks: Mapping[str, ParameterBlock]) -> None:
        self.blocks = dict(blocks)
        ends = np.cumsum([0, *(len(block.initial) for block in self.blocks.values())]).tolist()
        self.slices = {name: slice(*pair) for name, *pair in zip(self.blocks, ends, ends[1:], strict=False)}
        self._stacked = {
            name: np.concatenate([block.per_parameter(name) for block in self.blocks.values()])
            for name in ParameterBlock.__slots__
        }

    def values(self, vector: Array) -> Values:
        """Return the values of all blocks from the stacked parameter vector (X,)."""
        return {name: vector[place] for name, place in self.slices.items()}

    def normal_equations(self, vector: Array, found: Iterable[Residuals]) -> tuple[Array, Array]:
        """Return the information matrix (X, X) and the right-hand side (X,) at a parameter vector (X,)."""
        prior, offset = self._stacked, vector - self._stacked["mean"]
        pull = cauchy_weights((offset / prior["sigma"]) ** 2, prior["cauchy_scale"]) / prior["sigma"] ** 2
        matrix, right = np.diag(pull), -pull * offset - prior["decay_rate"]
        for term in found:
            columns = _indices(self.slices, term.of)
            root = np.sqrt(np.broadcast_to(term.weight, term.value.shape))
            jacobian = diags_array(root) @ term.jacobian if issparse(term.jacobian) else term.jacobian * root[:, None]
            squared = jacobian.T @ jacobian
            matrix[np.ix_(columns, columns)] += squared.toarray() if issparse(squared) else squared
            right[columns] -= jacobian.T @ (term.value * root)
        return matrix, right

    def solve(
        self, linearise: Linearise, *, iterations: int, damping: float = 1e-9, tolerance: float = 0.0
    ) -> Solution:
        """Return the most likely values.

        Parameters
        ----------
        linearise : callable
            ``linearise(values, iteration)`` returns the residuals at the values; curves are matched anew each time.
        iterations : int
            At most this many steps.
        damping : float
            Share of its own diagonal entry that is added for every parameter (Levenberg).
        tolerance : float
            Stop once a step is shorter than this many sigmas of every parameter (or this long, without a prior).
        """
        vector, prior = self._stacked["initial"].copy(), self._stacked
        scale = np.where(np.isfinite(prior["sigma"]), prior["sigma"], 1.0)
        room = np.where(np.isfinite(prior["max_sigmas"]), prior["max_sigmas"] * scale, np.inf)
        guard = np.maximum(prior["lower"], prior["mean"] - room), np.minimum(prior["upper"], prior["mean"] + room)
        for iteration in range(iterations):
            matrix, right = self.normal_equations(vector, linearise(self.values(vector), iteration))
            damped = matrix + np.diag(damping * np.diag(matrix) + 1e-12)
            step = solve_bounded(damped, right, prior["lower"] - vector, prior["upper"] - vector)
            step = np.clip(step, -prior["max_step"], prior["max_step"])
            vector = np.clip(vector + step, *guard)
            if (np.abs(step) < tolerance * scale).all():
                break
        return Solution(self.values(vector), matrix, self.slices)


def solve_bounded(matrix: Array, right: Array, lower: Array, upper: Array) -> Array:
    """Return the solution (X,) of normal equations within bounds, by an active set."""
    step = np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
    low: NDArray[np.bool_] = np.zeros(len(right), dtype=bool)
    high = low.copy()
    while (step < lower - 1e-12).any() or (step > upper + 1e-12).any():
        low, high = low | (step < lower), high | (step > upper)
        held, free = np.where(low, lower, np.where(high, upper, 0.0)), ~(low | high)
        step = held.copy()
        step[free] = np.linalg.solve(matrix[np.ix_(free, free)], (right - matrix @ held)[free])
    return step
