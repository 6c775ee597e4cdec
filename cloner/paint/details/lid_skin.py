"""Upper lids without the painted lashes of the open eye, which would stay up when the eye closes.

Lashes are a mesh of their own. Beneath an open lid's fold a photo shows no skin but lashes and eye; a blink unrolls
exactly that.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from cloner.generic.face_grids import eye_grid
from cloner.generic.load import GenericHuman
from cloner.geometry.meshes.rasters import fragments
from cloner.geometry.meshes.triangles import areas
from cloner.vision.photographs.blending import push_pull

Image = NDArray[np.uint8]
Map = NDArray[np.float32]

#: Of the lids' rings, counted from the margin: so far the photo's skin is not believed; up to there strands are taken
#: out; beyond there the photo stays.
UNSEEN_TO: Final = 4.5
CLEAN_TO, KEPT_FROM = 7.0, 9.0
#: Strands and the gaps between them are narrower, metres (anatomy: lashes are .1 mm, in photos tufts of three).
STRAND_M: Final = 0.0018
#: The margin between lashes and eye is so much darker than the lid, and half as dark at the ring outside (taste).
LINE: Final = 0.45


@dataclass(frozen=True, slots=True, eq=False)
class LidChart:
    """A chart of the atlas with a part of the lids around one eye.

    Attributes
    ----------
    ring : (h, w) float32
        Rings outside the lids' margin, infinite where the lids have no texels.
    upper : (h, w) float32
        Shares of the upper lid.
    box : (slice, slice)
        Rows and columns of the atlas where it lies.
    """

    ring: Map
    upper: Map
    box: tuple[slice, slice]

    def seen(self) -> Map:
        """Return (h, w) 1 where photos show skin: outside the fold, and not the eye's own lower rim."""
        return np.where((self.ring > UNSEEN_TO) & np.isfinite(self.ring), 1.0, 0.0).astype(np.float32)


def clean_lids(generic: GenericHuman, rgb: Image, vertices_m: NDArray[np.float64]) -> Image:
    """Return the atlas (S, S, 3) with upper lids of plain skin, dark at the margin where the lashes grow."""
    out = rgb.copy()
    for side in ("left", "right"):
        charts, texel_m = _lid_charts(generic, side, len(rgb), vertices_m)
        width = max(3, round(STRAND_M / texel_m) | 1)
        inmost = np.zeros(3, np.float32)
        for chart in charts:
            closed, known = _without_strands(out[chart.box], width), chart.seen()
            if known.any():
                skin = push_pull(closed, known)
                skin *= 1.0 - LINE * np.clip(1.0 - chart.ring / 2.0, 0.0, 1.0)[..., None]
                inmost = skin[chart.ring < chart.ring.min() + 0.5].mean(axis=0)
            else:  # the lid's inside, a chart of its own, goes on as the first ends
                skin = np.tile(inmost, (*known.shape, 1))
            own = (chart.upper * np.clip((KEPT_FROM - chart.ring) / (KEPT_FROM - CLEAN_TO), 0.0, 1.0))[..., None]
            mixed = own * skin + (1.0 - own) * out[chart.box]
            out[chart.box] = np.clip(np.rint(mixed), 0, 255).astype(np.uint8)
    return out


def _without_strands(rgb: Image, width: int) -> Map:
    """Return a picture (h, w, 3) without dark strands narrower than some texels, levels."""
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (width, width))
    closed = cv2.morphologyEx(rgb, cv2.MORPH_CLOSE, kernel).astype(np.float32)
    return np.asarray(cv2.GaussianBlur(closed, (0, 0), width / 4.0), np.float32)


def _lid_charts(
    generic: GenericHuman, side: str, size: int, vertices_m: NDArray[np.float64]
) -> tuple[list[LidChart], float]:
    """Return the charts of one eye's lids, the one with most rings first, and a texel's size in metres."""
    grid = eye_grid(side)
    rings, shares = np.full(len(vertices_m), np.inf), np.zeros(len(vertices_m))
    rings[grid.rings] = (np.arange(len(grid.rings)) - grid.margin)[:, None]
    shares[grid.rings] = np.where(grid.upper, 1.0, 0.0)
    shares[grid.rings[:, grid.corners[0 if side == "left" else 1]]] = 1.0  # the outer corner, where lashes are longest
    triangles, corners = generic.triangles()
    own = np.isfinite(rings[triangles]).all(axis=1)
    triangles, corners = triangles[own], corners[own]
    # A box around all charts would be half the atlas: they lie far apart.
    piece = _pieces(corners)
    rows = [np.flatnonzero(piece == number) for number in np.argsort(-np.bincount(piece), kind="stable")]
    uv = generic.uv.astype(np.float64) * size - 0.5
    charts = [
        _make_lid_chart(uv[corners[part]], rings[triangles[part]], shares[triangles[part]], size) for part in rows
    ]
    return charts, _texel_m(areas(vertices_m, triangles), areas(uv, corners))


def _pieces(corners: NDArray[np.integer]) -> NDArray[np.int32]:
    """Return (T,) numbers of the connected charts to which triangles (T, 3) of corners belong."""
    places = np.unique(corners, return_inverse=True)[1].reshape(corners.shape)
    ends = np.concatenate([places[:, :2], places[:, 1:]])
    count = int(places.max()) + 1
    links = coo_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
    return np.asarray(connected_components(links, directed=False)[1][places[:, 0]], np.int32)


def _make_lid_chart(
    uv: NDArray[np.float64], rings: NDArray[np.float64], shares: NDArray[np.float64], size: int
) -> LidChart:
    """Return the chart of triangles with corners at texels (T, 3, 2), rings (T, 3) and shares (T, 3)."""
    low = np.maximum(np.floor(uv.min(axis=(0, 1))).astype(int) - 2, 0)
    width, height = (np.minimum(np.ceil(uv.max(axis=(0, 1))).astype(int) + 3, size) - low).tolist()
    ring = np.full(height * width, np.inf, dtype=np.float32)
    upper = np.zeros(height * width, dtype=np.float32)
    flat = np.arange(3 * len(uv), dtype=np.int32).reshape(-1, 3)
    for pixel, row, weights in fragments((uv - low).reshape(-1, 2), flat, width, height):
        ring[pixel] = np.einsum("nk,nk->n", rings[row], weights)
        upper[pixel] = np.einsum("nk,nk->n", shares[row], weights)
    box = (slice(int(low[1]), int(low[1]) + height), slice(int(low[0]), int(low[0]) + width))
    return LidChart(ring.reshape(height, width), upper.reshape(height, width), box)


def _texel_m(area_m2: NDArray[np.float64], texels: NDArray[np.float64]) -> float:
    """Return the median length of a texel's side on some triangles."""
    return float(np.median(area_m2[texels > 0] / texels[texels > 0]) ** 0.5)
