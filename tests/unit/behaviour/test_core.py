"""The core is what its source says, and gives the same bits in Python, node and Chromium."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from pathlib import Path

import numpy as np
import pytest

from cloner.behaviour import dice
from cloner.behaviour.core.host import MODULE, Core
from cloner.behaviour.ground import box, ground_of
from cloner.behaviour.language import read_text
from cloner.behaviour.loop import digest, step
from cloner.behaviour.walking import GIVEN, bodies_on, walk
from cloner.behaviour.world import world_of
from cloner.errors import ClonerError
from kit.browser import CHROMIUM, browser
from kit.core_log import CoreLog, in_node, kept_places, page
from kit.scripts import script

BUILD = script("build_walkers")
PACKAGES = Path(os.environ.get("CLONER_NODE_MODULES", "/nowhere"))
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


@pytest.fixture(scope="module")
def played() -> tuple[str, list[bytes], str]:
    """Give the log of a scenario of 10,000 steps, its places at every thousandth, and the digest."""
    world = world_of(read_text(BUSY), 7)
    log = CoreLog(world.bodies, world.ground, places=len(world.places), seed=7)
    kept = []
    for number in range(1, STEPS + 1):
        step(world)
        if number % EVERY == 0:
            kept.append(world.bodies.place.tobytes())
    assert len(set(kept)) == len(kept), "people are on their way to the end"
    assert not world.bodies.present.all(), "some have left"
    return log.written(EVERY), kept, digest(world)


def test_the_module_is_what_its_provenance_says() -> None:
    told = json.loads(MODULE.with_name("PROVENANCE.json").read_text(encoding="utf-8"))[0]
    assert told["sha256"] == hashlib.sha256(MODULE.read_bytes()).hexdigest()
    assert told["source"] == BUILD.source_digests(), "generic_models/build/build_walkers.py was not run"


@pytest.mark.skipif(not (PACKAGES / "node_modules" / "assemblyscript").is_dir(), reason="no AssemblyScript here")
def test_the_module_is_built_again_to_the_byte() -> None:
    assert BUILD.built(PACKAGES) == MODULE.read_bytes()


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


def test_a_changed_seed_or_log_walks_otherwise(played: tuple[str, list[bytes], str], tmp_path: Path) -> None:
    if shutil.which("node") is None:
        pytest.skip("no node on this machine")
    log = json.loads(played[0]) | {"steps": 2 * EVERY}
    log["changes"] = [one for one in log["changes"] if one[0] < 2 * EVERY]
    assert kept_places(in_node(json.dumps(log), tmp_path)) == played[1][:2]
    other = kept_places(in_node(json.dumps(log | {"seed": "8"}), tmp_path))
    assert other[0] != played[1][0], "curves and wanderers are of the seed"


def test_the_way_of_a_ring_and_of_a_plane_are_one_where_nobody_crosses_the_seam() -> None:
    ground = ground_of([box((20, 4), (60, 8))])
    place = np.stack([10 + 12 * dice.uniform(1, 1, np.arange(40)), 1 + 6 * dice.uniform(1, 2, np.arange(40))], axis=1)
    found = []
    for period_m in (0.0, 200.0):
        bodies = bodies_on(ground, place, period_m=period_m)
        bodies.goal[:], bodies.way[:], bodies.wants[:] = GIVEN, (1.0, 0.0), 1.3
        for _ in range(60):
            walk(bodies)
        found.append(bodies.place.copy())
    assert np.abs(found[0] - found[1]).max() < 1e-9


def test_rows_outlive_their_world() -> None:
    bodies = bodies_on(ground_of([box((5, 5), (10, 10))]), np.array([[3.0, 4.0]]))
    place = bodies.place
    del bodies
    assert place.tolist() == [[3.0, 4.0]]


def test_a_world_larger_than_a_module_can_hold_is_a_sentence() -> None:
    with pytest.raises(ClonerError, match="too large for so many points"):
        Core(people=1, places=60, walls=4, cells=(2000, 2000), reach=2, low=(0, 0), period_m=0.0, seed=0)
