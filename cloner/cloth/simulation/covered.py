"""Skin that is covered deeply by cloth in every frame and need not be drawn."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.cloth.simulation.moving import WornGarment
from cloner.generic.load import load_generic
from cloner.geometry.meshes.triangles import edges_of, triangle_sides
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array

#: Hidden skin lies so deep under the nearest cloth, along the cloth's normal, metres.
DEEP_M: Final = 0.005
#: One frame in so many is looked at.
EVERY: Final = 3


def deeply_covered(worn: WornGarment, frames_m: Array, deep_m: float = DEEP_M) -> NDArray[np.bool_]:
    """Return (V,) which vertices of the generic human lie deep under cloth in all frames (F, N, 3), away from hems."""
    faces, body = worn.cloth.faces.astype(np.int32), worn.body
    ends, count = np.unique(np.sort(triangle_sides(faces), axis=1), axis=0, return_counts=True)
    hem = np.zeros(worn.cloth.count, dtype=bool)
    hem[ends[count == 1]] = True
    found = np.ones(len(body.rows), dtype=bool)
    for frame in range(0, len(frames_m), EVERY):
        skin = body.posed(worn.root_m[frame], worn.rotations[frame])
        outward = vertex_normals(frames_m[frame], faces)
        _, near = cKDTree(frames_m[frame]).query(skin)
        deep = np.einsum("ij,ij->i", frames_m[frame][near] - skin, outward[near])
        found &= (deep > deep_m) & ~hem[near]
    whole = np.zeros(len(load_generic().vertices_m), dtype=bool)
    whole[body.rows] = found
    ends = edges_of(load_generic().triangles()[0].astype(np.int32))[0]
    beside = np.zeros(len(whole), dtype=bool)
    for one, other in ((0, 1), (1, 0)):
        beside[ends[~whole[ends[:, other]], one]] = True
    return np.asarray(whole & ~beside)
