"""People controlled from outside: seen, avoided and reacted to, but not moved by the engine.

A scenario says how many may come: ``crowd 4 guests: from outside``.
"""

from __future__ import annotations

from cloner.behaviour.tables import FLAGS
from cloner.behaviour.world import World

_OUTSIDE = 1 << FLAGS.index("outside")


def free_guest(world: World) -> int:
    """Return whose place somebody from outside may take, -1 where all are taken."""
    return int(world.core.call("freeGuest"))


def receive(world: World, who: int, place: tuple[float, float], facing: tuple[float, float]) -> None:
    """Let a guest come, or go on, to a place on the floor, and look somewhere; who stands in a wall is not heard.

    Parameters
    ----------
    world : World
    who : int
        As of :func:`free_guest`.
    place, facing : (2,)
        Metres on the plan, and a unit direction.
    """
    world.hear("come", who, *place, *facing)


def leave(world: World, who: int) -> None:
    """Let a guest be gone."""
    if who >= 0:
        world.hear("depart", who)


def guests(world: World) -> int:
    """Return the number of guests."""
    outside = world.core.arrays["home_flags"][world.people.home] & _OUTSIDE
    return int((world.bodies.present & (outside != 0)).sum())
