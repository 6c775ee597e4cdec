"""Grids of the generic human's lids and lips: closed rings of quads around each opening."""

from __future__ import annotations

import functools
import itertools
from collections import defaultdict
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.eyeballs import CORNEA, Eyeball
from cloner.records.arrays import Array, freeze

Indices = NDArray[np.int32]

#: Two vertices that follow each other outwards in the middle of an opening's upper edge; hm08's own numbers.
_EYE_START = {"left": (13352, 6785), "right": (6756, 1)}
_MOUTH_START = (474, 468)
#: Rings inside and outside the opening's margin, and columns of the corners, counted along the ring.
_EYE_RINGS, _MOUTH_RINGS = (3, 9), (3, 7)
_REACH_M = 0.1  # three times as far from an opening's middle as its rings reach


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """Skin around an opening, between two corners.

    Attributes
    ----------
    rings : (K, N) int32
        Vertices; row ``margin`` is the opening's margin, rows before it lie behind it, rows after it outside.
    margin : int
    corners : (2,) int32
        Columns of the corners, the one nearer to +X first.
    upper : (N,) bool
        Columns of the upper lid or lip, without the corners.
    """

    rings: Indices
    margin: int
    corners: Indices
    upper: NDArray[np.bool_]

    def __post_init__(self) -> None:
        freeze(self, rings=(np.int32, (None, None)), corners=(np.int32, (2,)), upper=(np.bool_, (self.rings.shape[1],)))

    @property
    def lower(self) -> NDArray[np.bool_]:
        """Return the columns of the lower lid or lip, without the corners."""
        own = ~self.upper
        own[self.corners] = False
        return own

    def ring(self, outwards: int) -> Indices:
        """Return the vertices (N,) of the ring that many steps outside the margin, or inside it when negative."""
        return np.asarray(self.rings[self.margin + outwards], dtype=np.int32)


@dataclass(frozen=True, slots=True, eq=False)
class Lashes:
    """One eye's lashes.

    Attributes
    ----------
    vertices : (L,) int32
    column : (L,) int32
        Column of the lids that each grows from.
    upper : (L,) bool
        Whether it is one of the upper lid's.
    """

    vertices: Indices
    column: Indices
    upper: NDArray[np.bool_]

    def __post_init__(self) -> None:
        count = len(self.vertices)
        freeze(self, vertices=(np.int32, (None,)), column=(np.int32, (count,)), upper=(np.bool_, (count,)))


class _Quads:
    """Neighbours in the body's quads around a vertex."""

    def __init__(self, generic: GenericHuman, middle: int) -> None:
        near = np.linalg.norm(generic.vertices_m - generic.vertices_m[middle], axis=1) < _REACH_M
        own = (generic.quad_part == generic.part_names.index("body")) & near[generic.quads].all(axis=1)
        self.quads = [tuple(q) for q in generic.quads[own].tolist()]
        self.of_vertex: dict[int, list[int]] = defaultdict(list)
        self.near: dict[int, set[int]] = defaultdict(set)
        for row, quad in enumerate(self.quads):
            for a, b in zip(quad, quad[1:] + quad[:1], strict=True):
                self.of_vertex[a].append(row)
                self.near[a].add(b)
                self.near[b].add(a)

    def across(self, vertex: int, before: int) -> int:
        """Return the neighbour straight ahead behind a vertex."""
        beside = {v for row in self.of_vertex[vertex] if before in self.quads[row] for v in self.quads[row]}
        (ahead,) = self.near[vertex] - beside
        return ahead

    def loop(self, start: int, second: int) -> list[int]:
        """Return the closed ring straight ahead from two vertices."""
        out = [start, second]
        while (ahead := self.across(out[-1], out[-2])) != start:
            out.append(ahead)
        return out

    def beside(self, ring: list[int], first: int) -> list[int]:
        """Return the ring beside a ring, given its first vertex."""
        out = [first]
        for a, b in itertools.pairwise(ring):
            (row,) = (row for row in self.of_vertex[a] if b in self.quads[row] and out[-1] in self.quads[row])
            (ahead,) = set(self.quads[row]) - {a, b, out[-1]}
            out.append(ahead)
        return out


def _rings(quads: _Quads, start: tuple[int, int], counts: tuple[int, int]) -> Indices:
    """Return (inside + 1 + outside, N) rings; ``start`` holds a vertex of the margin and the one outside it."""
    middle, outer = start
    inner = quads.across(middle, outer)
    along = min(quads.near[middle] - {outer, inner})
    margin = quads.loop(middle, along)
    rows = {0: margin}
    for step, first, count in ((-1, inner, counts[0]), (1, outer, counts[1])):
        before, place = middle, first
        for number in range(1, count + 1):
            rows[step * number] = quads.beside(rows[step * (number - 1)], place)
            if number < count:
                before, place = place, quads.across(place, before)
    return np.array([rows[number] for number in sorted(rows)], dtype=np.int32)


def _grid(generic: GenericHuman, start: tuple[int, int], counts: tuple[int, int]) -> Grid:
    rings = _rings(_Quads(generic, start[0]), start, counts)
    margin = generic.vertices_m[rings[counts[0]]].astype(np.float64)
    corners = np.array([margin[:, 0].argmax(), margin[:, 0].argmin()])
    # between the corners, on the side of the start, which lies on the upper edge
    columns = np.arange(rings.shape[1])
    between = (columns > corners.min()) & (columns < corners.max())
    upper = between if between[0] else ~between
    upper[corners] = False
    return Grid(rings, counts[0], corners, upper)


@functools.cache
def eye_grid(side: str) -> Grid:
    """Return the lids of the "left" or "right" eye of the shipped generic human."""
    return _grid(load_generic(), _EYE_START[side], _EYE_RINGS)


@functools.cache
def mouth_grid() -> Grid:
    """Return the lips of the shipped generic human; the margin is the edge where closed lips begin to touch."""
    return _grid(load_generic(), _MOUTH_START, _MOUTH_RINGS)


@functools.cache
def lashes(side: str) -> Lashes:
    """Return the lashes of the "left" or "right" eye; each lid's are one strip of their own."""
    generic, grid = load_generic(), eye_grid(side)
    vertices = generic.part(f"lashes_{side}")
    part = generic.part_names.index(f"lashes_{side}")
    edges = generic.quads[generic.quad_part == part][:, [[0, 1], [1, 2], [2, 3]]].reshape(-1, 2)
    count = len(generic.vertices_m)
    links = csr_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(count, count))
    strip = connected_components(links, directed=False)[1][vertices]
    places = generic.vertices_m.astype(np.float64)
    upper = strip == max(np.unique(strip), key=lambda one: places[vertices[strip == one], 1].mean())
    column = np.zeros(len(vertices), dtype=np.int32)
    for own, lid in ((upper, grid.upper), (~upper, grid.lower)):
        allowed = np.flatnonzero(lid)
        roots = places[np.concatenate([grid.ring(0)[allowed], grid.ring(1)[allowed]])]
        column[own] = allowed[cKDTree(roots).query(places[vertices[own]])[1] % len(allowed)]
    return Lashes(vertices.astype(np.int32), column, upper)


def eyeball(vertices_m: NDArray[np.float64], side: str) -> Eyeball:
    """Return the "left" or "right" eyeball of a person with vertices (V, 3), from its two poles."""
    front, back = vertices_m[load_generic().part(f"eye_{side}")[[0, -1]]].astype(np.float64)
    return Eyeball((front + (1.0 + CORNEA) * back) / (2.0 + CORNEA))


def lip_gaps_m(grid: Grid, points: Array) -> Array:
    """Return the gap (N,) between the lips at every column's position, metres; negative where they cross.

    It is measured upright, as seen from the front, between the lowest line of the upper lip and the highest of the
    lower; zero at the corners.

    Parameters
    ----------
    grid : Grid
        `mouth_grid`.
    points : (K, N, 3) metres
        The grid's vertices in any shape of the face.
    """
    touching = points[grid.margin - 1 : grid.margin + 2]
    aside = points[grid.margin, :, 0]
    lines = []
    for lip, pick in ((grid.upper, np.min), (grid.lower, np.max)):
        own = lip.copy()
        own[grid.corners] = True
        columns = np.flatnonzero(own)[np.argsort(aside[own])]
        lines.append(np.interp(aside, aside[columns], pick(touching[:, columns, 1], axis=0)))
    gap = lines[0] - lines[1]
    gap[grid.corners] = 0.0
    return np.asarray(gap)
