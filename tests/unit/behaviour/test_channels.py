"""Guided before reaction before script before innate, on each channel alone: what the engine does of all orders."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from cloner.behaviour.loop import guide, step
from cloner.behaviour.world import CHANNELS, LEVELS, World
from kit.scenes import goals, of, pass_time, scene

INNATE, SCRIPT, REACTION, GUIDED = range(4)
VALUES = {"goal": (0, 2), "speed": (0.7, 1.9), "posture": (3, 5), "gaze": (0, 1), "avoidance": (0, 1)}


def two() -> World:
    """Return two people who stand and want nothing, and see two statues."""
    return scene("statue bear at 3, 7.6\ngroup some: 2 people, wanders, starts at middle\n")


def done(world: World) -> dict[str, list[float]]:
    """Return what both do on each channel after a step."""
    world.people.phase[:] = 0  # nobody chooses a goal of his own
    step(world)
    bodies, people = world.bodies, world.people
    found = {"goal": bodies.goal, "speed": bodies.wants, "posture": people.posture, "gaze": people.gaze,
             "avoidance": bodies.avoids}  # fmt: skip
    return {name: rows.astype(float).tolist() for name, rows in found.items()}


@pytest.mark.parametrize("channel", CHANNELS)
@pytest.mark.parametrize(("low", "high"), list(combinations(range(len(LEVELS)), 2)))
def test_the_higher_level_holds_and_the_lower_comes_back(channel: str, low: int, high: int) -> None:
    weak, strong = VALUES[channel]
    world = two()
    world.bodies.velocity[:] = 0.0
    world.orders[channel][low, :] = weak
    world.orders[channel][high, 0] = strong
    assert done(world)[channel] == [strong, weak]
    world = two()
    world.orders[channel][low, :] = weak
    world.orders[channel][high, 0] = strong
    world.orders[channel][high, 0] = -1.0
    assert done(world)[channel] == [weak, weak]


@pytest.mark.parametrize("channel", CHANNELS)
def test_an_order_on_one_channel_leaves_the_others_alone(channel: str) -> None:
    before = done(two())
    world = two()
    world.orders[channel][GUIDED, 0] = value = VALUES[channel][channel == "gaze"]
    found = done(world)
    assert found[channel][0] == value != before[channel][0]
    for name in CHANNELS:
        assert (found[name] == before[name]) == (name != channel)


def test_collisions_are_avoided_unless_somebody_orders_otherwise() -> None:
    world = two()
    for level in (SCRIPT, REACTION, GUIDED):
        world.orders["goal"][level] = 2
    assert done(world)["avoidance"] == [1.0, 1.0]
    world.orders["avoidance"][SCRIPT, 0] = 0
    assert done(world)["avoidance"] == [0.0, 1.0]


def test_an_order_with_a_time_ends_unless_another_has_taken_its_place() -> None:
    world = scene("group some: 2 people, starts at middle\n")
    guide(world, "some do wave for 1 s")
    pass_time(world, 0.5)
    guide(world, "some do point for 2 s")
    pass_time(world, 1.0)
    assert (world.orders["posture"][GUIDED] == world.acts.index("point")).all(), "the first one's end is not its own"
    pass_time(world, 1.1)
    assert (world.orders["posture"][GUIDED] == -1).all()


def test_a_guided_order_overrides_script_and_reaction_in_the_next_step() -> None:
    world = scene(
        "group some: 3 people, visits east, starts at west\nwhen event fire: some go to middle\nat 1 s: event fire\n"
    )
    pass_time(world, 1.2)
    assert goals(world, of(world, "some")) == ["middle"] * 3
    guide(world, "some go to west")
    for _ in range(2):
        step(world)
    assert goals(world, of(world, "some")) == ["west"] * 3
    guide(world, "some are free")
    pass_time(world, 0.2)
    assert goals(world, of(world, "some")) == ["east"] * 3
    assert np.all(world.bodies.avoids)


def test_more_orders_than_the_engine_takes_at_once_wait_for_the_next_steps() -> None:
    world = scene("group some: 3 people, starts at west\n")
    for _ in range(600):
        guide(world, "some go to middle")
    guide(world, "some go to east")
    step(world)
    assert world.guided
    pass_time(world, 0.2)
    assert not world.guided
    assert goals(world, of(world, "some")) == ["east"] * 3
