"""Triangulation of pattern pieces: a hexagonal grid inside, matching points along seams."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay, cKDTree

from cloner.cloth.drafting.pattern import Pattern, Segment, evenly_spaced, length_m
from cloner.geometry.meshes.triangles import paired_edges
from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: Inner points stay this share of the grid's step away from the edges: no slivers.
CLEAR: Final = 0.55


@dataclass(frozen=True, slots=True, eq=False)
class Cloth:
    """Sewn pieces as one triangle mesh.

    Attributes
    ----------
    flat_m : (W, 2) float64
        Places in the plane of each piece's points, before seams are merged; warp along y.
    triangles : (T, 3) int64, into the W points
    vertex : (W,) int64
        The vertex that each point is after sewing: seams are one.
    segment : (W,) int64
        Number of the piece.
    edges : mapping of str to int64 array
        Points along each "segment.edge".
    """

    flat_m: Array
    triangles: Ints
    vertex: Ints
    segment: Ints
    edges: Mapping[str, Ints]

    @property
    def faces(self) -> Ints:
        """The triangles by sewn vertices, (T, 3)."""
        return np.asarray(self.vertex[self.triangles])

    @property
    def count(self) -> int:
        """Number of sewn vertices."""
        return int(self.vertex.max()) + 1

    def seam_means(self, points_m: Array) -> Array:
        """Return the (N, 3) sewn vertices of points (W, 3): the means of those that become one."""
        counts = np.bincount(self.vertex, minlength=self.count)
        return np.stack([np.bincount(self.vertex, points_m[:, k]) / counts for k in range(3)], axis=1)


@dataclass(frozen=True, slots=True, eq=False)
class BendingHinges:
    """Inner edges with their opposite points in the plane; across a seam two pieces are placed side by side.

    Attributes
    ----------
    edges, tips : (I, 2) int64
        Vertices at the ends of every edge, and opposite it.
    triangles : (I, 2) int64
    heights_m, feet_m, lengths_m : (2, I) float64
        How far each tip lies off the edge, and along it from its first end; the edge's length in both pieces.
    weft : (2, I) float64
        How much of the edge's normal lies along the weft, squared.
    """

    edges: Ints
    tips: Ints
    triangles: Ints
    heights_m: Array
    feet_m: Array
    lengths_m: Array
    weft: Array


def hinges_of(cloth: Cloth) -> BendingHinges:
    """Return the inner edges of sewn pieces."""
    edges, triangles, tips = paired_edges(cloth.faces)
    sides = []
    for side in (0, 1):
        corners = cloth.triangles[triangles[:, side]]
        ours, rows = cloth.vertex[corners], np.arange(len(corners))
        start, end, tip = (
            cloth.flat_m[corners[rows, (ours == vertex[:, None]).argmax(axis=1)]]
            for vertex in (edges[:, 0], edges[:, 1], tips[:, side])
        )
        length = np.linalg.norm(end - start, axis=1)
        line, away = (end - start) / length[:, None], tip - start
        height = np.abs(line[:, 0] * away[:, 1] - line[:, 1] * away[:, 0])
        sides.append((height, (away * line).sum(axis=1), length, line[:, 1] ** 2))
    return BendingHinges(edges, np.asarray(tips, dtype=np.int64), triangles, *np.stack(sides, axis=1))


def triangulate(pattern: Pattern, step_m: float) -> Cloth:
    """Return a garment's pieces as triangles of about one size, sewn."""
    counts = {
        f"{segment.name}.{name}": max(2, round(length_m(edge) / step_m))
        for segment in pattern.segments
        for name, edge in segment.edges.items()
    }
    for one, other in pattern.seams:
        counts[one] = counts[other] = max(counts[one], counts[other])
    flats: list[Array] = []
    triangles: list[Ints] = []
    owners: list[Ints] = []
    edges: dict[str, Ints] = {}
    first = 0
    for number, segment in enumerate(pattern.segments):
        flat, faces, own = _mesh(segment, counts, step_m)
        edges |= {place: first + rows for place, rows in own.items()}
        flats.append(flat)
        triangles.append(first + faces)
        owners.append(np.full(len(flat), number, dtype=np.int64))
        first += len(flat)
    sewn = _merged_numbers(first, [(edges[one], edges[other][::-1]) for one, other in pattern.seams])
    return Cloth(np.concatenate(flats), np.concatenate(triangles), sewn, np.concatenate(owners), edges)


def _merged_numbers(count: int, pairs: list[tuple[Ints, Ints]]) -> Ints:
    """Return (count,) vertex numbers after merging the points of seams."""
    lowest = np.arange(count)
    while True:
        before = lowest.copy()
        for one, other in pairs:
            least = np.minimum(lowest[one], lowest[other])
            lowest[one] = lowest[other] = least
        if np.array_equal(before, lowest):
            break
    return np.unique(lowest, return_inverse=True)[1].ravel()


def _mesh(segment: Segment, counts: Mapping[str, int], step_m: float) -> tuple[Array, Ints, dict[str, Ints]]:
    """Return points (N, 2), triangles and the rows of every edge of one piece."""
    border, rows, start = [], {}, 0
    for name, edge in segment.edges.items():
        place = f"{segment.name}.{name}"
        border.append(evenly_spaced(edge, counts[place])[:-1])
        rows[place] = np.arange(start, start + counts[place] + 1)
        start += counts[place]
    outline = np.concatenate(border)
    rows = {place: own % start for place, own in rows.items()}
    low, high = outline.min(axis=0), outline.max(axis=0)
    tall = step_m * np.sqrt(3.0) / 2.0
    lines = np.arange(low[1], high[1], tall)
    columns = [np.arange(low[0] + 0.5 * step_m * (row % 2), high[0], step_m) for row in range(len(lines))]
    grid = np.concatenate([np.column_stack([x, np.full(len(x), y)]) for x, y in zip(columns, lines, strict=True)])
    away, _ = cKDTree(_dense_outline(outline)).query(grid)
    inner = grid[_inside(grid, outline) & (away > CLEAR * step_m)]
    points = np.concatenate([outline, inner])
    faces = Delaunay(points).simplices.astype(np.int64)
    middle = points[faces].mean(axis=1)
    faces = faces[_inside(middle, outline)]
    corner = points[faces]
    one, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    area = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    faces[area < 0.0] = faces[area < 0.0][:, ::-1]
    return points, faces[np.abs(area) > 1e-4 * step_m**2], rows


def _dense_outline(outline: Array) -> Array:
    """Return a closed outline with a point every fifth of a step."""
    following = np.roll(outline, -1, axis=0)
    shares = np.linspace(0.0, 1.0, 5, endpoint=False)[:, None, None]
    return np.asarray((outline + shares * (following - outline)).reshape(-1, 2))


def _inside(points: Array, outline: Array) -> NDArray[np.bool_]:
    """Return which points lie inside a closed polygon (even-odd rule)."""
    first, second = outline, np.roll(outline, -1, axis=0)
    inside = np.zeros(len(points), dtype=bool)
    for start, end in zip(first, second, strict=True):
        if start[1] == end[1]:
            continue
        spans = (start[1] > points[:, 1]) != (end[1] > points[:, 1])
        at = start[0] + (points[:, 1] - start[1]) / (end[1] - start[1]) * (end[0] - start[0])
        inside ^= spans & (points[:, 0] < at)
    return inside
