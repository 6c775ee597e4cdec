"""Initial placement of pieces around the body: close without contact, seams beside each other.

A garment hangs from a ring: the convex hull of the body's slice at its level, as a tape would lie. A piece's points
keep their distance from its upper edge and go outward as its hem is longer than that; seams go half-way between
both pieces.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, cKDTree

from cloner.cloth.drafting.cut import Cloth
from cloner.cloth.drafting.pattern import Pattern, evenly_spaced, length_m
from cloner.cloth.drafting.sections import convex_ring, girth_of, offset_ring
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.measurement.measures import UP, slice_points
from cloner.geometry.meshes.vectors import unit
from cloner.records.arrays import Array
from cloner.records.clones import Clone

Ints = NDArray[np.int64]

#: The ring lies this far outside the skin, metres.
OUTSIDE_M: Final = 0.006
#: What opens in front gapes so far at the ring, metres: its edges neither cross nor catch.
OPEN_M: Final = 0.02
#: No piece is placed flatter than this, radians from upright: what is wider lies in folds.
FLATTEST: Final = 1.2
TOP, HEM = "top", "hem"
#: Places along an upper edge.
RING: Final = 720


@dataclass(frozen=True, slots=True, eq=False)
class Ring:
    """The ring that a garment hangs from, in rest pose.

    Attributes
    ----------
    points_m : (S + 1, 3) float64
        Evenly round the body from the middle of the front to the person's left and on; the last is the first.
    girth_m : float
    """

    points_m: Array
    girth_m: float

    def at(self, share: Array) -> Array:
        """Return (N, 3) points at shares of the ring's length."""
        way = np.mod(share, 1.0) * (len(self.points_m) - 1)
        return np.column_stack([np.interp(way, np.arange(len(self.points_m)), self.points_m[:, k]) for k in range(3)])


def body_ring(clone: Clone, level: str) -> Ring:
    """Return the ring around a clone's skin, clothes included, at a level of the tape's rules."""
    rules = load_tape_rules()
    height = float(clone.vertices_m[list(rules.level_vertices[level]), 1].mean())
    points = slice_points(clone.vertices_m, rules.torso, np.array([0.0, height, 0.0]), UP)[:, [0, 2]]
    fine = offset_ring(convex_ring(points), OUTSIDE_M)
    return Ring(np.column_stack([fine[:, 0], np.full(len(fine), height), fine[:, 1]]), girth_of(fine))


def place_around(pattern: Pattern, cloth: Cloth, ring: Ring) -> tuple[Array, Ints, Array]:
    """Return positions (N, 3) of a garment's vertices around the body at rest, the held vertices, and their positions.

    Raises
    ------
    ClonerError
        If a piece has no upper edge to hang from.
    """
    tops = []
    for segment in pattern.segments:
        if TOP not in segment.edges or HEM not in segment.edges:
            hint = f"Name the edge at the ring {TOP!r} and the lowest one {HEM!r}"
            raise ClonerError(f"the piece {segment.name!r} has no edge to hang from", hint, pattern.name)
        tops.append(length_m(segment.edges[TOP]))
    shares = np.array(tops) / sum(tops)
    middles = np.cumsum(shares) - shares / 2.0 - shares[0] / 2.0
    is_open = len(pattern.seams) < len(tops)
    if is_open:
        middles += shares[0] / 2.0  # what is not sewn all round opens in front
    points = np.zeros((len(cloth.flat_m), 3))
    centre = ring.points_m.mean(axis=0)
    for number, segment in enumerate(pattern.segments):
        own = np.flatnonzero(cloth.segment == number)
        line = evenly_spaced(segment.edges[TOP], RING)
        down, near = cKDTree(line).query(cloth.flat_m[own])
        way = middles[number] + shares[number] * (0.5 - near / RING)
        if is_open:
            way = 0.5 + (way - 0.5) * (1.0 - OPEN_M / ring.girth_m)
        base = ring.at(way)
        length = max(float(down.max()), 1e-6)
        wider = (length_m(segment.edges[HEM]) - tops[number]) / shares[number] / (2.0 * np.pi * length)
        lean = float(np.clip(np.arcsin(np.clip(wider, -0.9, 1.0)), -0.5, FLATTEST))
        outward = (base - centre) * [1.0, 0.0, 1.0]
        outward = unit(outward)
        points[own] = base + down[:, None] * (np.sin(lean) * outward - np.cos(lean) * UP)
    places = cloth.seam_means(points)
    held = np.unique(cloth.vertex[np.concatenate([cloth.edges[f"{s.name}.{TOP}"] for s in pattern.segments])])
    return places, held, places[held]


@dataclass(frozen=True, slots=True, eq=False)
class HeldBand:
    """The held vertices, carried by the skin under them.

    Attributes
    ----------
    clone : Clone
    places_m : (P, 3) float64, rest pose
    joints : (P, 4) int32, weights : (P, 4) float64
    """

    clone: Clone
    places_m: Array
    joints: NDArray[np.int32]
    weights: Array

    def posed(self, root_m: Array, rotations: Array) -> Array:
        """Return the held positions (P, 3) in a frame."""
        parents = load_generic().joint_parents.astype(np.int32)
        transforms = joint_transforms(self.clone.joints_m, parents, rotations)
        return linear_blend_skinning(self.places_m, transforms, self.joints, self.weights) + root_m


def make_band(clone: Clone, places_m: Array, rows: Ints) -> HeldBand:
    """Return held positions carried by the nearest skin vertex of ``rows``."""
    generic = load_generic()
    _, near = cKDTree(clone.vertices_m[rows]).query(places_m)
    skin_rows = rows[near]
    joints, weights = generic.skin_joints[skin_rows].astype(np.int32), generic.skin_weights[skin_rows]
    return HeldBand(clone, places_m, joints, weights.astype(np.float64))


def push_outside(places_m: Array, skin_m: Array, held: Ints) -> Array:
    """Return positions pushed straight outward until they clear the hull of the body's sections at their heights."""
    out = places_m.copy()
    free = np.ones(len(places_m), dtype=bool)
    free[held] = False
    heights = np.arange(float(places_m[:, 1].min()) - 0.02, float(places_m[:, 1].max()), 0.02)
    for height in heights:
        rows = np.flatnonzero(free & (places_m[:, 1] >= height) & (places_m[:, 1] < height + 0.02))
        near = skin_m[np.abs(skin_m[:, 1] - height - 0.01) < 0.03][:, [0, 2]]
        if not len(rows) or len(near) < 3:
            continue
        hull = ConvexHull(near)
        sides, middle = hull.equations, near.mean(axis=0)
        away = out[rows][:, [0, 2]] - middle
        # Along each ray from the middle: how far the hull reaches.
        direction = unit(away)
        rise = direction @ sides[:, :2].T
        room = -(sides[:, 2] + middle @ sides[:, :2].T)
        reach = np.where(rise > 1e-9, room / np.maximum(rise, 1e-9), np.inf).min(axis=1) + OUTSIDE_M
        longer = np.maximum(np.linalg.norm(away, axis=1), reach)
        out[rows, 0], out[rows, 2] = (middle + longer[:, None] * direction).T
    return out
