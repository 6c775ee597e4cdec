"""Upper lids without the lashes of the open eye: what a photo paints on them would stay up when the eye shuts.

Lashes are a mesh of their own. Beneath an open lid's fold a photo shows no skin but lashes and eye; a blink unrolls
exactly that.
"""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.face_grids import eye_grid
from cloner.generic.load import GenericHuman
from cloner.geometry.rasters import fragments
from cloner.geometry.triangles import areas
from cloner.vision.blending import push_pull

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


def clean_lids(generic: GenericHuman, rgb: Image, vertices_m: NDArray[np.float64]) -> Image:
    """Return the atlas (S, S, 3) with upper lids of plain skin, dark at the margin where the lashes grow."""
    out = rgb.copy()
    for side in ("left", "right"):
        ring, upper, box, texel_m = _lid(generic, side, len(rgb), vertices_m)
        own = upper * np.clip((KEPT_FROM - ring) / (KEPT_FROM - CLEAN_TO), 0.0, 1.0)
        width = max(3, round(STRAND_M / texel_m) | 1)
        kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (width, width))
        closed = cv2.morphologyEx(out[box], cv2.MORPH_CLOSE, kernel).astype(np.float32)
        closed = cv2.GaussianBlur(closed, (0, 0), width / 4.0)
        # skin is taken from where it is seen: outside the fold, and not the eye's own lower rim
        known = np.where((ring > UNSEEN_TO) & np.isfinite(ring), 1.0, 0.0).astype(np.float32)
        skin = push_pull(closed, known)
        skin *= 1.0 - LINE * np.clip(1.0 - ring / 2.0, 0.0, 1.0)[..., None]
        mixed = own[..., None] * skin + (1.0 - own[..., None]) * out[box]
        out[box] = np.clip(np.rint(mixed), 0, 255).astype(np.uint8)
    return out


def _lid(
    generic: GenericHuman, side: str, size: int, vertices_m: NDArray[np.float64]
) -> tuple[Map, Map, tuple[slice, slice], float]:
    """Return rings outside the margin (H, W), shares of the upper lid (H, W), where they lie, and a texel's metres.

    Rings are infinite where the lids have no texels.
    """
    grid = eye_grid(side)
    rings, shares = np.full(len(vertices_m), np.inf), np.zeros(len(vertices_m))
    rings[grid.rings] = (np.arange(len(grid.rings)) - grid.margin)[:, None]
    shares[grid.rings] = np.where(grid.upper, 1.0, 0.0)
    shares[grid.rings[:, grid.corners[0 if side == "left" else 1]]] = 1.0  # the outer corner, where lashes are longest
    triangles, corners = generic.triangles()
    own = np.isfinite(rings[triangles]).all(axis=1)
    triangles, uv = triangles[own], generic.uv[corners[own]].astype(np.float64) * size - 0.5
    low = np.maximum(np.floor(uv.min(axis=(0, 1))).astype(int) - 2, 0)
    width, height = np.minimum(np.ceil(uv.max(axis=(0, 1))).astype(int) + 3, size) - low
    ring = np.full(height * width, np.inf, dtype=np.float32)
    upper = np.zeros(height * width, dtype=np.float32)
    flat = np.arange(3 * len(triangles), dtype=np.int32).reshape(-1, 3)
    places = (uv - low).reshape(-1, 2)
    for pixel, row, weights in fragments(places, flat, int(width), int(height)):
        ring[pixel] = np.einsum("nk,nk->n", rings[triangles[row]], weights)
        upper[pixel] = np.einsum("nk,nk->n", shares[triangles[row]], weights)
    box = (slice(int(low[1]), int(low[1] + height)), slice(int(low[0]), int(low[0] + width)))
    texel_m = _texel_m(areas(vertices_m, triangles), areas(places, flat))
    return ring.reshape(height, width), upper.reshape(height, width), box, texel_m


def _texel_m(area_m2: NDArray[np.float64], texels: NDArray[np.float64]) -> float:
    """Return the median length of a texel's side on some triangles."""
    return float(np.median(area_m2[texels > 0] / texels[texels > 0]) ** 0.5)
