"""Scalp and ears kept below the hair that covers them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.frames import m_from_mm
from cloner.generic.load import GenericHuman
from cloner.generic.surfaces import body_triangles
from cloner.geometry.charts.atlas import colours_at
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.records.heads import Shell

BELOW_MM = 1.5  # the scalp lies this far below the shell
#: How deep skin is tucked at most, mm, and neighbours that tell how deep (taste).
DEEPEST_MM = 25.0
NEAR_M = 0.022  # shell points farther off say nothing about a vertex
#: The same of a face, whose mesh is finer and whose skin was seen.
FACE_DEEPEST_MM, FACE_NEAR_M = 8.0, 0.008
SAME_WAY = 0.75  # nor do the hairline's walls, which face along the skin
NEIGHBOURS = 6
EAR_RINGS = 2  # rings of skin around an ear that hold the skin laid over its place
EAR_SHARE = 0.3  # an ear of which less is covered stays: a lock before it is no reason
BESIDE_M = 0.005  # a point of a shell covers what lies this near below it (its triangles' sides are 5 mm long)
OPAQUE = 128  # of a shell's alpha: the film beyond the hairline covers nothing


def tuck_scalp(generic: GenericHuman, vertices_m: Array, shells: tuple[Shell, ...]) -> Array:
    """Return the vertices (V, 3) with scalp, forehead and temples pulled in where they would intersect a shell.

    The bare skull under hair is a guess from the stature; the hair's outline was seen. Ears under hair are laid flat.
    The face gives way only to what is opaque: hair fades out over it.
    """
    hair = tuple(shell for shell in shells if shell.kind == "hair")
    vertices_m = press_ears_to_head(generic, vertices_m, ears_below(generic, vertices_m, hair))
    scalp = generic.region("scalp")
    if not shells or not scalp.any():
        return vertices_m
    normals, graph = vertex_normals(vertices_m, body_triangles()), surface_graph(vertices_m, body_triangles())
    points = np.concatenate([shell.vertices_m for shell in shells])
    facing = np.concatenate([vertex_normals(shell.vertices_m, shell.triangles) for shell in shells])
    opaque = np.concatenate([(shell.kind == "hair") & _opaque_vertices(shell) for shell in shells])
    depth = np.zeros(len(vertices_m))
    for skin, shown, reach_m, deepest_mm in (
        (scalp, np.ones_like(opaque), NEAR_M, DEEPEST_MM),
        (_skin_of_face(generic), opaque, FACE_NEAR_M, FACE_DEEPEST_MM),
    ):
        own, rows = np.zeros(len(vertices_m)), np.flatnonzero(skin)
        pull = _pull_m(vertices_m[rows], normals[rows], points[shown], facing[shown], reach_m)
        own[rows] = np.clip(pull, -m_from_mm(deepest_mm), 0.0)
        depth[rows] = np.minimum(own, graph.smooth(own[:, None], 1)[:, 0])[rows]
    return np.asarray(vertices_m + normals * depth[:, None])


def _skin_of_face(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return the face (V,) without its openings."""
    openings = generic.region("eyelids") | generic.region("lips") | generic.region("mouth_interior")
    return np.asarray(generic.region("face") & ~openings)


def _pull_m(skin_m: Array, normals: Array, points_m: Array, facing: Array, reach_m: float) -> Array:
    """Return by how much (R,) skin must move outwards, mostly inwards, to lie below a shell's points near it."""
    if not len(points_m):
        return np.zeros(len(skin_m))
    gap, near = cKDTree(points_m).query(skin_m, k=NEIGHBOURS, distance_upper_bound=reach_m)
    found = np.isfinite(gap)
    near = np.where(found, near, 0)
    found &= np.einsum("nkc,nc->nk", facing[near], normals) > SAME_WAY
    along = np.einsum("nkc,nc->nk", points_m[near] - skin_m[:, None], normals)
    # The lowest of the points nearby: a tail's root over the cap must not hide that the cap is below.
    offset = np.where(found, along, np.inf).min(axis=1)
    return np.where(found.any(axis=1), offset - m_from_mm(BELOW_MM), 0.0)


def ear_masks(generic: GenericHuman) -> tuple[NDArray[np.bool_], ...]:
    """Return the (V,) vertices of each ear."""
    return tuple(generic.region(name) for name in ("ear_left", "ear_right"))


def covered_ear_shares(generic: GenericHuman, covered: Array) -> Array:
    """Return how far each vertex of the ears is covered (V,), 0..1; zero for ears that hair covers too little."""
    out = np.zeros(len(covered))
    for ear in ear_masks(generic):
        if covered[ear].mean() > EAR_SHARE:
            out[ear] = covered[ear]
    return out


def press_ears_to_head(generic: GenericHuman, vertices_m: Array, covered: Array) -> Array:
    """Return the vertices (V, 3) with ears pressed to the head as far as hair covers them.

    Parameters
    ----------
    generic : GenericHuman
    vertices_m : (V, 3) float64
    covered : (V,) float64 in 0..1
    """
    out, triangles = vertices_m, body_triangles()
    for ear in ear_masks(generic):
        if not covered[ear].any():
            continue
        patch = ear
        for _ in range(EAR_RINGS):
            grown = patch.copy()
            grown[triangles[patch[triangles].any(axis=1)]] = True
            patch = grown
        rows, place = np.flatnonzero(patch), np.full(len(ear), -1, np.int32)
        place[rows] = np.arange(len(rows), dtype=np.int32)
        inner = place[triangles[patch[triangles].all(axis=1)]]
        graph = surface_graph(vertices_m[rows], inner)
        flat = graph.fill(vertices_m[rows], (~ear[rows]).astype(float), 0.01)
        share = graph.smooth(covered[rows], 2) * ear[rows]
        out = out.copy() if out is vertices_m else out
        out[rows] += share[:, None] * (flat - vertices_m[rows])
    return out


def ears_below(generic: GenericHuman, vertices_m: Array, shells: tuple[Shell, ...]) -> Array:
    """Return 0..1 (V,) which vertices of the ears would lie below the opaque part of shells if pressed to the head."""
    covered = np.zeros(len(vertices_m))
    if not shells:
        return covered
    everything = np.any(ear_masks(generic), axis=0).astype(float)
    flat = press_ears_to_head(generic, vertices_m, everything)
    normals = vertex_normals(flat, body_triangles())
    rows = np.flatnonzero(everything)
    points = np.concatenate([shell.vertices_m[_opaque_vertices(shell)] for shell in shells])
    if not len(points):
        return covered
    gap, near = cKDTree(points).query(flat[rows], k=NEIGHBOURS, distance_upper_bound=NEAR_M)
    found = np.isfinite(gap)
    away = points[np.where(found, near, 0)] - flat[rows, None]
    along = np.einsum("nkc,nc->nk", away, normals[rows])
    beside = np.linalg.norm(away - along[..., None] * normals[rows, None], axis=2)
    covered[rows] = (found & (along > 0.0) & (beside < BESIDE_M)).any(axis=1)
    return covered_ear_shares(generic, covered)


def _opaque_vertices(shell: Shell) -> NDArray[np.bool_]:
    """Return which vertices (N,) of a shell its texture shows."""
    return np.asarray(colours_at(shell.rgba, shell.uv)[:, 3] >= OPAQUE)
