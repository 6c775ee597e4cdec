"""Displacement of lips: a step of the margin that fades out over the rings around it."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.generic.face_grids import Grid
from cloner.records.arrays import Array

#: Share of a lip's step that every ring takes, from the one farthest inside; the lips' outer border hardly moves.
SHARE: Final = np.array([0.6, 0.85, 1.0, 1.0, 0.95, 0.75, 0.5, 0.3, 0.15, 0.05, 0.0])


def drop_from_borders(grid: Grid, rings_px: Array, borders_px: Array) -> Array:
    """Return how far (N,) each column's lip lies below the border that the photo shows, px.

    Parameters
    ----------
    grid : Grid
        The mouth's.
    rings_px : (K, N, 2)
        Where the grid's points are seen.
    borders_px : (2, B, 2)
        Inner borders of upper and lower lip, from one corner to the other.
    """
    touching = rings_px[grid.margin - 1 : grid.margin + 2]
    inner = np.where(grid.upper, touching[..., 1].argmax(axis=0), touching[..., 1].argmin(axis=0))
    seen = touching[inner, np.arange(len(inner))]
    way = np.zeros(len(seen))
    for lip, border in zip((grid.upper, grid.lower), borders_px, strict=True):
        along = np.argsort(border[:, 0])
        way[lip] = np.interp(seen[lip, 0], border[along, 0], border[along, 1]) - seen[lip, 1]
    return way
