"""How far points lie from where hair ends at their own height: what a photo tells of hair's plan."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.hair.volumes.views import HairView
from cloner.vision.retouching.aligning import sample

Array = NDArray[np.float64]


def across_px(hair: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (H, W) how far each pixel of hair is from the nearer end of the hair in its row, px; zero outside."""
    across = np.zeros(hair.shape, np.float32)
    rows, columns = np.flatnonzero(hair.any(axis=1)), np.flatnonzero(hair.any(axis=0))
    if rows.size:
        box = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
        bare = np.pad(~hair[box], ((0, 0), (1, 1)), constant_values=True)
        place = np.arange(bare.shape[1], dtype=np.int32)
        before = np.maximum.accumulate(np.where(bare, place, 0), axis=1)
        after = np.minimum.accumulate(np.where(bare, place, place[-1])[:, ::-1], axis=1)[:, ::-1]
        across[box] = np.maximum(np.minimum(place - before, after - place) - 0.5, 0.0)[:, 1:-1]
    return across


def across_mm(view: HairView, rows_px: NDArray[np.float32], points_m: Array) -> NDArray[np.float32]:
    """Return (N,) distances of rest points, mm, that a view's picture (H, W) of :func:`across_px` tells."""
    posed = view.to_view(points_m)
    return np.asarray(sample(rows_px, view.posed.camera.project(posed))[:, 0] * view.pixel_mm(posed), np.float32)
