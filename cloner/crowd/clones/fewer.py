"""Simplification of shells by edge collapse (quadric errors) on their own vertices.

References
----------
Garland and Heckbert 1997 (quadric errors); half-edge collapses keep original vertices. Mohr and Gleicher 2003: errors
are summed over poses, or a skirt loses what is flat at rest and spread by a stride. Hair has hundreds of charts in
its texture: a triangle that would lie in two of them costs as if it had moved by a centimetre.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from cloner.geometry.meshes.triangles import edges_of, triangle_sides
from cloner.geometry.outlines.silhouette import triangle_normals
from cloner.records.arrays import Array

Whole = NDArray[np.int64]

#: An open edge that moves counts as so many of its own squares of surface.
BORDER: Final = 1.0
TORN_M: Final = 0.01  # tried: 3 mm, 10 mm and never; at 128 px SSIM .979, .981, .966 on long curls
LEAST_COSINE: Final = 0.2  # no triangle turns farther; as others' simplifiers
_AT_ONCE: Final = 12  # a twelfth of the triangles a round: quadrics are brought up to date between rounds
_TRIED: Final = 6  # so many collapses are looked at for each that is wanted


@dataclass(slots=True)
class _Mesh:
    places: Array  # (K, P, 3): of every pose, the first one at rest
    faces: Whole  # (T, 3) places
    charts: Whole  # (T,)
    held: Whole  # sorted: place times count plus chart of every vertex
    count: int  # of charts
    quadrics: Array  # (K, P, 4, 4)


def simplify(places: Array, weld: Whole, triangles: NDArray[np.int32], most: int) -> NDArray[np.int32]:
    """Return at most ``most`` triangles (T, 3) that use the given triangles' vertices.

    Parameters
    ----------
    places : (K, P, 3) float64, metres
        In K poses, the first one at rest.
    weld : (V,) int64
        Place of each vertex.
    triangles : (T, 3) int32
    most : int
    """
    links = np.concatenate([triangles[:, :2], triangles[:, 1:]])
    graph = coo_matrix((np.ones(len(links)), links.T), shape=(len(weld), len(weld)))
    count, own = connected_components(graph, directed=False)
    own = own.astype(np.int64)
    faces, charts = weld[triangles].astype(np.int64), own[triangles[:, 0]]
    solid = _merge_opposite(faces)
    faces, charts = faces[solid], charts[solid]
    held = np.unique(weld * count + own)
    mesh = _Mesh(places, faces, charts, held, int(count), np.stack([_quadrics(one, faces) for one in places]))
    tried, cosine = _TRIED, LEAST_COSINE
    while len(mesh.faces) > most:
        if _collapse_round(mesh, most, tried, cosine):
            continue
        if tried == _TRIED:  # tear charts if it must be
            tried = len(mesh.faces)
        elif cosine > -1.0:  # fold too
            cosine = -2.0
        else:  # pieces that cannot be made fewer are cut off
            break
    return _vertices(mesh, weld, own)[:most]


def _merge_opposite(faces: Whole) -> NDArray[np.bool_]:
    a, b, c = faces.T
    return np.asarray((a != b) & (b != c) & (c != a))


def _planes(normals: Array, points: Array, weights: Array) -> Array:
    plane = np.column_stack([normals, -np.einsum("ij,ij->i", normals, points)])
    return np.asarray(weights[:, None, None] * plane[:, :, None] * plane[:, None, :])


def _quadrics(places: Array, faces: Whole) -> Array:
    """Return (P, 4, 4) quadrics: squared distances to the planes of a point's triangles and through its open edges."""
    normals = triangle_normals(places, faces)
    area = np.linalg.norm(normals, axis=1)
    normals /= np.maximum(area, 1e-20)[:, None]
    out = np.zeros((len(places), 4, 4))
    surface = _planes(normals, places[faces[:, 0]], area / 2.0)
    for k in range(3):
        np.add.at(out, faces[:, k], surface)
    edges = triangle_sides(faces)
    _, back, times = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True, return_counts=True)
    open_ = np.flatnonzero(times[back.reshape(-1)] == 1)
    along = places[edges[open_, 1]] - places[edges[open_, 0]]
    across = np.cross(along, np.tile(normals, (3, 1))[open_])
    across /= np.maximum(np.linalg.norm(across, axis=1), 1e-20)[:, None]
    walls = _planes(across, places[edges[open_, 0]], BORDER * np.einsum("ij,ij->i", along, along))
    for k in range(2):
        np.add.at(out, edges[open_, k], walls)
    return out


def _collapse_round(mesh: _Mesh, most: int, tried: int, cosine: float) -> int:
    """Collapse the cheapest pairs that do not touch one another; return their number."""
    places, faces = mesh.places[0], mesh.faces
    edges, _ = edges_of(faces)
    ways = np.concatenate([edges, edges[:, ::-1]])  # the first goes to the second
    cost = np.zeros(len(ways))
    for own, quadrics in zip(mesh.places, mesh.quadrics, strict=True):
        to = np.column_stack([own[ways[:, 1]], np.ones(len(ways))])
        cost += np.einsum("ni,nij,nj->n", to, quadrics[ways[:, 0]] + quadrics[ways[:, 1]], to) / len(mesh.places)
    cost += 1e-9 * np.linalg.norm(places[ways[:, 0]] - places[ways[:, 1]], axis=1)
    wanted = max(min((len(faces) - most) // 2, len(faces) // _AT_ONCE), 1)
    order = np.argsort(cost, kind="stable")[: wanted * tried]
    limit = cost[order[-1]] if tried == _TRIED else np.inf
    corner = np.argsort(faces.reshape(-1), kind="stable")
    starts = np.searchsorted(faces.reshape(-1)[corner], np.arange(len(places) + 1))
    around = corner // 3
    refused = _refused(mesh, ways[order], starts, around, cosine, limit - cost[order])
    taken, goes, done = np.zeros(len(places), bool), np.arange(len(places)), 0
    for u, v in ways[order[~refused]].tolist():
        ring = faces[around[starts[u] : starts[u + 1]]].reshape(-1)
        if taken[v] or taken[ring].any():
            continue
        goes[u] = v
        taken[ring] = taken[faces[around[starts[v] : starts[v + 1]]].reshape(-1)] = True
        mesh.quadrics[:, v] += mesh.quadrics[:, u]
        done += 1
        if done == wanted:
            break
    mesh.faces = goes[faces]
    solid = _merge_opposite(mesh.faces)
    mesh.faces, mesh.charts = mesh.faces[solid], mesh.charts[solid]
    return done


def _refused(mesh: _Mesh, ways: Whole, starts: Whole, around: Whole, cosine: float, most: Array) -> NDArray[np.bool_]:
    """Return which collapses (N, 2) flip or degenerate a triangle, or tear charts at more than their cost.

    A triangle is torn that gets a corner at a place where its chart has none. Collapses of one round touch no triangle
    of one another, so all are judged as they lie.
    """
    places, (leaves, stays) = mesh.places[0], ways.T
    many = starts[leaves + 1] - starts[leaves]
    which = np.repeat(np.arange(len(ways)), many)
    own = around[np.arange(len(which)) + np.repeat(starts[leaves] - np.cumsum(many) + many, many)]
    kept = ~(mesh.faces[own] == stays[which, None]).any(axis=1)
    own, which = own[kept], which[kept]
    faces = mesh.faces[own]
    before = triangle_normals(places, faces)
    after = triangle_normals(places, np.where(faces == leaves[which, None], stays[which, None], faces))
    was, becomes = np.linalg.norm(before, axis=1), np.linalg.norm(after, axis=1)
    turned = np.einsum("ij,ij->i", before, after) < cosine * was * becomes - 1e-18
    codes = stays[which] * mesh.count + mesh.charts[own]
    torn = mesh.held[np.minimum(np.searchsorted(mesh.held, codes), len(mesh.held) - 1)] != codes
    cost = np.bincount(which, was * torn, len(ways)) / 2.0 * TORN_M**2
    return np.asarray((np.bincount(which, turned, len(ways)) > 0) | (cost > most))


def _vertices(mesh: _Mesh, weld: Whole, own: Whole) -> NDArray[np.int32]:
    """Return a vertex for every corner: its point's in the triangle's chart, any of the point's if there is none."""
    codes = weld * mesh.count + own
    order = np.argsort(codes, kind="stable")
    wanted = mesh.faces * mesh.count + mesh.charts[:, None]
    at = np.minimum(np.searchsorted(codes[order], wanted), len(order) - 1)
    found = order[at]
    missing = codes[found] != wanted
    first = np.argsort(weld, kind="stable")
    starts = np.searchsorted(weld[first], np.arange(mesh.places.shape[1]))
    found[missing] = first[starts[mesh.faces[missing]]]
    return found.astype(np.int32)
