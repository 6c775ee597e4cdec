"""A plan as surfaces: panels that are drawn and lit, and quads that block rays.

Frame of everything from here on: metres, X to the right, Y up, Z towards the viewer; the plan's y is -Z. A *panel* is a
flat rectangle with holes; all level faces that touch in one plane are one panel, so that no light map has a seam in
a flat surface.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.records.arrays import Array
from cloner.scenes.building.looks import LOOKS, Look, procedural_look
from cloner.scenes.building.pieces import (
    Quad,
    axes_of,
    block_quads,
    box_face,
    box_faces,
    flipped,
    is_axis_aligned,
    make_box,
    pillar_quads,
    vault_quads,
    wall_boxes,
    wall_openings,
    wall_quads,
)
from cloner.scenes.building.plan import LARGEST, Ceiling, Plan, Vault

Rect = tuple[float, float, float, float]

#: Slabs of ceilings and vaults, metres.
SLAB_M: Final = 0.3
_TOUCH: Final = 1e-6
#: Faces are looked at in so many places each way: what hangs before a wall hides its middle.
LOOKED_AT: Final = 7


@dataclass(frozen=True, eq=False)
class Panel:
    """A flat part of the room that has light-map texels.

    Attributes
    ----------
    corner, along, up : (3,)
        Where u = v = 0 lies; unit axes. The normal is ``along x up``.
    size : (2,) metres
    parts : (u0, v0, u1, v1) metres and look of what is really there
    """

    corner: Array
    along: Array
    up: Array
    size: tuple[float, float]
    parts: list[tuple[Rect, str]] = field(default_factory=list)

    @cached_property
    def normal(self) -> Array:
        """The unit normal."""
        return np.asarray(np.cross(self.along, self.up))

    def at(self, u: Array, v: Array) -> Array:
        """Return (..., 3) points of panel coordinates in metres."""
        return np.asarray(self.corner + u[..., None] * self.along + v[..., None] * self.up)


@dataclass(frozen=True, slots=True, eq=False)
class Room:
    """The geometry of a plan.

    Attributes
    ----------
    panels : what is drawn
    stops : all that stops rays, drawn or not; one-sided, solids are closed
    boxes : (B, 2, 3) lowest and highest corners of solids, to tell what is inside one
    portals : openings to the sky, facing the room
    looks : what the surfaces look like, by name
    """

    plan: Plan
    panels: tuple[Panel, ...]
    stops: tuple[Quad, ...]
    boxes: Array
    portals: tuple[Quad, ...]
    looks: Mapping[str, Look]


def build_room(plan: Plan, photos: Mapping[str, Look] = MappingProxyType({})) -> Room:
    """Return the surfaces of a plan whose photos have been rectified (`photos.read_plan_photos`)."""
    quads: list[Quad] = []
    boxes: list[Array] = []
    slants: list[Quad] = []
    roofs: list[Quad] = []
    for wall in plan.walls:
        quads += wall_quads(wall)
        boxes += wall_boxes(wall)
    for block in plan.blocks:
        made, inside = pillar_quads(block) if block.pillar else block_quads(block)
        quads += [one for one in made if is_axis_aligned(one)]
        slants += [one for one in made if not is_axis_aligned(one)]
        boxes += inside
    for ceiling in plan.ceilings:
        box = make_box(ceiling.low, ceiling.high, ceiling.at, ceiling.at + SLAB_M)
        faces = box_faces(box, ceiling.look)
        quads.append(faces.pop(2))
        roofs += faces
        boxes.append(box)
    for vault in plan.vaults:
        slants += vault_quads(vault.low, vault.high, vault.spring, vault.rise, vault.look)
    ground = [box_faces(make_box(one.low, one.high, -SLAB_M, 0.0), one.look)[3] for one in plan.floors]
    held = np.array(boxes).reshape(-1, 2, 3)
    shown = [one for one in [*quads, *slants] if _is_visible(one, plan, held)]
    panels = _merged([*ground, *(one for one in shown if is_axis_aligned(one))])
    panels += [_alone(one) for one in shown if not is_axis_aligned(one)]
    both = [Quad(one.corner + one.along, -one.along, one.up, one.look) for one in slants if _is_vault(one)]
    looks = {name: procedural_look(name) for name in LOOKS} | dict(photos)
    return Room(plan, tuple(panels), (*ground, *quads, *slants, *both, *roofs), held, _portals(plan), looks)


def inside_solids(places: Array, boxes: Array, slack: float = 1e-6) -> NDArray[np.bool_]:
    """Return which of (N, 3) points lie in a solid."""
    found = np.zeros(len(places), bool)
    for low, high in boxes:
        found |= ((places > low + slack) & (places < high - slack)).all(axis=1)
    return found


def is_roofed(plan: Plan, x: Array, y: Array) -> NDArray[np.bool_]:
    """Return which points of the plan have a ceiling or a vault above."""
    found = np.zeros(np.shape(x), bool)
    roofs: tuple[Ceiling | Vault, ...] = (*plan.ceilings, *plan.vaults)
    for one in roofs:
        found |= (x > one.low[0]) & (x < one.high[0]) & (y > one.low[1]) & (y < one.high[1])
    return found


def _is_vault(quad: Quad) -> bool:
    """Return whether a quad belongs to a vault: visible from below only, but blocking rays from above too."""
    return bool(quad.normal[1] < -1e-9)


def _is_visible(quad: Quad, plan: Plan, boxes: Array) -> bool:
    """Return whether a face can be seen from a floor: some of it faces free space over a floor, or a door."""
    share = np.stack(np.meshgrid(*[(np.arange(LOOKED_AT) + 0.5) / LOOKED_AT] * 2), axis=-1).reshape(-1, 2)
    front = quad.corner + share[:, :1] * quad.along + share[:, 1:] * quad.up + quad.normal * 0.02
    front = front[front[:, 1] > 0.0]
    front = front[~inside_solids(front, boxes)]
    free = [box for wall in plan.walls for box in wall_openings(wall)[1]]
    free += [make_box(one.low, one.high, 0.0, LARGEST) for one in plan.floors]
    return any(((front >= low - _TOUCH) & (front <= high + _TOUCH)).all(axis=1).any() for low, high in free)


def _alone(quad: Quad) -> Panel:
    size = (float(np.linalg.norm(quad.along)), float(np.linalg.norm(quad.up)))
    return Panel(
        quad.corner, quad.along / size[0], quad.up / size[1], size, [((0.0, 0.0, size[0], size[1]), quad.look)]
    )


def _merged(quads: list[Quad]) -> list[Panel]:
    """Return panels of axis-aligned faces: faces in one plane that share a border are merged."""
    planes: dict[tuple[float, ...], list[Quad]] = defaultdict(list)
    for quad in quads:
        normal = quad.normal
        planes[(*np.round(normal).tolist(), round(float(normal @ quad.corner), 5))].append(quad)
    panels = []
    for held in planes.values():
        along, up = axes_of(held[0].normal)
        rects = np.array([[one.corner @ along, one.corner @ up, (one.corner + one.along) @ along,
                           (one.corner + one.up) @ up] for one in held])  # fmt: skip
        for members in _touching(rects):
            low = rects[members][:, :2].min(axis=0)
            size = rects[members][:, 2:].max(axis=0) - low
            normal = held[0].normal
            corner = normal * (normal @ held[0].corner) + along * low[0] + up * low[1]
            parts = [(tuple((rects[k] - np.tile(low, 2)).tolist()), held[k].look) for k in members]
            panels.append(Panel(corner, along, up, (float(size[0]), float(size[1])), parts))
    return panels


def _touching(rects: Array) -> list[list[int]]:
    """Return groups of rectangles that share more than a corner."""
    left, groups = set(range(len(rects))), []
    while left:
        group, edge = [], [left.pop()]
        while edge:
            one = edge.pop()
            group.append(one)
            wide = np.minimum(rects[:, 2:], rects[one, 2:]) - np.maximum(rects[:, :2], rects[one, :2])
            near = (wide > -_TOUCH).all(axis=1) & (wide > _TOUCH).any(axis=1)
            for k in [k for k in np.flatnonzero(near).tolist() if k in left]:
                left.discard(k)
                edge.append(k)
        groups.append(sorted(group))
    return groups


def _portals(plan: Plan) -> tuple[Quad, ...]:
    """Return the openings between roofed and open parts, on their outer side, facing the room."""
    found = []
    for wall in plan.walls:
        long, holes = wall_openings(wall)
        thin = 2 - long
        for hole in holes:
            outs = []
            for side in (0, 1):
                place = hole.mean(axis=0)
                place[thin] = hole[side, thin] + (0.5 if side else -0.5)
                outs.append(not is_roofed(plan, place[:1], -place[2:])[0])
            if outs[0] != outs[1]:
                found.append(flipped(box_face(hole, thin, 0 if outs[0] else 1, wall.look)))
    return tuple(found)
