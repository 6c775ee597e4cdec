"""The agents' loop as the source prints it: update the scene; all perceive and select; then all execute."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from typing import Final

from cloner.behaviour.language import read_actions
from cloner.behaviour.model import Action
from cloner.behaviour.obeying import obey
from cloner.behaviour.perceiving import perceive
from cloner.behaviour.rules import react, timed
from cloner.behaviour.together.flocking import one_speed
from cloner.behaviour.together.following import follow
from cloner.behaviour.together.goal_changing import change
from cloner.behaviour.together.repulsion import repel
from cloner.behaviour.visiting import visit
from cloner.behaviour.walking import STEP_S
from cloner.behaviour.world import World

#: Minds work at every second step, feet at each.
MIND_STEPS: Final = 2


def step(world: World) -> None:
    """Let .05 s pass."""
    timed(world)
    if world.steps % MIND_STEPS == 0:
        seen = perceive(world)
        react(world, seen)
        change(world, seen)
        follow(world, seen)
        visit(world)
        one_speed(world)
        repel(world, seen)
    obey(world)
    world.steps += 1


def run(world: World, seconds: float) -> Iterator[World]:
    """Yield the world after each step, for some seconds."""
    for _ in range(round(seconds / STEP_S)):
        step(world)
        yield world


def guide(world: World, order: str | Action) -> None:
    """Give an order from outside, above reactions and script; it is obeyed in the next step.

    Raises
    ------
    ClonerError
        If the order says something wrong.
    """
    world.guided += read_actions(order, world.scenario) if isinstance(order, str) else (order,)


def digest(world: World) -> str:
    """Return a digest of all places to the last bit: equal for equal scenario, seed and number of steps."""
    return hashlib.sha256(world.bodies.place.astype("<f8").tobytes()).hexdigest()[:16]
