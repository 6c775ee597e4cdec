"""An atlas, or a tile of it, while it is made."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman

PLAIN_RGB = (190, 160, 145)  # taste: what a person is painted with whom no photo shows


@dataclass(frozen=True, slots=True, eq=False)
class Baked:
    """An atlas, or a tile of it, while it is made: its arrays may still be written to.

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

    def doubled(self) -> Baked:
        """Return the same picture of twice as many texels a side."""
        size = (2 * self.rgb.shape[1], 2 * self.rgb.shape[0])
        covered, seen = (flags.repeat(2, axis=0).repeat(2, axis=1) for flags in (self.covered, self.seen))
        return Baked(np.asarray(cv2.resize(self.rgb, size, interpolation=cv2.INTER_LINEAR), np.uint8), covered, seen)


def blank(size: int) -> Baked:
    """Return an atlas without charts."""
    covered, seen = np.zeros((2, size, size), bool)
    return Baked(np.tile(np.array(PLAIN_RGB, np.uint8), (size, size, 1)), covered, seen)


def unpainted(generic: GenericHuman, size: int) -> Baked:
    """Return the atlas of a person whom no photo shows."""
    return replace(blank(size), covered=generic_atlas(generic, size).covered())
