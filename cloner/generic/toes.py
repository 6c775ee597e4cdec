"""Closed toes: smooth positions and normals for the skin of five toes inside a shoe's tip, which is full of slivers.

What one sees of a shoe is its tip, not how skin came to cover it. Places and normals there are those of all surface
a few millimetres around, by area, so that slivers hardly count; bare toes keep their own. Both are told apart by how
alike normals are along the skin: on a shoe's tip most of it looks one way, on bare toes it does not.
"""

from __future__ import annotations

import functools
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix, csr_matrix, diags
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.geometry.meshes.triangles import edges_of
from cloner.records.arrays import Array

#: How far around a vertex of a shoe's tip its normal is gathered, metres: half a toe's width.
REACH_M: Final = 0.010
#: How many edges far normals are gathered to tell closed toes from bare ones.
ROUNDS: Final = 10
#: Mean length of gathered unit normals at which toes are bare and at which they are closed. Fourteen clones in shoes
#: have .60 to .77, the bare generic human .48.
BARE, CLOSED = 0.52, 0.58
#: How far around a vertex the surface is gathered that it is laid on, metres, how often; and within what distance the
#: tip's shape at large is given back, which this rounds off, and how often. Tried on six clones in shoes and looked
#: at: 10 mm and three rounds leave scallops; given back never, once and three times a tip loses 6 to 11, .6 to 2.6 and
#: -.2 to 1.3 mm of its length.
LAID_M: Final = 0.012
LAID_ROUNDS: Final = 4
BACK_M: Final = 0.025
BACK_ROUNDS: Final = 3
_TOES: Final = ("l_metatarsal", "r_metatarsal")
_CARRIED: Final = 0.5  # share of the toes' joint from which on skin is theirs
_AROUND: Final = 0.05  # and from which on it lies near them


@functools.cache
def _patch() -> tuple[NDArray[np.int64], NDArray[np.int64], csr_matrix, csr_matrix, Array]:
    """Return the toes' vertices and those around, their triangles, who gathers what of both, and the toes' shares."""
    generic = load_generic()
    triangles = generic.triangles()[0]
    joints = [generic.joint(name) for name in _TOES]
    carried = np.where(np.isin(generic.skin_joints, joints), generic.skin_weights, 0.0).sum(axis=1)
    near = triangles[(carried > _AROUND)[triangles].any(axis=1)].astype(np.int64)
    rows, local = np.unique(near, return_inverse=True)
    local = local.reshape(-1, 3)
    count = len(rows)
    edges = edges_of(local)[0]
    own = np.arange(count)
    ends = np.concatenate([edges, edges[:, ::-1], np.column_stack([own, own])])
    beside = coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count)).tocsr()
    beside = (diags(1.0 / np.asarray(beside.sum(axis=1)).ravel()) @ beside).tocsr()
    faces = np.repeat(np.arange(len(local)), 3)
    around = coo_matrix((np.ones(len(faces)), (local.ravel(), faces)), shape=(count, len(local))).tocsr()
    return rows, near, beside, around, carried[rows]


def closed_toe_normals(vertices_m: Array, normals: Array) -> Array:
    """Return the generic human's (V, 3) unit normals with those of toes in shoes smooth, the others as given.

    Parameters
    ----------
    vertices_m, normals : (V, 3)
        Places in metres, and the normals of the surface itself.
    """
    rows, triangles, _, _, carried = _patch()
    share = _closed_share(vertices_m)
    if share == 0.0:
        return normals
    own = rows[carried > _CARRIED]
    middles, face = _faces(vertices_m[triangles])
    around_m2 = _kernel_weights(vertices_m[own], middles, REACH_M) @ face
    mixed = (1.0 - share) * normals[own] + share * _unit(around_m2, normals[own])
    smooth = normals.copy()
    smooth[own] = _unit(mixed, normals[own])
    return smooth


def smooth_shoe_tips(vertices_m: Array) -> Array:
    """Return the generic human's positions (V, 3), metres, with smooth tips of shoes; bare toes are unchanged.

    Every vertex is laid on the plane through the surface around it, a few times over; what the tip loses by that
    at large is given back, so that it stays as long as photos showed it. Nothing sinks below the soles.
    """
    rows, triangles, _, _, carried = _patch()
    share = _closed_share(vertices_m)
    if share == 0.0:
        return vertices_m
    moved = share * np.clip((carried - _AROUND) / (_CARRIED - _AROUND), 0.0, 1.0)
    own, moved = rows[moved > 0.0], moved[moved > 0.0, None]
    laid = vertices_m.copy()
    for _ in range(LAID_ROUNDS):
        middles, face = _faces(laid[triangles])
        pairs, area = _kernel_weights(laid[own], middles, LAID_M), np.linalg.norm(face, axis=1)
        normal = _unit(pairs @ face, np.zeros_like(laid[own]))
        seen = pairs @ np.column_stack([area[:, None] * middles, area])
        plane = seen[:, :3] / np.maximum(seen[:, 3:], 1e-15)
        laid[own] += moved * (normal * (plane - laid[own])).sum(axis=1, keepdims=True) * normal
    weight = np.bincount(triangles.ravel(), np.repeat(np.linalg.norm(face, axis=1), 3), len(laid))[own]
    pairs = _kernel_weights(laid[own], laid[own], BACK_M)
    for _ in range(BACK_ROUNDS):
        lost = pairs @ (weight[:, None] * (vertices_m[own] - laid[own])) / np.maximum(pairs @ weight, 1e-15)[:, None]
        laid[own] += moved * lost
    laid[own, 1] = np.maximum(laid[own, 1], vertices_m[own, 1].min())
    return laid


def _closed_share(vertices_m: Array) -> float:
    """Return how far toes are closed, from 0 (bare) to 1 (in shoes)."""
    _, triangles, beside, around, carried = _patch()
    face = _faces(vertices_m[triangles])[1]
    gathered = around @ np.column_stack([face, np.linalg.norm(face, axis=1)])
    for _ in range(ROUNDS):
        gathered = beside @ gathered
    length = np.linalg.norm(gathered[:, :3], axis=1)
    alike = float((length / np.maximum(gathered[:, 3], 1e-12))[carried > _CARRIED].mean())
    return float(np.clip((alike - BARE) / (CLOSED - BARE), 0.0, 1.0))


def _faces(corners_m: Array) -> tuple[Array, Array]:
    """Return the centres (T, 3) of triangles with corners (T, 3, 3), and normals of twice their areas' length."""
    a, b, c = corners_m[:, 0], corners_m[:, 1], corners_m[:, 2]
    return (a + b + c) / 3.0, np.cross(b - a, c - a)


def _kernel_weights(points_m: Array, others_m: Array, reach_m: float) -> csr_matrix:
    """Return weights (N, M) of other points, 1 at a point itself and 0 from ``reach_m`` on."""
    trees = cKDTree(points_m), cKDTree(others_m)
    apart = trees[0].sparse_distance_matrix(trees[1], reach_m, output_type="coo_matrix")
    apart.data = (1.0 - (apart.data / reach_m) ** 2) ** 2
    return apart.tocsr()


def _unit(vectors: Array, usual: Array) -> Array:
    """Return (N, 3) vectors made as long as one, the usual ones where they have no length."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.where(length > 1e-15, vectors / np.maximum(length, 1e-15), usual)
