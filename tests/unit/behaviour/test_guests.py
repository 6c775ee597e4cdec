"""People from outside: nobody before they come; then seen, avoided, reacted to, and moved by nobody else."""

from __future__ import annotations

import numpy as np

from cloner.behaviour.guests import find_free_guest, move_guest, remove_guest
from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import run, step
from cloner.behaviour.world import World, make_world

HALL = """floor 0, 0 to 16, 6
point left at 2, 3 region 2 x 4
point right at 14, 3 region 2 x 4
group walkers: 5 people, visits right > left again, starts at left, adapts to space
"""
GUESTS = "crowd 2 guests: from outside\n"
WALKERS = slice(0, 5)


def going(text: str, seconds: float, world: World | None = None) -> World:
    world = world or make_world(parse_scenario(text), seed=3)
    for _ in run(world, seconds):
        pass
    return world


def test_who_is_expected_but_has_not_come_changes_nothing() -> None:
    alone, expecting = going(HALL, 12.0), going(HALL + GUESTS, 12.0)
    assert not expecting.bodies.present[5:].any()
    assert np.array_equal(alone.bodies.place, expecting.bodies.place[WALKERS])


def test_a_guest_stands_where_told_and_all_go_round() -> None:
    world = make_world(parse_scenario(HALL + GUESTS), seed=3)
    who = find_free_guest(world)
    move_guest(world, who, (8.0, 3.0), (1.0, 0.0))
    assert find_free_guest(world) != who
    least, before = np.inf, going(HALL, 12.0).bodies.place
    for now in run(world, 12.0):
        assert now.bodies.place[who].tolist() == [8.0, 3.0]
        least = min(least, float(np.linalg.norm(now.bodies.place[WALKERS] - (8.0, 3.0), axis=1).min()))
    assert least >= 0.30
    assert (world.bodies.place[WALKERS, 0] > 9.0).all(), "they came past"
    assert not np.array_equal(before, world.bodies.place[WALKERS])


def test_a_guest_walks_between_what_is_told_and_through_no_wall() -> None:
    world = make_world(parse_scenario(HALL + GUESTS), seed=3)
    who = find_free_guest(world)
    move_guest(world, who, (8.0, 3.0), (1.0, 0.0))
    move_guest(world, who, (8.0, 4.0), (0.0, 1.0))
    step(world)
    assert 3.1 < world.bodies.place[who, 1] < 3.3, "as fast as one runs"
    going("", 1.0, world)
    assert world.bodies.place[who].tolist() == [8.0, 4.0]
    for nowhere in ((8.0, 6.5), (1e4, 1e4)):
        move_guest(world, who, nowhere, (0.0, 1.0))
    going("", 1.0, world)
    assert world.bodies.place[who].tolist() == [8.0, 4.0]


def test_they_are_seen_and_reacted_to_and_gone_when_they_leave() -> None:
    rules = "when anybody sees guests: they do wave for 60 s\nat 1 s: everybody goes to right\n"
    world = make_world(parse_scenario(HALL + GUESTS + rules), seed=3)
    assert going("", 3.0, world).orders["posture"][2, 0] < 0
    who = find_free_guest(world)
    place = world.bodies.place[WALKERS].mean(axis=0) + (3.0, 0.0)
    move_guest(world, who, tuple(place), (-1.0, 0.0))
    going("", 1.0, world)
    wave = world.acts.index("wave")
    assert (world.orders["posture"][2, WALKERS] == wave).all()
    assert world.bodies.place[who].tolist() == place.tolist(), "an order to everybody does not move a guest"
    remove_guest(world, who)
    going("", 1.0, world)
    assert not world.bodies.present[who]
    assert find_free_guest(world) == who
