"""Points on triangle meshes: ray hits from a camera, nearest points, barycentric coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.records.arrays import Array

Indices = NDArray[np.integer]

#: Pairs of pixel and triangle tested at once; keeps memory near 100 MiB.
CHUNK = 2_000_000
#: Triangles of less than this are flat: twice their area, in the unit of their corners squared.
FLAT = 1e-14


@dataclass(frozen=True, slots=True, eq=False)
class SurfacePoints:
    """Points on a mesh by barycentric coordinates.

    Attributes
    ----------
    corners : (N, 3) int32
        Vertex indices.
    weights : (N, 3) float64
        Barycentric, rows sum to one.
    """

    corners: NDArray[np.int32]
    weights: Array

    def at(self, vertices: Array) -> Array:
        """Return the (N, 3) positions on (V, 3) vertices, or (N, 3) values of any vertex field."""
        return np.asarray(np.einsum("nk,nka->na", self.weights, vertices[self.corners]))

    def take(self, rows: Indices | NDArray[np.bool_]) -> SurfacePoints:
        """Return some of the points."""
        return SurfacePoints(self.corners[rows], self.weights[rows])


def overlaps_triangles(points: Array, corners: Array) -> tuple[NDArray[np.bool_], Array, Array]:
    """Return which points (N, 2) lie inside which triangles, (N, T), and their weights on second and third corner.

    Parameters
    ----------
    points : (N, 2)
    corners : (T, 3, 2) of the triangles, in the points' unit; those without area have nothing over them
    """
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    area = np.where(np.abs(area) < FLAT, np.nan, area)
    away = points[:, None] - corners[None, :, 0]
    u = (away[..., 0] * second[:, 1] - away[..., 1] * second[:, 0]) / area
    v = (first[:, 0] * away[..., 1] - first[:, 1] * away[..., 0]) / area
    return np.asarray((u >= 0.0) & (v >= 0.0) & (u + v <= 1.0)), u, v


def first_hits(
    points_px: Array, projected_px: Array, depth_m: Array, triangles: Indices
) -> tuple[NDArray[np.int64], Array]:
    """Return the nearest triangle under each pixel, and the barycentric coordinates in the picture.

    Parameters
    ----------
    points_px : (N, 2) photo px
    projected_px : (V, 2) photo px
    depth_m : (V,) camera depth, metres
    triangles : (T, 3)

    Returns
    -------
    triangle : (N,) int64, -1 where no triangle lies under the pixel
    weights : (N, 3) barycentric in the picture (affine approximation inside one triangle)
    """
    corners = projected_px[triangles]
    found = np.full(len(points_px), -1, dtype=np.int64)
    weights = np.zeros((len(points_px), 3))
    step = max(1, CHUNK // max(1, len(triangles)))
    for start in range(0, len(points_px), step):
        inside, u, v = overlaps_triangles(points_px[start : start + step], corners)
        row, column = np.nonzero(inside)
        place = np.stack([1.0 - u[row, column] - v[row, column], u[row, column], v[row, column]], axis=1)
        depth = (place * depth_m[triangles[column]]).sum(axis=1)
        order = np.lexsort((depth, row))
        first = order[np.unique(row[order], return_index=True)[1]]
        found[start + row[first]] = column[first]
        weights[start + row[first]] = place[first]
    return found, weights


def nearest_points(queries_m: Array, vertices_m: Array, triangles: Indices, *, candidates: int = 16) -> SurfacePoints:
    """Return the nearest surface points on triangles, among those with the nearest centroids.

    Parameters
    ----------
    queries_m : (N, 3) metres
    candidates : int
        Triangles tried for each query; enough where triangles are of like size.
    """
    corners = vertices_m[triangles]
    count = min(candidates, len(triangles))
    _, tried = cKDTree(corners.mean(axis=1)).query(queries_m, k=count)
    tried = tried.reshape(len(queries_m), count)
    place = closest_in_triangles(np.repeat(queries_m, count, axis=0), corners[tried.ravel()])
    points = np.einsum("nk,nka->na", place, corners[tried.ravel()]).reshape(len(queries_m), count, 3)
    best = np.linalg.norm(points - queries_m[:, None], axis=2).argmin(axis=1)
    rows = np.arange(len(queries_m))
    chosen = triangles[tried[rows, best]].astype(np.int32)
    return SurfacePoints(chosen, place.reshape(len(queries_m), count, 3)[rows, best])


def closest_in_triangles(points: Array, corners: Array) -> Array:
    """Return barycentric weights (N, 3) of the points in N triangles (N, 3, 3) nearest to N points."""
    edge1, edge2, delta = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], points - corners[:, 0]
    g11, g12, g22 = (edge1**2).sum(1), (edge1 * edge2).sum(1), (edge2**2).sum(1)
    r1, r2 = (edge1 * delta).sum(1), (edge2 * delta).sum(1)
    determinant = np.maximum(g11 * g22 - g12**2, 1e-30)
    u, v = (g22 * r1 - g12 * r2) / determinant, (g11 * r2 - g12 * r1) / determinant
    best = np.stack([1.0 - u - v, u, v], axis=1)
    outside = (best < 0.0).any(axis=1)
    distance = np.where(outside, np.inf, 0.0)
    for first, second in ((0, 1), (1, 2), (2, 0)):
        start, along = corners[:, first], corners[:, second] - corners[:, first]
        share = np.clip(((points - start) * along).sum(1) / np.maximum((along**2).sum(1), 1e-30), 0.0, 1.0)
        away = np.linalg.norm(points - start - share[:, None] * along, axis=1)
        nearer = outside & (away < distance)
        distance = np.where(nearer, away, distance)
        edge = np.zeros_like(best)
        edge[:, first], edge[:, second] = 1.0 - share, share
        best[nearer] = edge[nearer]
    return best
