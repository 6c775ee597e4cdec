"""The generic human's texture atlas and surface graph, made once a process."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from cloner.generic.load import GenericHuman
from cloner.geometry.atlas import AtlasMap, map_atlas
from cloner.geometry.graphs import SurfaceGraph, surface_graph


@lru_cache(maxsize=2)
def generic_atlas(generic: GenericHuman, size: int) -> AtlasMap:
    """Return the atlas of the generic human at ``size`` texels a side."""
    triangles, uv_triangles = generic.triangles()
    uv = np.asarray(generic.uv, dtype=np.float64)
    return map_atlas(uv, uv_triangles.astype(np.int32), triangles.astype(np.int32), size)


def person_graph(generic: GenericHuman, vertices_m: np.ndarray) -> SurfaceGraph:
    """Return the edge graph of a person with the generic's topology."""
    return surface_graph(vertices_m, generic.triangles()[0].astype(np.int32))
