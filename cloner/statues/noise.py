"""Solid noise: what a block of material shows wherever it is cut."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates

from cloner.records.arrays import Array

Values = NDArray[np.float32]

#: Side of the lattice of random values, which repeats after so many cells.
CELLS: Final = 48
#: Pores lie so far from the middle of their cells at most, and have up to this radius, shares of the cell: none is cut.
ASIDE, WIDEST = 0.2, 0.3


class MaterialBlock:
    """A block of one material: the same seed gives the same block."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self._lattice = rng.normal(size=(CELLS, CELLS, CELLS)).astype(np.float32)
        self._pores = rng.uniform(size=(CELLS, CELLS, CELLS, 4)).astype(np.float32)
        self._offsets = rng.uniform(0.0, CELLS, (16, 3))

    def waves(self, places_m: Array, sizes_m: Sequence[float]) -> Values:
        """Return (N,) smooth values about 0 of spread about 1 at places (N, 3).

        Parameters
        ----------
        places_m : (N, 3)
        sizes_m : sequence of float
            Sizes of the patches, each counting as much as the others; metres.

        References
        ----------
        K. Perlin, An Image Synthesizer, SIGGRAPH 1985 (value noise on a lattice, summed over sizes).
        """
        total = np.zeros(len(places_m), np.float32)
        for number, size in enumerate(sizes_m):
            at = places_m / size + self._offsets[number]
            total += map_coordinates(self._lattice, at.T, order=1, mode="grid-wrap", output=np.float32)
        # linear interpolation of independent values keeps (2/3)^3 of their variance on average
        return total / np.float32(np.sqrt(len(sizes_m) * (2.0 / 3.0) ** 3))

    def pores(self, places_m: Array, cell_m: float, share: float) -> Values:
        """Return the depth (N,) of points (N, 3) in a pore: 0 outside, 1 in its middle.

        Parameters
        ----------
        places_m : (N, 3)
        cell_m : float
            One pore at most in each cube of this side, metres.
        share : float
            Of the cubes that hold one.
        """
        at = places_m / cell_m + self._offsets[-1]
        cell = np.floor(at)
        one = self._pores[tuple((cell.astype(np.int64) % CELLS).T)]
        middle = 0.5 + ASIDE * (2.0 * one[:, :3] - 1.0)
        away = np.linalg.norm(at - cell - middle, axis=1)
        radius = np.where(one[:, 3] < share, WIDEST * (0.4 + 0.6 * one[:, 3] / share), 0.0)
        return np.asarray(np.clip(1.0 - away / np.maximum(radius, 1e-6), 0.0, 1.0), np.float32)
