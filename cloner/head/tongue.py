"""The tongue: a rounded tip at rest, and the shape put out over the lower lip without intersecting it.

Tongue points are (T, 3) metres, +Y up, +Z front; the tip is the foremost end.
"""

from __future__ import annotations

import itertools
from typing import Final

import numpy as np
from scipy.interpolate import PchipInterpolator

from cloner.calibration.loader import calibrated
from cloner.generic.face_grids import Grid
from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.tongue")

TIP_M = _CALIBRATED.number("tip_m", "m")
BLUNT = _CALIBRATED.number("blunt", "share")
FURROW_M = _CALIBRATED.number("furrow_m", "m")
FURROW_WIDE_M = _CALIBRATED.number("furrow_wide_m", "m")
RAISED_M = _CALIBRATED.number("raised_m", "m")
RAISED_FROM_M = _CALIBRATED.number("raised_from_m", "m")
COMES_M = _CALIBRATED.number("comes_m", "m")
BEFORE_LIP_M = _CALIBRATED.number("before_lip_m", "m")
HANGS_M = _CALIBRATED.number("hangs_m", "m")
THICK_M = _CALIBRATED.number("thick_m", "m")
TIP_THICK_M = _CALIBRATED.number("tip_thick_m", "m")
WIDE_M = _CALIBRATED.number("wide_m", "m")
CLEAR_M = _CALIBRATED.number("clear_m", "m")
MIDDLE_M = _CALIBRATED.number("middle_m", "m")
#: Depths at which the tongue is measured: one every 4 mm, as its rings lie.
STEPS = 18


def rounded_tip(points: Array) -> Array:
    """Return a broad tongue with a round tip and a furrow along its back, of the same length."""
    out, tip = points.copy(), points[:, 2].max()
    middle = (points[:, 0].min() + points[:, 0].max()) / 2.0
    behind = np.clip((tip - points[:, 2]) / TIP_M, 0.0, 1.0)
    width = _half_ellipse(behind)
    out[:, 0] = middle + width * (points[:, 0] - middle)
    back, half = _ridge(points)
    upper = points[:, 1] > back
    furrow = FURROW_M * np.exp(-(((out[:, 0] - middle) / FURROW_WIDE_M) ** 2)) * np.minimum(2.0 * behind, 1.0)
    out[:, 1] += RAISED_M * np.clip(1.0 - (tip - points[:, 2]) / RAISED_FROM_M, 0.0, 1.0)
    out[:, 1] -= np.where(upper, np.minimum(furrow, half / 2.0), 0.0)
    return out


def _half_ellipse(behind: Array) -> Array:
    """Return the width of half an ellipse, 0..1, at a share of its length from its end."""
    return np.asarray(np.maximum(np.sqrt(1.0 - (1.0 - np.clip(behind, 0.0, 1.0)) ** 2), BLUNT))


def _extreme_at_depth(points: Array, values: Array, pick: np.ufunc) -> Array:
    """Return the least or the greatest (T,) of some values (T,) among the points at the same depth in the mouth."""
    steps = np.linspace(points[:, 2].min(), points[:, 2].max(), STEPS)
    found = []
    for depth in steps:
        away = np.abs(points[:, 2] - depth)
        found.append(pick.reduce(values[away <= max(0.75 * (steps[1] - steps[0]), away.min() + 1e-9)]))
    return np.asarray(np.interp(points[:, 2], steps, np.array(found)))


def _half_widths(points: Array) -> Array:
    """Return half of the tongue's width at every point's depth, (T,) metres."""
    middle = (points[:, 0].min() + points[:, 0].max()) / 2.0
    return _extreme_at_depth(points, np.abs(points[:, 0] - middle), np.maximum)


def _ridge(points: Array) -> tuple[Array, Array]:
    """Return the height of the tongue's middle at every point's depth, and half of its thickness there, (T,) metres."""
    low, high = (_extreme_at_depth(points, points[:, 1], pick) for pick in (np.minimum, np.maximum))
    return (low + high) / 2.0, np.maximum((high - low) / 2.0, 1e-4)


def extended_tongue(rest: Array, lying: Array, lips: Array, grid: Grid, teeth: Array) -> Array:
    """Return the tongue (T, 3) put out between lips that the jaw has opened.

    Its front part goes up over the lower teeth, lies on the lower lip, cupped as that is, and hangs down before it.

    Parameters
    ----------
    rest, lying : (T, 3)
        At rest, and carried by the jaw as far as it is open.
    lips : (K, N, 3)
        The opened lips.
    grid : Grid
        `mouth_grid`.
    teeth : (L, 3)
        The lower teeth as the jaw holds them.
    """
    comes = np.clip(1.0 - (rest[:, 2].max() - rest[:, 2]) / COMES_M, 0.0, 1.0)
    middle = (rest[:, 0].min() + rest[:, 0].max()) / 2.0
    path, lip_top = _tongue_path(lying, comes, lips, grid, teeth, middle)
    bend = PchipInterpolator(path[:, 0], path[:, 1:])
    place, along = bend(comes), bend.derivative()(comes)
    along = unit(along)
    back, half = _ridge(rest)
    rise = (rest[:, 1] - back) / half
    blend = np.clip(comes / 0.5, 0.0, 1.0)
    on_lip = float(path[2, 0])
    thick = np.interp(comes, [on_lip, 1.0], [THICK_M, TIP_THICK_M])
    thick = half + blend * (np.minimum(thick, half) - half)
    out_wide = WIDE_M * (rest[:, 0] - middle) / np.maximum(_half_widths(rest), 1e-4)
    aside = rest[:, 0] - middle + blend * (out_wide - (rest[:, 0] - middle))
    rise *= thick
    out = np.stack([middle + aside, place[:, 0] + rise * along[:, 1], place[:, 1] - rise * along[:, 0]], axis=1)
    out[:, 1] += blend * np.maximum(np.interp(out[:, 0], *lip_top) - np.interp(middle, *lip_top), 0.0)
    share = np.clip(comes / 0.15, 0.0, 1.0)[:, None]  # the root stays where the jaw holds it
    return np.asarray(lying + share * (out - lying))


def _tongue_path(
    lying: Array, comes: Array, lips: Array, grid: Grid, teeth: Array, middle: float
) -> tuple[Array, tuple[Array, Array]]:
    """Return the path of the tongue's middle, rows of (share, y, z), and the lower lip's top (x, y)."""
    lower = np.flatnonzero(grid.lower)
    top = lips[:, lower, 1].max(axis=0)
    order = np.argsort(lips[grid.margin, lower, 0])
    lip_top = (lips[grid.margin, lower, 0][order], top[order])
    near = lower[np.abs(lips[grid.margin, lower, 0] - middle) < MIDDLE_M]
    touching = lips[grid.margin - 1 :, near].reshape(-1, 3)
    height, front = touching[:, 1].max(), touching[:, 2].max()
    tooth = teeth[np.abs(teeth[:, 0] - middle) < 2.0 * MIDDLE_M]
    edge = tooth[tooth[:, 1].argmax()]
    still = lying[comes == 0.0]
    root = still[still[:, 2] > np.quantile(still[:, 2], 0.8)].mean(axis=0)
    above = max(height, edge[1]) + CLEAR_M + THICK_M
    points = [
        (root[1], root[2]),
        (edge[1] + CLEAR_M + THICK_M, edge[2] - THICK_M),
        (above, (edge[2] + front) / 2.0),
        (height + CLEAR_M + THICK_M, front + CLEAR_M),
        (height - HANGS_M, front + BEFORE_LIP_M),
    ]
    ways = np.cumsum([0.0, *(float(np.hypot(b[0] - a[0], b[1] - a[1])) for a, b in itertools.pairwise(points))])
    return np.column_stack([ways / ways[-1], points]), lip_top
