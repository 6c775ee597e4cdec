"""Measures of a body by name, and which parts are covered by cloth."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Final


@dataclass(frozen=True, slots=True)
class MeasureKind:
    """One measure of the table.

    Attributes
    ----------
    key : str
        Name as in the reference table of ISO 8559-1 measures; a few of our own.
    words : str
        What is measured, for people.
    clause : str
        Clause of ISO 8559-1:2017; "" where the name is customary or our own.
    is_girth : bool
        Closed curves; everything else is a height, a breadth, a depth or a length over the skin.
    segment, place : str and float
        The skin segment (without its side) that carries the measure, and how far along it: 0 at the upper end.
    """

    key: str
    words: str
    clause: str
    is_girth: bool
    segment: str
    place: float


def _girth(key: str, words: str, clause: str, segment: str, place: float) -> MeasureKind:
    return MeasureKind(f"{key}_girth", words, clause, True, segment, place)


def _length(key: str, words: str, clause: str, segment: str, place: float) -> MeasureKind:
    return MeasureKind(key, words, clause, False, segment, place)


#: Every measure, in the order of the report. `place` is 0.5 where a segment is judged as a whole.
MEASURES: Final = (
    _girth("head", "head, over the brow", "", "head", 0.5),
    _girth("neck", "neck, below the larynx", "5.3.2", "neck", 0.5),
    _girth("bust", "chest, over the fullest of the breast", "5.3.4", "torso", 0.4),
    _girth("underbust", "chest, directly below the breast", "5.3.6", "torso", 0.55),
    _girth("narrowest_waist", "waist where it is narrowest", "", "torso", 0.75),
    _girth("waist", "waist, halfway from the lowest rib to the hip bone", "5.3.10", "torso", 0.85),
    _girth("navel", "waist at the navel", "", "pelvis", 0.1),
    _girth("hip", "hips, over the fullest of the buttocks", "5.3.13", "pelvis", 0.8),
    _girth("thigh", "thigh, below the buttock", "5.3.20", "thigh", 0.25),
    _girth("knee", "knee, over the kneecap", "5.3.22", "thigh", 0.97),
    _girth("calf", "calf where it is fullest", "5.3.24", "calf", 0.35),
    _girth("ankle", "ankle, over the ankle bones", "", "calf", 0.97),
    _girth("upper_arm", "upper arm, halfway to the elbow", "5.3.16", "upper_arm", 0.5),
    _girth("wrist", "wrist, over its bone", "5.3.19", "forearm", 0.97),
    _length("back_neck_height", "floor to the nape", "", "neck", 0.5),
    _length("shoulder_height", "floor to the shoulder's end", "", "torso", 0.2),
    _length("waist_height", "floor to the waist", "", "torso", 0.85),
    _length("hip_height", "floor to the level of the hip girth", "", "pelvis", 0.8),
    _length("inside_leg_height", "inside leg: floor to the crotch", "5.1.15", "pelvis", 0.95),
    _length("knee_height", "floor to the kneecap", "", "thigh", 0.97),
    _length("shoulder_width", "shoulder to shoulder, over the nape", "5.4.2", "torso", 0.15),
    _length("biacromial_breadth", "shoulder to shoulder, straight", "", "torso", 0.2),
    _length("chest_depth", "chest, back to front", "", "torso", 0.4),
    _length("arm_length", "shoulder over the elbow to the wrist", "5.7.8", "upper_arm", 0.5),
    _length("back_waist_length", "nape to waist along the back", "5.4.5", "torso", 0.5),
    _length("total_crotch_length", "waist to waist between the legs", "5.4.18", "pelvis", 0.5),
    _length("head_length", "brow to the back of the skull", "", "head", 0.5),
    _length("head_breadth", "skull above the ears", "", "head", 0.5),
    _length("face_length", "root of the nose to the chin", "", "head", 0.5),
    _length("hand_length", "wrist to the tip of the middle finger", "", "hand", 0.5),
    _length("foot_length", "heel to the longest toe", "", "foot", 0.5),
)
MEASURE_KEYS: Final = tuple(kind.key for kind in MEASURES)
BY_KEY: Final = MappingProxyType({kind.key: kind for kind in MEASURES})

#: How loosely a garment fits, closest first.
FITS: Final = ("tight", "regular", "loose")


@dataclass(frozen=True, slots=True)
class Measure:
    """One measure of the body under its clothes.

    Attributes
    ----------
    value_mm : float
    plus_minus_mm : float or None
        Nine in ten of such values lie within it; None when no photo showed the body.
    shown_mm : float or None
        The same measure on the clone's skin, which has the outline of the clothes; None where loose clothing hides it.
    taped : bool
        Whether an operator measured it on the person.
    """

    value_mm: float
    plus_minus_mm: float | None
    shown_mm: float | None
    taped: bool = False


@dataclass(frozen=True, slots=True)
class Cover:
    """Whether cloth covers a segment.

    Attributes
    ----------
    covered : tuple of bool or None
        Slices from the segment's upper end to its lower one; None where no photo shows the slice well.
    confidence : float in 0..1
        How clearly the colours tell.
    """

    covered: tuple[bool | None, ...]
    confidence: float

    @property
    def share(self) -> float | None:
        """Share of the seen slices under cloth; None when none was seen."""
        seen = [slice_ for slice_ in self.covered if slice_ is not None]
        return sum(seen) / len(seen) if seen else None

    def at(self, place: float) -> bool | None:
        """Return whether the slice at 0..1 along the segment is covered."""
        if not self.covered:
            return None
        return self.covered[min(int(place * len(self.covered)), len(self.covered) - 1)]


@dataclass(frozen=True, slots=True, eq=False)
class MeasureSet:
    """All measures of one person, and what the photos tell of the clothes.

    Attributes
    ----------
    measures : mapping of str to Measure
        By key of `MEASURES`.
    covers : mapping of str to Cover
        By name of the skin segment; empty when no photo showed the body.
    upper_fit, lower_fit : mapping of str to float
        Probability of each of `FITS` for the clothes above and below the waist.
    """

    measures: Mapping[str, Measure]
    covers: Mapping[str, Cover] = field(default_factory=dict)
    upper_fit: Mapping[str, float] = field(default_factory=dict)
    lower_fit: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("measures", "covers", "upper_fit", "lower_fit"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))
