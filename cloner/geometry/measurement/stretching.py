"""Stretching of a body's slices until their girths reach tape measures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import lsq_linear

from cloner.geometry.measurement.measures import girth_mm, slice_points
from cloner.records.arrays import Array

#: Least and greatest standard deviation of a stretched zone's bell, metres, and its share of the way to the next tape.
ZONE_M: Final = (0.020, 0.045)
ZONE_SHARE: Final = 0.45
#: Step of the numerical slopes; a slice grows by one percent.
STEP: Final = 0.01
#: Girths nearer than this to the tape are left, mm.
CLOSE_MM: Final = 1.0
#: Halvings of a step that went too far: a slice with a hollow grows slowly at first.
HALVINGS: Final = 6


@dataclass(frozen=True, slots=True, eq=False)
class Loop:
    """A girth with a tape measure that it must reach.

    Attributes
    ----------
    point_m, normal : (3,) float64
        The plane of the tape.
    triangles : (T, 3) int32
        Of the part it goes round.
    weight : (V,) float64
        How much of each vertex belongs to the part, 0..1.
    wanted_mm : float
    zone_m : float
        Standard deviation of the bell along the part, within which vertices move.
    """

    point_m: Array
    normal: Array
    triangles: NDArray[np.int32]
    weight: Array
    wanted_mm: float
    zone_m: float

    def girth_mm(self, vertices_m: Array) -> float:
        """Return the girth on a mesh, mm."""
        return girth_mm(vertices_m, self.triangles, self.point_m, self.normal)


def stretch_fields(vertices_m: Array, loop: Loop, frontal: Array) -> tuple[Array, Array, Array]:
    """Return three displacement fields (V, 3) around a loop, each of unit size: corners, depth, whole.

    Corners stand between the outlines that photos from front and side see, so they come first;
    depth is seen from the side only; last the whole slice grows.

    Parameters
    ----------
    vertices_m : (V, 3) model frame, metres
    loop : Loop
    frontal : (3,) the direction of depth
    """
    axis = loop.normal / np.linalg.norm(loop.normal)
    deep = frontal - (frontal @ axis) * axis
    deep = deep / np.linalg.norm(deep)
    wide = np.cross(axis, deep)
    ring = slice_points(vertices_m, loop.triangles, loop.point_m, loop.normal)
    away = vertices_m - loop.point_m
    along, u, v = away @ axis, away @ wide, away @ deep
    ring_u, ring_v = (ring - loop.point_m) @ wide, (ring - loop.point_m) @ deep
    u = u - (ring_u.min() + ring_u.max()) / 2.0
    v = v - (ring_v.min() + ring_v.max()) / 2.0
    near = loop.weight * np.exp(-0.5 * (along / loop.zone_m) ** 2)
    scaled = (u / max(np.ptp(ring_u), 1e-6), v / max(np.ptp(ring_v), 1e-6))
    corner = np.sin(2.0 * np.arctan2(*scaled)) ** 2
    across, depth = u[:, None] * wide, v[:, None] * deep
    return (near * corner)[:, None] * (across + depth), near[:, None] * depth, near[:, None] * (across + depth)


def grow_to_tapes(vertices_m: Array, loops: Sequence[Loop], directions: Sequence[Array], most: float) -> Array:
    """Return displacements (V, 3) that widen the slices of loops that are too small; no slice shrinks.

    Parameters
    ----------
    vertices_m : (V, 3)
    loops : sequence of Loop
        Neighbours are solved together: what one gains the other need not.
    directions : sequence of (V, 3)
        One field a loop.
    most : float
        Largest multiple of a field.
    """
    before = np.array([loop.girth_mm(vertices_m) for loop in loops])
    wanted = np.array([loop.wanted_mm for loop in loops])
    asked = [
        int(row) for row in np.flatnonzero(wanted - before > CLOSE_MM)
    ]  # a girth that is large enough is cloth and no matter here
    if not len(asked):
        return np.zeros_like(vertices_m)
    slopes = np.empty((len(asked), len(asked)))
    for column, row in enumerate(asked):
        moved = vertices_m + STEP * directions[row]
        slopes[:, column] = [(loops[other].girth_mm(moved) - before[other]) / STEP for other in asked]
    found = lsq_linear(slopes, (wanted - before)[asked], bounds=(0.0, most))
    step = np.tensordot(found.x, np.array([directions[row] for row in asked]), axes=1)
    return np.asarray(_largest_share(vertices_m, step, [loops[row] for row in asked]) * step)


def _largest_share(vertices_m: Array, step: Array, loops: Sequence[Loop]) -> float:
    """Return the largest share of a step, by bisection, that takes no loop beyond its tape measure."""

    def beyond(share: float) -> bool:
        moved = vertices_m + share * step
        return any(loop.girth_mm(moved) > loop.wanted_mm + CLOSE_MM for loop in loops)

    if not beyond(1.0):
        return 1.0
    low, high = 0.0, 1.0
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        low, high = (low, middle) if beyond(middle) else (middle, high)
    return low


def zone_width_m(away_m: Sequence[float]) -> float:
    """Return the width of a loop's zone, given the distances to its neighbours on the same part."""
    nearest = min((abs(away) for away in away_m), default=np.inf)
    return float(np.clip(ZONE_SHARE * nearest, *ZONE_M))
