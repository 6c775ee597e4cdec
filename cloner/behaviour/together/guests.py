"""People from outside, as who walks along in a served page: seen, avoided and reacted to, but moved by nobody here.

A scenario says how many may come: ``crowd 4 guests: from outside``.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.behaviour.channels import GUIDED
from cloner.behaviour.walking import STEP_S
from cloner.behaviour.world import Guest, World

#: A guest whose page tells places twice a second walks between them, no faster than so, m/s: a run; taste. Who is
#: farther away than this, metres, is there at once.
FASTEST_M_S: Final = 4.0
JUMPS_M: Final = 4.0


def free_guest(world: World) -> int:
    """Return whose place somebody from outside may take, -1 where all are taken."""
    outside = np.array([group.outside for group in world.scenario.groups])[world.people.home]
    free = [one for one in np.flatnonzero(outside).tolist() if one not in world.guests]
    return free[0] if free else -1


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
    wanted = np.array(place, np.float64)
    if not world.ground.stands(wanted[None])[0]:
        return
    if who not in world.guests:
        world.guests[who] = Guest(wanted.copy(), wanted, np.array(facing))
        world.orders.give(GUIDED, "posture", who, world.acts.index("stand"))
        world.bodies.place[who] = wanted
        world.bodies.present[who] = True
    guest = world.guests[who]
    guest.wanted, guest.facing = wanted, np.array(facing)


def leave(world: World, who: int) -> None:
    """Let a guest be gone."""
    if world.guests.pop(who, None) is not None:
        world.bodies.present[who] = False


def keep(world: World) -> None:
    """Move guests by one step to where they are to be: nobody pushes them, and no order of the scenario moves them."""
    bodies = world.bodies
    for who, guest in world.guests.items():
        way = guest.wanted - guest.at
        far = float(np.hypot(*way))
        share = min(FASTEST_M_S * STEP_S / far, 1.0) if 0.0 < far < JUMPS_M else 1.0
        step = way * share
        guest.at = guest.at + step
        bodies.place[who] = guest.at
        bodies.velocity[who] = step / STEP_S if far < JUMPS_M else 0.0
        bodies.facing[who] = guest.facing
        bodies.present[who], world.people.leaving[who] = True, False
