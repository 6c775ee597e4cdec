"""Heads modelled like clay: sphere, egg, regions pushed and pulled, half a head, mirrored.

The source's order of work (terracotta soldiers): scale a sphere to an egg; select regions as triangles and lift or move
them; split in half to work on one half; push nose, jaws and eyes back and forth; apply the reversed scaling on X for
the other half, and merge both. Every tool is a function from clay to clay.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.exporters.shared.obj_files import wrapped
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array, freeze
from cloner.records.meshes import Mesh

Index = NDArray[np.int32]

#: Nearer to the middle than this is the middle, share of the clay's width.
MIDDLE: Final = 1e-6
#: Rings and sectors of a sphere: a vertex every 5 mm on a head.
RINGS, SECTORS = 72, 96
#: Width, height and depth of an egg against its sphere's; 10 cm make a head 14 cm wide, 22 high and 19 deep, as is the
#: generic human's without its nose.
EGG: Final = (0.75, 1.1, 0.98)
#: An egg is narrower below: by this share of its width at the chin.
NARROWER: Final = 0.22


@dataclass(frozen=True, slots=True, eq=False)
class Clay:
    """A lump: (V, 3) vertices, metres, Y up, facing +Z, and (T, 3) triangles, outside counter-clockwise."""

    vertices_m: Array
    triangles: Index

    def __post_init__(self) -> None:
        freeze(self, vertices_m=(np.float64, (None, 3)), triangles=(np.int32, (None, 3)))


def sphere(radius_m: float, rings: int = RINGS, sectors: int = SECTORS) -> Clay:
    """Return a ball about the origin with poles above and below; a meridian runs down its front and one down its back.

    Raises
    ------
    ClonerError
        If it has no size, too few rings, or sectors that cannot be halved.
    """
    if not (np.isfinite(radius_m) and radius_m > 0.0 and rings >= 3 and sectors >= 4 and sectors % 2 == 0):
        hint = "Give a radius, 3 rings or more and an even number of sectors from 4 on"
        raise ClonerError("this is no sphere", hint, "sphere")
    down = np.pi * np.arange(1, rings) / rings
    turn = 2.0 * np.pi * np.arange(sectors) / sectors
    ring = np.stack([np.sin(turn), np.zeros(sectors), np.cos(turn)], axis=1)
    ring[[0, sectors // 2], 0] = 0.0  # exactly in the middle
    points = np.sin(down)[:, None, None] * ring + np.cos(down)[:, None, None] * np.array([0.0, 1.0, 0.0])
    vertices = np.concatenate([[[0.0, 1.0, 0.0]], points.reshape(-1, 3), [[0.0, -1.0, 0.0]]])
    here = 1 + np.arange(sectors)
    beside = 1 + (np.arange(sectors) + 1) % sectors
    rows = [np.stack([np.zeros(sectors, int), here, beside], axis=1)]
    for number in range(rings - 2):
        a, b = here + number * sectors, beside + number * sectors
        c, d = a + sectors, b + sectors
        rows += [np.stack([a, c, b], axis=1), np.stack([b, c, d], axis=1)]
    last = (rings - 2) * sectors
    rows.append(np.stack([here + last, np.full(sectors, len(vertices) - 1), beside + last], axis=1))
    return Clay(radius_m * vertices, np.concatenate(rows).astype(np.int32))


def egg(clay: Clay, scale: tuple[float, float, float] = EGG, narrower: float = NARROWER) -> Clay:
    """Return clay scaled along X, Y, Z and narrower below by a share."""
    low, high = clay.vertices_m[:, 1].min(), clay.vertices_m[:, 1].max()
    share = (clay.vertices_m[:, 1] - low) / (high - low)
    scaled = clay.vertices_m * scale
    scaled[:, [0, 2]] *= (1.0 - narrower * (1.0 - share) ** 2)[:, None]
    return Clay(scaled, clay.triangles)


def region(clay: Clay, place_m: Array, reach_m: float) -> Array:
    """Return the weight (V,) of each vertex in the region around the skin nearest to a point: 1 there, 0 at the radius.

    Distances go along the surface, so that a chin's region leaves the neck behind it alone; the fall is smooth.
    """
    nearest = np.zeros(len(clay.vertices_m), bool)
    nearest[np.argmin(np.linalg.norm(clay.vertices_m - np.asarray(place_m), axis=1))] = True
    away = surface_graph(clay.vertices_m, clay.triangles).distance_from(nearest, reach_m) / reach_m
    return np.asarray((1.0 - np.clip(away, 0.0, 1.0) ** 2) ** 2)


def moved(clay: Clay, share: Array, by_m: Array) -> Clay:
    """Return clay whose region (V,) went by (3,) metres."""
    return _shifted(clay, share[:, None] * np.asarray(by_m, np.float64))


def lifted(clay: Clay, share: Array, by_m: float) -> Clay:
    """Return clay whose region (V,) was lifted along its normals, pressed in where ``by_m`` is below 0."""
    return _shifted(clay, by_m * share[:, None] * vertex_normals(clay.vertices_m, clay.triangles))


def smoothed(clay: Clay, share: Array, rounds: int = 3) -> Clay:
    """Return clay whose region (V,) was stroked smooth."""
    even = surface_graph(clay.vertices_m, clay.triangles).smooth(clay.vertices_m, rounds)
    return _shifted(clay, share[:, None] * (even - clay.vertices_m))


def halved(clay: Clay) -> Clay:
    """Return the left half (X from 0 on) of clay that has edges all down its middle.

    Raises
    ------
    ClonerError
        If a triangle lies across the middle.
    """
    middle = _in_middle(clay)
    side = np.where(middle, 0, np.sign(clay.vertices_m[:, 0])).astype(int)[clay.triangles]
    if ((side > 0).any(axis=1) & (side < 0).any(axis=1)).any():
        raise ClonerError("the clay has no edge down its middle", "Begin with a sphere", "halved")
    kept = (side >= 0).all(axis=1) & (side > 0).any(axis=1)
    rows = np.unique(clay.triangles[kept])
    number = np.zeros(len(clay.vertices_m), np.int32)
    number[rows] = np.arange(len(rows))
    vertices = clay.vertices_m[rows].copy()
    vertices[middle[rows], 0] = 0.0
    return Clay(vertices, number[clay.triangles[kept]])


def mirrored(half: Clay) -> Clay:
    """Return a half and its mirror image as one: reversed scaling on X, both merged down the middle.

    Raises
    ------
    ClonerError
        If the half reaches across the middle, or its cut does not lie in it.
    """
    rim = _rim(half)
    middle = np.abs(half.vertices_m[:, 0]) <= MIDDLE * max(float(np.ptp(half.vertices_m[:, 0])), 1e-12)
    if (half.vertices_m[~middle, 0] < 0.0).any() or not middle[rim].all() or not rim.any():
        hint = "Halve a whole lump first, and push nothing across the middle"
        raise ClonerError("this is no half that ends in the middle", hint, "mirrored")
    merged = middle & rim  # what else touches the middle stays apart from its twin
    other = np.where(merged, np.arange(len(middle)), 0).astype(np.int64)
    other[~merged] = len(middle) + np.arange(int((~merged).sum()))
    twins = half.vertices_m[~merged] * (-1.0, 1.0, 1.0)
    both = np.concatenate([half.triangles, other[half.triangles][:, ::-1]])
    return Clay(np.concatenate([half.vertices_m, twins]), both.astype(np.int32))


def mesh_of_clay(clay: Clay) -> Mesh:
    """Return clay with a texture wrapped round it, for `cloner.statues.photo_fit`."""
    return Mesh(clay.vertices_m, clay.triangles, *wrapped(clay.vertices_m, clay.triangles))


def _shifted(clay: Clay, by_m: Array) -> Clay:
    """Return clay moved by (V, 3); the cut of a half stays in the middle."""
    out = clay.vertices_m + by_m
    out[_in_middle(clay) & _rim(clay), 0] = 0.0
    return Clay(out, clay.triangles)


def _in_middle(clay: Clay) -> NDArray[np.bool_]:
    return np.asarray(np.abs(clay.vertices_m[:, 0]) <= MIDDLE * float(np.ptp(clay.vertices_m[:, 0])))


def _rim(clay: Clay) -> NDArray[np.bool_]:
    """Return (V,) which vertices lie on edges of one triangle alone."""
    edges = np.sort(np.concatenate([clay.triangles[:, [0, 1]], clay.triangles[:, [1, 2]], clay.triangles[:, [2, 0]]]))
    each, count = np.unique(edges, axis=0, return_counts=True)
    found = np.zeros(len(clay.vertices_m), bool)
    found[each[count == 1]] = True
    return found
