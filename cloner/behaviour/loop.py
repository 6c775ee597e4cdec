"""The simulation loop: the engine updates the scene; all agents perceive and select; then all execute."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator

from cloner.behaviour.language import parse_actions
from cloner.behaviour.model import Action
from cloner.behaviour.told import sentences
from cloner.behaviour.walking import STEP_S
from cloner.behaviour.world import World


def step(world: World) -> None:
    """Advance by .05 s."""
    while world.guided:
        action = world.guided[0]
        if not world.hear("guide", *world.names.row_of(action), action.seconds):
            world.log.pop()
            break  # as many as the engine takes at once
        world.guided.popleft()
    world.core.call("live")
    world.steps += 1
    numbers = world.core.arrays["numbers"]
    if numbers[0]:
        world.told += sentences(world.core.arrays["told"][: numbers[0]], world.names)
        numbers[0] = 0


def run(world: World, seconds: float) -> Iterator[World]:
    """Yield the world after each step, for some seconds."""
    for _ in range(round(seconds / STEP_S)):
        step(world)
        yield world


def guide(world: World, order: str | Action) -> None:
    """Give an order from outside, with priority over reactions and script; it is obeyed in the next step.

    Raises
    ------
    ClonerError
        If the order says something wrong.
    """
    world.guided += parse_actions(order, world.scenario) if isinstance(order, str) else (order,)


def digest(world: World) -> str:
    """Return a digest of all positions to the last bit: equal for equal scenario, seed and number of steps."""
    return hashlib.sha256(world.bodies.place.astype("<f8").tobytes()).hexdigest()[:16]
