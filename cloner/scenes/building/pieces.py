"""Walls, pillars, blocks and vaults as rectangles, and as boxes for collision.

Frame: metres, X to the right, Y up, Z towards the viewer; the plan's y is -Z.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Final

import numpy as np

from cloner.records.arrays import Array
from cloner.scenes.building.plan import Block, Wall

#: A pillar's shaft against its footprint; heights of base and capital, metres: taste.
SHAFT: Final = 0.78
BASE_M, CAPITAL_M = 0.35, 0.3
SIDES, STRIPS = 8, 12


@dataclass(frozen=True, eq=False)
class Quad:
    """A rectangle: corner (3,), edges along and up (3,) metres, unit normal ``along x up`` (3,), and its look."""

    corner: Array
    along: Array
    up: Array
    look: str

    @cached_property
    def normal(self) -> Array:
        """The unit normal."""
        n = np.cross(self.along, self.up)
        return np.asarray(n / np.linalg.norm(n))

    def middle(self) -> Array:
        """Return the centre."""
        return np.asarray(self.corner + (self.along + self.up) / 2.0)


def from_plan(x: float, y: float, height: float = 0.0) -> Array:
    """Return a point of the plan as a point in space."""
    return np.array([x, height, -y])


def make_box(low: tuple[float, float], high: tuple[float, float], bottom: float, top: float) -> Array:
    """Return the (2, 3) lowest and highest corners of a box over a rectangle of the plan."""
    return np.array([[low[0], bottom, -high[1]], [high[0], top, -low[1]]])


def axes_of(normal: Array) -> tuple[Array, Array]:
    """Return a face's axes: up is vertical, or the plan's up on horizontal faces."""
    up = np.array([0.0, 1.0, 0.0]) if abs(normal[1]) < 0.5 else np.array([0.0, 0.0, -1.0])
    return np.cross(up, normal), up


def box_face(box: Array, axis: int, side: int, look: str) -> Quad:
    """Return a box's face: the lower (0) or upper (1) along an axis."""
    normal = np.zeros(3)
    normal[axis] = 1.0 if side else -1.0
    along, up = axes_of(normal)
    corner = np.where(along + up >= 0.0, box[0], box[1])
    corner[axis] = box[side, axis]
    size = box[1] - box[0]
    return Quad(corner, along * abs(float(along @ size)), up * abs(float(up @ size)), look)


def box_faces(box: Array, look: str) -> list[Quad]:
    """Return a box's -X, +X, -Y, +Y, -Z and +Z faces."""
    return [box_face(box, axis, side, look) for axis in range(3) for side in (0, 1)]


def wall_openings(wall: Wall) -> tuple[int, list[Array]]:
    """Return the wall's long axis in space, and its openings as boxes."""
    long = 0 if wall.high[0] - wall.low[0] >= wall.high[1] - wall.low[1] else 1
    made = []
    for hole in wall.openings:
        low, high = list(wall.low), list(wall.high)
        low[long], high[long] = hole.at - hole.wide / 2.0, hole.at + hole.wide / 2.0
        made.append(make_box((low[0], low[1]), (high[0], high[1]), hole.low, hole.high))
    return (0 if long == 0 else 2), made


def wall_quads(wall: Wall) -> list[Quad]:
    """Return a wall's faces: both sides with holes, and the insides of its openings."""
    box = make_box(wall.low, wall.high, 0.0, wall.height)
    long, holes = wall_openings(wall)
    thin = 2 - long
    found = [box_face(box, axis, side, wall.look) for axis in (long, 1) for side in (0, 1)]
    cuts = [np.unique([box[:, k], *(hole[:, k] for hole in holes)]) for k in range(3)]
    for first, last in zip(cuts[long][:-1], cuts[long][1:], strict=True):
        for low, high in zip(cuts[1][:-1], cuts[1][1:], strict=True):
            part = box.copy()
            part[:, long], part[:, 1] = (first, last), (low, high)
            middle = part.mean(axis=0)
            if not any(((middle > hole[0]) & (middle < hole[1])).all() for hole in holes):
                found += [box_face(part, thin, side, wall.look) for side in (0, 1)]
    for hole in holes:
        for axis in (long, 1):
            for side in (0, 1):
                if not (axis == 1 and side == 0 and hole[0, 1] <= 0.0):
                    found.append(flipped(box_face(hole, axis, side, wall.look)))
    return found


def flipped(quad: Quad) -> Quad:
    """Return a face with the opposite normal and matching axes."""
    along, up = axes_of(-quad.normal)
    far = quad.corner + quad.along + quad.up
    low, high = np.minimum(quad.corner, far), np.maximum(quad.corner, far)
    size = high - low
    corner = np.where(along + up >= 0.0, low, high)
    return Quad(corner, along * abs(float(along @ size)), up * abs(float(up @ size)), quad.look)


def wall_boxes(wall: Wall) -> list[Array]:
    """Return a wall as solid boxes around its openings."""
    box = make_box(wall.low, wall.high, 0.0, wall.height)
    long, holes = wall_openings(wall)
    cuts = np.unique([box[:, long], *(hole[:, long] for hole in holes)])
    found = []
    for first, last in pairwise(cuts):
        middle = (first + last) / 2.0
        taken = sorted((hole[0, 1], hole[1, 1]) for hole in holes if hole[0, long] < middle < hole[1, long])
        level = 0.0
        for low, high in [*taken, (wall.height, wall.height)]:
            if low > level:
                part = box.copy()
                part[:, long], part[:, 1] = (first, last), (level, low)
                found.append(part)
            level = high
    return found


def block_quads(block: Block) -> tuple[list[Quad], list[Array]]:
    """Return a block's faces and its solid box."""
    half = np.array(block.size) / 2.0
    low, high = np.array(block.at) - half, np.array(block.at) + half
    box = make_box((low[0], low[1]), (high[0], high[1]), block.low, block.high)
    return box_faces(box, block.look), [box]


def pillar_quads(block: Block) -> tuple[list[Quad], list[Array]]:
    """Return an eight-sided shaft between a base and a capital."""
    half = np.array(block.size) / 2.0
    low, high = tuple(np.array(block.at) - half), tuple(np.array(block.at) + half)
    base = make_box(low, high, block.low, block.low + BASE_M)
    capital = make_box(low, high, block.high - CAPITAL_M, block.high)
    bottom, top = block.low + BASE_M, block.high - CAPITAL_M
    core = half * SHAFT * np.sqrt(0.5)  # a square inside the eight sides
    shaft = make_box(tuple(np.array(block.at) - core), tuple(np.array(block.at) + core), bottom, top)
    angles = 2.0 * np.pi * (np.arange(SIDES) + 0.5) / SIDES
    out = half * SHAFT / np.cos(np.pi / SIDES)
    ring = [from_plan(block.at[0] + out[0] * np.cos(a), block.at[1] + out[1] * np.sin(a), bottom) for a in angles]
    up = np.array([0.0, top - bottom, 0.0])
    sides = [Quad(one, other - one, up, block.look) for one, other in zip(ring, ring[1:] + ring[:1], strict=True)]
    return [*box_faces(base, block.look), *box_faces(capital, block.look), *sides], [base, capital, shaft]


def vault_quads(
    low: tuple[float, float], high: tuple[float, float], spring: float, rise: float, look: str
) -> list[Quad]:
    """Return the strips of a barrel vault along y, facing down."""
    angles = np.linspace(0.0, np.pi, STRIPS + 1)
    x = (low[0] + high[0]) / 2.0 - np.cos(angles) * (high[0] - low[0]) / 2.0
    y = spring + np.sin(angles) * rise
    along = np.array([0.0, 0.0, low[1] - high[1]])
    made = []
    for k in range(STRIPS):
        first, other = from_plan(x[k], low[1], y[k]), from_plan(x[k + 1], low[1], y[k + 1])
        made.append(Quad(other, along, first - other, look))
        if made[-1].normal[1] > 0.0:
            made[-1] = Quad(first, along, other - first, look)
    return made


def is_axis_aligned(quad: Quad) -> bool:
    """Return whether a face is perpendicular to an axis."""
    return bool(np.abs(quad.normal).max() > 1.0 - 1e-9)
