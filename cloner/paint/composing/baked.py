"""An atlas, or a tile of it, under construction."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman

PLAIN_RGB = (190, 160, 145)  # taste: what a person is painted with whom no photo shows


@dataclass(frozen=True, slots=True, eq=False)
class AtlasInProgress:
    """An atlas, or a tile of it, under construction: its arrays are still writable.

    Attributes
    ----------
    rgb : (H, W, 3) uint8
        `PLAIN_RGB` far from the charts.
    covered : (H, W) bool
        Texels in charts.
    seen : (H, W) bool
        Texels that a photo (not a mirrored one) painted.
    """

    rgb: NDArray[np.uint8]
    covered: NDArray[np.bool_]
    seen: NDArray[np.bool_]

    def doubled(self) -> AtlasInProgress:
        """Return the same picture with twice as many texels a side."""
        size = (2 * self.rgb.shape[1], 2 * self.rgb.shape[0])
        covered, seen = (flags.repeat(2, axis=0).repeat(2, axis=1) for flags in (self.covered, self.seen))
        return AtlasInProgress(
            np.asarray(cv2.resize(self.rgb, size, interpolation=cv2.INTER_LINEAR), np.uint8), covered, seen
        )


def blank_atlas(size: int) -> AtlasInProgress:
    """Return an atlas without charts."""
    covered, seen = np.zeros((2, size, size), bool)
    return AtlasInProgress(np.tile(np.array(PLAIN_RGB, np.uint8), (size, size, 1)), covered, seen)


def unpainted_atlas(generic: GenericHuman, size: int) -> AtlasInProgress:
    """Return the atlas of a person without any photo."""
    return replace(blank_atlas(size), covered=generic_atlas(generic, size).covered())
