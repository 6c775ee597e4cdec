"""Morph targets of a clone laid out over all vertices, one after the other."""

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
