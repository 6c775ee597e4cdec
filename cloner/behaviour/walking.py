"""Locomotion: the engine's rows of bodies (`core/`), advanced by .05 s with each call of `walk`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.core.host import CrowdEngine
from cloner.behaviour.ground import BODY_M, Ground, Mask
from cloner.records.arrays import Array

#: Seconds of one step of the engine, which counts in it (core/memory.ts), and frames a second of files and feet.
STEP_S: Final = 0.05
RATE_HZ: Final = 10
#: Goals that are no place: none, and a direction that is given in `Bodies.way`.
NOWHERE, GIVEN = -1, -2


@dataclass(slots=True, eq=False)
class Bodies:
    """Positions and goals of everybody in the engine's own memory, one row per person.

    ``place, velocity`` (n, 2) m, m/s; ``radius`` m; ``way`` (n, 2) unit direction to the goal, zero to stand, set by
    the core unless ``goal`` is `GIVEN`; ``wants`` m/s, the speed on a free way, and ``own_speed`` what is left of it
    before a spot; ``goal`` a place's number; ``spotted`` whether one goes to a spot there, ``target`` (n, 2), or just
    into its region; ``settled`` whether one has arrived, ``direct`` whether the spot is in sight, ``slow`` for how
    many steps one stands near it; ``wanders``; ``facing`` (n, 2); ``looks`` whether one looks at ``look`` (n, 2) when
    one stands; ``avoids`` whether collisions are avoided; ``present`` whether the person is in the world.
    """

    core: CrowdEngine
    place: Array
    velocity: Array
    way: Array
    wants: Array
    own_speed: Array
    radius: Array
    target: Array
    facing: Array
    look: Array
    goal: NDArray[np.int32]
    present: Mask
    avoids: Mask
    spotted: Mask
    settled: Mask
    direct: Mask
    slow: NDArray[np.int32]
    wanders: Mask
    looks: Mask

    def lead(self, place: int, region: Mask) -> None:
        """Compute the paths to a place, a region of cells (rows, cols), before anyone goes there."""
        self.core.arrays["regions"][place] = region
        self.core.call("lead", place)


def make_bodies(ground: Ground, place: Array, *, places: int = 0, seed: int = 0, period_m: float = 0.0) -> Bodies:
    """Return people standing on a ground at points (n, 2), without goals, in a world with some number of destinations.

    With a period the world repeats along x: a corridor is a ring.
    """
    rows, cols, reach = ground.near.shape
    counts = {"people": len(place), "rows": rows, "cols": cols, "walls": len(ground.walls), "reach": reach,
              "places": places}  # fmt: skip
    core = CrowdEngine(counts, (float(ground.low[0]), float(ground.low[1])), period_m=period_m, seed=seed)
    return engine_bodies(core, ground, place)


def engine_bodies(core: CrowdEngine, ground: Ground, place: Array) -> Bodies:
    """Return the people of a new engine, who stand on its ground at points (n, 2)."""
    core.arrays["clear"][:], core.arrays["walls"][:] = ground.clear, ground.walls
    core.arrays["near"][:] = ground.near
    core.call("ready")
    bodies = Bodies(core, **{name: core.arrays[name] for name in Bodies.__slots__ if name != "core"})
    bodies.place[:] = bodies.target[:] = place
    bodies.radius[:] = BODY_M
    bodies.goal[:] = NOWHERE
    bodies.present[:] = bodies.avoids[:] = bodies.settled[:] = True
    bodies.facing[:, 0] = 1.0
    return bodies


def walk(bodies: Bodies) -> None:
    """Advance everybody by one step of `STEP_S`."""
    bodies.core.call("step")
