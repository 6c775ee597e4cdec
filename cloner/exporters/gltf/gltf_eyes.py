"""Eyes with depth: flat irises that reflect light like the round cornea in front of them.

The generic human's eyeball is one closed surface on which iris and pupil are painted: seen from the side, a pupil
stands at the front of the ball. Here the painted disc is laid flat, 1.9 mm behind, and has the normals of a cornea,
which is rounder than the ball. No shell of its own: a blended one shows no highlight (readers clip light before they
blend), and one with KHR_materials_transmission is a white patch wherever that is not known.

References
----------
Gullstrand's eye: the cornea's front has a radius of 7.7 mm, before an iris 5.9 mm from its middle to its rim.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.face_grids import eyeball
from cloner.generic.load import load_generic
from cloner.generic.surfaces import Surface, load_surfaces
from cloner.geometry.meshes.eyeballs import IRIS_M
from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array
from cloner.records.clones import Clone

Ints = NDArray[np.int64]

CORNEA_M: Final = 0.0077  # radius of the front of the cornea (Gullstrand, above)
#: Angles from the gaze between which the ring of the iris' rim lies on the shipped ball, radians.
_RIM_RAD: Final = (np.radians(22.0), np.radians(24.0))


@dataclass(frozen=True, slots=True, eq=False)
class Front:
    """An eyeball's front: its vertices, all of the ball's, and which lie on the iris' rim.

    Attributes
    ----------
    ball : (B,) int64
    front : (N,) int64, iris and rim
    rim : (N,) bool
    """

    ball: Ints
    front: Ints
    rim: NDArray[np.bool_]

    def frame(self, vertices_m: Array) -> tuple[Array, Array, float]:
        """Return the middle (3,) of the iris' rim, the unit gaze (3,) and the rim's radius, metres."""
        rim = vertices_m[self.front[self.rim]]
        middle = rim.mean(axis=0)
        gaze = np.linalg.svd(rim - middle, full_matrices=False)[2][2]
        gaze *= np.sign((vertices_m[self.front] - middle).sum(axis=0) @ gaze)
        return middle, gaze, float(np.linalg.norm(rim - middle, axis=1).mean())


@functools.cache
def fronts() -> tuple[Front, Front]:
    """Return the fronts of the left and of the right eyeball, the same for every clone."""
    generic = load_generic()
    points, found = generic.vertices_m.astype(np.float64), []
    for side in ("left", "right"):
        ball = np.asarray(generic.part(f"eye_{side}"), dtype=np.int64)
        gaze = unit(points[ball] - eyeball(points, side).centre)
        angle = np.arccos(np.clip(gaze[:, 2], -1.0, 1.0))
        front = angle < _RIM_RAD[1]
        found.append(Front(ball, ball[front], angle[front] > _RIM_RAD[0]))
    left, right = found
    return left, right


@functools.cache
def creased_eyes() -> tuple[Surface, NDArray[np.bool_]]:
    """Return the eyeballs' surface with the iris' rim split, and (W,) which of its wedges are the irises'.

    The rim's copies come last: lists of triangles over the unsplit surface stay true.
    """
    eyes = next(surface for surface in load_surfaces() if surface.name == "eyes")
    front = np.concatenate([one.front for one in fronts()])
    inside: NDArray[np.bool_] = np.asarray(np.isin(eyes.vertex[eyes.triangles], front).all(axis=1))
    rim = np.intersect1d(eyes.triangles[inside], eyes.triangles[~inside])
    copy = np.arange(len(eyes.vertex))
    copy[rim] = len(copy) + np.arange(len(rim))
    triangles = np.where(inside[:, None], copy[eyes.triangles], eyes.triangles).astype(np.int32)
    surface = Surface(
        "eyes", np.append(eyes.vertex, eyes.vertex[rim]), np.vstack([eyes.uv, eyes.uv[rim]]), triangles, None
    )
    iris = np.zeros(len(surface.vertex), dtype=np.bool_)
    iris[triangles[inside]] = True
    return surface, iris


def eyes_with_depth(clone: Clone, normals: Array) -> tuple[Surface, Clone, Array]:
    """Return the eyes' surface, a clone that has them right in vertices and targets, and (W, 3) normals.

    Parameters
    ----------
    clone : Clone
    normals : (V, 3)
        Of its vertices.
    """
    surface, iris = creased_eyes()
    lit = normals[surface.vertex]
    lit[iris] = cornea_normals(clone, normals)[surface.vertex[iris]]
    return surface, with_flat_irises(clone), lit


def with_flat_irises(clone: Clone) -> Clone:
    """Return the clone whose irises lie flat at their rims; the targets that turn eyeballs turn them along."""
    vertices, delta = clone.vertices_m.copy(), clone.morph_delta_m.copy()
    for eye in fronts():
        middle, gaze, _ = eye.frame(vertices)
        vertices[eye.front] -= ((vertices[eye.front] - middle) @ gaze)[:, None] * gaze
        entries = np.flatnonzero(np.isin(clone.morph_index, eye.ball))
        target = np.searchsorted(clone.morph_start, entries, side="right")
        for one in np.unique(target):
            rows = entries[target == one]
            ball = clone.morph_index[rows]
            spokes = clone.vertices_m[ball] - middle
            turn = np.linalg.lstsq(np.column_stack([spokes, np.ones(len(rows))]), delta[rows], rcond=None)[0]
            delta[rows] += ((vertices[ball] - clone.vertices_m[ball]) @ turn[:3]).astype(np.float32)
    return replace(clone, vertices_m=vertices, morph_delta_m=delta)


def cornea_normals(clone: Clone, normals: Array) -> Array:
    """Return the (V, 3) normals of a clone's skin with those of round corneas at the fronts of its eyes."""
    out = normals.copy()
    for eye in fronts():
        middle, gaze, radius = eye.frame(clone.vertices_m)
        aside = clone.vertices_m[eye.front] - middle
        aside -= (aside @ gaze)[:, None] * gaze
        lean = np.arcsin(np.clip(np.linalg.norm(aside, axis=1) / radius * IRIS_M / CORNEA_M, 0.0, 1.0))
        out[eye.front] = np.cos(lean)[:, None] * gaze + np.sin(lean)[:, None] * unit(aside)
    return out
