"""The most likely body of the family with given measures (damped Gauss-Newton)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from cloner.bodies.family import Family
from cloner.bodies.ruler import Reading, girth_slopes, length_slopes, level_slopes, read
from cloner.geometry.measurement.measures import TapeRules
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

#: Error of a told measure that the family leaves to the regions, mm: closer, it would bend knees and feet for a belly.
TOLD_MM: Final = 4.0
#: Beyond this many standard deviations a mode's shapes crumple (seen in pictures).
FARTHEST: Final = 2.2
ROUNDS: Final = 4
#: Largest step of a coefficient in a round.
STEP: Final = 1.2


def fit_measures(
    family: Family,
    rules: TapeRules,
    told_mm: Mapping[str, float],
    untold_mm: Mapping[str, tuple[float, float]],
    *,
    seat: bool,
) -> BodyMesh:
    """Return the body of the family closest to the given measures and, with less weight, to the likeliest other ones.

    Parameters
    ----------
    family : Family
    rules : TapeRules
    told_mm : mapping of str to float
    untold_mm : mapping of str to (float, float)
        Likeliest value and its spread.
    seat : bool
        As for :func:`cloner.bodies.ruler.tapes`.
    """
    wanted = {key: (value, TOLD_MM) for key, value in told_mm.items()} | dict(untold_mm)
    coefficients = np.zeros(len(family.modes_m))
    for _ in range(ROUNDS if wanted else 0):
        body = family.body(coefficients)
        reading = read(body.vertices_m, body.joints_m, rules, tuple(wanted), seat=seat)
        slopes = np.array([_slopes(body, family, rules, reading, key) for key in wanted])
        sigma = np.array([pair[1] for pair in wanted.values()])
        gap = np.array([pair[0] - reading.mm[key] for key, pair in wanted.items()])
        scaled = slopes / sigma[:, None]
        normal = scaled.T @ scaled + np.eye(len(coefficients))
        step = np.linalg.solve(normal, scaled.T @ (gap / sigma) - coefficients)
        largest = float(np.abs(step).max())
        coefficients = np.clip(coefficients + step * min(1.0, STEP / max(largest, 1e-9)), -FARTHEST, FARTHEST)
        if largest < 0.05:
            break
    return family.body(coefficients)


def _slopes(body: BodyMesh, family: Family, rules: TapeRules, reading: Reading, key: str) -> Array:
    if key in reading.planes:
        rise = level_slopes(family.modes_m, rules, key)
        return girth_slopes(body.vertices_m, family.modes_m, reading.planes[key], rise)
    return length_slopes(body.vertices_m, family.modes_m, rules, key)
