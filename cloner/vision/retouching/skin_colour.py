"""Colour of a person's skin in one photo."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array

#: Least spread of skin in log red/green and log blue/green (JPEG, make-up, blood; measured on the sample faces: 0.05).
LEAST_SPREAD: Final = 0.05
#: Fewer samples tell no colour.
LEAST_SAMPLES: Final = 30
_GAMMA: Final = 2.2
_DARK: Final = 0.004  # linear light that counts as black


@dataclass(frozen=True, slots=True)
class SkinColour:
    """Skin colour in one photo.

    Attributes
    ----------
    middle : tuple of float
        Log red/green and log blue/green of linear light.
    spread : tuple of float
        Standard deviations of both.
    """

    middle: tuple[float, float]
    spread: tuple[float, float]

    def shares(self) -> tuple[float, float]:
        """Return red and blue relative to green, in coded levels."""
        return float(np.exp(self.middle[0] / _GAMMA)), float(np.exp(self.middle[1] / _GAMMA))


def log_chroma(rgb: NDArray[np.number]) -> tuple[Array, Array]:
    """Return log ratios (N, 2), which are invariant to shading, and brightness (N,) of sRGB values (N, 3), 0..255."""
    linear = (rgb.astype(np.float64) / 255.0) ** _GAMMA + _DARK
    ratios = np.log(linear[:, [0, 2]] / linear[:, 1:2])
    return ratios, linear.mean(axis=1)


def skin_colour(rgb: NDArray[np.number]) -> SkinColour | None:
    """Return the colour of (N, 3) samples of bare skin; None when there are too few."""
    if len(rgb) < LEAST_SAMPLES:
        return None
    ratios, _ = log_chroma(rgb)
    middle = np.median(ratios, axis=0)
    spread = 1.48 * np.median(np.abs(ratios - middle), axis=0)  # a normal distribution's, robust
    wide = np.maximum(spread, LEAST_SPREAD)
    return SkinColour((float(middle[0]), float(middle[1])), (float(wide[0]), float(wide[1])))
