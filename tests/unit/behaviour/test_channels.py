"""Guided before reaction before script before innate, on each channel alone."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from cloner.behaviour.channels import CHANNELS, GUIDED, INNATE, LEVELS, REACTION, SCRIPT, Orders
from kit.scenes import goals, of, pass_time, scene

VALUES = {"goal": (3, 5), "speed": (0.7, 1.9), "posture": (1, 2), "gaze": (0, 4), "avoidance": (0, 1)}


@pytest.mark.parametrize("channel", CHANNELS)
@pytest.mark.parametrize(("low", "high"), list(combinations(range(len(LEVELS)), 2)))
def test_the_higher_level_holds_and_the_lower_comes_back(channel: str, low: int, high: int) -> None:
    weak, strong = VALUES[channel]
    orders = Orders(2)
    orders.give(high, channel, [0], strong)
    orders.give(low, channel, [0, 1], weak)
    assert orders.chosen(channel).tolist() == [strong, weak]
    orders.withdraw(high, [0])
    assert orders.chosen(channel).tolist() == [weak, weak]


@pytest.mark.parametrize("channel", CHANNELS)
def test_an_order_on_one_channel_leaves_the_others_alone(channel: str) -> None:
    orders = Orders(1)
    before = {name: orders.chosen(name).tolist() for name in CHANNELS}
    orders.give(GUIDED, channel, [0], VALUES[channel][0])
    for name in CHANNELS:
        assert (orders.chosen(name).tolist() == before[name]) == (name != channel)


def test_collisions_are_avoided_unless_somebody_orders_otherwise() -> None:
    orders = Orders(1)
    assert orders.chosen("avoidance").tolist() == [1]
    for level in (SCRIPT, REACTION, GUIDED):
        orders.give(level, "goal", [0], 2)
    assert orders.chosen("avoidance").tolist() == [1]
    orders.withdraw(INNATE, [0])
    assert orders.chosen("avoidance").tolist() == [1]


def test_a_guided_order_overrides_script_and_reaction_in_the_next_step() -> None:
    from cloner.behaviour.loop import guide, step

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
