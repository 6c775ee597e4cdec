"""The eight group behaviours: what each does, and that without it things are otherwise."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import guide, step
from cloner.behaviour.tables import APART_M, PHASES
from cloner.behaviour.world import make_world
from kit.scenes import gathered, goals, of, pass_time, scene


def left_behind(words: str) -> int:
    """Return how many are still on their way to the middle when the first of six goes on."""
    world = scene(f"group some: 6 people, visits middle > east, starts at west{words}\n")
    who = of(world, "some")
    for _ in range(600):
        step(world)
        if "east" in goals(world, who):
            return int((~world.bodies.settled[who] & (world.bodies.goal[who] == 1)).sum())
    raise AssertionError("nobody went on")


def test_flocking_waits_for_the_last() -> None:
    assert left_behind(", flocking") == 0
    assert left_behind("") > 0


@pytest.mark.parametrize(("words", "same"), [(", flocking", True), ("", False)])
def test_flocking_walks_at_one_speed_to_one_goal_on_different_ways(words: str, same: bool) -> None:
    world = scene(f"group some: 6 people, visits east, starts at west{words}\n")
    pass_time(world, 4.0)
    who = of(world, "some")
    assert (float(np.ptp(world.bodies.own_speed[who])) < 1e-12) == same
    assert goals(world, who) == ["east"] * 6
    assert len(np.unique(world.bodies.target[who], axis=0)) == 6


def test_following_for_ever_takes_the_other_groups_goals() -> None:
    text = "group first: 2 people, visits east > west, starts at middle\n"
    text += "group then: 2 people, visits middle, starts at west"
    followed, alone = scene(f"{text}, follows first\n"), scene(f"{text}\n")
    for world, wanted in ((followed, "east"), (alone, "middle")):
        pass_time(world, 2.0)
        assert goals(world, of(world, "then")) == [wanted] * 2
    pass_time(followed, 12.0)
    assert goals(followed, of(followed, "first")) == goals(followed, of(followed, "then")) == ["west"] * 2


def test_following_for_some_seconds_ends() -> None:
    world = scene("group first: 2 people, visits east, starts at middle\n"
                  "group then: 2 people, visits middle, follows first for 3 s, starts at west\n")  # fmt: skip
    pass_time(world, 2.5)
    assert goals(world, of(world, "then")) == ["east"] * 2
    pass_time(world, 1.0)
    assert goals(world, of(world, "then")) == ["middle"] * 2


def test_following_at_times_does_both() -> None:
    world = scene("group first: 1 people, visits east, starts at middle\n"
                  "group then: 1 people, visits west, follows first at times, starts at west\n")  # fmt: skip
    had = set()
    for _ in range(45):
        pass_time(world, 1.0)
        had |= set(goals(world, of(world, "then")))
    assert had >= {"east", "west"}


@pytest.mark.parametrize(("liking", "joins"), [(0.9, True), (0.3, False)])
def test_who_likes_another_group_better_joins_it(liking: float, joins: bool) -> None:
    world = scene("group club: 3 people, visits east, starts at middle\n"
                  f"group one: 1 people, visits west, likes club {liking}, starts at middle\n")  # fmt: skip
    stranger = of(world, "one")
    pass_time(world, 1.0)
    assert (world.people.band[stranger] == 0).all() == joins
    pass_time(world, 0.5)
    assert goals(world, stranger) == (["east"] if joins else ["west"])


def test_the_highest_domination_emerges_as_leader_and_leads_elsewhere() -> None:
    world = scene("group club: 3 people, leader emerging, visits east > west > middle, starts at middle\n"
                  "group loners: 1 people, likes club 1, visits middle, starts at middle\n")  # fmt: skip
    newcomer = int(of(world, "loners")[0])
    world.people.domination[newcomer] = 2.0
    first = world.bands[0].leader
    assert world.people.domination[first] == world.people.domination[:3].max()
    pass_time(world, 1.0)
    assert world.bands[0].leader == newcomer
    assert sorted(world.bands[0].visits) == [0, 1, 2]


def test_attraction_spreads_people_over_the_region_looking_at_the_thing_until_the_end() -> None:
    world = scene(
        "point stage at 12, 4 region 5 x 5 look at lion\n"
        "group some: 9 people, visits west, starts at middle, adapts to space\n"
        "at 3 s: everybody gathers at stage for 14 s\n"
    )
    pass_time(world, 1.0)
    assert "stage" not in goals(world, of(world, "some"))
    pass_time(world, 15.0)
    stage = len(world.places) - 1
    place = world.bodies.place
    assert np.abs(world.bodies.target - world.places[stage].middle).max() <= 2.5
    assert np.linalg.norm(place - world.bodies.target, axis=1).max() < 0.5
    assert np.ptp(place, axis=0).min() > 3.0, "all over the region"
    apart = np.linalg.norm(place[:, None] - place[None], axis=2)[np.triu_indices(9, 1)]
    assert apart.min() > 0.4
    to_lion = np.array([12.0, 7.6]) - place
    cosine = (to_lion * world.bodies.facing).sum(axis=1) / np.linalg.norm(to_lion, axis=1)
    assert cosine.min() > np.cos(np.radians(10.0))
    pass_time(world, 2.0)
    assert "stage" not in goals(world, of(world, "some"))


def test_a_cleared_region_is_left_and_avoided_until_it_is_free_again() -> None:
    world = scene("group some: 8 people, visits middle, starts at middle\nat 2 s: clear middle for 14 s\n")
    pass_time(world, 1.9)
    assert len(gathered(world, 1)) == 8
    pass_time(world, 12.0)
    assert len(gathered(world, 1)) == 0
    assert "middle" not in goals(world, of(world, "some"))
    pass_time(world, 2.4)
    assert goals(world, of(world, "some")) == ["middle"] * 8


def test_twelve_people_split_into_groups_with_intentions_of_their_own() -> None:
    world = scene("group dozen: 12 people, visits middle > east > west, starts at west\nat 1 s: split dozen into 3\n")
    pass_time(world, 0.9)
    assert len(world.bands) == 1
    pass_time(world, 0.5)
    sizes = [len(world.members(k)) for k in range(len(world.bands))]
    assert len(sizes) == 3
    assert sum(sizes) == 12
    assert min(sizes) >= 1
    assert all(int(world.people.band[band.leader]) == k for k, band in enumerate(world.bands))
    first = world.places[world.bands[0].visits[0]].name
    assert all(world.places[band.visits[0]].name != first for band in world.bands[1:])
    assert {world.places[band.visits[0]].name for band in world.bands[1:]} >= set(goals(world, world.members(1)))


def used_area(words: str) -> float:
    world = scene(f"group some: 6 people, visits east, starts at west{words}\n")
    pass_time(world, 0.5)
    return float(np.prod(np.ptp(world.bodies.target[of(world, "some")], axis=0)))


def test_who_adapts_to_space_uses_the_whole_region() -> None:
    assert used_area(", adapts to space") > 0.5 * 3.0 * 6.0
    assert used_area("") < 0.2 * 3.0 * 6.0


def met(words: str) -> tuple[float, float]:
    """Return how far aside two who walk at each other are a metre before, and how straight one goes on after."""
    world = scene(
        f"group a: 1 people, visits east, starts at west\ngroup b: 1 people, visits west, starts at east\n{words}"
    )
    world.bodies.place[:] = [[2.0, 4.0], [22.0, 4.0]]
    pass_time(world, 0.2)
    world.bodies.target[:] = [[22.0, 4.0], [2.0, 4.0]]
    for _ in range(400):
        step(world)
        across = world.bodies.place[1] - world.bodies.place[0]
        if across[0] < 1.0:
            aside = abs(float(across[1]))
            pass_time(world, 4.0)
            velocity = world.bodies.velocity[0] / np.linalg.norm(world.bodies.velocity[0])
            return aside, float(velocity[0])
    raise AssertionError("they never met")


def test_safe_wandering_turns_away_before_and_back_after() -> None:
    aside, back = met("")
    assert aside > 0.2
    assert back > np.cos(np.radians(5.0))
    assert met("at 0 s: everybody ignores others\n")[0] < 0.05


def test_nobody_is_sent_to_a_spot_within_half_a_step_of_anothers() -> None:
    text = "point stage at 12, 4 region 5 x 5\n"
    for k, words in enumerate(("", ", adapts to space", "", ", adapts to space")):
        text += f"group some{k}: 9 people, visits stage, starts at west{words}\n"
    world = scene(text)
    for number, late in enumerate(("", "some0 goes to east", "some2 goes to east", "some0 goes to stage")):
        if late:
            guide(world, late)
        pass_time(world, 0.5)
        target = world.bodies.target[world.bodies.goal == 3]
        away = np.linalg.norm(target[:, None] - target[None], axis=2)[np.triu_indices(len(target), 1)]
        assert len(target) == (36, 27, 18, 27)[number]
        assert away.min() > 0.99 * APART_M


def test_wanderers_keep_off_the_walls_and_each_other() -> None:
    world = scene("group some: 10 people, wanders\n")
    begun = world.bodies.place.copy()
    for _ in range(400):
        step(world)
        assert (world.bodies.place > 0.19).all()
        assert (world.bodies.place < np.array([24.0, 8.0]) - 0.19).all()
    assert (np.linalg.norm(world.bodies.place - begun, axis=1) > 0.5).all()


def bent(floor: str) -> tuple[np.ndarray, np.ndarray]:
    """Return how far six people who went from one place to one spot were aside of the straight line at most."""
    ways = []
    for seed in range(1, 7):
        world = make_world(parse_scenario(f"{floor}\npoint end at 11, 4\ngroup one: 1 people, visits end\n"), seed)
        world.bodies.place[0] = (1.0, 4.0)
        aside = []
        while not world.bodies.settled[0] or world.bodies.goal[0] < 0:
            step(world)
            aside.append(world.bodies.place[0, 1] - 4.0)
        ways.append(max(aside, key=abs))
        assert np.linalg.norm(world.bodies.place[0] - world.bodies.target[0]) < 0.15
    return np.abs(ways), np.array(ways)


def test_every_way_is_a_curve_of_its_own_where_there_is_room() -> None:
    wide, signed = bent("floor 0, 0 to 12, 8")
    assert wide.max() < 0.15 * 10.0
    assert wide.max() > 0.3
    assert len(np.unique(np.round(signed, 2))) >= 5, "never two equal"
    narrow, _ = bent("floor 0, 3.6 to 12, 4.4")
    assert narrow.max() < 0.25


def test_a_counter_serves_one_at_a_time_and_everybody_in_turn() -> None:
    world = scene("point till at 12, 2 region 4 x 3 act pay for 2 s one at a time\n"
                  "group queue: 4 people, visits till > east, starts at middle\n")  # fmt: skip
    till, served = len(world.places) - 1, set()
    for _ in range(560):
        step(world)
        now = np.flatnonzero((world.people.phase == PHASES.index("acting")) & (world.bodies.goal == till))
        assert len(now) <= 1
        served |= set(now.tolist())
    assert len(served) == 4
    assert not ((world.people.phase == PHASES.index("waiting")) & (world.bodies.goal == till)).any()


def test_feelings_set_the_speed_and_share_is_exact() -> None:
    world = scene("crowd 40 visitors: emotion sad 75 %, visits east, starts at west\n")
    names = [one.name for one in world.scenario.emotions]
    sad = world.people.emotion == names.index("sad")
    assert int(sad.sum()) == 30
    world.people.value[:] = 1.0
    world.people.vigour[:] = 1.0
    pass_time(world, 0.1)
    assert np.allclose(world.bodies.own_speed[sad], 0.87)
    guide(world, "everybody becomes explosive")
    pass_time(world, 0.1)
    assert np.allclose(world.bodies.own_speed, 1.66)


def test_a_place_that_is_not_known_is_not_gone_to_until_it_is_seen() -> None:
    blind = "group some: 1 people, visits far, knows west, starts at west\n"
    walls = "floor 24, 3 to 26, 5\nfloor 26, 3 to 28, 12\npoint far at 27, 11 region 1.4 x 1.4\n"
    world = scene(walls + blind)
    pass_time(world, 3.0)
    assert goals(world, of(world, "some")) == [""]
    guide(world, "some go to far")
    pass_time(world, 0.2)
    assert goals(world, of(world, "some")) == ["far"]


def test_more_visits_than_people_and_places_keep_their_numbers() -> None:
    visits = " > ".join(["west", "middle"] * 40)
    world = scene(f"group club: 1 people, leader emerging, visits {visits}, starts at middle\n"
                  "group loners: 1 people, likes club 1, visits east, starts at middle\n")  # fmt: skip
    world.people.domination[:] = 0.1, 0.9
    pass_time(world, 1.0)
    assert world.bands[0].leader == 1
    assert sorted(world.bands[0].visits) == [0] * 40 + [1] * 40


def test_a_region_with_a_bitten_corner_has_a_spot() -> None:
    """No cell of this one lies in its first row and column, nor three from them: the lattice of spots was empty."""
    floor = "floor 0, 2 to 6, 6\nfloor 2, 0 to 6, 6\n"
    for size in ("1.5 x 1.5", "1.5 x 1.8", "1.6 x 1.5"):
        text = f"{floor}point here at 1.6, 1.6 region {size}\ngroup one: 1 people, visits here\n"
        world = make_world(parse_scenario(text), 1)
        pass_time(world, 0.2)
        assert np.abs(world.bodies.target[0] - 1.6).max() <= 0.9
