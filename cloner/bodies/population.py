"""Population statistics of measures: for adults the shipped table, adjusted to a public survey.

The family (``measures.npz``, from CC0 data) knows how measures go together; its women and men are slimmer than people.
So the measures that the survey has are given the survey's mean and spread, and all others follow (Jeffrey's rule on a
Gaussian). What is told then tells of what is not told. Children are the family's.

References
----------
C. C. Gordon et al., 2012 Anthropometric Survey of U.S. Army Personnel: Methods and Summary Statistics,
NATICK/TR-15/007, 2014: 1,986 women and 4,082 men of 17 to 58 years; a work of the U.S. government, in the public
domain. The Gaussian's arithmetic: C. M. Bishop, Pattern Recognition and Machine Learning, 2006, 2.3.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.bodies.children import GROWN, children
from cloner.generic.measure_prior import load_measure_prior
from cloner.geometry.measurement.measuring import ALL_KEYS
from cloner.records.arrays import Array

SEXES: Final = ("f", "m")
#: Mean stature and its spread, mm (ANSUR II).
STATURE_MM: Final = {"f": (1628.5, 64.2), "m": (1756.2, 68.6)}
#: Mean and spread, mm (ANSUR II: chest, waist at the navel, buttock, neck, wrist and calf circumference). Women's first
#: three means, and the spreads of hip, wrist and calf by their 1st and 99th percentiles, were checked against readings
#: of the survey's files; the report itself was not at hand for the others.
SURVEY_MM: Final[Mapping[str, Mapping[str, tuple[float, float]]]] = {
    "f": {
        "bust_girth": (946.9, 82.7), "navel_girth": (860.9, 99.8), "hip_girth": (1021.2, 75.9),
        "neck_girth": (330.0, 18.8), "wrist_girth": (154.5, 7.7), "calf_girth": (378.0, 29.9),
    },
    "m": {
        "bust_girth": (1058.7, 87.4), "navel_girth": (940.5, 111.7), "hip_girth": (1019.8, 76.6),
        "neck_girth": (397.6, 25.7), "wrist_girth": (176.0, 9.0), "calf_girth": (392.0, 29.5),
    },
}  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class People:
    """Measures of one sex over stature.

    Attributes
    ----------
    mean : (K,) float64, mm a metre of stature, in the order of `ALL_KEYS`
    covariance : (K, K) float64
    """

    mean: Array
    covariance: Array

    def spread_mm(self, key: str, stature_m: float) -> tuple[float, float]:
        """Return mean and standard deviation of a measure at a stature, mm."""
        row = ALL_KEYS.index(key)
        return float(stature_m * self.mean[row]), float(stature_m * np.sqrt(self.covariance[row, row]))

    def told(self, stature_m: float, told_mm: Mapping[str, float]) -> People:
        """Return the people of a stature who have these measures, to 3 mm: what a tape reads twice."""
        rows = np.array([ALL_KEYS.index(key) for key in told_mm], dtype=np.intp)
        if not len(rows):
            return self
        values = np.array([told_mm[key] for key in told_mm]) / stature_m
        noise = (3.0 / stature_m) ** 2 * np.eye(len(rows))
        gain = np.linalg.solve(self.covariance[np.ix_(rows, rows)] + noise, self.covariance[rows]).T
        mean = self.mean + gain @ (values - self.mean[rows])
        return People(mean, self.covariance - gain @ self.covariance[rows])


def people(sex: str, age_years: float) -> People:
    """Return the table of a sex of `SEXES` at an age: one for all adults."""
    if age_years < GROWN:
        own = children(sex)
        return People(own.at(age_years)[1], own.covariance.astype(np.float64))
    return _adults(sex)


@functools.cache
def _adults(sex: str) -> People:
    prior = load_measure_prior()
    mean, covariance = (table[SEXES.index(sex)] for table in (prior.means, prior.covariances))
    stature_m = STATURE_MM[sex][0] / 1e3
    survey = SURVEY_MM[sex]
    rows = np.array([ALL_KEYS.index(key) for key in survey])
    wanted, spread = (np.array([pair[place] for pair in survey.values()]) / stature_m for place in (0, 1))
    own = covariance[np.ix_(rows, rows)]
    family = np.sqrt(np.diag(own))
    theirs = own * np.outer(spread / family, spread / family)  # correlations stay the family's
    gain = np.linalg.solve(own, covariance[rows]).T
    return People(mean + gain @ (wanted - mean[rows]), covariance + gain @ (theirs - own) @ gain.T)
