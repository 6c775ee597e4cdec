"""Stretch a body's slices until a tape laid round them reads what it read on the person."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import lsq_linear

from cloner.geometry.measures import girth_mm, slice_points

Array = NDArray[np.float64]

#: Half-height of a stretched zone, metres: neighbouring levels stay smooth and apart.
ZONE_M: Final = 0.045
#: Step of the numerical slopes; a slice grows by one percent.
STEP: Final = 0.01
#: Girths nearer than this to the tape are left, mm.
CLOSE_MM: Final = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Loop:
    """A girth that must not be smaller than a tape read.

    Attributes
    ----------
    point_m, normal : (3,) float64
        The plane of the tape.
    triangles : (T, 3) int32
        Of the part it goes round.
    weight : (V,) float64
        How much of each vertex belongs to the part, 0..1.
    wanted_mm : float
    """

    point_m: Array
    normal: Array
    triangles: NDArray[np.int32]
    weight: Array
    wanted_mm: float

    def girth_mm(self, vertices_m: Array) -> float:
        """Return what the tape reads on a mesh."""
        return girth_mm(vertices_m, self.triangles, self.point_m, self.normal)


def fields(vertices_m: Array, loop: Loop, frontal: Array) -> tuple[Array, Array, Array]:
    """Return three displacement fields (V, 3) round a loop, each one unit: corners, depth, whole.

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
    near = loop.weight * np.exp(-0.5 * (along / ZONE_M) ** 2)
    scaled = (u / max(np.ptp(ring_u), 1e-6), v / max(np.ptp(ring_v), 1e-6))
    corner = np.sin(2.0 * np.arctan2(*scaled)) ** 2
    across, depth = u[:, None] * wide, v[:, None] * deep
    return (near * corner)[:, None] * (across + depth), near[:, None] * depth, near[:, None] * (across + depth)


def grown(vertices_m: Array, loops: Sequence[Loop], directions: Sequence[Array], most: Sequence[float]) -> Array:
    """Return (V, 3) displacements that widen the slices of loops that are too small; no slice shrinks.

    Parameters
    ----------
    vertices_m : (V, 3)
    loops : sequence of Loop
        Neighbours are solved together: what one gains the other need not.
    directions : sequence of (V, 3)
        One field a loop.
    most : sequence of float
        Largest multiple of each field.
    """
    deficit = np.array([loop.wanted_mm - loop.girth_mm(vertices_m) for loop in loops])
    if deficit.max() < CLOSE_MM:
        return np.zeros_like(vertices_m)
    slopes = np.empty((len(loops), len(loops)))
    for column, field in enumerate(directions):
        moved = vertices_m + STEP * field
        slopes[:, column] = [(loop.girth_mm(moved) - loop.girth_mm(vertices_m)) / STEP for loop in loops]
    asked = np.flatnonzero(deficit > 0.0)  # a girth that is large enough is cloth and no matter here
    bounds = (np.zeros(len(loops)), np.maximum(most, 1e-6))
    found = lsq_linear(slopes[asked], deficit[asked], bounds=bounds)
    return np.asarray(np.tensordot(found.x, np.array(directions), axes=1))
