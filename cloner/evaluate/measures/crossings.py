"""Intersections of a mesh with itself or with another one: depth, and visible triangles.

References
----------
Segments against triangles by the signs of volumes: Segura & Feito 2001, "Algorithms to test ray-triangle
intersection".
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.geometry.meshes.rasters import fragments
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array, freeze
from cloner.records.views import Camera

Index = NDArray[np.integer]

#: Triangles are looked up in classes of size, each half of the one before, so that a large one finds few candidates.
_CLASSES: Final = 8
#: A buried vertex is looked at so far before its skin, metres: clear of rounding, less than a crease is wide.
_BEFORE_M: Final = 1e-4
#: Columns: two directions across the ray, and the ray's own.
_RAY: Final = np.linalg.qr(np.array([[0.31, 0.77, -0.53], [-0.42, 0.59, 0.64], [0.85, 0.11, 0.29]]))[0]
#: Skin stands before a vertex if it lies no farther aside, metres: the length of a large triangle's side.
_BESIDE_M: Final = 0.02
#: How many vertices around a buried one may be the skin it went through.
_AROUND: Final = 400


@dataclass(frozen=True, slots=True, eq=False)
class Intersections:
    """Pairs of intersecting triangles.

    Attributes
    ----------
    pairs : (P, 2) int64
        Rows of the first and the second set of triangles.
    places_m : (P, 3) float64
        One point of every cut, in the middle of what the triangles' sides cut.
    """

    pairs: NDArray[np.int64]
    places_m: Array

    def __post_init__(self) -> None:
        freeze(self, pairs=(np.int64, (None, 2)), places_m=(np.float64, (len(self.pairs), 3)))


def self_intersections(points_m: Array, triangles: Index) -> Intersections:
    """Return the pairs of a mesh's triangles that intersect, without neighbours that share a vertex.

    Parameters
    ----------
    points_m : (V, 3) metres
    triangles : (T, 3) int
        Indices of vertices; seams are welded before.
    """
    corners = points_m[triangles]
    pairs = _pairs_with_touching_boxes(corners)
    first, second = triangles[pairs[:, 0]], triangles[pairs[:, 1]]
    apart = (first[:, :, None] != second[:, None, :]).all(axis=(1, 2))
    return _intersecting_pairs(corners, pairs[apart])


def intersections_between(first_m: Array, second_m: Array) -> Intersections:
    """Return the intersecting pairs of two sets of triangle corners (T, 3, 3) and (U, 3, 3), metres."""
    corners = np.concatenate([first_m, second_m])
    pairs = np.sort(_pairs_with_touching_boxes(corners), axis=1)
    found = _intersecting_pairs(corners, pairs[(pairs[:, 0] < len(first_m)) & (pairs[:, 1] >= len(first_m))])
    return Intersections(found.pairs - np.array([0, len(first_m)], dtype=np.int64), found.places_m)


def _pairs_with_touching_boxes(corners: Array) -> NDArray[np.int64]:
    """Return (P, 2) pairs of triangles (T, 3, 3) whose boxes touch, each once."""
    low, high = corners.min(axis=1), corners.max(axis=1)
    centre, reach = (low + high) / 2.0, np.linalg.norm(high - low, axis=1) / 2.0
    ends = reach.max(initial=0.0) * 0.5 ** np.arange(_CLASSES)
    size = (reach[:, None] < ends[None, 1:]).sum(axis=1)
    found = []
    for number, end in enumerate(ends):
        own, smaller = np.flatnonzero(size == number), np.flatnonzero(size > number)
        if not own.size:
            continue
        tree = cKDTree(centre[own])
        found.append(own[tree.query_pairs(2.0 * end, output_type="ndarray")])
        if smaller.size:
            near = cKDTree(centre[smaller]).sparse_distance_matrix(tree, 1.5 * end, output_type="coo_matrix")
            found.append(np.column_stack([own[near.col], smaller[near.row]]))
    pairs = np.concatenate([np.zeros((0, 2), np.int64), *found]).astype(np.int64)
    one, other = pairs.T
    touching = (low[one] <= high[other]).all(axis=1) & (low[other] <= high[one]).all(axis=1)
    return np.asarray(pairs[touching], dtype=np.int64)


def _volumes(a: Array, b: Array, c: Array, d: Array) -> Array:
    """Return (N,) six times the signed volumes of tetrahedra."""
    return np.asarray(np.einsum("na,na->n", np.cross(b - a, c - a), d - a))


def _sides(planes: Array, corners: Array) -> Array:
    """Return (N, 3) on which side of triangles' planes (N, 3, 3) the corners (N, 3, 3) of others lie."""
    a, b, c = np.moveaxis(planes, 1, 0)
    return np.stack([_volumes(a, b, c, corners[:, k]) for k in range(3)], axis=1)


def _intersecting_pairs(corners: Array, pairs: NDArray[np.int64]) -> Intersections:
    """Return those of some pairs of triangles that really cut each other."""
    sides = [_sides(corners[pairs[:, one]], corners[pairs[:, 1 - one]]) for one in (0, 1)]
    cut = np.all([(side.min(axis=1) < 0.0) & (side.max(axis=1) > 0.0) for side in sides], axis=0)
    pairs = pairs[cut]
    total, count = np.zeros((len(pairs), 3)), np.zeros(len(pairs))
    for one in (0, 1):  # the triangle that is pierced
        a, b, c = np.moveaxis(corners[pairs[:, one]], 1, 0)
        for k in range(3):
            p, q = corners[pairs[:, 1 - one], k], corners[pairs[:, 1 - one], (k + 1) % 3]
            before, behind = sides[one][cut][:, k], sides[one][cut][:, (k + 1) % 3]
            around = np.stack([_volumes(p, q, a, b), _volumes(p, q, b, c), _volumes(p, q, c, a)])
            pierced = (before * behind < 0.0) & ((around > 0.0).all(axis=0) | (around < 0.0).all(axis=0))
            share = np.where(pierced, before / np.where(pierced, before - behind, 1.0), 0.0)
            total += np.where(pierced[:, None], p + share[:, None] * (q - p), 0.0)
            count += pierced
    real = count > 0
    return Intersections(pairs[real], total[real] / count[real, None])


def winding_numbers(places_m: Array, corners_m: Array) -> NDArray[np.int64]:
    """Return the winding number (N,) of a closed mesh's triangles (T, 3, 3) around points (N, 3): 1 inside.

    Counts the triangles that a ray leaves through, less those it enters through. The ray's direction is none that
    sides of a mesh keep to.
    """
    flat, height = corners_m @ _RAY[:, :2], corners_m @ _RAY[:, 2]
    centre = flat.mean(axis=1)
    reach = float(np.linalg.norm(flat - centre[:, None], axis=2).max(initial=0.0))
    near = cKDTree(centre).query_ball_point(places_m @ _RAY[:, :2], reach)
    place = np.repeat(np.arange(len(places_m)), [len(rows) for rows in near])
    triangle = np.concatenate([np.zeros(0, np.int64), *map(np.asarray, near)]).astype(np.int64)
    sides = flat[triangle] - (places_m @ _RAY[:, :2])[place, None]
    after = np.roll(sides, -1, axis=1)
    shares = np.roll(sides[..., 0] * after[..., 1] - sides[..., 1] * after[..., 0], -1, axis=1)
    hit = (shares > 0.0).all(axis=1) | (shares < 0.0).all(axis=1)
    total = shares[hit].sum(axis=1)
    above = np.einsum("hk,hk->h", shares[hit], height[triangle[hit]]) / total > (places_m @ _RAY[:, 2])[place[hit]]
    ways = np.where(above, np.sign(total), 0.0)
    return np.asarray(np.bincount(place[hit], ways, minlength=len(places_m)), dtype=np.int64)


def buried_depths(points_m: Array, triangles: Index, crossings: Intersections) -> Array:
    """Return (V,) how deep vertices lie inside another part of their own closed mesh, metres, zero where they do not.

    The parts are found from the crossings inwards. Depth is the way out: to the nearest skin that faces the vertex from
    behind, or to the nearest vertex that is not buried.
    """
    normals = vertex_normals(points_m, np.asarray(triangles, dtype=np.int32))
    buried = _flood_fill(points_m, triangles, normals, np.unique(triangles[crossings.pairs.ravel()]))
    depths = np.zeros(len(points_m))
    if buried.size:
        away, rows = cKDTree(points_m).query(points_m[buried], k=min(_AROUND, len(points_m)))
        way = np.einsum("nka,nka->nk", points_m[rows] - points_m[buried, None], normals[rows])
        facing = np.einsum("nka,na->nk", normals[rows], normals[buried]) < 0.0
        before = facing & (way > 0.0) & (away**2 - way**2 < _BESIDE_M**2)
        nearest = np.where(before, way, np.inf).min(axis=1)
        free = np.setdiff1d(np.unique(triangles), buried)
        depths[buried] = np.minimum(nearest, cKDTree(points_m[free]).query(points_m[buried])[0])
    return depths


def _flood_fill(points_m: Array, triangles: Index, normals: Array, start: Index) -> NDArray[np.int64]:
    """Return the vertices reached over neighbours from some vertices while the mesh's inside lies before their skin."""
    corners, known = points_m[triangles], np.zeros(len(points_m), dtype=np.bool_)
    ahead, buried = np.asarray(start, dtype=np.int64), np.zeros(0, dtype=np.int64)
    while ahead.size:
        known[ahead] = True
        inside = winding_numbers(points_m[ahead] + _BEFORE_M * normals[ahead], corners) > 0
        buried = np.concatenate([buried, ahead[inside]])
        beside = np.isin(triangles, ahead[inside]).any(axis=1)
        around = np.unique(triangles[beside])
        ahead = around[~known[around]].astype(np.int64)
    return buried


def visible_triangles(
    points_m: Array, triangles: Index, camera: Camera
) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
    """Return the index (H, W) of the nearest triangle at each pixel, -1 where none is, and its depth, metres."""
    picture, depth = camera.project(points_m), camera.to_camera(points_m)[:, 2]
    width, height = camera.width_px, camera.height_px
    empty = np.iinfo(np.int64).max
    nearest = np.full(width * height, empty, dtype=np.int64)
    faces = np.asarray(triangles, dtype=np.int32)
    for pixel, triangle, weights in fragments(picture, faces, width, height):
        away = np.einsum("nk,nk->n", depth[faces[triangle]], weights).astype(np.float32)
        # positive floats keep their order as integers: depth above, row below, one minimum for both
        np.minimum.at(nearest, pixel, (away.view(np.int32).astype(np.int64) << 32) | triangle)
    rows = np.where(nearest == empty, -1, nearest & 0xFFFFFFFF)
    away = np.where(nearest == empty, 0, nearest >> 32).astype(np.int32).view(np.float32)
    return rows.reshape(height, width), np.where(rows < 0, np.inf, away).astype(np.float32).reshape(height, width)
