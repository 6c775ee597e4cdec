"""Six emotional styles of walking as parameters of :func:`cloner.motion.moves.gait.walk`.

The six are the five of ViCrowd and "afraid". What differs follows the literature in kind, and is taste in size: sad is
slow and short of step, slouched, arms still; happy steps long, bounces and swings its arms; anger is fast and stamps;
fear is fast with short steps, crouched, and moves little but the forearms.

References
----------
N. F. Troje, Decomposing biological motion, 2002. S. Halovic, C. Kroos, Not all is noticed: kinematic cues of
emotion-specific gait, 2018.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final


@dataclass(frozen=True, slots=True)
class Style:
    """One manner of walking.

    Attributes
    ----------
    name : str
    cycle_frames : int
        Sixtieths of a second of one left and one right step; even, so that both feet are planted on the same frames.
    thigh, knee, foot : float
        Shares of the regular walk's angles of the leg: stride, lift, and how far heel and toes roll.
    crouch_deg : float
        Added to the thigh's and twice to the knee's bend all the time.
    arm_deg : float
        Half of the swing of the upper arm.
    elbow_deg : (float, float)
        Its bend at the back and at the front of the swing.
    lean_deg : float
        Of the chest forward of the vertical.
    bow_deg : float
        Of the head, nose down, against the vertical.
    shrug_deg : float
        By which the collar bones are raised.
    sway_m : float
        Of the hips over the standing foot.
    chest_turn_deg, pelvis_turn_deg, pelvis_drop_deg : float
    stance : float
        Share of a foot's own cycle in which it stands (Winter: .60 of a walk).
    """

    name: str
    cycle_frames: int = 60
    thigh: float = 1.0
    knee: float = 1.0
    foot: float = 1.0
    crouch_deg: float = 0.0
    arm_deg: float = 21.0
    elbow_deg: tuple[float, float] = (14.0, 34.0)
    lean_deg: float = 1.7
    bow_deg: float = 0.0
    shrug_deg: float = 0.0
    sway_m: float = 0.018
    chest_turn_deg: float = 5.0
    pelvis_turn_deg: float = 5.0
    pelvis_drop_deg: float = 3.0
    stance: float = 0.60


REGULAR: Final = Style("regular")
#: The six by name; sad has 100 steps a minute, explosive 144.
STYLES: Final[Mapping[str, Style]] = MappingProxyType({
    style.name: style
    for style in (
        Style("sad", cycle_frames=72, thigh=0.78, knee=0.85, foot=0.7, arm_deg=8.0, elbow_deg=(10.0, 16.0),
              lean_deg=9.0, bow_deg=22.0, sway_m=0.024, chest_turn_deg=2.0, pelvis_turn_deg=3.0),
        Style("calm", cycle_frames=66, thigh=0.92, knee=0.95, foot=0.9, arm_deg=16.0, elbow_deg=(12.0, 26.0),
              chest_turn_deg=4.0, pelvis_turn_deg=4.0),
        REGULAR,
        Style("happy", cycle_frames=58, thigh=1.12, knee=1.12, arm_deg=30.0, elbow_deg=(18.0, 52.0), lean_deg=-2.0,
              bow_deg=-5.0, chest_turn_deg=9.0, pelvis_turn_deg=7.0, pelvis_drop_deg=4.5),
        Style("explosive", cycle_frames=50, thigh=1.15, knee=1.15, foot=0.9, arm_deg=36.0, elbow_deg=(40.0, 78.0),
              lean_deg=9.0, bow_deg=4.0, shrug_deg=5.0, sway_m=0.012, chest_turn_deg=10.0, pelvis_turn_deg=7.0),
        Style("afraid", cycle_frames=46, thigh=0.95, knee=1.0, foot=0.85, crouch_deg=8.0, arm_deg=10.0,
              elbow_deg=(75.0, 98.0), lean_deg=13.0, bow_deg=-4.0, shrug_deg=10.0, sway_m=0.010, chest_turn_deg=3.0),
    )
})  # fmt: skip
#: What of a walk is more or less in women and men, against the usual one: hips against shoulders (Murray, Kory, Sepic
#: 1970; Kozlowski, Cutting 1978); how much is taste.
SEXES: Final[Mapping[str, Mapping[str, float]]] = MappingProxyType({
    "f": {"pelvis_turn_deg": 1.3, "pelvis_drop_deg": 1.4, "chest_turn_deg": 0.8},
    "m": {"pelvis_turn_deg": 0.85, "pelvis_drop_deg": 0.75, "chest_turn_deg": 1.25},
})  # fmt: skip
#: Children below the first age step faster, by the share at four years (Sutherland 1988: 143 steps a minute at seven,
#: 114 grown); from the second age on steps are shorter and flatter, by the shares at the last one (Winter, Patla,
#: Frank, Walt 1990; Judge 1996), and one stoops by so many degrees more.
GROWN_YEARS, YOUNGEST_YEARS, FASTER = 14.0, 4.0, 0.22
OLD_YEARS, OLDEST_YEARS = 60.0, 85.0
OLD: Final[Mapping[str, float]] = MappingProxyType({"thigh": 0.82, "knee": 0.9, "foot": 0.75, "arm_deg": 0.6})
STOOPED: Final[Mapping[str, float]] = MappingProxyType({"lean_deg": 6.0, "bow_deg": 8.0, "crouch_deg": 3.0})
#: No foot rolls less than this share of the usual, however old and sad: slow and turning, it would drag (slides of 8.4
#: mm a step in the mean; `benchmarks/footings.py`).
FLATTEST: Final = 0.6
#: A jog in which always one foot carries, knees bent, no flight: 2.1 (anna) and 2.3 m/s (boris).
RUN: Final = Style("run", cycle_frames=42, thigh=1.4, knee=1.45, crouch_deg=8.0, arm_deg=38.0, elbow_deg=(80.0, 105.0),
                   lean_deg=12.0, sway_m=0.008, chest_turn_deg=9.0, pelvis_turn_deg=8.0, stance=0.57)  # fmt: skip


def suited(style: Style, sex: str = "", age_years: float = 0.0) -> Style:
    """Return a style adapted to a sex and age; unknown ones change nothing.

    Parameters
    ----------
    style : Style
    sex : str
        "f", "m", or "" where nobody told.
    age_years : float
        0 where nobody told.
    """
    changed = {name: getattr(style, name) * share for name, share in SEXES.get(sex, {}).items()}
    if 0.0 < age_years < GROWN_YEARS:
        young = min((GROWN_YEARS - age_years) / (GROWN_YEARS - YOUNGEST_YEARS), 1.0)
        changed["cycle_frames"] = 2 * round(style.cycle_frames * (1.0 - FASTER * young) / 2.0)
    old = min(max((age_years - OLD_YEARS) / (OLDEST_YEARS - OLD_YEARS), 0.0), 1.0)
    changed |= {name: getattr(style, name) * (1.0 + (share - 1.0) * old) for name, share in OLD.items() if old}
    changed |= {name: getattr(style, name) + more * old for name, more in STOOPED.items() if old}
    if "foot" in changed:
        changed["foot"] = max(changed["foot"], min(FLATTEST, style.foot))
    return replace(style, **changed)
