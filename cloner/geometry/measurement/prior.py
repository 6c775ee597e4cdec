"""The statistics with which measures under clothes are estimated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array, freeze
from cloner.records.measures import FITS

#: Garments in `MeasurePrior.garment`: bit 1 what is worn above the waist, bit 2 what is worn below.
UPPER: Final = 1
LOWER: Final = 2


@dataclass(frozen=True, slots=True, eq=False)
class MeasurePrior:
    """Statistics of a family's measures, of clothes' ease and of the fit's errors; K measures in a fixed order.

    Attributes
    ----------
    means : (S, K) float64
        Mean measure over stature, mm a metre, one row for each sex; all equally frequent.
    covariances : (S, K, K) float64
    ease_mm : (F, K) float64
        What the clothes of each fit of `FITS` add to what a clone shows.
    ease_covariances : (F, K, K) float64, mm²
    fit_bias : (K,) float64
        Mean relative error of the clone's skin against the dressed person, over all fits of clothes.
    fit_covariance : (K, K) float64
        Of that error.
    temper : float
        Power of the likelihoods, below 1: the fit's errors are no clean Gaussians. Measured on known people.
    log_odds : (F,) float64
        Added to the likelihoods' logarithms for each garment of a fit, measured likewise.
    spread : (K,) float64
        Half of nine in ten of the errors, in standard deviations of the estimate; measured on known people.
    rumple_means, rumple_spreads : (F, 2) float64
        Mean and standard deviation of the logarithm of the outline's rumple in mm, above and below the waist.
    garment : (K,) int64
        0 where clothes add nothing, `UPPER`, `LOWER`, or both where the wider one makes the outline.
    gap_mm : float
        Mean gap between the clone's and the photos' outlines over those people.
    under_shift, under_gain : (K,) float64
        A girth seen under clothes, over stature, is the shift plus the gain times the body's; 0 for not seen.
    under_covariance : (K, K) float64
        Of what is left of it, over stature squared.
    """

    means: Array
    covariances: Array
    ease_mm: Array
    ease_covariances: Array
    fit_bias: Array
    fit_covariance: Array
    temper: float
    log_odds: Array
    spread: Array
    rumple_means: Array
    rumple_spreads: Array
    garment: NDArray[np.int64]
    gap_mm: float
    under_shift: Array
    under_gain: Array
    under_covariance: Array

    def __post_init__(self) -> None:
        count = len(self.fit_bias)
        vectors = {name: (np.float64, (count,)) for name in ("fit_bias", "spread", "under_shift", "under_gain")}
        tables = {"means": (np.float64, (None, count)), "ease_mm": (np.float64, (len(FITS), count))}
        stacks = {name: (np.float64, (None, count, count)) for name in ("covariances", "ease_covariances")}
        vectors["log_odds"] = (np.float64, (len(FITS),))
        tables |= {name: (np.float64, (len(FITS), 2)) for name in ("rumple_means", "rumple_spreads")}
        squares = {name: (np.float64, (count, count)) for name in ("fit_covariance", "under_covariance")}
        freeze(self, **vectors, **tables, **stacks, **squares, garment=(np.int64, (count,)))
