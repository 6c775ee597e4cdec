"""The specification of a body, with plausibility checks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.bodies.children import GROWN, OLDEST, USUAL_AGE, YOUNGEST, stature_mm
from cloner.bodies.population import SEXES, people
from cloner.errors import ClonerError
from cloner.geometry.measurement.measuring import ALL_KEYS
from cloner.records.measures import BY_KEY

#: Girths and lengths that can be told; the head is kept, and the others follow.
GIRTHS: Final = (
    "neck_girth", "bust_girth", "underbust_girth", "narrowest_waist_girth", "waist_girth", "navel_girth", "hip_girth",
    "thigh_girth", "knee_girth", "calf_girth", "ankle_girth", "upper_arm_girth", "wrist_girth",
)  # fmt: skip
LENGTHS: Final = (
    "back_neck_height", "waist_height", "inside_leg_height", "knee_height", "shoulder_width", "arm_length",
)  # fmt: skip
#: What is usually asked for (with the stature 4 and 9): a shop's tape, and a tailor's.
PRESETS: Final = {
    "four": ("bust_girth", "waist_girth", "hip_girth"),
    "nine": (
        "neck_girth", "bust_girth", "underbust_girth", "waist_girth", "hip_girth", "thigh_girth", "inside_leg_height",
        "arm_length",
    ),
}  # fmt: skip
#: Of adults.
STATURES_M: Final = (1.30, 2.20)
#: A measure alone may be so many spreads from the mean, and given the others told with it; beyond, nobody is.
FAR, FAR_TOGETHER = 4.5, 6.0
#: Pairs in which the first is never smaller than the second.
NEVER_SMALLER: Final = (
    ("waist_girth", "narrowest_waist_girth"), ("navel_girth", "narrowest_waist_girth"),
    ("bust_girth", "underbust_girth"), ("hip_girth", "thigh_girth"), ("thigh_girth", "knee_girth"),
    ("thigh_girth", "calf_girth"), ("calf_girth", "ankle_girth"), ("upper_arm_girth", "wrist_girth"),
    ("back_neck_height", "waist_height"), ("waist_height", "inside_leg_height"), ("inside_leg_height", "knee_height"),
)  # fmt: skip
#: A waist this much below the hips already makes the belly the widest, mm.
BELLY_MM: Final = 30.0
_MEASURE: Final = "Measure again"


@dataclass(frozen=True, slots=True)
class BodySpecification:
    """What is given of a body.

    Attributes
    ----------
    sex : str
        "f" or "m".
    stature_m : float
    mm : mapping of str to float
        By key of the measures' table.
    age_years : float
    """

    sex: str
    stature_m: float
    mm: Mapping[str, float]
    age_years: float = USUAL_AGE

    @property
    def seat(self) -> bool:
        """Whether the waist exceeds the hips: then their tape lies over the buttocks, not at the widest."""
        waists = [self.mm.get(key, 0.0) for key in ("waist_girth", "navel_girth", "narrowest_waist_girth")]
        return "hip_girth" in self.mm and max(waists) > self.mm["hip_girth"] - BELLY_MM


def statures_m(sex: str, age_years: float) -> tuple[float, float]:
    """Return the least and the greatest stature that can be made, metres."""
    if age_years >= GROWN:
        return STATURES_M
    median, spread = stature_mm(sex, age_years)
    return (median - FAR * spread) / 1e3, (median + FAR * spread) / 1e3


def check_specification(spec: BodySpecification) -> None:
    """Refuse what no body can have.

    Raises
    ------
    ClonerError
        One sentence that names the measure.
    """
    if spec.sex not in SEXES:
        raise ClonerError(f"the sex {spec.sex!r} is not known", "Give --sex f or --sex m", "--sex")
    if not YOUNGEST <= spec.age_years <= OLDEST:  # neither nan
        hint = f"People of {YOUNGEST:.0f} to {OLDEST:.0f} years can be made"
        raise ClonerError(f"an age of {spec.age_years:g} years cannot be made", hint, "--age")
    low, high = (100.0 * end for end in statures_m(spec.sex, spec.age_years))
    if not low <= 100.0 * spec.stature_m <= high:
        hint = f"Adults of {low:.0f} to {high:.0f} cm can be made"
        if spec.age_years < GROWN:
            hint = f"At {spec.age_years:g} years bodies of {low:.0f} to {high:.0f} cm can be made"
        raise ClonerError(f"a stature of {100.0 * spec.stature_m:g} cm cannot be made", hint, "--stature")
    for key in spec.mm:
        if key not in (*GIRTHS, *LENGTHS):
            hint = f"These can: {', '.join((*GIRTHS, *LENGTHS))}"
            raise ClonerError(f"the {_words(key)} cannot be told, it follows from the others", hint, key)
    for larger, smaller in NEVER_SMALLER:
        if larger in spec.mm and smaller in spec.mm and spec.mm[larger] < spec.mm[smaller]:
            large, small = spec.mm[larger], spec.mm[smaller]
            raise ClonerError(
                f"the {_words(larger)} of {_cm(large)} is smaller than the {_words(smaller)} of {_cm(small)}",
                _MEASURE,
                larger,
            )
    _check_likely(spec)


def _check_likely(spec: BodySpecification) -> None:
    """Refuse measures far from everybody's, alone or beside the others."""
    everybody = people(spec.sex, spec.age_years)
    for key, value in spec.mm.items():
        _check_near(spec, key, value, everybody.spread_mm(key, spec.stature_m), FAR, alone=True)
    for key, value in spec.mm.items():
        others = {other: each for other, each in spec.mm.items() if other != key}
        alike = everybody.told(spec.stature_m, others)
        _check_near(spec, key, value, alike.spread_mm(key, spec.stature_m), FAR_TOGETHER, alone=False)


def _check_near(
    spec: BodySpecification, key: str, value: float, usual: tuple[float, float], far: float, *, alone: bool
) -> None:
    mean, spread = usual[0], max(usual[1], 0.02 * usual[0])
    if abs(value - mean) > far * spread:
        hint = f"Measure again; {_cm(mean - far * spread)} to {_cm(mean + far * spread)} can be made"
        message = f"a {_words(key)} of {_cm(value)} is no body's of {100.0 * spec.stature_m:.0f} cm"
        raise ClonerError(message if alone else f"{message} with the other measures", hint, key)


def refused(key: str, error_mm: float, wanted_mm: float) -> ClonerError:
    """Return the refusal of a body that a measure could not be given to."""
    message = f"no body could be made with a {_words(key)} of {_cm(wanted_mm)}: {abs(error_mm):.0f} mm remain"
    return ClonerError(message, "Measure it again, or leave it out", key)


def untold_mm(spec: BodySpecification) -> dict[str, tuple[float, float]]:
    """Return the most likely value and the standard deviation of every measure that is not given, mm."""
    alike = people(spec.sex, spec.age_years).told(spec.stature_m, spec.mm)
    deviation = spec.stature_m * np.sqrt(np.maximum(np.diag(alike.covariance), 0.0))
    values = spec.stature_m * alike.mean
    return {key: (float(values[row]), float(deviation[row])) for row, key in enumerate(ALL_KEYS) if key not in spec.mm}


def _words(key: str) -> str:
    return key.replace("_", " ") if key in BY_KEY else key


def _cm(value_mm: float) -> str:
    return f"{value_mm / 10.0:.1f} cm"
