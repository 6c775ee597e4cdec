"""Morph targets of a clone laid out over all vertices, one after the other, or over the wedges of a surface."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from cloner.records.clones import Clone


def target_offsets(clone: Clone) -> Iterator[tuple[str, NDArray[np.float32]]]:
    """Yield every morph target's name and offsets (V + 1, 3), metres; the last row, reached by -1, never moves.

    The array is the same each time: take what is wanted of it before the next.
    """
    offsets = np.zeros((len(clone.vertices_m) + 1, 3), dtype=np.float32)
    for k, name in enumerate(clone.morph_names):
        rows = slice(int(clone.morph_start[k]), int(clone.morph_start[k + 1]))
        offsets[:] = 0.0
        offsets[clone.morph_index[rows]] = clone.morph_delta_m[rows]
        yield name, offsets


def wedge_offsets(
    clone: Clone, vertex: NDArray[np.integer], smallest_m: float
) -> Iterator[tuple[str, NDArray[np.int64], NDArray[np.float32]]]:
    """Yield every morph target's name, the wedges (M,) that it moves by more than ``smallest_m``, and offsets (M, 3).

    Parameters
    ----------
    clone : Clone
    vertex : (N,) int
        The vertex of every wedge, -1 for one that never moves; wedges of one vertex move alike.
    smallest_m : float
        Along the axis on which they move most, metres.
    """
    order = np.argsort(vertex, kind="stable")
    start = np.searchsorted(vertex[order], np.arange(len(clone.vertices_m) + 1))
    x, y, z = np.abs(clone.morph_delta_m).T
    far = np.maximum(np.maximum(x, y), z) > smallest_m  # rows of three are slow to reduce
    for k, name in enumerate(clone.morph_names):
        first = int(clone.morph_start[k])
        rows = first + np.flatnonzero(far[first : clone.morph_start[k + 1]])
        own = clone.morph_index[rows]
        count = start[own + 1] - start[own]
        ahead = np.cumsum(count) - count
        wedges = order[np.arange(int(count.sum())) + np.repeat(start[own] - ahead, count)]
        rising = np.argsort(wedges)
        yield name, wedges[rising], clone.morph_delta_m[np.repeat(rows, count)[rising]]
