"""Loose clothing in a photo: cloth that fills the gap between the legs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import freeze

#: Cloth around both legs: skirts, dresses, long coats.
AROUND_LEGS = "around legs"
#: A bag beside the hip, on the person's left or right.
BAG_LEFT, BAG_RIGHT = "bag left", "bag right"
#: Where a hem is told: -1 at the cloth's first edge, 1 at its last.
HEM_PLACES: Final = np.linspace(-1.0, 1.0, 13)


@dataclass(frozen=True, slots=True, eq=False)
class LooseRegion:
    """One piece of loose clothing in one photo.

    Attributes
    ----------
    name : str
        ``AROUND_LEGS``, ``BAG_LEFT`` or ``BAG_RIGHT``.
    top_px : int
        First photo row.
    edges_px : (R, 2) float64
        First and last column in every row from ``top_px`` down; below the hem's ends they go on straight.
    hem_px : (13,) float64
        Rows in which the cloth ends, at `HEM_PLACES` between its edges.
    seen : (R, 2) bool
        False where an arm hides the edge, which is then carried over from the rows around.
    confidence : float in 0..1
    """

    name: str
    top_px: int
    edges_px: NDArray[np.float64]
    hem_px: NDArray[np.float64]
    seen: NDArray[np.bool_]
    confidence: float

    def __post_init__(self) -> None:
        freeze(
            self,
            edges_px=(np.float64, (None, 2)),
            hem_px=(np.float64, (len(HEM_PLACES),)),
            seen=(np.bool_, (len(self.edges_px), 2)),
        )

    @property
    def bottom_px(self) -> int:
        """Last photo row."""
        return self.top_px + len(self.edges_px) - 1

    def covers(self, points_px: NDArray[np.floating], *, margin_px: float = 0.0) -> NDArray[np.bool_]:
        """Return which of (N, 2) photo points lie on the cloth, or beside it by no more than a margin."""
        row = points_px[:, 1] - self.top_px
        place = np.clip(np.round(row).astype(np.int64), 0, len(self.edges_px) - 1)
        first, last = self.edges_px[place].T
        across = (points_px[:, 0] >= first - margin_px) & (points_px[:, 0] <= last + margin_px)
        return np.asarray(across & (row >= -0.5 - margin_px) & (row <= len(self.edges_px) - 0.5 + margin_px))

    def hem_row(self, across: NDArray[np.floating]) -> NDArray[np.float64]:
        """Return (N,) the hem's row at places between the edges, -1 at the first, 1 at the last."""
        return np.asarray(np.interp(across, HEM_PLACES, self.hem_px))

    def cloth(self, shape: tuple[int, int], *, margin_px: float = 0.0) -> NDArray[np.bool_]:
        """Return the (H, W) pixels between the edges and above the hem by at least a margin."""
        low, high = self.edges_px[int(np.clip(self.hem_px.mean() - self.top_px, 0, len(self.edges_px) - 1))]
        across = 2.0 * (np.arange(shape[1]) - low) / max(high - low, 1.0) - 1.0
        return self.mask(shape) & (np.arange(shape[0])[:, None] <= self.hem_row(across) - margin_px)

    def mask(self, shape: tuple[int, int]) -> NDArray[np.bool_]:
        """Return the (H, W) pixels between the edges."""
        picture = np.zeros(shape, dtype=np.bool_)
        first, last = max(self.top_px, 0), min(self.bottom_px, shape[0] - 1)
        edges = self.edges_px[first - self.top_px : last - self.top_px + 1]
        columns = np.arange(shape[1])
        picture[first : last + 1] = (columns >= edges[:, :1]) & (columns <= edges[:, 1:])
        return picture
