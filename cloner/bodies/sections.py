"""Displacement fields for breast, waist, hips and limbs, after the source.

Seo's "volumetric deformation" (the heritage tutorial): the breast is a grid of 20 rows with 23 stations, each row a
closed curve that stays round; the waist the same with Bézier curves; the hips a free-form deformation. The source
gives no formulas; amounts in front, at the sides and behind are taste, after how bodies grow.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from scipy.interpolate import CubicSpline, RegularGridInterpolator

from cloner.easing import half_wave
from cloner.records.arrays import Array

#: Heights of a section, and stations around it (taste).
ROWS, STATIONS = 20, 23
#: How much of its growth a breast's row takes in front (twice, at both breasts), everywhere, for women and men.
LOBES: Final = {"f": (1.0, 0.35), "m": (0.5, 0.6)}
#: Where the breasts stand, radians from the front, and how wide they are.
LOBE_AT, LOBE_WIDE = 0.55, 0.45
#: Handles of a waist's section: front, sides, back.
HANDLES: Final = (1.0, 0.75, 0.55)
#: A circle of four cubic arcs (the usual constant 4/3 (sqrt 2 - 1)).
ARC: Final = 0.5522847498
#: Control points of the hips' lattice in x, y, z, and their growth to the sides, behind and in front.
LATTICE: Final = (4, 3, 4)
HIPS: Final = (1.0, 1.0, 0.45)


def bell(away_m: Array, wide_m: float) -> Array:
    """Return 1 at the level, 0 beyond twice the width, smooth between (raised cosine)."""
    return np.asarray(np.where(np.abs(away_m) < 2.0 * wide_m, 0.5 + 0.5 * np.cos(np.pi * away_m / (2.0 * wide_m)), 0.0))


def around(points_m: Array, centre_m: Array) -> tuple[Array, Array]:
    """Return angles (V,) from the front, left positive, and outward directions (V, 3) about an upright axis."""
    away = (points_m - centre_m) * [1.0, 0.0, 1.0]
    outward = away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-6)
    return np.arctan2(away[:, 0], away[:, 2]), outward


def breast(points_m: Array, centre_m: Array, span_m: tuple[float, float], level_m: float, sex: str) -> Array:
    """Return (V, 3) the field of a breast: rows from ``span_m`` low to high, fullest at ``level_m``."""
    low, high = span_m
    heights = np.linspace(low, high, ROWS)
    stations = np.linspace(-np.pi, np.pi, STATIONS + 1)
    lobe, everywhere = LOBES[sex]
    front = np.exp(-0.5 * ((np.abs(stations) - LOBE_AT) / LOBE_WIDE) ** 2)
    share = np.where(heights < level_m, (heights - low) / (level_m - low), (high - heights) / (high - level_m))
    fullness = half_wave(np.clip(share, 0.0, 1.0))
    grid = fullness[:, None] * (everywhere + lobe * front)[None]
    fine = np.linspace(-np.pi, np.pi, 8 * STATIONS + 1)
    closed = np.array([CubicSpline(stations, np.r_[row[:-1], row[0]], bc_type="periodic")(fine) for row in grid])
    angle, outward = around(points_m, centre_m)
    inside = RegularGridInterpolator((heights, fine), closed, bounds_error=False, fill_value=0.0)
    return np.asarray(inside(np.column_stack([points_m[:, 1], angle]))[:, None] * outward)


def waist(points_m: Array, centre_m: Array, level_m: float, wide_m: float) -> Array:
    """Return (V, 3) the field of a waist: a section of four cubic Bézier arcs, fading up and down."""
    angle, outward = around(points_m, centre_m)
    profile = np.interp(angle, *_section(), period=2.0 * np.pi)
    return np.asarray((profile * bell(points_m[:, 1] - level_m, wide_m))[:, None] * outward)


def _section() -> tuple[Array, Array]:
    """Return angles and radii of the closed Bézier curve whose handles are front, sides and back."""
    front, side, back = HANDLES
    corners = [(0.0, front), (side, 0.0), (0.0, -back), (-side, 0.0)]
    share = np.linspace(0.0, 1.0, 24, endpoint=False)[:, None]
    arcs = []
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        one, two = np.array(start), np.array(end)
        first, second = one + ARC * two, two + ARC * one
        arcs.append(
            (1 - share) ** 3 * one + 3 * share * (1 - share) ** 2 * first + 3 * share**2 * (1 - share) * second
            + share**3 * two
        )  # fmt: skip
    curve = np.concatenate(arcs)
    order = np.argsort(np.arctan2(curve[:, 0], curve[:, 1]))
    return np.arctan2(curve[:, 0], curve[:, 1])[order], np.linalg.norm(curve, axis=1)[order]


def hips(points_m: Array, box_m: tuple[Array, Array], level: float) -> Array:
    """Return (V, 3) the field of the hips: a lattice whose middle layer grows, one metre at its corners.

    Parameters
    ----------
    points_m : (V, 3)
    box_m : (3,) and (3,)
        Lowest and highest corner of the lattice.
    level : float in 0..1
        Where between them the hips are widest.
    """
    low, high = box_m
    share = (points_m - low) / (high - low)
    inside = (share[:, 1] > 0.0) & (share[:, 1] < 1.0)
    warped = np.where(share[:, 1] < level, 0.5 * share[:, 1] / level, 1.0 - 0.5 * (1.0 - share[:, 1]) / (1.0 - level))
    u, w = (np.clip(share[:, axis], 0.0, 1.0) for axis in (0, 2))
    v = np.clip(warped, 0.0, 1.0)
    sides, behind, front = HIPS
    control = np.zeros((*LATTICE, 3))
    control[:, 1, :, 0] = np.linspace(-sides, sides, LATTICE[0])[:, None]
    control[:, 1, :, 2] = np.linspace(-behind, front, LATTICE[2])[None]
    weights = [_bernstein(LATTICE[axis] - 1, value) for axis, value in enumerate((u, v, w))]
    moved = np.einsum("ia,ja,ka,ijkc->ac", *weights, control, optimize=True)
    return np.asarray(2.0 * moved * (inside * np.sin(np.pi * v))[:, None])  # its slope ends at nothing too


def _bernstein(degree: int, share: Array) -> Array:
    """Return (degree + 1, V) Bernstein polynomials."""
    row = np.arange(degree + 1)
    choose = np.array([1.0, 2.0, 1.0]) if degree == 2 else np.array([1.0, 3.0, 3.0, 1.0])
    return np.asarray(choose[:, None] * share ** row[:, None] * (1.0 - share) ** (degree - row)[:, None])


def limb(points_m: Array, point_m: Array, axis: Array, wide_m: float) -> Array:
    """Return (V, 3) the field of a limb: outward from its axis, fading along it."""
    unit = axis / np.linalg.norm(axis)
    away = points_m - point_m
    along = away @ unit
    across = away - along[:, None] * unit
    outward = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-6)
    return np.asarray(bell(along, wide_m)[:, None] * outward)
