"""Dark nostrils: photos do not show their depth, and skin spread from around fills them too brightly."""

from __future__ import annotations

import functools
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic

#: Middle of the left hollow from the subnasale on the generic human, metres (left, up, forward).
HOLLOW_M: Final = (0.0085, 0.0083, -0.0012)
#: The hollow's radius, and over how much it ends, metres.
RADIUS_M, EDGE_M = 0.0026, 0.0018
#: Levels inside at most, share of the skin's at the rim (the sample visitors' photos show .35 to .5).
DARK: Final = 0.45
#: Texels with less of the hollow than this are its rim.
RIM: Final = 0.2


def darken_nostrils(rgb: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return the atlas (S, S, 3) with the nostrils in shade."""
    texel, share = nostril_texels(len(rgb))
    out = rgb.copy()
    flat = out.reshape(-1, 3)
    level = flat[texel].astype(np.float64)
    deep = np.minimum(level, DARK * np.median(level[share < RIM], axis=0))
    flat[texel] = np.rint(level + share[:, None] * (deep - level)).astype(np.uint8)
    return out


@functools.lru_cache(maxsize=2)
def nostril_texels(size: int) -> tuple[NDArray[np.integer], NDArray[np.floating]]:
    """Return the texels (N,) of the nostrils, and how deep each lies in the hollow, 0..1."""
    generic = load_generic()
    away = (generic.vertices_m - generic.vertices_m[generic.feature("subnasale")]).astype(np.float64)
    away[:, 0] = np.abs(away[:, 0])
    distance = np.linalg.norm(away - HOLLOW_M, axis=1)
    inside = np.clip((RADIUS_M + EDGE_M - distance) / EDGE_M, 0.0, 1.0)
    inside *= generic.skin
    triangles, _ = generic.triangles()
    atlas = generic_atlas(generic, size, wanted=np.asarray((inside > 0.0)[triangles].any(axis=1), np.bool_))
    return atlas.texel, atlas.interpolate(inside)
