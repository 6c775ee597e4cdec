"""Roughness and occlusion maps in glTF's conventions."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.shared.regions import NOTHING, region_texels, texel_triangles
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.records.clones import Clone
from cloner.records.regions import REGIONS

#: Taste, within what renderers' tables give: skin is oily, cloth is dull, leather between.
ROUGHNESS: Final[Mapping[str, float]] = MappingProxyType({
    "skin": 0.58, "hair": 0.65, "eyes": 0.25, "mouth": 0.45, "upper_clothes": 0.9, "lower_clothes": 0.9, "shoes": 0.6,
})  # fmt: skip
LIPS: Final = 0.42
ELSEWHERE: Final = 0.85
SIZE: Final = 512  # regions are as coarse as the triangles
#: Half of how far grown people open their mouths (40 to 50 mm): what lies behind the lips sees so large a round window,
#: metres.
WINDOW_M: Final = 0.020


def roughness_map(clone: Clone) -> NDArray[np.uint8]:
    """Return (SIZE, SIZE, 3) texels of a clone's atlas as glTF has them: red is occlusion, green roughness, blue metal.

    Only the mouth is occluded: all else is painted from photographs, which show its shade already.

    People are nowhere metal; an atlas that has a shine of its own gives that, in its size.

    References
    ----------
    Khronos Group 2021, glTF 2.0 specification, section 3.9.2.
    """
    if clone.atlas.shine.size:
        return clone.atlas.shine
    generic = load_generic()
    table = np.full(256, ELSEWHERE)
    table[: len(REGIONS)] = [ROUGHNESS[name] for name in REGIONS]
    table[NOTHING] = ELSEWHERE
    rough = table[region_texels(clone, SIZE)]
    lips = np.asarray(generic.region("lips")[generic.triangles()[0]].all(axis=1), bool)
    rough[np.append(lips, False)[texel_triangles(SIZE)]] = LIPS  # outside the charts is the last one
    texels = np.zeros((SIZE, SIZE, 3), np.uint8)
    texels[..., 0] = mouth_light()
    texels[..., 1] = np.rint(255.0 * rough)
    return texels


@lru_cache(maxsize=1)
def mouth_light() -> NDArray[np.uint8]:
    """Return (SIZE, SIZE) how much of the light around reaches each texel, 255 everywhere but in the mouth; read only.

    Of the generic human; so far behind the lips as a texel lies, a round window of an open mouth fills this share of
    what it faces: the cosine-weighted share of a disc, r^2 / (r^2 + d^2).
    """
    generic = load_generic()
    triangles = generic.triangles()[0]
    own = generic.region("mouth_interior").copy()
    for name in ("teeth_upper", "teeth_lower", "tongue"):
        own[generic.part(name)] = True
    behind_m = np.maximum(generic.vertices_m[generic.feature("stomion"), 2] - generic.vertices_m[:, 2], 0.0)
    share = WINDOW_M**2 / (WINDOW_M**2 + behind_m**2)
    inside = generic_atlas(generic, SIZE, wanted=np.asarray(own[triangles].all(axis=1), np.bool_))
    texels = np.full(SIZE * SIZE, 255, np.uint8)
    texels[inside.texel] = np.rint(255.0 * inside.interpolate(share))
    texels.setflags(write=False)
    return texels.reshape(SIZE, SIZE)


def shell_shine(clone: Clone, usual: float) -> tuple[float, float]:
    """Return roughness (the usual one of hair and cloth) and metal, 0..1, of shells; a statue's as most of it is."""
    if not clone.atlas.shine.size:
        return usual, 0.0
    rough, metal = (float(np.median(clone.atlas.shine[..., k])) / 255.0 for k in (1, 2))
    return rough, metal
