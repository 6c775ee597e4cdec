"""Named unknowns, what is expected of each, and the values that evidence makes likeliest, by their normal equations.

Damped Gauss-Newton on the negative log likelihood: robust rows are weighted by what they are now (iterated
reweighting), values stay within bounds by holding those that would leave them (active set). The normal equations of the
last turn tell how certain the values are.

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

from cloner.fit.evidence import Rows, cauchy
from cloner.records.arrays import Array

Values = dict[str, Array]
#: What evidence says at some values, in a turn.
Look = Callable[[Values, int], Iterable[Rows]]


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """Unknowns that belong together.

    Attributes
    ----------
    start : (n,) float64
        First values.
    expected, spread : float or (n,)
        What is usual, and by how much it differs; an infinite spread leaves it to the evidence.
    tail : float
        So many spreads away, values are held half as hard (Cauchy).
    rarity : float or (n,)
        Decline of the expected logarithm beside the normal prior: for what is mostly absent.
    least, most : float or (n,)
        No value lies beyond; the others explain what it may not.
    farthest : float
        Values that evidence takes farther from what is expected, in spreads, are cut off there: a guard.
    longest : float or (n,)
        No value moves farther in one turn: so far the linear model is good.
    """

    start: Array
    expected: Array | float = 0.0
    spread: Array | float = np.inf
    tail: float = np.inf
    rarity: Array | float = 0.0
    least: Array | float = -np.inf
    most: Array | float = np.inf
    farthest: Array | float = np.inf
    longest: Array | float = np.inf

    def even(self, name: str) -> Array:
        """Return one of its numbers for every unknown, (n,)."""
        return np.broadcast_to(np.asarray(getattr(self, name), dtype=np.float64), self.start.shape)


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """The likeliest values, and the normal equations' matrix (X, X) at them, priors included, without damping."""

    values: Values
    information: Array
    places: Mapping[str, slice]

    def covariance(self, *names: str) -> Array:
        """Return the joint covariance (n, n) of some blocks, in the order of their names."""
        rows = np.concatenate([np.arange(self.places[name].start, self.places[name].stop) for name in names])
        return np.asarray(np.linalg.inv(self.information)[np.ix_(rows, rows)])


class Problem:
    """Blocks of unknowns, solved together.

    Parameters
    ----------
    blocks : mapping of str to Block
    """

    def __init__(self, blocks: Mapping[str, Block]) -> None:
        self.blocks = dict(blocks)
        ends = np.cumsum([0, *(len(block.start) for block in self.blocks.values())]).tolist()
        self.places = {name: slice(*pair) for name, *pair in zip(self.blocks, ends, ends[1:], strict=False)}
        self._told = {
            name: np.concatenate([block.even(name) for block in self.blocks.values()])
            for name in ("start", "expected", "spread", "tail", "rarity", "least", "most", "farthest", "longest")
        }

    def values(self, vector: Array) -> Values:
        """Return all blocks' values from (X,) numbers."""
        return {name: vector[place] for name, place in self.places.items()}

    def equations(self, vector: Array, found: Iterable[Rows]) -> tuple[Array, Array]:
        """Return the normal equations (X, X), (X,) of a step from some values (X,)."""
        told, away = self._told, vector - self._told["expected"]
        held = cauchy((away / told["spread"]) ** 2, told["tail"]) / told["spread"] ** 2
        matrix, right = np.diag(held), -held * away - told["rarity"]
        for rows in found:
            columns = np.concatenate([np.arange(self.places[name].start, self.places[name].stop) for name in rows.of])
            root = np.sqrt(np.broadcast_to(rows.weight, rows.value.shape))
            slopes = diags_array(root) @ rows.slopes if issparse(rows.slopes) else rows.slopes * root[:, None]
            squared = slopes.T @ slopes
            matrix[np.ix_(columns, columns)] += squared.toarray() if issparse(squared) else squared
            right[columns] -= slopes.T @ (rows.value * root)
        return matrix, right

    def solve(self, look: Look, *, turns: int, damping: float = 1e-9, still: float = 0.0) -> Solution:
        """Return the likeliest values.

        Parameters
        ----------
        look : callable
            ``look(values, turn)`` returns the evidence linearised at the values: curves are matched anew each turn.
        turns : int
            Steps at most.
        damping : float
            Share by which every unknown is held more than it is known (Levenberg).
        still : float
            A step shorter than so many spreads of every unknown (of one, without a spread) is the last.
        """
        vector, told = self._told["start"].copy(), self._told
        scale = np.where(np.isfinite(told["spread"]), told["spread"], 1.0)
        room = np.where(np.isfinite(told["farthest"]), told["farthest"] * scale, np.inf)
        guard = np.maximum(told["least"], told["expected"] - room), np.minimum(told["most"], told["expected"] + room)
        for turn in range(turns):
            matrix, right = self.equations(vector, look(self.values(vector), turn))
            damped = matrix + np.diag(damping * np.diag(matrix) + 1e-12)
            step = bounded(damped, right, told["least"] - vector, told["most"] - vector)
            step = np.clip(step, -told["longest"], told["longest"])
            vector = np.clip(vector + step, *guard)
            if (np.abs(step) < still * scale).all():
                break
        return Solution(self.values(vector), matrix, self.places)


def bounded(matrix: Array, right: Array, least: Array, most: Array) -> Array:
    """Return the unknowns (X,) of normal equations, none beyond its bounds; those that would be stay at theirs."""
    step = np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
    low: NDArray[np.bool_] = np.zeros(len(right), dtype=bool)
    high = low.copy()
    while (step < least - 1e-12).any() or (step > most + 1e-12).any():
        low, high = low | (step < least), high | (step > most)
        held, free = np.where(low, least, np.where(high, most, 0.0)), ~(low | high)
        step = held.copy()
        step[free] = np.linalg.solve(matrix[np.ix_(free, free)], (right - matrix @ held)[free])
    return step
