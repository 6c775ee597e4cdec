"""One Bézier curve per individual from where the spot comes in sight to the spot: alike in a group, never two equal.

[S] One curve a person and goal, kept only until it is used. Before the spot is in sight the way is the field's.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour import dice
from cloner.behaviour.dice import purpose
from cloner.behaviour.ground import RAY_BODY_M, Array, Indices
from cloner.behaviour.world import World

#: The control point lies aside of the middle by up to this share of the way; a tenth bends a way by a twentieth; taste.
ASIDE: Final = 0.2
#: How strongly one comes back to the own curve, 1/m, and from where on one walks straight to the spot, m.
BACK: Final = 0.5
STRAIGHT_M: Final = 1.0


def begin_curves(world: World, who: Indices) -> None:
    """Give people curves from where they are to their spots: bent to a side of their own where there is room for it."""
    if not len(who):
        return
    start, end = world.bodies.place[who], world.people.target[who]
    along = end - start
    share = dice.uniform(world.seed, purpose("curve", world.steps), who)
    share = (2.0 * share - 1.0) * ASIDE
    middle = (start + end) / 2.0
    control = middle + share[:, None] * np.stack([-along[:, 1], along[:, 0]], axis=1)
    room = world.ground.stands(control)
    room &= world.ground.sees(start, control, RAY_BODY_M) & world.ground.sees(control, end, RAY_BODY_M)
    world.people.curve[who, 0] = start
    world.people.curve[who, 1] = np.where(room[:, None], control, middle)


def along_curves(world: World, who: Indices) -> Array:
    """Return the direction of each person on the own curve, (m, 2) unit vectors."""
    place, end = world.bodies.place[who], world.people.target[who]
    start, control = world.people.curve[who, 0], world.people.curve[who, 1]
    whole, left = end - start, end - place
    length = np.sqrt(whole[:, 0] * whole[:, 0] + whole[:, 1] * whole[:, 1])
    far = np.sqrt(left[:, 0] * left[:, 0] + left[:, 1] * left[:, 1])
    u = np.clip(1.0 - far / np.maximum(length, 1e-9), 0.0, 1.0)[:, None]
    at = (1.0 - u) * (1.0 - u) * start + 2.0 * u * (1.0 - u) * control + u * u * end
    tangent = (1.0 - u) * (control - start) + u * (end - control)
    size = np.sqrt(tangent[:, 0] * tangent[:, 0] + tangent[:, 1] * tangent[:, 1])
    way = tangent / np.maximum(size, 1e-9)[:, None] + BACK * (at - place)
    way = np.where((far < STRAIGHT_M)[:, None] | (far > length)[:, None], left, way)
    size = np.sqrt(way[:, 0] * way[:, 0] + way[:, 1] * way[:, 1])
    return np.asarray(way / np.maximum(size, 1e-9)[:, None])
