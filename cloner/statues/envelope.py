"""A body fitted to the surface of its blobs along the normals of the standard skin, so that it stays rigged."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.generic.charts import person_graph
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.surfaces import load_triangles
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.arrays import Array
from cloner.statues.blobs import LEVEL, Field

#: Parts that are attached to the envelope as they are.
KEPT: Final = ("head", "left_hand", "right_hand", "left_foot", "right_foot")
#: Rays along the skin's normals begin so deep, shares of the way to the bone, and end so far outside, metres; at so
#: many places.
DEPTH, OUTSIDE_M, PLACES = 0.8, 0.18, 48
#: Where the skin leans away from the bone, rays begin no less deep than for this cosine.
LEANING: Final = 0.25
HALVINGS: Final = 18
#: Rounds over which normals are averaged: rays of neighbours do not cross.
ROUNDS: Final = 6
#: Stiffness of the skin beside a vertex whose ray met the surface, and how much kept parts pull; taste: an edge or two.
STIFF, HELD = 0.25, 20.0


@dataclass(frozen=True, slots=True, eq=False)
class Envelope:
    """A body on its blobs.

    Attributes
    ----------
    vertices_m : (V, 3)
    off_m : (V,)
        How far the skin lies from the blobs' surface, metres; nan for kept parts and where no ray met it.
    missed : int
        Vertices whose rays met no surface: they follow their neighbours.
    asked : int
        Vertices that should have met one.
    """

    vertices_m: Array
    off_m: Array
    missed: int
    asked: int


def fit_to_blobs(vertices_m: Array, joints_m: Array, field: Field) -> Envelope:
    """Return a body (V, 3) with joints (94, 3) fitted to the surface of blobs; head, hands and feet stay attached."""
    generic, graph = load_generic(), person_graph(load_generic(), vertices_m)
    kept, bone = _kept(generic), vertices_m - _axes(generic, vertices_m, joints_m)
    body = generic.skin & (kept < 1.0)
    normals = graph.smooth(vertex_normals(vertices_m, load_triangles()), ROUNDS)
    normals = unit(normals)
    away = np.maximum(np.linalg.norm(bone, axis=1), 1e-6)
    depth = DEPTH * away * np.maximum(np.einsum("va,va->v", bone, normals) / away, LEANING)
    rows, shift = np.flatnonzero(body), np.full(len(vertices_m), np.nan)
    shift[rows] = _met(field, vertices_m[rows], normals[rows], depth[rows])
    met = np.isfinite(shift)
    weight = np.where(body, met.astype(np.float64) + HELD * kept**2, HELD)
    filled = graph.fill(((1.0 - kept) * np.where(met, shift, 0.0))[:, None], weight, STIFF)[:, 0]
    filled[~body] = 0.0
    off = np.where(met & (kept == 0.0), filled - shift, np.nan)
    return Envelope(vertices_m + filled[:, None] * normals, off, int((body & ~met).sum()), int(body.sum()))


def _kept(generic: GenericHuman) -> Array:
    """Return the weight (V,) of each vertex in parts that stay as they are."""
    return np.asarray(np.clip(np.maximum(generic.share(*KEPT[1:]), generic.head_blend), 0.0, 1.0))


def _axes(generic: GenericHuman, vertices_m: Array, joints_m: Array) -> Array:
    """Return (V, 3) the place on the bones from which each vertex is seen: the nearest of its segments' axes, mixed."""
    total, place = np.zeros(len(vertices_m)), np.zeros_like(vertices_m)
    for number, (first, last) in enumerate(generic.slice_axis_joints):
        if first < 0:
            continue
        share = generic.segment_weights[:, number].astype(np.float64)
        direction = joints_m[last] - joints_m[first]
        along = np.clip((vertices_m - joints_m[first]) @ direction / float(direction @ direction), 0.0, 1.0)
        place += share[:, None] * (joints_m[first] + along[:, None] * direction)
        total += share
    return np.asarray(np.where(total[:, None] > 0.0, place / np.maximum(total, 1e-9)[:, None], vertices_m))


def _met(field: Field, skin_m: Array, normals: Array, depth_m: Array) -> Array:
    """Return (N,) metres along normals (N, 3) at which rays from inside leave the blobs first; nan for none."""
    steps = np.linspace(0.0, 1.0, PLACES)
    along = -depth_m + steps[:, None] * (depth_m + OUTSIDE_M)
    inside = np.stack([field.at(skin_m + each[:, None] * normals) >= LEVEL for each in along])
    leaves = inside[:-1] & ~inside[1:]
    first, rows = leaves.argmax(axis=0), np.arange(len(skin_m))
    low, high = along[first, rows], along[first + 1, rows]
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        within = field.at(skin_m + middle[:, None] * normals) >= LEVEL
        low, high = np.where(within, middle, low), np.where(within, high, middle)
    return np.where(leaves.any(axis=0), 0.5 * (low + high), np.nan)
