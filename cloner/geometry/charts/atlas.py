"""The texture atlas: the triangle and barycentric coordinates of every texel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from cloner.geometry.meshes.rasters import rasterise


@dataclass(frozen=True, slots=True, eq=False)
class AtlasMap:
    """Texels of all charts in a window of the atlas, row by row.

    Attributes
    ----------
    shape : (int, int)
        Height and width of the window, texels.
    triangles : (T, 3) int32
        Vertex indices of the triangles: those given, of a window those that show in it.
    texel : (N,) int32
        ``row * width + column`` in the window of every covered texel, each once.
    triangle : (N,) int32
        The triangle that covers it, a row of ``triangles``.
    barycentric : (N, 3) float32
    """

    shape: tuple[int, int]
    triangles: NDArray[np.int32]
    texel: NDArray[np.int32]
    triangle: NDArray[np.int32]
    barycentric: NDArray[np.float32]

    def interpolate(self, values: NDArray[np.floating], rows: NDArray[np.integer] | None = None) -> NDArray[np.float32]:
        """Return per-vertex ``values`` (V,) or (V, K) at the texels ``rows`` (all when None), float32."""
        # ``take`` gathers rows of three in a quarter of the time that an index takes.
        triangle = self.triangle if rows is None else self.triangle.take(rows)
        weights = self.barycentric if rows is None else self.barycentric.take(rows, axis=0)
        table = np.ascontiguousarray(values, dtype=np.float32)
        corners = self.triangles.take(
            triangle, axis=0
        ).ravel()  # a sparse row a texel: a third faster than gathering corners
        rows_of = np.arange(0, corners.size + 1, 3, dtype=np.int32)
        return np.asarray(csr_array((weights.ravel(), corners, rows_of), shape=(len(triangle), len(table))) @ table)

    def rows_of(self, triangles: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Return the rows of the texels whose triangle is marked in (T,) ``triangles``."""
        return np.flatnonzero(triangles[self.triangle])

    def covered(self) -> NDArray[np.bool_]:
        """Return bool of the window's shape, True inside charts."""
        inside = np.zeros(self.shape[0] * self.shape[1], dtype=bool)
        inside[self.texel] = True
        return inside.reshape(self.shape)


@dataclass(frozen=True, slots=True)
class Window:
    """A rectangle of an atlas: first row and column, height and width, texels."""

    top: int
    left: int
    height: int
    width: int


def colours_at(picture: NDArray[np.uint8], uv: NDArray[np.floating]) -> NDArray[np.uint8]:
    """Return the texels (N, C) of a texture (h, w, C) at points (N, 2), uv in 0..1, v downwards."""
    size = np.array(picture.shape[1::-1])
    column, row = np.clip((uv * size).astype(np.int64), 0, size - 1).T
    return np.asarray(picture[row, column])


def map_atlas(
    uv: NDArray[np.floating],
    uv_triangles: NDArray[np.int32],
    triangles: NDArray[np.int32],
    size: int,
    window: Window | None = None,
) -> AtlasMap:
    """Rasterise the charts.

    Parameters
    ----------
    uv : (U, 2) float in 0..1, v downwards
    uv_triangles, triangles : (T, 3) int
        The same triangles by UV point and by vertex.
    size : int
        Side of the atlas in texels; texel (0, 0) has its centre at uv 0.5/size.
    window : Window, optional
        The part of the atlas that is wanted, all by default.
    """
    part = window or Window(0, 0, size, size)
    points = np.asarray(uv, float) * size - 0.5 - (part.left, part.top)
    texel, triangle, weight = rasterise(points, uv_triangles, part.width, part.height)
    if window is not None:  # tables by triangle are then as small as the window
        shown = np.zeros(len(triangles), np.bool_)
        shown[triangle] = True
        triangles, triangle = triangles[shown], (np.cumsum(shown, dtype=np.int32) - 1)[triangle]
    return AtlasMap((part.height, part.width), triangles, texel, triangle, weight)
