"""Cloth that does not pass through itself: vertices keep apart unless they are neighbours in the cloth.

No vertex gets through a triangle, and no edge through another, whose corners all stay farther off than a triangle's
corners lie from its middle (.58 of an edge) and half the crossed diagonals of two edges (.71). Nothing is remembered,
so what starts free stays free, and what was entangled by the body comes apart at its ends.

References
----------
R. Bridson, R. Fedkiw, J. Anderson, Robust Treatment of Collisions, Contact and Friction for Cloth Animation, SIGGRAPH
2002 (repulsion before collisions); M. Müller, Ten Minute Physics 15, Self-collisions solved, 2022.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: How far apart vertices stay, of the mean edge at both. At .6, .7, .8 and .9 a circle skirt crosses itself in 48, 0, 0
#: and 0 triangles of the median frame, a long skirt in 21, 10, 0, 0, a cape in 21, 0, 0, 0, trousers in 5, 3, 0, 0.
APART: Final = 0.9
#: Vertices farther off than this are not looked at until pairs are searched again, metres: layers that meet faster than
#: 1.2 m/s can pass. Nor are those whose speeds bring them no nearer than ``SURE_M``.
REACH_M: Final = 0.02
SURE_M: Final = 0.004
#: Farthest that one pair is moved apart in one small step, of its spacing: what was sewn too near unfolds step by step,
#: and what is pushed faster flies (with .2 and small steps half as long a skirt passed through itself).
AT_ONCE: Final = 0.1


@dataclass(frozen=True, slots=True, eq=False)
class Spacing:
    """How far a cloth's vertices stay apart.

    Attributes
    ----------
    radius_m : (N,) float64
        Two vertices stay the sum of theirs apart.
    neighbours : (K,) int64
        Sorted keys, lower row times N plus the higher one, of pairs with an edge, whose threads hold them.
    """

    radius_m: Array
    neighbours: Ints


@dataclass(frozen=True, slots=True, eq=False)
class Pairs:
    """Vertices (P,) and (P,) that may meet soon, and how far apart they stay (P,), metres."""

    one: Ints
    other: Ints
    apart_m: Array


def spacing_of(edges: Ints, rest_m: Array, across: Ints, across_m: Array, count: int) -> Spacing:
    """Return the spacing of a cloth with edges (E, 2) of rest lengths (E,); ``across`` (I, 2) lie over an edge.

    What lies nearer in the plane of its piece than cloth keeps apart is neighbours as well.
    """
    ends = edges.T.ravel()
    each = np.bincount(ends, np.tile(rest_m, 2), count) / np.maximum(np.bincount(ends, minlength=count), 1)
    radius = APART / 2.0 * each
    near = across[across_m < radius[across].sum(axis=1)]
    pairs = np.sort(np.concatenate([edges, near]), axis=1)
    return Spacing(radius, np.unique(pairs[:, 0] * count + pairs[:, 1]))


def pairs_of(spacing: Spacing, places_m: Array, speeds_m_s: Array, seconds: float) -> Pairs:
    """Return the vertices that may meet within so many seconds."""
    count = len(places_m)
    one, other = cKDTree(places_m).query_pairs(2.0 * float(spacing.radius_m.max()) + REACH_M, output_type="ndarray").T
    apart = spacing.radius_m[one] + spacing.radius_m[other]
    away, faster = places_m[other] - places_m[one], speeds_m_s[other] - speeds_m_s[one]
    gap, speed = (np.sqrt(np.einsum("ij,ij->i", each, each)) for each in (away, faster))
    soon = np.flatnonzero(gap - apart < seconds * speed + SURE_M)
    keys = one[soon] * count + other[soon]
    at = np.searchsorted(spacing.neighbours, keys).clip(max=len(spacing.neighbours) - 1)
    soon = soon[spacing.neighbours[at] != keys]
    return Pairs(one[soon], other[soon], apart[soon])


def keep_apart(pairs: Pairs, places: Array, free: Array) -> None:
    """Move vertices that are too near apart, in place; ``free`` (N,) is one over each one's mass, 0 for held ones."""
    away = places[pairs.other] - places[pairs.one]
    length2 = np.einsum("ij,ij->i", away, away)
    rows = np.flatnonzero(length2 < pairs.apart_m**2)
    if not len(rows):
        return
    one, other, away = pairs.one[rows], pairs.other[rows], away[rows]
    length = np.maximum(np.sqrt(length2[rows]), 1e-9)
    first, second = free[one], free[other]
    far = np.minimum(pairs.apart_m[rows] - length, AT_ONCE * pairs.apart_m[rows])
    weight = far / length / np.maximum(first + second, 1e-12)
    both = np.concatenate([one, other])
    moves = np.concatenate([-(weight * first)[:, None] * away, (weight * second)[:, None] * away])
    for axis in range(3):
        places[:, axis] += np.bincount(both, moves[:, axis], len(places))
