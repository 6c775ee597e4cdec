"""Body statistics of children of 4 to 18 years: ``children.npz``, made by ``generic_models/build/build_children.py``.

Their bodies and measures are those of the family's children (CC0), their statures a public survey's: no public table
of all a tailor's measures of children was at hand.
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.measurement.measuring import ALL_KEYS
from cloner.records.arrays import Array

#: Age of a body of which nothing is said, years.
USUAL_AGE: Final = 35.0
#: From this age on a body is an adult's, years; the youngest that can be made; the oldest.
GROWN, YOUNGEST, OLDEST = 18.0, 4.0, 90.0
#: Median stature, mm, and its spread over it, of girls ("f") and boys at 4, 6 ... 18 years. R. J. Kuczmarski et al.,
#: 2000 CDC Growth Charts for the United States, Vital and Health Statistics 11 (246), 2002; in the public domain.
SURVEY_AGES: Final = (4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0)
STATURES_MM: Final = {
    "f": (1008.0, 1147.0, 1276.0, 1380.0, 1512.0, 1604.0, 1625.0, 1631.0),
    "m": (1022.0, 1154.0, 1279.0, 1386.0, 1491.0, 1638.0, 1735.0, 1762.0),
}
SPREADS: Final = {
    "f": (0.0432, 0.0449, 0.0459, 0.0486, 0.0488, 0.0411, 0.0398, 0.0397),
    "m": (0.0413, 0.0436, 0.0451, 0.0476, 0.0499, 0.0490, 0.0432, 0.0407),
}


@dataclass(frozen=True, slots=True, eq=False)
class Children:
    """The family's children of one sex.

    Attributes
    ----------
    ages : (A,) float32, years
    coefficients : (A, C) float32
        The usual child of each age in the family.
    means : (A, K) float32
        Its measures, mm a metre of stature, in the order of `ALL_KEYS`.
    covariance : (K, K) float32
        Of children of one age.
    """

    ages: NDArray[np.float32]
    coefficients: NDArray[np.float32]
    means: NDArray[np.float32]
    covariance: NDArray[np.float32]

    def at(self, age: float) -> tuple[Array, Array]:
        """Return (C,) coefficients and (K,) mean measures of the usual child of an age."""
        whole = np.hstack([self.coefficients, self.means]).astype(np.float64)
        found = np.array([np.interp(age, self.ages, column) for column in whole.T])
        return found[: self.coefficients.shape[1]], found[self.coefficients.shape[1] :]


@functools.cache
def children(sex: str) -> Children:
    """Return the family's girls ("f") or boys ("m").

    Raises
    ------
    ValueError
        If the table was made for other measures.
    """
    place = importlib.resources.files("cloner_models") / "children.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as data:
        if tuple(data["keys"].tolist()) != ALL_KEYS:
            raise ValueError("children.npz was made for other measures: run build_children.py")
        row = "fm".index(sex)
        return Children(data["ages"], *(data[name][row] for name in ("coefficients", "means", "covariances")))


def stature_mm(sex: str, age: float) -> tuple[float, float]:
    """Return the median stature of children of an age and its spread, mm."""
    median, share = (float(np.interp(age, SURVEY_AGES, table[sex])) for table in (STATURES_MM, SPREADS))
    return median, median * share
