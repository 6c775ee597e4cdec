"""A hairline is no cut: strands thin out over some millimetres."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.geometry.atlas import AtlasMap

FADE_MM = (-1.0, 4.0)  # taste: transparent this far outside the hairline, opaque this far inside
STRAND_MM = 1.5  # dark strands reach this much farther out than light gaps
STRAND_TEXELS = 4.0  # width of what counts as one strand's surroundings
LIGHTEST_LEVELS = 6.0  # differences below this are noise


def soften_edge(rgba: NDArray[np.uint8], atlas: AtlasMap, inside_mm: NDArray[np.floating]) -> NDArray[np.uint8]:
    """Return the texture (S, S, 4) with alpha falling to nothing over the hairline.

    Parameters
    ----------
    rgba : (S, S, 4) uint8
    atlas : AtlasMap of the shell
    inside_mm : (N,) of its vertices, distance inside the hairline
    """
    light = rgba[..., :3].astype(np.float32).mean(axis=2)
    gap = cv2.GaussianBlur(light, (0, 0), STRAND_TEXELS) - light
    spread = max(float(gap[atlas.covered()].std()), LIGHTEST_LEVELS)
    distance = np.full(light.size, np.float32(FADE_MM[1] + STRAND_MM))
    distance[atlas.texel] = atlas.interpolate(np.minimum(inside_mm, 4.0 * FADE_MM[1])[:, None])[:, 0]
    distance = distance.reshape(light.shape) + STRAND_MM * np.clip(gap / spread, -1.0, 1.0)
    share = np.clip((distance - FADE_MM[0]) / (FADE_MM[1] - FADE_MM[0]), 0.0, 1.0)
    result = rgba.copy()
    result[..., 3] = np.rint(255.0 * share * share * (3.0 - 2.0 * share)).astype(np.uint8)
    return result
