"""Normals of closed toes: the skin of five toes laid over a shoe's tip is full of slivers, whose own normals are noise.

What light shows of a shoe is its tip, not how skin came to cover it. Normals there are those of all surface a few
millimetres around, by area, so that slivers hardly count; bare toes keep their own. Both are told apart by how alike
normals are along the skin: on a shoe's tip most of it looks one way, on bare toes it does not.
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

Array = NDArray[np.float64]

#: How far around a vertex of a shoe's tip its normal is gathered, metres: half a toe's width.
REACH_M: Final = 0.010
#: How many edges far normals are gathered to tell closed toes from bare ones.
ROUNDS: Final = 10
#: Mean length of gathered unit normals at which toes are bare and at which they are closed. Fourteen clones in shoes
#: have .60 to .77, the bare generic human .48.
BARE, CLOSED = 0.52, 0.58
_TOES: Final = ("l_metatarsal", "r_metatarsal")
_CARRIED: Final = 0.5  # share of the toes' joint from which on skin is theirs
_AROUND: Final = 0.05  # and from which on it lies near them


@functools.cache
def _patch() -> tuple[NDArray[np.int64], NDArray[np.int64], csr_matrix, csr_matrix, NDArray[np.bool_]]:
    """Return the toes' vertices and those around, their triangles, who gathers what of both, and which are toes."""
    generic = load_generic()
    triangles = generic.triangles()[0]
    joints = [generic.joint(name) for name in _TOES]
    carried = np.where(np.isin(generic.skin_joints, joints), generic.skin_weights, 0.0).sum(axis=1)
    toes = np.flatnonzero(carried > _CARRIED)
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
    return rows, near, beside, around, np.isin(rows, toes)


def closed_toe_normals(vertices_m: Array, normals: Array) -> Array:
    """Return the generic human's (V, 3) unit normals with those of toes in shoes smooth, the others as given.

    Parameters
    ----------
    vertices_m, normals : (V, 3)
        Places in metres, and the normals of the surface itself.
    """
    rows, triangles, beside, around, toes = _patch()
    a, b, c = (vertices_m[triangles[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    gathered = around @ np.column_stack([face, np.linalg.norm(face, axis=1)])
    for _ in range(ROUNDS):
        gathered = beside @ gathered
    length = np.linalg.norm(gathered[:, :3], axis=1)
    alike = float((length / np.maximum(gathered[:, 3], 1e-12))[toes].mean())
    share = float(np.clip((alike - BARE) / (CLOSED - BARE), 0.0, 1.0))
    if share == 0.0:
        return normals
    own = rows[toes]
    middles, reached = cKDTree((a + b + c) / 3.0), cKDTree(vertices_m[own])
    pairs = reached.sparse_distance_matrix(middles, REACH_M, output_type="coo_matrix").tocsr()
    pairs.data = (1.0 - (pairs.data / REACH_M) ** 2) ** 2
    smooth = normals.copy()
    around_m2 = pairs @ face
    mixed = (1.0 - share) * normals[own] + share * _unit(around_m2, normals[own])
    smooth[own] = _unit(mixed, normals[own])
    return smooth


def _unit(vectors: Array, usual: Array) -> Array:
    """Return (N, 3) vectors made as long as one, the usual ones where they have no length."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.where(length > 1e-15, vectors / np.maximum(length, 1e-15), usual)
