"""The scalp kept below the hair that covers it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.baking.posed import body_triangles
from cloner.frames import m_from_mm
from cloner.generic.load import GenericHuman
from cloner.geometry.graphs import surface_graph
from cloner.geometry.wedges import vertex_normals
from cloner.records.heads import Shell

Array = NDArray[np.float64]

BELOW_MM = 1.5  # the scalp lies this far below the shell
DEEPEST_MM = 25.0
NEAR_M = 0.022  # shell points farther off say nothing about a vertex
SAME_WAY = 0.75  # nor do the hairline's walls, which face along the skin
NEIGHBOURS = 6


def tuck_scalp(generic: GenericHuman, vertices_m: Array, shells: tuple[Shell, ...]) -> Array:
    """Return the vertices (V, 3) with the scalp pulled in where it would stand out of a shell.

    The bare skull under hair is a guess from the stature; the hair's outline was seen.
    """
    triangles = body_triangles(generic)
    rows = np.flatnonzero(generic.region("scalp"))
    if not shells or rows.size == 0:
        return vertices_m
    normals = vertex_normals(vertices_m, triangles)
    points = np.concatenate([shell.vertices_m for shell in shells])
    facing = np.concatenate([vertex_normals(shell.vertices_m, shell.triangles) for shell in shells])
    gap, near = cKDTree(points).query(vertices_m[rows], k=NEIGHBOURS, distance_upper_bound=NEAR_M)
    found = np.isfinite(gap)
    near = np.where(found, near, 0)
    found &= np.einsum("nkc,nc->nk", facing[near], normals[rows]) > SAME_WAY
    along = np.einsum("nkc,nc->nk", points[near] - vertices_m[rows, None], normals[rows])
    # The lowest of the points nearby: a tail's root over the cap must not hide that the cap is below.
    offset = np.where(found, along, np.inf).min(axis=1)
    pull = np.where(found.any(axis=1), offset - m_from_mm(BELOW_MM), 0.0)
    depth = np.zeros(len(vertices_m))
    depth[rows] = np.clip(pull, -m_from_mm(DEEPEST_MM), 0.0)
    smooth = surface_graph(vertices_m, triangles).smooth(depth[:, None], 1)[:, 0]
    depth[rows] = np.minimum(depth[rows], smooth[rows])
    return np.asarray(vertices_m + normals * depth[:, None])
