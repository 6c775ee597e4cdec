"""Meshes split along UV seams, with normals that stay smooth across them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array, freeze

Index = NDArray[np.int32]


@dataclass(frozen=True, slots=True, eq=False)
class Wedges:
    """Vertices duplicated where one position has several texture coordinates.

    Attributes
    ----------
    vertex : (W,) int32
        Mesh vertex of every wedge.
    uv : (W,) int32
        Row of the UV table of every wedge.
    triangles : (T, 3) int32
        Wedge indices, in the order of the faces given.
    """

    vertex: Index
    uv: Index
    triangles: Index

    def __post_init__(self) -> None:
        freeze(self, vertex=(np.int32, (None,)), uv=(np.int32, (len(self.vertex),)), triangles=(np.int32, (None, 3)))


def triangulate(quads: Index) -> tuple[Index, Index]:
    """Return the (T, 3) triangles of (Q, 4) quads and the (T, 3) quad corners they use.

    Corners (0, 1, 2) and (0, 2, 3) of every quad, in quad order, so that two
    tables of the same quads (vertices and UVs) stay in step. Quads that repeat
    a corner give one triangle only.

    Returns
    -------
    triangles : (T, 3) int32, vertex indices
    corners : (T, 2) -> (T, 3) int32, flat indices ``4 * quad + corner``
    """
    corners = (4 * np.arange(len(quads), dtype=np.int32))[:, None, None] + np.array([[0, 1, 2], [0, 2, 3]], np.int32)
    corners = corners.reshape(-1, 3)
    triangles = quads.reshape(-1)[corners].astype(np.int32)
    a, b, c = triangles.T
    keep = (a != b) & (b != c) & (c != a)
    return triangles[keep], corners[keep]


def split_seams(triangles: Index, uv_triangles: Index) -> Wedges:
    """Return the wedges of a mesh whose faces index positions and UVs separately.

    Parameters
    ----------
    triangles, uv_triangles : (T, 3) int
        The same corners, once as vertex and once as UV rows.
    """
    span = int(uv_triangles.max(initial=0)) + 1
    key = triangles.astype(np.int64) * span + uv_triangles
    unique, inverse = np.unique(key.reshape(-1), return_inverse=True)
    return Wedges(unique // span, unique % span, inverse.reshape(-1, 3))


def welded_normals(vertices_m: Array, triangles: Index) -> Array:
    """Return unit normals (V, 3), equal for coincident vertices so that chart seams do not show."""
    _, place = np.unique(np.round(vertices_m, 7), axis=0, return_inverse=True)
    place = place.reshape(-1).astype(np.int32)
    points = np.zeros((int(place.max(initial=-1)) + 1, 3))
    points[place] = vertices_m
    return vertex_normals(points, np.asarray(place[triangles], dtype=np.int32))[place]


def vertex_normals(vertices_m: Array, triangles: Index) -> Array:
    """Return (V, 3) unit normals, weighted by the corners' angles.

    Angle weights make the normal independent of how a quad is cut in two.
    Vertices without a face, or whose faces cancel, get +Y.

    References
    ----------
    Thuermer & Wuethrich 1998, Computing vertex normals from polygonal facets.
    """
    a, b, c = (vertices_m[triangles[:, k]] for k in range(3))
    ab, bc, ca = b - a, c - b, a - c
    (x, y, z), (u, v, w) = ab.T, ca.T
    face = np.stack([w * y - v * z, u * z - w * x, v * x - u * y], axis=1)
    face *= -1.0
    twice_area = np.sqrt(np.einsum("ij,ij->i", face, face))
    face /= np.maximum(twice_area, 1e-20)[:, None]
    between = [-np.einsum("ij,ij->i", ahead, behind) for ahead, behind in ((ab, ca), (bc, ab), (ca, bc))]
    # the cross product of two sides is as long at all three corners
    angle = np.arctan2(twice_area[:, None], np.stack(between, axis=1))
    corners, count = triangles.ravel(), len(vertices_m)
    total = np.stack(
        [np.bincount(corners, (angle * face[:, axis, None]).ravel(), minlength=count) for axis in range(3)], axis=1
    )
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.where(length > 1e-9, total / np.maximum(length, 1e-9), [0.0, 1.0, 0.0])
