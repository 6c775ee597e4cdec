"""Hems of garments, texel by texel: near borders of triangle regions the texture's own colours decide.

Regions are of triangles, so a hem lies on a saw of them, and a dye would show its teeth. Where colours say nothing the
border runs through the middle of the teeth.
"""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation

from cloner.crowd.clones.groups import GROUPS, STEP, WORN
from cloner.records.arrays import Array

Pixels = NDArray[np.uint8]
_Mask = NDArray[np.bool_]

#: Groups whose borders are looked at; nails, eyes, mouth and hair keep their triangles.
_SEEN: Final = ("head", "arms", "legs", *WORN)
#: Side of an atlas that the lengths below were tried at, texels; 330 a metre.
_TRIED_PX: Final = 512
#: A border may move so far: a tooth of the generic human's triangles, texels.
BAND: Final = 7
#: Texels so near a border do not tell what colour a group has: they may be on its wrong side.
_UNSURE: Final = 4
#: How far a group's colours count from where they are, standard deviation, texels.
_AROUND: Final = 8.0
#: Share of sure texels around from which a group's colour is known.
_ENOUGH: Final = 1e-3
#: Variance that every colour has besides its own, squares of CIELAB.
_NOISE: Final = 9.0
#: What it costs to leave the side of the border that a texel is on, as a logarithm of likelihood; taste. The border is
#: evened before, standard deviation, texels: so it runs straight through the teeth where cloth has one colour.
_LEAVING: Final = 2.5
_EVENED: Final = 5.0
#: Costs are shared with neighbours, standard deviation, texels: single threads and buttons do not decide.
_SHARED: Final = 1.5


def refine_hems(rgb: Pixels, codes: Pixels) -> Pixels:
    """Return the codes (S, S) of an atlas with garment borders moved to where colours (S, S, 3) change."""
    scale = len(codes) / _TRIED_PX
    lab = cv2.cvtColor(rgb.astype(np.float32) / 255.0, cv2.COLOR_RGB2Lab)
    charts = codes > 0
    held = [STEP * (GROUPS.index(name) + 1) for name in _SEEN]
    held = [code for code in held if (codes == code).any()]
    reach = [_dilated_in_chart(codes == code, BAND * scale, charts) for code in held]
    worn = [code for code in held if GROUPS[code // STEP - 1] in WORN]
    band = (np.sum(reach, axis=0) > 1) & np.any([reach[held.index(code)] for code in worn], axis=0) if worn else None
    if band is None or not band.any():
        return codes
    costs, known = zip(*(_cost(lab, codes, code, scale) for code in held), strict=True)
    inside = charts.astype(np.float32)
    sides = [_mean((charts & (codes != code)).astype(np.float32), inside, _EVENED * scale) for code in held]
    shared = [_mean((cost + _LEAVING * side) * band, band.astype(np.float32), _SHARED * scale)
              for cost, side in zip(costs, sides, strict=True)]  # fmt: skip
    own = np.any([(codes == code) & there for code, there in zip(held, known, strict=True)], axis=0)
    best = np.array(held, np.uint8)[np.where(np.array(reach) & known, shared, np.inf).argmin(axis=0)]
    skins = ~np.isin(best, worn) & ~np.isin(codes, worn)  # limbs keep their borders with one another
    return np.where(band & own & ~skins, best, codes).astype(np.uint8)


def _dilated_in_chart(mask: _Mask, texels: float, charts: _Mask) -> _Mask:
    """Return a mask dilated within its charts."""
    return np.asarray(binary_dilation(mask, iterations=max(round(texels), 1), mask=charts))


def _cost(lab: NDArray[np.float32], codes: Pixels, code: int, scale: float) -> tuple[Array, _Mask]:
    """Return how unlikely each texel's colour is among those of a group around it, and where there are any."""
    sure = (codes == code) & ~_dilated_in_chart((codes > 0) & (codes != code), _UNSURE * scale, codes > 0)
    weight = sure.astype(np.float32)
    around = _AROUND * scale
    near = cv2.GaussianBlur(weight, (0, 0), around)
    mean = _mean(lab * weight[..., None], weight, around)
    square = _mean((lab * lab).sum(axis=2) * weight, weight, around)
    spread = np.maximum(square - (mean * mean).sum(axis=2), 0.0) / 3.0 + _NOISE
    cost = 0.5 * ((lab - mean) ** 2).sum(axis=2) / spread + 1.5 * np.log(spread)
    known = near > _ENOUGH
    return np.asarray(np.where(known, cost, 0.0), np.float64), known


def _mean(summed: NDArray[np.floating], weight: NDArray[np.float32], sigma: float) -> Array:
    """Return the local mean around each texel of values that are already weighted."""
    below = np.maximum(cv2.GaussianBlur(weight, (0, 0), sigma), 1e-6)
    total = cv2.GaussianBlur(summed.astype(np.float32), (0, 0), sigma)
    return np.asarray(total / (below[..., None] if total.ndim > 2 else below), np.float64)
