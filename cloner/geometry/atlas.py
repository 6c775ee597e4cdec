"""The texture atlas: which triangle, and where in it, every texel shows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.geometry.rasters import fragments

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class AtlasMap:
    """Texels of all charts, in the order of their triangles.

    Attributes
    ----------
    size : int
        Side of the square atlas, texels.
    triangles : (T, 3) int32
        Vertex indices of the triangles.
    texel : (N,) int32
        ``row * size + column`` of every covered texel, each once.
    triangle : (N,) int32
        The triangle that covers it.
    barycentric : (N, 3) float32
    """

    size: int
    triangles: NDArray[np.int32]
    texel: NDArray[np.int32]
    triangle: NDArray[np.int32]
    barycentric: NDArray[np.float32]

    def interpolate(self, values: NDArray[np.floating], rows: NDArray[np.integer] | None = None) -> NDArray[np.float32]:
        """Return per-vertex ``values`` (V,) or (V, K) at the texels ``rows`` (all when None), float32."""
        triangle = self.triangle if rows is None else self.triangle[rows]
        weights = self.barycentric if rows is None else self.barycentric[rows]
        # Gather by triangle first: one index array a texel instead of three.
        corners = np.ascontiguousarray(values, dtype=np.float32)[self.triangles]
        result = corners[triangle, 0].T * weights[:, 0]
        result += corners[triangle, 1].T * weights[:, 1]
        result += corners[triangle, 2].T * weights[:, 2]
        return np.ascontiguousarray(result.T)

    def rows_of(self, triangles: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Return the rows of the texels whose triangle is marked in (T,) ``triangles``."""
        return np.flatnonzero(triangles[self.triangle])

    def covered(self) -> NDArray[np.bool_]:
        """Return (size, size) bool, True inside charts."""
        inside = np.zeros(self.size * self.size, dtype=bool)
        inside[self.texel] = True
        return inside.reshape(self.size, self.size)


def map_atlas(
    uv: NDArray[np.floating], uv_triangles: NDArray[np.int32], triangles: NDArray[np.int32], size: int
) -> AtlasMap:
    """Rasterise the charts.

    Parameters
    ----------
    uv : (U, 2) float in 0..1, v downwards
    uv_triangles, triangles : (T, 3) int
        The same triangles by UV point and by vertex.
    size : int
        Side of the atlas in texels; texel (0, 0) has its centre at uv 0.5/size.
    """
    owner = np.full(size * size, -1, dtype=np.int32)
    weight = np.zeros((size * size, 3), dtype=np.float32)
    for texel, triangle, barycentric in fragments(np.asarray(uv, float) * size - 0.5, uv_triangles, size, size):
        owner[texel] = triangle
        weight[texel] = barycentric
    texel = np.flatnonzero(owner >= 0)
    order = texel[np.argsort(owner[texel], kind="stable")]
    return AtlasMap(size, triangles, order.astype(np.int32), owner[order], weight[order])
