"""Group behaviour 4, attraction: people gather in a region, spread by density, and look where they are told to look."""

from __future__ import annotations

import numpy as np

from cloner.behaviour.dice import Indices
from cloner.behaviour.world import World


def attract(world: World, level: int, who: Indices, place: int, seconds: float) -> None:
    """Send people to a region, to stand all over it, facing what the point says, until the time is over."""
    orders, point = world.orders, world.places[place]
    orders.give(level, "goal", who, place)
    channels: tuple[str, ...] = ("goal",)
    if point.look_at >= 0:
        orders.give(level, "gaze", who, point.look_at)
        channels = ("goal", "gaze")
    world.bodies.settled[who] = False
    world.bodies.goal[who] = -1  # the spot is chosen anew: all over the region
    if seconds:
        world.expiring.append((world.time_s + seconds, level, who.copy(), channels))


def gathered(world: World, place: int) -> Indices:
    """Return who stands in a region."""
    from cloner.behaviour.ground import inside

    return np.flatnonzero(world.bodies.present & inside(world.bodies.place, world.places[place].corners))
