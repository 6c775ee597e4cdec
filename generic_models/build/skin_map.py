"""Regions of the skin, found from hm08's vertex rings, UV islands and a hairline on the mean head."""

from __future__ import annotations

import atlas
import numpy as np
import scipy.sparse as sparse
from cage import Cage
from names import Figure
from source import FloatArray, IntArray, Source

LIP_RINGS = 7  # vertex rings from the mouth's seam to the lips' outer edge: lip_top and lip_bottom lie on ring 7
INNER_LIP_RING = 2  # stomion lies on ring 2
LID_RINGS = 6

# Hairline on the mean head of 1.70 m: lowest hair (y) at a depth (z), metres; anatomy by eye, from nape to forehead.
HAIRLINE_Z = (-0.05, -0.03, 0.00, 0.02, 0.045, 0.060, 0.072, 0.080, 0.095, 0.110, 0.125)
HAIRLINE_Y = (1.500, 1.500, 1.515, 1.545, 1.570, 1.575, 1.590, 1.620, 1.645, 1.657, 1.663)


def island_vertices(cage: Cage, vertices_m: FloatArray) -> dict[str, IntArray]:
    """Return the vertices of each named UV island."""
    island = atlas.island_of_uv(cage)
    names = atlas.island_names(cage, island, vertices_m)
    of_quad = island[cage.quad_uv[:, 0]]
    return {name: np.unique(cage.quads[of_quad == k]) for k, name in enumerate(names)}


def ring_number(cage: Cage, seeds: IntArray, allowed: IntArray, most: int) -> IntArray:
    """Return each vertex's distance in quads from the seeds, (V,); ``most`` + 1 where farther or not allowed."""
    count = cage.full_of_vertex.size
    pairs = np.vstack([cage.quads[:, [a, b]] for a in range(4) for b in range(4) if a != b])
    touch = sparse.csr_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    open_ = np.zeros(count, dtype=np.bool_)
    open_[allowed] = True
    ring = np.full(count, most + 1)
    front = np.zeros(count, dtype=np.bool_)
    front[seeds] = True
    for number in range(most + 1):
        front &= open_ & (ring > most)
        ring[front] = number
        front = touch @ front > 0
    return ring


def mouth_rings(cage: Cage, islands: dict[str, IntArray]) -> IntArray:
    """Return the mouth's ring numbers, 0 at the seam to the inner mouth."""
    return ring_number(cage, np.intersect1d(islands["head"], islands["mouth"]), islands["head"], 20)


def eye_rings(cage: Cage, islands: dict[str, IntArray], side: str) -> IntArray:
    """Return one eye's ring numbers, 0 at the seam to the socket."""
    return ring_number(cage, np.intersect1d(islands["head"], islands[f"socket_{side}"]), islands["head"], 20)


def regions(
    source: Source, cage: Cage, figure: Figure, islands: dict[str, IntArray], head_blend: FloatArray
) -> dict[str, np.ndarray]:
    """Return the masks ``region_*``, (V,) bool each, on body vertices; mirror-symmetric as a whole."""
    v = figure.vertices_m
    count = v.shape[0]

    def mask(rows: IntArray) -> np.ndarray:
        out = np.zeros(count, dtype=np.bool_)
        out[rows] = True
        return out

    body = mask(figure.body)
    out: dict[str, np.ndarray] = {}
    for side in ("left", "right"):
        wing = np.linalg.norm(cage.build(source.mpfb_target(f"ears/{side[0]}-ear-wing-incr")), axis=1)
        out[f"region_ear_{side}"] = body & (wing > 1e-6)
        out[f"region_hand_{side}"] = mask(islands[f"hand_{side}"])
        out[f"region_foot_{side}"] = mask(islands[f"foot_{side}"])
    out["region_lips"] = mouth_rings(cage, islands) <= LIP_RINGS
    out["region_eyelids"] = (eye_rings(cage, islands, "left") <= LID_RINGS) | (
        eye_rings(cage, islands, "right") <= LID_RINGS
    )
    out["region_mouth_interior"] = mask(islands["mouth"])
    ears = out["region_ear_left"] | out["region_ear_right"]
    skull = mask(islands["head"]) & (head_blend > 0.6)
    above = v[:, 1] > np.interp(v[:, 2], HAIRLINE_Z, HAIRLINE_Y)
    out["region_scalp"] = skull & above & ~ears
    under = (v[:, 1] < 1.487) & (v[:, 2] < 0.105)  # below the jaw's edge, metres
    out["region_face"] = skull & ~above & ~ears & ~under & (v[:, 2] > 0.03)
    out["region_neck"] = (
        body
        & (head_blend > 0.02)
        & ~out["region_face"]
        & ~out["region_scalp"]
        & ~ears
        & ~(
            out["region_mouth_interior"]
            | mask(islands["socket_left"])
            | mask(islands["socket_right"])
            | (out["region_lips"] | out["region_eyelids"])
        )
    )
    feet = out["region_foot_left"] | out["region_foot_right"]
    out["region_sole"] = feet & (v[:, 1] < 0.014) & (_normals(v, cage.quads)[:, 1] < -0.35)
    return {name: np.asarray(value, dtype=np.bool_) for name, value in out.items()}


def _normals(vertices_m: FloatArray, quads: IntArray) -> FloatArray:
    corners = vertices_m[quads]
    face = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    out = np.zeros_like(vertices_m)
    for k in range(4):
        np.add.at(out, quads[:, k], face)
    return out / np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-12)
