"""Lips in contact: steps that close them and that remove crossings.

All functions take and give the grid's points (K, N, 3), metres, rings by columns as
:class:`cloner.generic.face_grids.Grid` has them.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.generic.face_grids import Grid, lip_gaps_m
from cloner.generic.lip_steps import SHARE
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.lips")

SEAL_SHARE = np.array(_CALIBRATED.triple("seal_share", "share"))
PRESS_M = _CALIBRATED.number("press_m", "m")
#: A step moves lips whose columns lie beside each other a little apart again: so many suffice for 0.05 mm.
TURNS = 3
TOOTH_M = _CALIBRATED.number("tooth_m", "m")
BEFORE_M = _CALIBRATED.number("before_m", "m")
OVAL = _CALIBRATED.number("oval", "factor")
OVAL_FROM_M = _CALIBRATED.number("oval_from_m", "m")
OVAL_TO_M = _CALIBRATED.number("oval_to_m", "m")
BLUNT = _CALIBRATED.number("blunt", "factor")
ROUND = _CALIBRATED.table("round", "share")


def close_lips(grid: Grid, points: Array) -> Array:
    """Return the lips moved vertically, each half of the way, until they touch wherever there is a gap."""
    return _closed_within(grid, points, 0.0, np.inf)


def uncross_lips(grid: Grid, points: Array) -> Array:
    """Return the lips moved vertically, each half of the way, until they cross nowhere by more than a light contact."""
    return _closed_within(grid, points, -np.inf, 0.0)


def seal_lips(grid: Grid, points: Array) -> Array:
    """Return closed lips whose inner edges coincide, so that no slit is visible from above or below."""
    out, edge = points.copy(), points[grid.margin - 1]
    lines = []
    for lip in (grid.upper, grid.lower):
        own = lip.copy()
        own[grid.corners] = True
        columns = np.flatnonzero(own)[np.argsort(edge[own, 0])]
        lines.append(np.stack([np.interp(edge[:, 0], edge[columns, 0], edge[columns, k]) for k in (1, 2)], axis=1))
    step = (lines[0] + lines[1]) / 2.0 - edge[:, 1:]
    step[grid.corners] = 0.0
    out[: grid.margin, :, 1:] += SEAL_SHARE[:, None, None] * step
    return out


def round_lips(grid: Grid, rest: Array, moved: Array, width: float = 1.0) -> Array:
    """Return open lips in an oval in place of a V: as low in the middle, and fuller beside it.

    Parameters
    ----------
    rest, moved : (K, N, 3)
        Before and after the motion, metres.
    width : float
        Share of the corners' distance that they keep.
    """
    out, margin = moved.copy(), moved[grid.margin]
    left, right = (int(corner) for corner in grid.corners)
    middle, half = (margin[left, 0] + margin[right, 0]) / 2.0, max((margin[left, 0] - margin[right, 0]) / 2.0, 1e-6)
    across = np.clip((margin[:, 0] - middle) / half, -1.0, 1.0)
    base = margin[right, 1] + (margin[left, 1] - margin[right, 1]) * (across + 1.0) / 2.0
    step = np.zeros(len(margin))
    for lip in (grid.upper, grid.lower):
        own = margin[:, 1] - base
        column = np.flatnonzero(lip)[np.abs(across[lip]).argmin()]
        centre = float(own[column])
        drop = float(moved[grid.margin, column, 1] - rest[grid.margin, column, 1])
        drop -= float(np.mean(margin[[left, right], 1] - rest[grid.margin, [left, right], 1]))
        share = np.clip((abs(drop) - OVAL_FROM_M) / (OVAL_TO_M - OVAL_FROM_M), 0.0, 1.0)
        fuller = BLUNT * centre * (1.0 - across**2) ** OVAL - own
        # an upper lip keeps the bow of its own; a lower one that is fullest in its middle would hang to a point
        step[lip] = share * np.where((fuller[lip] * centre > 0.0) | grid.lower[lip], fuller[lip], 0.0)
    out[:, :, 1] += SHARE[:, None] * step
    out[:, :, 0] += SHARE[:, None] * (width - 1.0) * (margin[:, 0] - middle)
    return np.asarray(out)


def keep_before_teeth(grid: Grid, points: Array, teeth: Array) -> Array:
    """Return the lips in front of the teeth (T, 3) at their height, edges included."""
    out = points.copy()
    lip = out[grid.margin - 1 :].reshape(-1, 3)
    beside = np.abs(lip[:, None, 0] - teeth[None, :, 0]) < TOOTH_M
    front = np.where(beside, teeth[None, :, 2], -np.inf).max(axis=1) + BEFORE_M
    level = (lip[:, 1] > teeth[:, 1].min() - BEFORE_M) & (lip[:, 1] < teeth[:, 1].max() + BEFORE_M)
    lip[:, 2] = np.where(level, np.maximum(lip[:, 2], front), lip[:, 2])
    out[grid.margin - 1 :] = lip.reshape(out[grid.margin - 1 :].shape)
    return out


def _closed_within(grid: Grid, points: Array, least: float, most: float) -> Array:
    """Return the lips moved towards a light contact, with steps between two limits (closing is positive)."""
    out = points.copy()
    for _ in range(TURNS):
        step = 0.5 * np.clip(lip_gaps_m(grid, out) + PRESS_M, least, most)
        out[:, :, 1] += SHARE[:, None] * np.where(grid.upper, -step, np.where(grid.lower, step, 0.0))
    return out
