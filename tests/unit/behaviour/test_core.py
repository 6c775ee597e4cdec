"""The engine gives the same bits in Python, node and Chromium."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from cloner.behaviour import dice
from cloner.behaviour.core.host import MODULE, CrowdEngine
from cloner.behaviour.ground import make_ground, rectangle
from cloner.behaviour.language import parse_actions, parse_scenario
from cloner.behaviour.loop import digest, guide, step
from cloner.behaviour.walking import GIVEN, make_bodies, walk
from cloner.behaviour.world import make_world
from cloner.errors import ClonerError
from kit.browser import CHROMIUM, browser
from kit.engine_log import in_node, kept_places, log_of, page

STEPS, EVERY = 10_000, 1_000
#: Everything that moves people: curves, fields, flocking, wanderers, a counter, other orders on the way, who leaves.
BUSY = """
floor 0, 0 to 24, 12
obstacle pillar at 9, 6 size 1 x 1
obstacle desk at 15, 3 size 2 x .6
statue lion at 18, 9
point door at 1, 6 region 1 x 4
point till at 6, 1 act pay for 2 s one at a time
point front at 17, 7 region 4 x 3 act look for 3 s look at lion
point far at 22.5, 2 region 2 x 2
crowd 24 guests: emotion happy 80 %, visits door > till > front > far again
group school: 8 people, leader anna, visits front > far > door again, flocking, adapts to space
group strays: 5 people, wanders
crowd 3 late: visits far
at 30 s: guests ignores others
at 40 s: guests heeds others, strays goes to front
at 60 s: strays is free
at 90 s: school runs to far
at 200 s: late leaves by door
"""


#: And minds: who joins, emerges as leader, follows, gathers, is cleared away, splits, sees, flees, is guided; counters.
MINDS = """
floor 0, 0 to 24, 12
obstacle pillar at 9, 6 size 1 x 1
statue lion at 18, 9
point door at 1, 6 region 1 x 4
point till at 6, 1 region 3 x 2 act pay for 2 s one at a time
point front at 17, 7 region 4 x 3 act look for 3 s look at lion
point far at 22.5, 2 region 2 x 2
crowd 12 guests: emotion happy 80 %, likes school 0.8, starts at door
group school: 8 people, leader emerging, flocking, adapts to space, starts at front
group guards: 4 people, visits door > far again, follows school at times, memory 3
crowd 9 others: starts at far
at 20 s: clear front for 12 s
at 60 s: others gather at till for 9 s
at 90 s: lion awakens, split school into 3
when anybody sees lion awake: they become afraid, they run to door, they do point for 3 s
when guards sees anybody afraid: they look at lion for 5 s
when school reaches far: event there
when event there: others follow guards for 20 s
at 200 s: lion sleeps, everybody becomes calm
"""
ORDERS = {
    400: "others go to door",
    900: "others is free",
    2000: "everybody goes to far",
    2600: "everybody is free",
    5000: "split guards into 2",
}


@pytest.fixture(scope="module", params=["bodies", "minds"])
def played(request: pytest.FixtureRequest) -> tuple[str, list[bytes], str]:
    """Give the log of a scenario of 10,000 steps, its places at every thousandth, and the digest."""
    busy = request.param == "bodies"
    world = make_world(parse_scenario(BUSY if busy else MINDS), 7)
    texts = {} if busy else ORDERS
    rows = [(at, (*world.names.row_of(one), one.seconds)) for at, text in texts.items()
            for one in parse_actions(text, world.scenario)]  # fmt: skip
    log, kept = log_of(world, STEPS, EVERY, rows), []
    for number in range(STEPS):
        if number in texts:
            guide(world, texts[number])
        step(world)
        if (number + 1) % EVERY == 0:
            kept.append(world.bodies.place.tobytes())
    assert len(set(kept)) == len(kept), "people are on their way to the end"
    assert busy or {"awakens", "sleeps", "joined", "splits", "free", "event"} <= {
        word for _, text in world.told for word in text.split()
    }
    assert world.bodies.present.all() != busy, "some of the busy have left"
    return log, kept, digest(world)


@pytest.mark.skipif(shutil.which("node") is None, reason="no node on this machine")
def test_node_walks_as_python_does(played: tuple[str, list[bytes], str], tmp_path: Path) -> None:
    found = kept_places(in_node(played[0], tmp_path))
    assert found == played[1]
    assert hashlib.sha256(found[-1]).hexdigest()[:16] == played[2]


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_a_page_walks_as_python_does(played: tuple[str, list[bytes], str], tmp_path: Path) -> None:
    path = tmp_path / "core.html"
    path.write_text(page(played[0]), encoding="utf-8")
    with browser(tmp_path / "profile") as shown:
        shown.open(path)
        shown.wait_for("typeof LOG === 'object'")
        assert kept_places(shown.value("play(LOG)")) == played[1]
        assert not shown.complaints()


def test_a_changed_seed_or_order_walks_otherwise(played: tuple[str, list[bytes], str], tmp_path: Path) -> None:
    if shutil.which("node") is None:
        pytest.skip("no node on this machine")
    log = json.loads(played[0]) | {"steps": 2 * EVERY}
    assert kept_places(in_node(json.dumps(log), tmp_path)) == played[1][:2]
    told = log["told"] | {"seed": "8"}
    other = kept_places(in_node(json.dumps(log | {"told": told}), tmp_path))
    assert other[0] != played[1][0], "curves, wanderers and choices are of the seed"
    if log["orders"]:
        other = kept_places(in_node(json.dumps(log | {"orders": []}), tmp_path))
        assert other[0] != played[1][0]


def test_the_numbers_of_purposes_are_those_of_their_names() -> None:
    text = (MODULE.parent / "dice.ts").read_text(encoding="utf-8")
    told = re.findall(r"([A-Z]+): u64 = (0x[0-9a-f]{8})[,;]", text)
    assert len(told) == 14
    assert all(dice.purpose_number(name.lower()) >> 32 == int(number, 16) for name, number in told)


def test_the_way_of_a_ring_and_of_a_plane_are_one_where_nobody_crosses_the_seam() -> None:
    ground = make_ground([rectangle((20, 4), (60, 8))])
    place = np.stack([10 + 12 * dice.uniform(1, 1, np.arange(40)), 1 + 6 * dice.uniform(1, 2, np.arange(40))], axis=1)
    found = []
    for period_m in (0.0, 200.0):
        bodies = make_bodies(ground, place, period_m=period_m)
        bodies.goal[:], bodies.way[:], bodies.wants[:] = GIVEN, (1.0, 0.0), 1.3
        for _ in range(60):
            walk(bodies)
        found.append(bodies.place.copy())
    assert np.abs(found[0] - found[1]).max() < 1e-9


def test_rows_outlive_their_world() -> None:
    bodies = make_bodies(make_ground([rectangle((5, 5), (10, 10))]), np.array([[3.0, 4.0]]))
    place = bodies.place
    del bodies
    assert place.tolist() == [[3.0, 4.0]]


def test_a_world_larger_than_a_module_can_hold_is_a_sentence() -> None:
    with pytest.raises(ClonerError, match="too large for so many points"):
        CrowdEngine({"people": 1, "places": 60, "walls": 4, "rows": 2000, "cols": 2000, "reach": 2}, (0.0, 0.0))
