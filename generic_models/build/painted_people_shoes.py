"""Shoes and long hair of random people: hulls around foot and skull that follow one joint each."""

from __future__ import annotations

import numpy as np
import trimesh
from numpy.typing import NDArray
from painted_people_bodies import RandomBody, waves
from painted_people_wardrobe import HAIR, SHOE, SHOE_M, Wardrobe
from scipy.sparse import csr_matrix

from cloner.generic.load import GenericHuman

Array = NDArray[np.float64]
Triangles = NDArray[np.int64]
Piece = tuple[Array, Triangles, NDArray[np.int8], Array, csr_matrix]
"""Vertices (N, 3), triangles (T, 3), kinds (N,), colours (N, 3) and what carries them (N, V)."""


def shoes(
    generic: GenericHuman, body: RandomBody, normals: Array, wardrobe: Wardrobe, rng: np.random.Generator
) -> list[Piece]:
    """Return both shoes: hulls of heel and forefoot on a flat sole."""
    meshes = []
    upper, sole = (np.clip(rng.uniform(0.08, 0.9) + rng.normal(0.0, 0.06, 3), 0.03, 0.95) for _ in range(2))
    high = rng.uniform(0.075, 0.11) * body.stature_m / 1.7
    for side in ("left", "right"):
        foot = np.flatnonzero(generic.vertex_segment == generic.segment_names.index(f"{side}_foot"))
        points = body.vertices_m[foot] + SHOE_M * normals[foot]
        length = float(np.ptp(points[:, 2]))
        share = (points[:, 2] - points[:, 2].min()) / length
        points[:, 2] += 0.012 * np.clip(share - 0.6, 0.0, 1.0) / 0.4
        low = points[points[:, 1] < 0.035]
        centre = low.mean(axis=0)
        flat = centre + (low - centre) * [1.05, 0.0, 1.02]
        for part in ((share < 0.62) & (points[:, 1] < high), share > 0.30):
            near = flat[np.isin(np.flatnonzero(points[:, 1] < 0.035), np.flatnonzero(part))]
            slab = [near * [1, 0, 1] + [0, at, 0] for at in (-wardrobe.sole_m, 0.006)]
            hull = trimesh.convex.convex_hull(np.vstack([points[part & (points[:, 1] < high)], *slab]))
            hull = hull.subdivide_to_size(0.012)
            vertices, triangles = np.asarray(hull.vertices), np.asarray(hull.faces, dtype=np.int64)
            colours = np.where(vertices[:, 1:2] < 0.002, sole, upper)
            heel = np.full(len(vertices), generic.feature(f"heel_{side}"))
            meshes.append(
                (vertices, triangles, np.full(len(vertices), SHOE, np.int8), colours, following(generic, heel))
            )
    return meshes


def long_hair(
    generic: GenericHuman, body: RandomBody, normals: Array, colour: Array, rng: np.random.Generator
) -> Piece:
    """Return hair that falls behind the ears to neck or shoulders, as one hull that follows the skull."""
    scalp = np.flatnonzero(generic.region("scalp"))
    ears = float(body.joints_m[generic.joint("skullbase"), 2])
    behind = scalp[body.vertices_m[scalp, 2] < ears + 0.035]
    top = body.vertices_m[behind] + 0.015 * normals[behind]
    nape, chin = body.vertices_m[generic.feature("nape")], body.vertices_m[generic.feature("chin_bottom")]
    low = chin[1] + rng.uniform(-0.9, 0.3) * (chin[1] - nape[1])
    half = float(np.abs(top[:, 0]).max()) * rng.uniform(0.75, 1.0)
    back = min(float(top[:, 2].min()), nape[2] - 0.005)
    ends = np.array(
        [[x * half, low, back + depth] for x in np.linspace(-1, 1, 7) for depth in (0.0, 0.05 + 0.02 * abs(x))]
    )
    hull = trimesh.convex.convex_hull(np.vstack([top, ends])).subdivide_to_size(0.012)
    vertices, triangles = np.asarray(hull.vertices), np.asarray(hull.faces, dtype=np.int64)
    vertices = vertices + 0.002 * waves(vertices, (0.02, 0.06), 12, rng)[:, None]
    colours = np.clip(colour * (1.0 + 0.15 * waves(vertices * [1, 0.1, 1], (0.006, 0.02), 12, rng))[:, None], 0, 1)
    top_row = np.full(len(vertices), generic.feature("head_top"))
    return vertices, triangles, np.full(len(vertices), HAIR, np.int8), colours, following(generic, top_row)


def following(generic: GenericHuman, rows: NDArray[np.integer]) -> csr_matrix:
    """Return the matrix of vertices that move as one coarse vertex each."""
    ones = np.ones(len(rows))
    return csr_matrix((ones, (np.arange(len(rows)), rows)), shape=(len(rows), len(generic.vertices_m)))
