"""Edges of a part of a photo, detected once and reused while an outline is corrected."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.contours.edges import EdgeMap, detect_edges

Floats = NDArray[np.float64]
Image = NDArray[np.float32]

#: Blur of the colours that are compared across edges, px.
COLOUR_BLUR_PX = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class CachedEdges:
    """The edges of one part of a photo.

    Attributes
    ----------
    top_left : ndarray, shape (2,), float64
        The photo's pixel at the part's first one.
    edge_map : EdgeMap
        Of that part.
    smooth : ndarray, shape (h, w, 3), float32
        Its colours, blurred a little.
    """

    top_left: Floats
    edge_map: EdgeMap
    smooth: Image

    @property
    def window(self) -> tuple[slice, slice]:
        """Rows and columns of the photo that the part shows."""
        rows, columns = self.edge_map.edges.shape
        left, top = (int(value) for value in self.top_left)
        return slice(top, top + rows), slice(left, left + columns)

    def around(self, points_px: Floats, *, margin_px: float) -> CachedEdges:
        """Return the part of it that holds all points."""
        own = self.edge_map
        corner, at = _window(points_px - self.top_left, own.edges.shape, margin_px=margin_px)
        cut = EdgeMap(own.edges[at], own.gradient[at], own.magnitude[at], own.low, own.high)
        return CachedEdges(self.top_left + corner, cut, self.smooth[at])


def cache_edges(rgb: NDArray[np.uint8], points_px: Floats, *, margin_px: float) -> CachedEdges:
    """Detect the edges of the part of a photo that holds all points.

    Parameters
    ----------
    rgb : ndarray, shape (H, W, 3), uint8
    points_px : ndarray, shape (N, 2), float64
    margin_px : float
        How far beyond the points the part reaches.
    """
    top_left, window = _window(points_px, rgb.shape, margin_px=margin_px)
    smooth = cv2.GaussianBlur(rgb[window], (0, 0), COLOUR_BLUR_PX).astype(np.float32)
    return CachedEdges(top_left, detect_edges(rgb[window]), smooth)


def _window(points_px: Floats, shape: tuple[int, ...], *, margin_px: float) -> tuple[Floats, tuple[slice, slice]]:
    """Return the part of a picture that holds all points: its corner and its slices."""
    size = np.array([shape[1], shape[0]], dtype=np.float64)
    low = np.clip(np.floor(points_px.min(axis=0) - margin_px), 0.0, size - 1.0)
    high = np.clip(np.ceil(points_px.max(axis=0) + margin_px) + 1.0, low + 1.0, size)
    rows = slice(int(low[1]), int(high[1]))
    return low, (rows, slice(int(low[0]), int(high[0])))
