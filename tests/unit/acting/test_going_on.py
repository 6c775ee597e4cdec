"""A page from the disk goes on with its scenario: the engine's own steps, who walks along, events, all anew."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from cloner.acting.going_on import with_guest
from cloner.acting.written import bake_file
from cloner.behaviour.language import parse_scenario
from cloner.crowd.packs.check import check_pack
from cloner.crowd.packs.reading import read_acted, read_facts
from cloner.crowd.staged.footing import GONE, people_at
from kit.browser import CHROMIUM, Page, browser

pytestmark = [pytest.mark.gl, pytest.mark.slow,
              pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")]  # fmt: skip
PEOPLE, BAKED_S, LONG_S = 7, 7.0, 30.0
RULES = "when event bell: guests go to door, guests do applaud for 20 s\nat 13 s: sorry leaves by door\n"


@pytest.fixture(scope="module")
def packs(scenario: Path, lively: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The same scenario baked for some seconds and for longer."""
    folder = tmp_path_factory.mktemp("going")
    (folder / "bell.crowd").write_text(scenario.read_text() + RULES)
    for name, seconds in (("short", BAKED_S), ("long", LONG_S)):
        bake_file(folder / "bell.crowd", lively, folder / name, seconds=seconds, seed=3)
    return folder / "short", folder / "long"


@pytest.fixture
def page(packs: tuple[Path, Path], tmp_path: Path) -> Iterator[Page]:
    with browser(tmp_path / "profile") as shown:
        shown.open(packs[0] / "player.html", 160, 100)
        shown.wait_for("document.body && document.body.dataset.ready", 120)
        shown.value("renderer.setAnimationLoop(null), 1")
        yield shown
        assert not shown.complaints()
        assert all(address.startswith(("file:", "blob:", "data:", "about:")) for address in shown.requests())


def went_on(page: Page, seconds: float, visitor: str = "null") -> tuple[float, np.ndarray]:
    """Let the page's time pass without drawing; return its time and everybody's rows."""
    told = page.value(
        f"(async () => {{ for (let k = 0; k < {round(seconds * 20)}; k++) {{ minds.walk({visitor});"
        " state.now = minds.go_on(state.now, 0.05); if (k % 5 === 0) await new Promise((go) => setTimeout(go)); }"
        " act();"
        " return JSON.stringify([state.now, Array.from(walkers.rows)]); })()"
    )
    now, rows = json.loads(told)
    return now, np.array(rows).reshape(-1, 5, 4)


def test_the_page_takes_the_very_steps_that_a_longer_bake_has(page: Page, packs: tuple[Path, Path]) -> None:
    acted = read_acted(packs[1], read_facts(packs[1]))
    assert check_pack(packs[0])[-1].startswith(f"scenario: {PEOPLE + 1} people act {BAKED_S:g} s")
    for _ in range(12):
        now, rows = went_on(page, 1.9)
        want = people_at(acted, now)
        assert np.array_equal(rows[:, 0, 0] < GONE, want[:, 0, 0] < GONE)
        here = want[:, 0, 0] < GONE
        assert np.abs(rows[here] - want[here]).max(initial=0.0) < 1e-4, now
    assert now > 2.0 * BAKED_S
    assert page.value("minds.begun")


def test_who_walks_along_is_gone_round_and_leaves_no_double(page: Page) -> None:
    _, alone = went_on(page, 5.0)
    least = np.inf
    for _ in range(8):
        _, rows = went_on(page, 1.0, "[6, -5, 1.2]")
        here = rows[:, 0, 0] < GONE
        assert not here[PEOPLE], "nobody sees the own body"
        least = min(least, float(np.linalg.norm(rows[here, 0, 1:3] - (6.0, -5.0), axis=1).min()))
    assert page.value("minds.own") == PEOPLE
    assert 0.2 < least < 3.0, "they came past, and not through"
    for _ in range(8):
        _, rows = went_on(page, 0.5)
        assert not rows[PEOPLE, 0, 0] < GONE
    assert (alone[:PEOPLE, 0, 0] < GONE).all()


def test_an_event_of_the_scenario_can_be_let_happen(page: Page) -> None:
    assert page.value("minds.events") == ["bell"]
    assert page.value("Array.from(document.querySelectorAll('#knobs button')).map((one) => one.textContent)").count(
        "bell"
    )
    went_on(page, 2.0)
    page.value(
        "Array.from(document.querySelectorAll('#knobs button')).find((one) => one.textContent === 'bell').click()"
    )
    found = set()
    for _ in range(24):
        _, rows = went_on(page, 0.5)
        found |= {int(one) for one in rows[:5, 2, 3]}
    clips = page.value("facts.people[0].clips.map((one) => one.name)")
    assert clips.index("applaud") in found


def test_when_all_have_left_it_begins_anew_otherwise(page: Page) -> None:
    first = went_on(page, 6.0)[1]
    times = []
    for _ in range(40):
        now, rows = went_on(page, 2.0)
        times.append(now)
        if len(times) > 1 and now < times[-2]:
            break
    assert now < times[-2], "after those who were to leave have left"
    now, rows = went_on(page, 6.0 - now)
    assert now == pytest.approx(6.0, abs=0.1)
    here = rows[:PEOPLE, 0, 0] < GONE
    assert here.all()
    assert np.abs(rows[:PEOPLE, 0, 1:3] - first[:PEOPLE, 0, 1:3]).max() > 0.05, "chance is another"


def test_a_scene_that_has_come_to_rest_begins_anew_but_not_before_a_visitors_eyes(lively: Path, tmp_path: Path) -> None:
    text = "floor 0, 0 to 8, 6\npoint b at 6, 3 region 2 x 2\npoint a at 2, 3\n"
    (tmp_path / "rest.crowd").write_text(text + "group two: 2 people, visits b, starts at a\n")
    bake_file(tmp_path / "rest.crowd", lively, tmp_path / "rest", seconds=3.0, seed=3)
    with browser(tmp_path / "profile") as page:
        page.open(tmp_path / "rest" / "player.html", 160, 100)
        page.wait_for("document.body && document.body.dataset.ready", 120)
        page.value("renderer.setAnimationLoop(null), 1")
        now, _ = went_on(page, 90.0, "[1, -5, 0]")
        assert now > 75.0
        again, rows = went_on(page, 5.0)
        assert again < 10.0
        assert (rows[:2, 0, 0] < GONE).all()
        assert not page.complaints()


def test_a_scenario_without_guests_gets_one_and_no_name_twice() -> None:
    text = "floor 0, 0 to 8, 6\ngroup visitor: 2 people"
    groups = parse_scenario(with_guest(text)).groups
    assert [(one.name, one.people, one.outside) for one in groups][1:] == [("visitor_", 1, True)]
    known = text + "\ncrowd 3 friends: from outside\n"
    assert with_guest(known) == known
