"""People controlled from outside: seen, avoided and reacted to, but not moved by the engine.

A scenario says how many may come: ``crowd 4 guests: from outside``.
"""

from __future__ import annotations

from cloner.behaviour.tables import FLAGS
from cloner.behaviour.world import World

_OUTSIDE = 1 << FLAGS.index("outside")


def find_free_guest(world: World) -> int:
    """Return a guest that nobody controls, -1 if there is none."""
    return int(world.core.call("freeGuest"))


def move_guest(world: World, who: int, place: tuple[float, float], facing: tuple[float, float]) -> None:
    """Move a guest to a point on the floor with a heading; points inside walls are ignored.

    Parameters
    ----------
    world : World
    who : int
        As of :func:`find_free_guest`.
    place, facing : (2,)
        Metres on the plan, and a unit direction.
    """
    world.hear("come", who, *place, *facing)


def remove_guest(world: World, who: int) -> None:
    """Remove a guest."""
    if who >= 0:
        world.hear("depart", who)


def guest_count(world: World) -> int:
    """Return the number of guests."""
    outside = world.core.arrays["home_flags"][world.people.home] & _OUTSIDE
    return int((world.bodies.present & (outside != 0)).sum())
