"""Ground, fields and feet: known lengths, no wall crossed, no two in one place, doors passed, lanes formed."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from cloner.behaviour import dice
from cloner.behaviour.ground import BODY_M, Ground, inside, make_ground, rectangle
from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import step
from cloner.behaviour.walking import GIVEN, STEP_S, Bodies, make_bodies, walk
from cloner.behaviour.world import make_world
from kit.scripts import script

WORLDS = script("behaviour_worlds")

SIGHT_M = 6.0


def bodies_at(
    ground: Ground, place: list[list[float]], way: tuple[float, float], speed: float = 1.34, **world: float
) -> Bodies:
    bodies = make_bodies(ground, np.array(place, float), **world)
    bodies.goal[:], bodies.way[:], bodies.wants[:] = GIVEN, way, speed
    return bodies


def test_walls_of_overlapping_floors_are_those_around_all() -> None:
    ground = make_ground([rectangle((5, 2), (10, 4)), rectangle((9, 2), (4, 1))], [rectangle((3, 2), (1, 1))])
    length = np.linalg.norm(ground.walls[:, 2:] - ground.walls[:, :2], axis=1).sum()
    assert length == pytest.approx(
        2 * (10 + 4) + 2 * 1 + 4 * 1
    )  # the second floor stands out by 1 m, the obstacle has 4
    row, column = ground.cells(np.array([[5.5, 2.0]]))
    middle = ground.middles(row, column)[0]
    assert ground.clear[row[0], column[0]] == pytest.approx(min(middle[1], 4 - middle[1], abs(middle[0] - 3.5)))


@pytest.mark.parametrize(("obstacle", "facing", "seen"), [
    ("", 1.0, True), ("", -1.0, False), ("obstacle wall at 4, 4 size .4 x 7\n", 1.0, False),
    ("obstacle wall at 4, 6 size .4 x 3\n", 1.0, True), ("obstacle plinth at 7, 4 size 1 x 1\n", 1.0, True),
])  # fmt: skip
def test_sight_goes_forward_and_ends_at_walls_but_not_at_a_plinth(obstacle: str, facing: float, seen: bool) -> None:
    text = f"floor 0, 0 to 20, 8\n{obstacle}statue lion at 7, 4\ngroup one: 1 people, wanders\n"
    world = make_world(parse_scenario(text), 1)
    world.bodies.place[:], world.bodies.facing[:] = (2.0, 4.0), (facing, 0.0)
    step(world)
    assert [name for _, name in world.bands[0].memory] == ["lion"] * seen


def test_inside_of_a_corner_polygon() -> None:
    corner = np.array([[0, 0], [4, 0], [4, 1], [1, 1], [1, 4], [0, 4]], float)
    assert inside(np.array([[0.5, 3.0], [3.0, 0.5], [3.0, 3.0], [-1.0, 0.5]]), corner).tolist() == [
        True,
        True,
        False,
        False,
    ]


def test_a_field_leads_round_an_obstacle_on_nearly_the_shortest_way() -> None:
    ground = make_ground([rectangle((10, 5), (20, 10))], [rectangle((10, 3.5), (1, 7))])
    goal = rectangle((18, 2), (1, 1))
    lost = bodies_at(ground, [[2.0, 2.0]], (0.0, 0.0), places=1)
    lost.lead(0, ground.region(goal))
    distance = lost.core.arrays["distance"]
    row, column = ground.cells(np.array([[2.0, 2.0]]))
    straight = np.hypot(10 - 0.5 - 2, 5) + 1 + np.hypot(18 - 0.5 - 10.5, 4.5)  # by the corners at y = 7
    assert straight < distance[row[0], column[0]] < 1.25 * straight  # walls cost more, sixteen directions 2.7 %
    way = lost.core.arrays["fields"][0, row[0], column[0]]
    assert way @ np.array([7.5, 5.2]) / np.hypot(7.5, 5.2) > np.cos(np.radians(12))
    shut = make_ground([rectangle((2, 2), (4, 4)), rectangle((9, 2), (4, 4))])
    inside_one = bodies_at(shut, [[2.0, 2.0]], (0.0, 0.0), places=1)
    inside_one.lead(0, shut.region(rectangle((9, 2), (1, 1))))
    assert np.isinf(inside_one.core.arrays["distance"][shut.cells(np.array([[2.0, 2.0]]))]).all()


def test_distances_are_the_least_sums_over_sixteen_neighbours() -> None:
    """Another's search over the same moves and prices finds the same, to the last bit."""
    chance = np.random.default_rng(4)
    posts = [rectangle(one, (0.9, 0.9)) for one in chance.uniform(1, 9, (9, 2))]
    ground = make_ground([rectangle((5, 5), (10, 10))], posts)
    people = bodies_at(ground, [[0.5, 0.5]], (0.0, 0.0), places=1)
    region = ground.region(rectangle((9.4, 9.4), (0.6, 0.6)))
    people.lead(0, region)
    rows, cols = ground.clear.shape
    price = 1.0 + np.clip((0.5 - ground.clear) / (0.5 - 0.15), 0.0, 1.0)
    stands = ground.clear >= 0.15
    moves = [(r, c) for r in range(-2, 3) for c in range(-2, 3) if r * r + c * c in (1, 2, 5)]
    edges = {}
    for row, column in np.argwhere(stands):
        for r, c in moves:
            to = row + r, column + c
            if not (0 <= to[0] < rows and 0 <= to[1] < cols and stands[to]):
                continue
            length = 0.2 * np.sqrt(float(r * r + c * c))
            if abs(r) + abs(c) > 1 and (ground.clear[row, column] + ground.clear[to]) / 2.0 <= length / 2.0 * 0.3:
                continue
            edges[row * cols + column, to[0] * cols + to[1]] = length * (price[row, column] + price[to]) / 2.0
    graph = coo_array((list(edges.values()), np.array(list(edges)).T), shape=(rows * cols, rows * cols)).tocsr()
    found = dijkstra(graph, indices=np.flatnonzero(region), min_only=True).reshape(rows, cols)
    assert np.isfinite(found).sum() > 1_000
    assert np.array_equal(people.core.arrays["distance"], found)


def test_the_nearest_sixteen_are_found_by_the_grid() -> None:
    place = np.stack([dice.uniform(3, k, np.arange(200)) * 20 for k in (1, 2)], axis=1)
    bodies = bodies_at(make_ground([rectangle((10, 10), (24, 24))]), place.tolist(), (0.0, 0.0))
    walk(bodies)
    found = bodies.core.arrays["others"]
    away = np.linalg.norm(place[:, None] - place[None], axis=2)
    np.fill_diagonal(away, np.inf)
    for k, row in enumerate(found):
        want = [one for one in np.argsort(away[k])[:16] if away[k, one] <= SIGHT_M]
        assert row[row >= 0].tolist() == want


def test_one_alone_walks_forty_metres_at_his_own_speed() -> None:
    ground = make_ground([rectangle((25, 1), (50, 2))])
    one = bodies_at(ground, [[1.0, 1.0]], (1.0, 0.0), 1.33)
    for _ in range(round(30.0 / STEP_S)):
        walk(one)
    assert one.place[0, 0] == pytest.approx(1.0 + 1.33 * (30.0 - 0.5), abs=0.1)  # half a second to come to speed


def test_nobody_crosses_a_wall_or_stands_in_another() -> None:
    ground = make_ground([rectangle((4, 2), (8, 4)), rectangle((8.2, 2), (0.6, 1.0)), rectangle((11, 2), (5, 4))])
    goal = rectangle((12.5, 2), (1, 3))
    people = bodies_at(ground, [[1 + 0.6 * (k % 5), 0.7 + 0.6 * (k // 5)] for k in range(25)], (1.0, 0.0), places=1)
    people.lead(0, ground.region(goal))
    people.goal[:] = 0
    least, passed = np.inf, 0
    for k in range(round(40.0 / STEP_S)):
        walk(people)
        inner = (people.place[:, 0] < 8.0) | (people.place[:, 0] > 8.5)
        assert (people.place[:, 1] > BODY_M - 1e-9).all()
        assert (people.place[:, 1] < 4.0 - BODY_M + 1e-9).all()
        assert (np.abs(people.place[~inner, 1] - 2.0) < 0.5 - BODY_M + 1e-9).all()
        if k % 20 == 0:
            away = np.linalg.norm(people.place[:, None] - people.place[None], axis=2)[np.triu_indices(25, 1)]
            least = min(least, float(away.min()))
        passed = int((people.place[:, 0] > 8.5).sum())
    assert passed == 25
    assert least > 0.3


def test_speed_falls_with_density_as_weidmann_says() -> None:
    found = []
    for density, speed in ((0.25, 1.34), (1.0, 1.06)):
        ground = make_ground([rectangle((15, 2), (46, 4))])
        count = round(density * 30 * 4)
        k = np.arange(count)
        rows = 2 if density < 1 else 6
        place = np.stack([(k // rows + 0.5) * 30 / (count / rows), 0.4 + (k % rows + 0.5) * 3.2 / rows], axis=1)
        people = bodies_at(ground, place.tolist(), (1.0, 0.0), period_m=30.0)
        people.wants[:] = 1.34 + 0.26 * np.clip(dice.normal(4, 1, k), -2, 2)
        went = np.zeros(count)
        for number in range(300):
            before = people.place[:, 0].copy()
            walk(people)
            moved = people.place[:, 0] - before
            went += moved - 30.0 * np.floor(moved / 30.0 + 0.5) if number >= 100 else 0.0
        found.append(float(went.mean() / 10.0) / speed)
    assert np.allclose(found, 1.0, atol=0.15)


@pytest.mark.parametrize("seed", [5, 10])
def test_streams_against_each_other_do_not_lock(seed: int) -> None:
    pace, lanes = WORLDS.streams(seed, WORLDS.Middles())  # these two locked while bodies were pushed straight apart
    assert pace > 0.6
    assert lanes > 0.5


@pytest.mark.parametrize("polite", [True, False])
def test_who_stands_makes_way_for_who_comes(polite: bool) -> None:
    ground = make_ground([rectangle((5, 0.5), (10, 1))])
    people = bodies_at(ground, [[1.0, 0.5], [5.0, 0.5]], (1.0, 0.0))
    people.way[1] = 0.0
    people.avoids[1] = polite
    for _ in range(round(10.0 / STEP_S)):
        walk(people)
    assert (people.place[0, 0] > people.place[1, 0] + 1.0) == polite


def test_dice_are_even_normal_and_repeat() -> None:
    who = np.arange(20_000)
    even, bell = dice.uniform(5, 7, who), dice.normal(5, 7, who)
    assert abs(even.mean() - 0.5) < 0.01
    assert abs(even.std() - 12**-0.5) < 0.01
    assert abs(bell.mean()) < 0.03
    assert abs(bell.std() - 1.0) < 0.03
    assert np.array_equal(dice.uniform(5, 7, who[::-1]), even[::-1])
    assert not np.array_equal(dice.uniform(6, 7, who), even)
    assert sorted(dice.shuffled(1, 2, who[:50]).tolist()) == list(range(50))
