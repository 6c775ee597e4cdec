"""A mesh as a graph: geodesic distances, averaging, smooth filling."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix, diags
from scipy.sparse.csgraph import dijkstra
from scipy.sparse.linalg import splu

from cloner.geometry.meshes.triangles import edges_of
from cloner.records.arrays import Array


@dataclass(frozen=True, slots=True, eq=False)
class SurfaceGraph:
    """Edges of a mesh with their lengths, as a symmetric sparse matrix (metres)."""

    lengths: csr_matrix

    def part(self, rows: NDArray[np.integer]) -> SurfaceGraph:
        """Return the graph of some vertices (N,) alone, in their order."""
        return SurfaceGraph(self.lengths[rows][:, rows])

    def distance_from(self, sources: NDArray[np.bool_], limit_m: float) -> Array:
        """Return each vertex's distance along edges to the nearest source, metres, at most ``limit_m``."""
        rows = np.flatnonzero(sources)
        if rows.size == 0:
            return np.full(sources.size, limit_m)
        distance = dijkstra(self.lengths, directed=False, indices=rows, min_only=True, limit=limit_m)
        return np.asarray(np.minimum(distance, limit_m), np.float64)

    def smooth(self, values: Array, rounds: int) -> Array:
        """Return values (V, ...) averaged with their neighbours ``rounds`` times."""
        link = (self.lengths > 0).astype(np.float64)
        degree = np.asarray(link.sum(axis=1)).ravel()
        mean = diags(0.5 / np.maximum(degree, 1.0)) @ link
        for _ in range(rounds):
            values = np.where((degree > 0).reshape(-1, *[1] * (values.ndim - 1)), 0.5 * values + mean @ values, values)
        return values

    def nearest(self, known: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Return the nearest known vertex (V,) along the surface; a vertex without any keeps its own index."""
        own = np.arange(known.size)
        rows = np.flatnonzero(known)
        if rows.size == 0:
            return own
        _, _, found = dijkstra(self.lengths, directed=False, indices=rows, min_only=True, return_predecessors=True)
        return np.asarray(np.where(found >= 0, found, own), np.int64)

    def fill(self, values: Array, weight: Array, stiffness: float, alike: Array | None = None) -> Array:
        """Return values (V, K) that follow ``values`` by ``weight`` and are harmonic elsewhere.

        Solves (W + s L) x = W c with the umbrella Laplacian L; a part without
        any weight gets the weighted mean of all.

        Parameters
        ----------
        values : (V, K)
        weight : (V,), 0 = unknown
        stiffness : float
            Weight s of one edge against one known vertex of weight 1.
        alike : (V, K), optional
            Edges count less, the more these values differ along them: borders stay borders.
        """
        link = (self.lengths > 0).astype(np.float64)
        if alike is not None:
            ends = link.tocoo()
            gap = np.abs(alike[ends.row] - alike[ends.col]).mean(axis=1)
            link = csr_matrix((1.0 / (1.0 + gap**2) ** 2, (ends.row, ends.col)), shape=link.shape)
        laplacian = diags(np.asarray(link.sum(axis=1)).ravel()) - link
        mean = (weight[:, None] * values).sum(0) / max(float(weight.sum()), 1e-12)
        anchor = 1e-6  # keeps parts without data solvable; far below any real weight
        system = (diags(weight + anchor) + stiffness * laplacian).tocsc()
        right = weight[:, None] * values + anchor * mean
        symmetric = splu(system, permc_spec="MMD_AT_PLUS_A", panel_size=4, options={"SymmetricMode": True})
        return np.asarray(symmetric.solve(right))


def surface_graph(vertices_m: Array, triangles: NDArray[np.int32]) -> SurfaceGraph:
    """Return the graph of a triangle mesh's edges."""
    ends = edges_of(triangles)[0]
    ends = ends[ends[:, 0] != ends[:, 1]]
    length = np.maximum(np.linalg.norm(vertices_m[ends[:, 0]] - vertices_m[ends[:, 1]], axis=1), 1e-6)
    count = len(vertices_m)
    half = csr_matrix((length, (ends[:, 0], ends[:, 1])), shape=(count, count))
    return SurfaceGraph((half + half.T).tocsr())
