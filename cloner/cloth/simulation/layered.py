"""Garments worn over another: the lower one is a moving collider."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.cloth.simulation.wearer import Wearer
from cloner.easing import smoothstep
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array

#: Skin so near below cloth is not met by what is worn over that cloth, metres.
BELOW_M: Final = 0.06


@dataclass(frozen=True, slots=True, eq=False)
class Under:
    """Cloth that is worn below.

    Attributes
    ----------
    faces : (T, 3) int64
    put_m : (P, N, 3)
        Its points while it hangs and is taken into the walk, then in the walk's first cycle as it was simulated.
    loop_m : (F, N, 3)
        In its closed loop.
    """

    faces: NDArray[np.int64]
    put_m: Array
    loop_m: Array

    def at(self, frame: int) -> Array:
        """Return (N, 3) its points in a frame counted from the beginning; within the first cycle it blends into its
        loop.
        """
        count = len(self.loop_m)
        begun = frame - (len(self.put_m) - count)
        if begun < 0:
            return np.asarray(self.put_m[frame])
        looped = self.loop_m[begun % count]
        if begun >= count:
            return np.asarray(looped)
        share = smoothstep(begun / count)
        return np.asarray((1.0 - share) * self.put_m[frame] + share * looped)


def layered_collider(body: Wearer, under: Under, hung: int) -> Wearer:
    """Return the collider of body and lower cloth: its points after the skin's, without the skin close below it.

    Parameters
    ----------
    body : Wearer
    under : Under
    hung : int
        Frame in which it hangs on the clone at rest.
    """
    cloth = under.at(hung)
    skin = body.clone.vertices_m[body.rows]
    outward = vertex_normals(cloth, under.faces.astype(np.int32))
    away, near = cKDTree(cloth).query(skin)
    above = np.einsum("ij,ij->i", cloth[near] - skin, outward[near]) > 0.0
    seen = ~(above & (away < BELOW_M))
    kept = body.triangles[seen[body.triangles].any(axis=1)]
    own = np.unique(kept)
    triangles = np.concatenate([np.searchsorted(own, kept), under.faces + len(own)])
    return replace(body, rows=body.rows[own], triangles=triangles.astype(np.int64))
