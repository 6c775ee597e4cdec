"""Girths of the body under its clothes, from girths of the clothes' outline.

Outlines show clothes. A coat's waist says how large the waist can be, not how large
it is. So the girths are estimated together: which body of the generic family, under
which clothes, would show these outlines? A family of bodies (their girths vary
together: Gaussian, women and men apart) is dressed in a grid of upper and lower
garments, from tight to wide; each pair of garments gives a Gaussian estimate and a
likelihood, and the answer is their mixture, with its standard deviation.

References
----------
"Beyond": not in the paper, whose people wear tight clothes. The arithmetic is that of
a Gaussian mixture (C. M. Bishop, Pattern Recognition and Machine Learning, 2006, 2.3).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.measures import GIRTH_NAMES, Girth
from cloner.records.arrays import freeze

Array = NDArray[np.float64]

#: Ease (garment minus body) at the chest or the hip for the kinds of garment that are tried, mm: from a tight knit
#: to a coat, in steps as tailors' tables have them.
UPPER_EASE_MM: Final = (8.0, 20.0, 40.0, 75.0, 130.0, 200.0)
LOWER_EASE_MM: Final = (8.0, 20.0, 40.0, 75.0, 130.0)
#: How often each upper garment is tried, relative; a coat is worn least indoors. Taste.
UPPER_SHARE: Final = (1.0, 1.0, 1.0, 1.0, 1.0, 0.5)
#: Ease of a garment elsewhere, relative to its ease at chest or hip. Judged from how shirts, jackets and trousers are
#: cut, not measured: collars stand off less, a jacket is wide at the waist, a straight trouser leg is wide at the calf.
UPPER_CUT: Final = {
    "neck": 0.4, "chest": 1.0, "underbust": 1.1, "waist": 1.2, "waist_min": 1.3, "hip": 1.0, "upper_arm": 0.6
}  # fmt: skip
LOWER_CUT: Final = {"waist": 0.3, "hip": 1.0, "thigh": 0.9, "calf": 1.8}
#: Spread of the ease within one kind of garment, and of one girth's ease against the others' (of logarithms; taste).
KIND_SPREAD: Final = 0.25
CUT_SPREAD: Final = 0.35
#: What a tape reads, mm.
TAPE_MM: Final = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class GirthPrior:
    """Girths of a family of bodies, in the order of `GIRTH_NAMES`.

    Attributes
    ----------
    means : (K, 9) float64
        Mean girth over stature, one row for each kind of person, all equally frequent.
    covariance : (9, 9) float64
        Of girth over stature, the same for all kinds.
    fit_bias, fit_deviation : (9,) float64
        Relative error of a girth fitted to a naked body's outlines: mean and standard deviation.
    """

    means: Array
    covariance: Array
    fit_bias: Array
    fit_deviation: Array

    def __post_init__(self) -> None:
        count = len(GIRTH_NAMES)
        freeze(
            self,
            means=(np.float64, (None, count)),
            covariance=(np.float64, (count, count)),
            fit_bias=(np.float64, (count,)),
            fit_deviation=(np.float64, (count,)),
        )


def girths_under_clothes(shown_mm: Mapping[str, float], stature_m: float, prior: GirthPrior) -> dict[str, Girth]:
    """Return the likeliest girths of the body, and one standard deviation each.

    Parameters
    ----------
    shown_mm : mapping of str to float
        Girths of the clone's skin as :func:`girths_mm` gives them, clothes included.
    stature_m : float
    prior : GirthPrior
    """
    shown = np.array([shown_mm[name] for name in GIRTH_NAMES]) / (1.0 + prior.fit_bias)
    noise = np.diag((prior.fit_deviation * shown) ** 2 + TAPE_MM**2)
    spread = prior.covariance * (1e3 * stature_m) ** 2
    logs, means, covariances = [], [], []
    for mean in prior.means * 1e3 * stature_m:
        for share, ease, ease_spread in _garments():
            total = spread + ease_spread + noise
            gap = shown - mean - ease
            logs.append(np.log(share) - 0.5 * (gap @ np.linalg.solve(total, gap) + np.linalg.slogdet(total)[1]))
            gain = np.linalg.solve(total, spread).T
            means.append(mean + gain @ gap)
            covariances.append(spread - gain @ spread)
    weights = np.exp(np.array(logs) - max(logs))
    weights /= weights.sum()
    each = np.array(means)
    best = weights @ each
    variance = weights @ (np.diagonal(np.array(covariances), axis1=1, axis2=2) + (each - best) ** 2)
    return {
        name: Girth(float(value), float(np.sqrt(wide)))
        for name, value, wide in zip(GIRTH_NAMES, best, variance, strict=True)
    }


def _garments() -> list[tuple[float, Array, Array]]:
    """Return frequency, mean ease (9,) and its covariance (9, 9), mm, of every pair of garments."""
    pairs = []
    for share, upper_mm in zip(UPPER_SHARE, UPPER_EASE_MM, strict=True):
        for lower_mm in LOWER_EASE_MM:
            upper, lower = (
                np.array([size * cut.get(name, 0.0) for name in GIRTH_NAMES])
                for size, cut in ((upper_mm, UPPER_CUT), (lower_mm, LOWER_CUT))
            )
            outer = upper >= lower  # where both cover the body, the wider one makes the outline
            mean = np.maximum(upper, lower) * np.exp((KIND_SPREAD**2 + CUT_SPREAD**2) / 2.0)
            common = np.where(outer[:, None] == outer[None], np.expm1(KIND_SPREAD**2), 0.0)
            own = np.exp(KIND_SPREAD**2) * np.expm1(CUT_SPREAD**2)
            pairs.append((share, mean, np.outer(mean, mean) * (common + own * np.eye(len(mean)))))
    return pairs
