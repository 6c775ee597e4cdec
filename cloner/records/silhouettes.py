"""Outlines of the person in the photos."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.arrays import freeze
from cloner.records.loose import LooseRegion


@dataclass(frozen=True, slots=True, eq=False)
class Silhouette:
    """The person's outline in one photo.

    Attributes
    ----------
    view : ViewId
    contours_px : tuple of (M, 2) float64
        Closed polygons in photo pixels; outer boundaries and holes.
    mask : (H, W) bool
        The filled outline at photo resolution.
    sources : tuple of (str, str, float)
        Per feature segment: its name, "edges" or "mask", and the goodness G^P.
    loose : tuple of LooseRegion
        Where loose clothing, not the body, makes the outline.
    through : tuple of str
        Points an operator placed far off, through which the outline was traced again.
    """

    view: ViewId
    contours_px: tuple[NDArray[np.float64], ...]
    mask: NDArray[np.bool_]
    sources: tuple[tuple[str, str, float], ...]
    loose: tuple[LooseRegion, ...] = ()
    through: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, mask=(np.bool_, (None, None)))

    @property
    def top_px(self) -> float:
        """Row of the person's highest edge, photo pixels."""
        return float(np.flatnonzero(self.mask.any(axis=1))[0]) - 0.5

    def loose_mask(self) -> NDArray[np.bool_]:
        """Return the (H, W) pixels between the edges of loose clothing."""
        picture = np.zeros(self.mask.shape, dtype=np.bool_)
        for region in self.loose:
            picture |= region.mask(self.mask.shape)
        return picture


@dataclass(frozen=True, slots=True, eq=False)
class SilhouetteSet:
    """One silhouette a photo."""

    views: Mapping[ViewId, Silhouette]

    def __post_init__(self) -> None:
        object.__setattr__(self, "views", MappingProxyType(dict(self.views)))
