"""Local bends of a skin: smooth bumps of limited radius, solved together.

A bump is 1 at its place and falls to 0, with slope and curvature, on an ellipsoid around it. What is near in space but
far along the skin - the arm beside a flank, the other thigh - is left out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls
from scipy.sparse import csr_matrix

from cloner.easing import smoothstep
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.geometry.meshes.triangles import areas, paired_edges
from cloner.records.arrays import Array

Ints = NDArray[np.int64]

#: The way along a round limb to its other side is pi / 2 times the distance through it; what is farther around is
#: another part. The slack lets folds pass, and over the fade the bump goes to zero, metres.
ROUND, SLACK_M, FADE_M = 1.6, 0.03, 0.05


@dataclass(frozen=True, slots=True, eq=False)
class EdgePoint:
    """A point on an edge of a mesh: ``(1 - share) * first + share * second``."""

    first: int
    second: int
    share: float

    def at(self, values: Array) -> Array:
        """Return the value of a (V, ...) vertex field at the point."""
        return np.asarray((1.0 - self.share) * values[self.first] + self.share * values[self.second])


@dataclass(frozen=True, slots=True, eq=False)
class SkinMetric:
    """Topology and edge lengths of a skin; made once for the generic human.

    Attributes
    ----------
    triangles : (T, 3) int
    edges : (E, 2) int64
        Edges between two triangles.
    beside : (E, 2) int64
        Those two triangles.
    graph : SurfaceGraph
        Edges, and links over every edge to the corner opposite: paths that follow edges alone are up to 40 % too long.
    area_m2 : (T,)
    """

    triangles: NDArray[np.integer]
    edges: Ints
    beside: Ints
    graph: SurfaceGraph
    area_m2: Array


def skin_metric(vertices_m: Array, triangles: NDArray[np.integer]) -> SkinMetric:
    """Return the metric of a triangle mesh.

    Parameters
    ----------
    vertices_m : (V, 3) rest pose, metres
    triangles : (T, 3), closed surface; vertices outside it are linked to nothing
    """
    edges, beside, opposite = paired_edges(triangles)
    count = len(vertices_m)
    over = np.sort(opposite, axis=1)
    pairs = np.unique(np.concatenate([edges, over[over[:, 0] != over[:, 1]]]), axis=0)
    length = np.maximum(np.linalg.norm(vertices_m[pairs[:, 0]] - vertices_m[pairs[:, 1]], axis=1), 1e-6)
    half = csr_matrix((length, (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    return SkinMetric(triangles, edges, beside, SurfaceGraph((half + half.T).tocsr()), areas(vertices_m, triangles))


def bump(vertices_m: Array, along_m: Array, place: EdgePoint, axes: Array, reach_m: Array) -> tuple[Ints, Array]:
    """Return the vertices within the radius of a point, and the bump's height there: 1 at the point.

    ``(1 - s²)³`` with s = 1 on the ellipsoid of reaches.

    Parameters
    ----------
    vertices_m : (V, 3) rest pose, metres
    along_m : (V,) distances from the place along the skin, metres
    place : Place
    axes : (3, 3) orthonormal rows
    reach_m : (3,) where the bump ends along each axis, metres
    """
    offset = vertices_m - place.at(vertices_m)
    squared = (((offset @ axes.T) / reach_m) ** 2).sum(axis=1)
    inside = np.flatnonzero(squared < 1.0)
    around = along_m[inside] - ROUND * np.linalg.norm(offset[inside], axis=1) - SLACK_M
    height = (1.0 - squared[inside]) ** 3 * (1.0 - smoothstep(around, 0.0, FADE_M))
    kept = height > 0.0
    return inside[kept], height[kept]


def least_norm_step(matrix: Array, wanted: Array, at_most: NDArray[np.bool_], damping: float) -> Array:
    """Return the smallest x with ``matrix @ x = wanted``, or ``<= wanted`` where that is enough.

    Parameters
    ----------
    matrix : (K, N)
    wanted : (K,)
    at_most : (K,) bool
    damping : float
        Above 0; relative to the matrix's longest row. What contradicts is then met in between.

    References
    ----------
    Lawson and Hanson 1974, "Solving least squares problems", ch. 23 (least distance programming by its dual).
    """
    both = ~at_most
    rows, limits = np.vstack([matrix, -matrix[both]]), np.concatenate([wanted, -wanted[both]])
    product = rows @ rows.T
    product += damping**2 * float(np.diag(product).max()) * np.eye(len(rows))
    lower = np.linalg.cholesky(product)
    multipliers, _ = nnls(lower.T, -np.linalg.solve(lower, limits))
    return np.asarray(-rows.T @ multipliers)
