"""A scene that goes on while it is shown: clones come with consent, within seconds, and are gone without a rest."""

from __future__ import annotations

import json
import os
import shutil
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from cloner.behaviour.language import parse_scenario
from cloner.behaviour.loop import guide
from cloner.crowd.packs.reading import read_acted, read_facts
from cloner.crowd.staged.footing import COLUMNS, FROM, GONE, UNTIL, Acted, people_at
from cloner.errors import ClonerError
from cloner.personal_data.holdings import find_holding, holdings
from cloner.personal_data.privacy import forget
from cloner.scenes.served import living
from cloner.scenes.served.minds import HEAD_S, RunningScenario, WalkerFeet, start_scenario
from cloner.scenes.served.newcomers import Newcomer
from cloner.scenes.served.serving import serve_folder
from kit.crowds import dressed_toy, saved
from kit.living import SCENARIO, SECONDS, finished, hello_of, shown

GUESTS = "crowd 2 guests: from outside"
PEOPLE = 5  # who act; the sixth part is that of whoever walks along

pytestmark = [pytest.mark.gl, pytest.mark.slow]


def minds_in(built: Path) -> RunningScenario:
    facts = read_facts(built)
    return start_scenario(
        parse_scenario(facts["scenario"]["text"]), 1, read_acted(built, facts), facts["people"][0]["clips"]
    )


def walked(minds: RunningScenario, times: np.ndarray) -> list[np.ndarray]:
    """Everybody's footings as a page gathers them."""
    ways = [np.zeros((0, COLUMNS), np.float32) for _ in minds.feet.look]
    for now in times:
        for who, rows in minds.go_on(float(now)).items():
            ways[who] = np.concatenate([ways[who][ways[who][:, FROM] < rows[0, FROM]], rows])
    return ways


def test_who_goes_on_takes_the_very_steps_that_were_baked(built: Path) -> None:
    acted = read_acted(built, read_facts(built))
    for times in (np.arange(0, SECONDS - HEAD_S, 0.5), np.array([0.0, 0.07, 3.3, 3.4, 7.0])):
        ways = walked(minds_in(built), times)
        for who, way in enumerate(ways[:PEOPLE]):
            baked = acted.footings[acted.starts[who] : acted.starts[who + 1]]
            assert len(way) > 4
            assert np.array_equal(way[:-1], baked[: len(way) - 1])
            assert way[-1, UNTIL] >= times[-1] + 1.9, "feet are ahead of what is shown"


def test_who_walks_along_in_a_page_is_there_on_feet_and_gone_when_the_page_falls_silent(
    built, hot, monkeypatch
) -> None:
    clock = [time.monotonic()]
    monkeypatch.setattr(living.time, "monotonic", lambda: clock[0])
    scene, _ = shown(built, hot)
    scene._scenario = parse_scenario(SCENARIO.replace("group watchers: 2 people, visits b, starts at b", GUESTS))
    scene._begin()
    told, way = scene.told(0.01), np.zeros((0, COLUMNS), np.float32)
    assert 3 not in dict(next(told)[1]["of"])
    assert scene.walks("one", (4.0, -4.0, 0.0)) == 3
    assert scene.walks("two", (5.0, -4.0, 0.0)) == 4
    assert scene.walks("three", (5.0, -4.0, 0.0)) == -1, "two are expected"
    come = scene._minds.world.time_s
    for k in range(24):
        clock[0] += 0.5
        if k < 12:
            scene.walks("one", (4.0, -4.0 + 0.25 * min(k, 8), 0.0))
        scene.go_on()
        rows = scene._ways.get(3, way[:0])
        if len(rows):
            way = np.concatenate([way[way[:, FROM] < rows[0, FROM]], rows])
    assert scene.walks("three", (4.0, -4.0, 0.0)) >= 3, "both are free again"
    acted = read_acted(built, read_facts(built))
    alone = Acted(way, np.array([0, len(way)], np.uint32), acted.people[3:4].copy(), acted.touches, acted.clips)
    shown_at = {t: people_at(alone, come + t)[0, 0] for t in (-0.3, 0.5, 6.0, 14.0)}
    assert shown_at[-0.3][0] == shown_at[14.0][0] == GONE
    assert shown_at[0.5][1:3] == pytest.approx((4.0, -4.0), abs=0.3)
    assert shown_at[6.0][1:3] == pytest.approx((4.0, -2.0), abs=0.5), "it has walked"


def test_who_joins_while_minds_think_does_not_wait_for_them(built: Path, hot: Path, monkeypatch) -> None:
    scene, _ = shown(built, hot)
    finished(hot, "eve")
    scene.look()
    key = hello_of(scene)["newcomers"][0]["key"]
    thinks, free = threading.Event(), threading.Event()

    def think(minds: RunningScenario, shown_s: float) -> dict:
        thinks.set()
        free.wait(60.0)
        return {}

    monkeypatch.setattr(RunningScenario, "go_on", think)
    going = threading.Thread(target=scene.go_on, daemon=True)
    going.start()
    assert thinks.wait(10.0)
    joined: list[object] = []
    asking = threading.Thread(
        target=lambda: joined.extend((hello_of(scene), scene.file(key, "numbers.bin"))), daemon=True
    )
    asking.start()
    asking.join(20.0)
    free.set()
    going.join(20.0)
    assert len(joined) == 2
    assert joined[1], "a newcomer's file"


def test_who_leaves_is_gone_when_the_feet_have_left_and_no_part_is_free_then(built: Path) -> None:
    minds = minds_in(built)
    guide(minds.world, "everybody leaves by out")
    ways = walked(minds, np.arange(0, 25.0, 0.5))
    assert minds.over()
    for who, way in enumerate(ways[:PEOPLE]):
        assert way[-1, UNTIL] == pytest.approx(minds.gone_s[who], abs=1.0)
    with pytest.raises(ClonerError, match="nobody's part is free"):
        minds.farthest_walker(frozenset())


def test_a_newcomer_walks_on_with_its_own_feet_where_another_walked(built: Path) -> None:
    facts = read_facts(built)
    acted, minds = read_acted(built, facts), minds_in(built)
    ways = walked(minds, np.arange(0, 8.0, 0.5))
    who = minds.farthest_walker(frozenset())
    assert who < 3, "a walker's part, not a watcher's"
    other = 1 - int(acted.people[who, 1, 2])
    at = minds.set_feet(who, WalkerFeet(acted.touches[other], acted.clips[other], 1.0))
    assert 8.0 < at + 0.5 < 8.0 + HEAD_S
    more = walked(minds, np.arange(8.0, 25.0, 0.5))[who]
    way = np.concatenate([ways[who][ways[who][:, FROM] < more[0, FROM]], more])

    def places(clone: int, times: np.ndarray) -> np.ndarray:
        rows = acted.people[who : who + 1].copy()
        rows[0, 1, 2:4] = clone, 1.0
        alone = Acted(way, np.array([0, len(way)], np.uint32), rows, acted.touches, acted.clips)
        return np.array([people_at(alone, t)[0, 0, 1:3] for t in times])

    mine, theirs = places(other, np.arange(at, 24.0, 0.02)), np.arange(at, 24.0, 0.02)
    baked = np.array([people_at(acted, t)[who, 0, 1:3] for t in theirs[::10]])
    steps = np.linalg.norm(np.diff(mine, axis=0), axis=1)
    assert steps.max() < 0.06, "nobody jumps"
    assert steps.sum() > 5.0
    assert np.linalg.norm(mine[::10] - baked, axis=1).mean() < 0.35


def test_who_agreed_comes_and_who_did_not_is_told_and_stays_away(built: Path, hot: Path) -> None:
    scene, said = shown(built, hot)
    finished(hot, "ann", consent=False)
    finished(hot, "eve")
    (hot / ".half").mkdir()
    (saved(hot / "unfinished", dressed_toy())).joinpath("x").touch()
    for _ in range(4):
        scene.look()
    assert len(said) == 2
    assert "eve is in the scene" in said
    assert sum("no consent" in one and "ann" in one for one in said) == 1
    hello = hello_of(scene)
    (eve,) = hello["newcomers"]
    assert "eve" not in json.dumps(hello), "pages are told no name"
    assert set(eve) == {"key", "row", "fresh", "who", "at"}
    assert scene.file(eve["key"], "numbers.bin")
    assert scene.file(eve["key"], "../crowd.json") is None
    assert scene.file("other", "numbers.bin") is None


def test_who_is_forgotten_leaves_no_file_and_gives_the_part_back(built: Path, hot: Path) -> None:
    scene, said = shown(built, hot)
    finished(hot, "eve")
    scene.look()
    key = hello_of(scene)["newcomers"][0]["key"]
    assert scene.file(key, "atlas.webp")
    told = scene.told(0.01)
    next(told)
    assert forget(find_holding("eve", holdings(None, hot)), None, hot) == ()
    scene.look()
    assert next(told) == ("gone", {"key": key})
    assert scene.file(key, "atlas.webp") is None
    assert hello_of(scene)["newcomers"] == []
    assert said[-1] == "somebody has left the scene"


def test_the_newest_stay_and_a_clone_made_anew_comes_again(built: Path, hot: Path, monkeypatch) -> None:
    own = read_acted(built, read_facts(built))
    one = Newcomer({}, {}, own.touches[0], own.clips[0])
    monkeypatch.setattr(living, "make_newcomer", lambda *_: one)
    monkeypatch.setattr(living, "MOST", 2)
    scene, said = shown(built, hot)
    for number, name in enumerate("abc"):
        os.utime(finished(hot, name) / "clone.npz", (1000 + number, 1000 + number))
    for _ in range(4):
        scene.look()
    assert said == ["c is in the scene", "b is in the scene"]
    os.utime(hot / "a" / "clone.npz", (2000, 2000))
    for _ in range(3):
        scene.look()
    assert said[2:] == ["somebody has left the scene", "a is in the scene"]


def test_a_scene_that_is_taken_away_ends_everywhere(built: Path, hot: Path, tmp_path: Path) -> None:
    pack = tmp_path / "scene"
    shutil.copytree(built, pack)
    scene, _ = shown(pack, hot)
    finished(hot, "eve")
    scene.look()
    told = scene.told(0.01)
    key = next(told)[1]["newcomers"][0]["key"]
    assert forget(find_holding("ben", holdings(None, tmp_path)), None, tmp_path) == ()
    with pytest.raises(ClonerError, match="taken away"):
        scene.look()
    assert next(told)[0] == "over"
    assert next(told, None) is None
    assert scene.file(key, "atlas.webp") is None


def test_orders_are_obeyed_and_a_scene_that_everybody_has_left_begins_again(
    built: Path, hot: Path, monkeypatch
) -> None:
    scene, _ = shown(built, hot)
    finished(hot, "eve")
    scene.look()
    told = scene.told(0.01)
    (eve,) = next(told)[1]["newcomers"]
    with pytest.raises(ClonerError, match="column"):
        scene.order("walkers fly to moon")
    scene.order("walkers leaves by out")
    clock, kinds = [time.monotonic()], []
    monkeypatch.setattr(living.time, "monotonic", lambda: clock[0])
    for _ in range(120):
        clock[0] += 0.5
        scene.go_on()
        kinds.append(next(told)[0])
        if kinds[-1] == "plays":
            scene.order("everybody leaves by out")
        if kinds[-1] == "hello":
            break
    assert set(kinds) == {"steps", "plays", "hello"}, "who plays a part that leaves gets another, until all have left"
    assert scene.file(eve["key"], "atlas.webp")
    assert [one["key"] for one in hello_of(scene)["newcomers"]] == [eve["key"]]


def test_a_page_that_takes_nothing_is_let_go_and_memory_does_not_grow(built: Path, hot: Path) -> None:
    scene, _ = shown(built, hot)
    slow = scene.told(0.01)
    next(slow)
    for _ in range(living.KEPT_EVENTS + 5):
        scene.go_on()
    assert list(slow) == [], "it may ask anew"
    assert len(scene._events) == living.KEPT_EVENTS


def test_what_cannot_be_shown_is_one_sentence(built: Path, lively: Path, hot: Path) -> None:
    with pytest.raises(ClonerError, match="acts no scenario"):
        serve_folder(lively, hot, said=str)
    with pytest.raises(ClonerError, match="no such folder"):
        serve_folder(built, hot / "none", said=str)
    with pytest.raises(ClonerError, match="no crowd"):
        serve_folder(hot, hot, said=str)
