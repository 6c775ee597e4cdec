"""The generic human's texture atlas and surface graph."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.geometry.charts.atlas import AtlasMap, Window, map_atlas
from cloner.geometry.meshes.graphs import SurfaceGraph, surface_graph


def generic_atlas(
    generic: GenericHuman,
    size: int,
    *,
    window: Window | None = None,
    wanted: NDArray[np.bool_] | slice = np.s_[:],
) -> AtlasMap:
    """Return the atlas of the generic human at ``size`` texels a side, or a window of it.

    ``wanted`` (T,) picks triangles, all by default.
    """
    triangles, uv_triangles = generic.triangles()
    uv = np.asarray(generic.uv, dtype=np.float64)
    return map_atlas(uv, uv_triangles[wanted].astype(np.int32), triangles[wanted].astype(np.int32), size, window)


def vertex_uv(generic: GenericHuman) -> NDArray[np.float64]:
    """Return (V, 2) a place of every vertex in the texture, uv in 0..1; on a seam one of its places."""
    triangles, uv_triangles = generic.triangles()
    places = np.zeros((len(generic.vertices_m), 2))
    places[triangles.ravel()] = generic.uv[uv_triangles.ravel()]
    return places


def person_graph(generic: GenericHuman, vertices_m: np.ndarray) -> SurfaceGraph:
    """Return the edge graph of a person with the generic's topology."""
    return surface_graph(vertices_m, generic.triangles()[0].astype(np.int32))
