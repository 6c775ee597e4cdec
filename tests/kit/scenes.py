"""Small scenarios for tests: a hall of 24 x 8 m with points at both ends and in the middle."""

from __future__ import annotations

import numpy as np

from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import step
from cloner.behaviour.world import World, make_world

HALL = """floor 0, 0 to 24, 8
statue lion at 12, 7.6
point west at 2, 4 region 3 x 6
point middle at 12, 4 region 4 x 6
point east at 22, 4 region 3 x 6
"""


def scene(text: str, seed: int = 1) -> World:
    """Return the world of the hall with more lines."""
    return make_world(parse_scenario(HALL + text), seed)


def pass_time(world: World, seconds: float) -> None:
    """Let the world go on for some seconds."""
    for _ in range(round(seconds * 20)):
        step(world)


def of(world: World, name: str) -> np.ndarray:
    """Return the people of one of the scenario's groups."""
    return world.of_home([group.name for group in world.scenario.groups].index(name))


def goals(world: World, who: np.ndarray) -> list[str]:
    """Return the name of the place each goes to, "" for none."""
    return [world.places[int(k)].name if k >= 0 else "" for k in world.bodies.goal[who]]


def gathered(world: World, place: int) -> np.ndarray:
    """Return who stands in a place's region."""
    row, column = world.ground.cells(world.bodies.place)
    return np.flatnonzero(world.bodies.present & world.places[place].region[row, column])
