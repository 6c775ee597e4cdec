"""A served scene: two browsers see the same, who is cut off is back, and nobody without the token is let in."""

from __future__ import annotations

import http.client
import json
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from urllib.parse import urlsplit

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from cloner.errors import ClonerError
from cloner.personal_data.holdings import find_holding, holdings
from cloner.personal_data.privacy import forget
from cloner.scenes.served.living import RunningScene
from cloner.scenes.served.serving import HOST, LONGEST_BYTES, MOST_PAGES, advancing, served
from kit.browser import CHROMIUM, browser
from kit.living import finished, hello_of, shown

pytestmark = [pytest.mark.gl, pytest.mark.slow]


def asked(url: str, path: str = "", method: str = "GET", **headers: str) -> int:
    place = urlsplit(url)
    line = http.client.HTTPConnection(place.hostname, place.port, timeout=60)
    line.request(method, path if path.startswith("/") else place.path + path, headers=headers)
    code = line.getresponse().status
    line.close()
    return code


def page_at(url: str, **headers: str) -> ClientConnection:
    place = urlsplit(url)
    told = {"Origin": f"http://{place.netloc}", **headers}
    return connect(
        url.replace("http", "ws", 1) + "live", origin=told.pop("Origin"), additional_headers=told, proxy=None
    )


def answered(page: ClientConnection, said: str) -> dict:
    page.send(said)
    while True:
        told = json.loads(page.recv(timeout=60))
        if told["kind"] == "answer":
            return dict(told)


@pytest.fixture
def open_scene(built: Path, hot: Path) -> Iterator[tuple[RunningScene, str]]:
    scene, _ = shown(built, hot)
    with served(scene, "42".__eq__) as url, advancing(scene):
        yield scene, url


def test_only_who_knows_the_address_is_answered_and_only_this_machine(open_scene, built: Path, hot: Path) -> None:
    _, url = open_scene
    place = urlsplit(url)
    assert place.hostname == HOST
    assert len(place.path) > 30
    assert asked(url) == 200
    for wrong in ("/", "/guess/", "/guess/live", "crowd.json", "newcomers/../crowd.json", "newcomers/a/b"):
        assert asked(url, wrong) == 404
    assert asked(url, Host="evil.example") == 404, "a foreign page that calls this machine by another name"
    assert asked(url, "live") == 404, "no socket without a page of ours"
    assert asked(url, "", "POST") != 200
    for origin in ("http://evil.example", f"https://{place.netloc}"):
        with pytest.raises(InvalidStatus):
            page_at(url, Origin=origin)
    with pytest.raises(InvalidStatus):
        page_at(f"http://{place.netloc}/guess/")
    with pytest.raises(ClonerError, match="cannot be had"), served(shown(built, hot)[0], bool, HOST, place.port):
        pass


@pytest.mark.parametrize("host", ["0.0.0.0", "8.8.8.8", "evil.example", "", "::1"])
def test_no_address_but_an_own_one_is_opened(built: Path, hot: Path, host: str) -> None:
    with pytest.raises(ClonerError, match="network of one's own"), served(shown(built, hot)[0], bool, host):
        pass


def test_only_the_operator_is_obeyed(open_scene) -> None:
    scene, url = open_scene
    with page_at(url) as page:
        assert "number" in answered(page, '{"order": "walkers goes to b"}')["error"]
        begun = time.monotonic()
        assert answered(page, '{"number": "41"}')["staff"] is False
        assert time.monotonic() - begun > 0.4, "guessing is slow"
        assert "number" in answered(page, '{"order": "walkers goes to b"}')["error"]
        assert not scene._minds.world.guided
        assert answered(page, '{"number": "42"}')["staff"] is True
        assert "moon" in answered(page, '{"order": "walkers goes to moon"}')["error"]
        assert answered(page, '{"order": "walkers goes to b"}')["obeyed"]
        with page_at(url) as other:
            assert "number" in answered(other, '{"order": "walkers goes to b"}')["error"], "staff on one page alone"


def test_who_walks_along_tells_where_and_needs_no_number(open_scene) -> None:
    scene, url = open_scene
    heard = []
    scene.walks = lambda page, place: heard.append(place) or 3  # type: ignore[method-assign]
    with page_at(url) as page:
        assert answered(page, '{"walk": "4.5 -3 1.57"}')["who"] == 3
        answered(page, '{"walk": ""}')
    for _ in range(100):
        if len(heard) == 3:
            break
        time.sleep(0.1)
    assert heard == [(4.5, -3.0, 1.57), None, None], "a page that is closed walks no more"


@pytest.mark.parametrize(
    "said",
    [
        '{"walk": "4"}', '{"walk": "1 nan 0"}', '{"walk": "0 0 inf"}', '{"walk": "1e9 0 0"}', '{"walk": "a b c"}',
        "", "{", "[]", "null", '"order"', '{"order": 1}', '{"order": "a", "number": "42"}', '{"hello": "a"}',
        b"\xff\x00",
        '{"number": "\\ud800"}', "[" * 900, "x" * (LONGEST_BYTES + 1), '{"order": "' + "a" * 2 * LONGEST_BYTES + '"}',
    ],
)  # fmt: skip
def test_what_is_no_message_ends_that_page_and_the_scene_goes_on(open_scene, said: str | bytes) -> None:
    _, url = open_scene
    with page_at(url) as page, page_at(url) as other:
        page.send(said)
        with pytest.raises(ConnectionClosed):
            list(page)
        assert json.loads(other.recv(timeout=60))["kind"] == "hello"
        assert json.loads(other.recv(timeout=60))["kind"] == "steps"
    assert asked(url) == 200


def test_there_are_so_many_places_and_they_are_given_back(open_scene) -> None:
    _, url = open_scene
    with ExitStack() as stack:
        pages = [stack.enter_context(page_at(url)) for _ in range(MOST_PAGES)]
        assert all(json.loads(page.recv(timeout=60))["kind"] == "hello" for page in pages)
        with page_at(url) as late, pytest.raises(ConnectionClosed) as closed:
            late.recv(timeout=60)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1013
    end = time.monotonic() + 60.0
    while time.monotonic() < end:
        with page_at(url) as again:
            try:
                assert json.loads(again.recv(timeout=60))["kind"] == "hello"
                return
            except ConnectionClosed:
                time.sleep(0.2)
    raise AssertionError("no place was given back")


def test_at_the_end_nothing_listens(built: Path, hot: Path) -> None:
    scene, _ = shown(built, hot)
    with ExitStack() as stack:
        with served(scene, bool) as url, advancing(scene):
            page = stack.enter_context(page_at(url))
            assert json.loads(page.recv(timeout=60))["kind"] == "hello"
        assert [json.loads(one)["kind"] for one in page][-1] == "over"
    with pytest.raises(OSError, match="efused"):
        socket.create_connection((HOST, urlsplit(url).port), 1.0)


def in_page(page, url: str) -> None:
    page._ask("Emulation.setDeviceMetricsOverride", width=320, height=180, deviceScaleFactor=1, mobile=False)
    page._ask("Page.navigate", url=url)
    page.wait_for("document.body?.dataset.ready === 'yes' && live.rejoined !== null", 120)


def watched(scene: RunningScene, over: threading.Event) -> None:
    while not over.wait(0.2) and not scene.over:
        scene.look()


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_the_camera_finds_who_has_come_and_who_is_forgotten_is_gone(built: Path, hot: Path, tmp_path: Path) -> None:
    scene, _ = shown(built, hot)
    over = threading.Event()
    threading.Thread(target=watched, args=(scene, over), daemon=True).start()
    with served(scene, "42".__eq__) as url, advancing(scene), browser(tmp_path / "profile") as page:
        in_page(page, url)
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
        page.value("window.prompt = () => 'watchers goes to a'")
        page.value("live.order('watchers goes to a')")
        page.value("window.alert = (text) => { window.said = text; }")
        page.value("live.order('watchers goes to moon')")
        page.wait_for("!live.staff || window.said?.includes('moon')", 20)
        assert not page.complaints()
        assert all(one.startswith(url) for one in page.requests())
        page.wait_for("state.camera === 'live' && !live.staff", 60)
        over.set()
        scene.stop()
        page.wait_for("document.querySelector('#status').textContent.includes('no longer')", 20)


SEEN = """(() => { const rows = acted.people.slice(); acted.at(AT, rows); return Array.from(rows); })()"""


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_two_browsers_see_the_same_people_and_one_that_was_cut_off_is_back(built: Path, hot: Path, tmp_path) -> None:
    scene, _ = shown(built, hot)
    finished(hot, "eve")
    scene.look()
    with (
        served(scene, bool) as url, advancing(scene),
        browser(tmp_path / "one") as first, browser(tmp_path / "two") as second,
    ):  # fmt: skip
        for page in (first, second):
            in_page(page, url)
            page.wait_for("live.newcomers.size === 1 && live.settled", 60)
        scene.order("watchers goes to a")
        second.value("live.cut()")
        second.wait_for("live.rejoined === null", 10)
        second.wait_for("live.rejoined !== null", 10)
        assert second.value("live.rejoined") < 3.0
        scene.order("walkers do wave for 3 s")
        for _ in range(3):  # past what was told when the link was back: each page's own steps
            time.sleep(2.5)
            at = f"{scene.now() - 0.5:.3f}"
            seen = [np.array(page.value(SEEN.replace("AT", at)), np.float32) for page in (first, second)]
            assert np.array_equal(seen[0], seen[1])
            rows = seen[0].reshape(-1, 5, 4)
            assert (rows[:5, 0, 0] == 3.0).all(), "everybody is there"
            eve = rows[hello_of(scene)["newcomers"][0]["who"]]
            assert eve[1, 2] == 2.0, "the third clone, in both"
        assert first.value("live.runner.core.sum()") != 0
        runner = "window.before = live.runner; live.runner.rows.place[0] += 0.1"
        second.value(runner)
        second.wait_for("live.runner !== window.before", 20)  # it sees that it goes other steps, and asks anew
        assert not (first.complaints() + [one for one in second.complaints() if "live" not in one])


KEY = "{ key: 'K', ctrlKey: true, shiftKey: true, bubbles: true }"
