"""Arms that cover the trunk's depth in the side photo."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.body.outlined import PosedSilhouette
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import ALL_KEYS, TRUNK_SLICES
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/measure.toml``.
_CALIBRATED: Final = calibrated("measure.side_arms")


TRUNK: Final = ("torso", "pelvis")
CLEAR_MM: Final = _CALIBRATED.number("clear_mm", "mm")
BAND_MM: Final = _CALIBRATED.number("band_mm", "mm")
HANDS: Final = _CALIBRATED.number("hands", "share")
#: Measures of the trunk with the vertices of `TapeRules` at their level, or their place from armpit (0) to crotch (1).
LEVELS: Final[Mapping[str, str | float]] = {
    "bust_girth": "chest",
    "chest_depth": "chest",
    "underbust_girth": "underbust",
    "narrowest_waist_girth": "natural_waist",
    "waist_girth": "natural_waist",
    "navel_girth": "waist",
    **{f"trunk_slice_{100 * place:.0f}": place for place in TRUNK_SLICES if place < HANDS},
}


def hidden_rows(vertices_m: Array, seen: Mapping[ViewId, PosedSilhouette]) -> NDArray[np.bool_]:
    """Return which trunk measures (K,) of `ALL_KEYS` have their depth covered by an arm.

    Parameters
    ----------
    vertices_m : (V, 3) rest pose
    seen : mapping of ViewId to Seen
        The same vertices posed as in each photo; without a side photo nothing is called hidden.
    """
    hidden = np.zeros(len(ALL_KEYS), dtype=bool)
    if ViewId.BODY_SIDE not in seen:
        return hidden
    side = seen[ViewId.BODY_SIDE]
    for key, level in LEVELS.items():
        hidden[ALL_KEYS.index(key)] = _is_hidden(vertices_m[:, 1] - _height_m(vertices_m, level), side)
    return hidden


def _height_m(vertices_m: Array, level: str | float) -> float:
    rules = load_tape_rules()
    if isinstance(level, str):
        return float(vertices_m[list(rules.level_vertices[level]), 1].mean())
    crotch, armpit = (float(vertices_m[rules.points[name], 1]) for name in ("crotch", "armpit_left"))
    return armpit + level * (crotch - armpit)


def _is_hidden(above_m: Array, side: PosedSilhouette) -> bool:
    """Return whether the trunk's vertices near a level (0) end beside an arm, on either side."""
    generic = load_generic()
    names = np.array([name.removeprefix("left_").removeprefix("right_") for name in generic.segment_names])
    part = names[generic.vertex_segment]
    trunk = side.body.pixels[np.isin(part, TRUNK) & (np.abs(above_m) < 1e-3 * BAND_MM)]
    arms = side.body.pixels[np.isin(part, ("upper_arm", "forearm", "hand"))]
    if not len(trunk):
        return False
    low, high = np.quantile(trunk[:, 1], (0.25, 0.75))
    arms = arms[(arms[:, 1] >= low) & (arms[:, 1] <= high)]
    clear = CLEAR_MM / side.mm_per_px
    return bool((arms[:, 0] < trunk[:, 0].min() + clear).any() or (arms[:, 0] > trunk[:, 0].max() - clear).any())
