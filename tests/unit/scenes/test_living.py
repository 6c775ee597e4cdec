"""Clones that come into a scene while it is shown: within seconds, with consent, and gone without a rest."""

from __future__ import annotations

import http.client
import json
import os
import socket
import threading
import time
from functools import partial
from pathlib import Path
from urllib.parse import urlsplit

import numpy as np
import pytest

from cloner.crowd.footing import Acted, rows_at
from cloner.crowd.levels import body_levels
from cloner.crowd.people import Found
from cloner.crowd.reading import read_acted, read_facts
from cloner.errors import ClonerError
from cloner.holdings import find_holding, holdings
from cloner.privacy import forget
from cloner.project.results import RESULT_MARK, file_digest
from cloner.scenes import living
from cloner.scenes.inhabited import build_folder
from cloner.scenes.living import Living, finished_in
from cloner.scenes.newcomers import footings_for, newcomer_of, part_for, parts_in
from cloner.scenes.serving import HOST, serve_folder, served
from kit.browser import CHROMIUM, browser
from kit.crowds import dressed_toy, saved

pytestmark = [pytest.mark.gl, pytest.mark.slow]
SECONDS = 30.0
SCENARIO = """floor 0, 0 to 8, 6
point a at 1.5, 3 region 2 x 4
point b at 6.5, 3 region 2 x 4
group walkers: 3 people, visits a > b again, starts at a, adapts to space
group watchers: 2 people, visits b, starts at b
"""


@pytest.fixture(scope="module")
def built(lit_folder: Path, lively: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("served")
    (folder / "walk.crowd").write_text(SCENARIO)
    build_folder(lit_folder, folder / "walk.crowd", lively, folder / "scene", seconds=SECONDS, seed=1)
    return folder / "scene"


@pytest.fixture
def hot(tmp_path: Path) -> Path:
    (tmp_path / "clones").mkdir()
    return tmp_path / "clones"


def finished(folder: Path, name: str, **told: object) -> Path:
    """A clone that appears whole, as a result does."""
    aside = saved(folder / f".{name}", dressed_toy(1.60, shift=-40, **told))
    listed = {"clone.npz": file_digest(aside / "clone.npz")}
    (aside / RESULT_MARK).write_text(json.dumps({"format": 3, "stamp": {}, "outputs": listed}))
    return aside.rename(folder / name)


def shown(built: Path, hot: Path) -> tuple[Living, list[str]]:
    said: list[str] = []
    return Living(built, partial(finished_in, hot), said.append), said


def heard(scene: Living) -> list[tuple[str, dict]]:
    """What a page that opens now is told at once."""
    events = []
    for event in scene.told(0.01):
        if event is None:
            break
        events.append(event)
    return events


def test_a_newcomer_walks_a_walkers_way_with_steps_of_its_own(built: Path, hot: Path) -> None:
    facts = read_facts(built)
    acted = read_acted(built, facts)
    own = newcomer_of(Found("eve", finished(hot, "eve")), facts, body_levels())
    parts = parts_in(acted, SECONDS)
    who = part_for(parts, 2.0, frozenset())
    assert who < 3, "a walker's part, not a watcher's"
    assert part_for(parts, 2.0, frozenset({who})) not in (who, 3, 4)
    footings = footings_for(own, acted, who)
    alone = Acted(
        footings, np.array([0, len(footings)], np.uint32), acted.people[who : who + 1].copy(), own.touches[None],
        own.clips[None],
    )  # fmt: skip
    alone.people[0, 1, 2:4] = 0.0, 1.0
    times = np.arange(1.0, SECONDS - 1.0, 0.5)
    mine = np.array([rows_at(alone, t)[0, 0, 1:3] for t in times])
    theirs = np.array([rows_at(acted, t)[who, 0, 1:3] for t in times])
    away = np.linalg.norm(mine - theirs, axis=1)
    assert away.mean() < 0.35
    assert away.max() < 1.2
    assert np.linalg.norm(np.diff(mine, axis=0), axis=1).sum() > 5.0


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
    (kind, hello), *rest = heard(scene)
    assert kind == "hello"
    assert not rest
    (eve,) = hello["newcomers"]
    assert "eve" not in json.dumps(hello), "pages are told no name"
    assert set(eve) == {"key", "row", "fresh"}
    part = json.loads(scene.file(eve["key"], "part.json") or b"")
    assert part["who"] < 3
    assert scene.file(eve["key"], "../crowd.json") is None
    assert scene.file("other", "numbers.bin") is None


def test_who_is_forgotten_leaves_no_file_and_gives_the_part_back(built: Path, hot: Path) -> None:
    scene, said = shown(built, hot)
    finished(hot, "eve")
    scene.look()
    key = heard(scene)[0][1]["newcomers"][0]["key"]
    assert scene.file(key, "atlas.webp")
    told = scene.told(0.01)
    next(told)
    assert forget(find_holding("eve", holdings(None, hot)), None, hot) == ()
    scene.look()
    assert next(told) == ("gone", {"key": key})
    assert scene.file(key, "atlas.webp") is None
    assert scene.file(key, "part.json") is None
    assert heard(scene)[0][1]["newcomers"] == []
    assert said[-1] == "somebody has left the scene"


def test_the_newest_stay_and_a_clone_made_anew_comes_again(built: Path, hot: Path, monkeypatch) -> None:
    monkeypatch.setattr(living, "newcomer_of", lambda found, *_: type("One", (), {"row": {}, "files": {}})())
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
    import shutil

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


def asked(url: str, path: str = "", method: str = "GET", body: str | None = None, **headers: str) -> int:
    place = urlsplit(url)
    line = http.client.HTTPConnection(place.hostname, place.port, timeout=10)
    line.request(method, path if path.startswith("/") else place.path + path, body, headers)
    code = line.getresponse().status
    line.close()
    return code


def test_only_who_knows_the_address_is_answered_and_only_this_machine(built: Path, hot: Path) -> None:
    scene, _ = shown(built, hot)
    with served(scene, lambda number: number == "42") as url:
        assert urlsplit(url).hostname == HOST
        assert len(urlsplit(url).path) > 30
        assert asked(url) == 200
        assert asked(url, "/") == 404
        assert asked(url, "/guess/") == 404
        assert asked(url, "crowd.json") == 404
        assert asked(url, "newcomers/../crowd.json") == 404
        assert asked(url, Host="evil.example") == 404, "a foreign page that calls this machine by another name"
        assert asked(url, "staff", "POST", "42") == 200
        assert asked(url, "staff", "POST", "41") == 403
        assert asked(url, "staff", "POST", "4" * 1000) == 404
        port = urlsplit(url).port
        with pytest.raises(ClonerError, match="cannot be had"), served(shown(built, hot)[0], bool, port):
            pass
    with pytest.raises(OSError, match="efused"):
        socket.create_connection((HOST, port), 1.0)


def test_what_cannot_be_shown_is_one_sentence(built: Path, lively: Path, hot: Path) -> None:
    with pytest.raises(ClonerError, match="acts no scenario"):
        serve_folder(lively, hot, said=str)
    with pytest.raises(ClonerError, match="no such folder"):
        serve_folder(built, hot / "none", said=str)
    with pytest.raises(ClonerError, match="no crowd"):
        serve_folder(hot, hot, said=str)


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_the_camera_finds_who_has_come_and_who_is_forgotten_is_gone(built: Path, hot: Path, tmp_path: Path) -> None:
    scene, _ = shown(built, hot)
    over = threading.Event()

    def watch() -> None:
        while not over.wait(0.2) and not scene.over:
            scene.look()

    threading.Thread(target=watch, daemon=True).start()
    with served(scene, lambda number: number == "42") as url, browser(tmp_path / "profile") as page:
        page._ask("Emulation.setDeviceMetricsOverride", width=320, height=180, deviceScaleFactor=1, mobile=False)
        page._ask("Page.navigate", url=url)
        page.wait_for("document.body?.dataset.ready === 'yes'", 120)
        assert page.value("[state.camera, document.querySelector('#knobs').style.display]") == ["live", "none"]
        before = page.value("[stage.people.length, acted.people.length]")
        finished(hot, "eve")
        done = time.time()
        page.wait_for("live.history.length && live.history[0].step", 60)
        assert page.value("live.history[0].step") - done < 30.0, "10 s on a machine that does nothing else"
        assert page.value("live.followed") == page.value("live.history[0].who")
        assert page.value("document.querySelector('#caption').textContent") == "You are in the cell"
        assert page.value("walkers.rows[live.followed * 20 + 6]") == 2, "the third clone, after the pack's two"
        page.wait_for(
            "Math.hypot(camera.position.x - walkers.x[live.followed], camera.position.z - walkers.z[live.followed]) < 5"
        )
        assert forget(find_holding("eve", holdings(None, hot)), None, hot) == ()
        page.wait_for("live.newcomers.size === 0", 30)
        assert page.value("stage.people[2] === stage.people[0] && live.parts.size === 0")
        assert page.value("acted.people.length") == before[1]
        page.value("canvas.dispatchEvent(new PointerEvent('pointerdown', { bubbles: true, pointerId: 1 }))")
        assert page.value("state.camera") == "orbit"
        page.value("window.prompt = () => '41'; dispatchEvent(new KeyboardEvent('keydown', KEY))".replace("KEY", KEY))
        time.sleep(1.0)
        assert not page.value("live.staff")
        page.value("window.prompt = () => '42'; dispatchEvent(new KeyboardEvent('keydown', KEY))".replace("KEY", KEY))
        page.wait_for("live.staff && document.querySelector('#knobs').style.display === ''", 20)
        page.wait_for("state.camera === 'live' && !live.staff", 60)
        assert all("403" in one for one in page.complaints())
        assert all(one.startswith(url) for one in page.requests())
        over.set()
        scene.stop()
        page.wait_for("document.querySelector('#status').textContent.includes('no longer')", 20)


KEY = "{ key: 'K', ctrlKey: true, shiftKey: true, bubbles: true }"
