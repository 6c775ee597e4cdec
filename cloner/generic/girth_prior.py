"""What girths people of the generic family have, and how the fit errs on them; no sample visitor took part.

All figures are printed by ``benchmarks/girth_prior.py``. Order: `GIRTH_NAMES`.
"""

from __future__ import annotations

import functools
from typing import Final

import numpy as np

from cloner.geometry.under_clothes import GirthPrior

#: Thousandths of the stature, mean of women and of men (phenotype "sex" below and above one half).
_MEANS: Final = (
    (201.3, 520.3, 444.0, 447.1, 413.1, 587.1, 312.1, 213.2, 158.2),
    (223.9, 544.6, 490.4, 461.8, 446.9, 562.7, 309.4, 218.3, 167.8),
)
#: Standard deviation and correlation; the two sexes differ by less than 0.2 and 0.02.
_DEVIATION: Final = (24.3, 43.4, 40.4, 48.7, 44.0, 46.4, 31.0, 19.0, 21.9)
_CORRELATION: Final = (
    (1.00, 0.55, 0.62, 0.54, 0.60, 0.37, 0.44, 0.51, 0.52),
    (0.55, 1.00, 0.89, 0.54, 0.68, 0.39, 0.45, 0.48, 0.47),
    (0.62, 0.89, 1.00, 0.71, 0.85, 0.43, 0.48, 0.49, 0.47),
    (0.54, 0.54, 0.71, 1.00, 0.95, 0.80, 0.70, 0.45, 0.38),
    (0.60, 0.68, 0.85, 0.95, 1.00, 0.68, 0.66, 0.48, 0.46),
    (0.37, 0.39, 0.43, 0.80, 0.68, 1.00, 0.85, 0.43, 0.32),
    (0.44, 0.45, 0.48, 0.70, 0.66, 0.85, 1.00, 0.45, 0.47),
    (0.51, 0.48, 0.49, 0.45, 0.48, 0.43, 0.45, 1.00, 0.39),
    (0.52, 0.47, 0.47, 0.38, 0.46, 0.32, 0.47, 0.39, 1.00),
)
#: Relative error of the fitted girths over 16 naked bodies, photographed in three stances each.
_FIT_BIAS: Final = (0.032, -0.001, 0.000, 0.003, 0.003, 0.008, 0.010, 0.019, 0.014)
_FIT_DEVIATION: Final = (0.019, 0.009, 0.025, 0.016, 0.008, 0.007, 0.011, 0.027, 0.033)

#: Least relative error where cloth makes the outline: sleeves hide the armpits, hems and folds are no skin; taste.
_CLOTHED_DEVIATION: Final = 0.015


@functools.cache
def load_girth_prior() -> GirthPrior:
    """Return the girths of the shipped generic human's family."""
    deviation = np.array(_DEVIATION) / 1e3
    return GirthPrior(
        means=np.array(_MEANS) / 1e3,
        covariance=np.outer(deviation, deviation) * np.array(_CORRELATION),
        fit_bias=np.array(_FIT_BIAS),
        fit_deviation=np.maximum(_FIT_DEVIATION, _CLOTHED_DEVIATION),
    )
