"""Other programs guide a running scenario: orders in the next step, the token asked for, everything wrong in a line."""

from __future__ import annotations

import json
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("websockets")

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from cloner.behaviour import guiding
from cloner.behaviour.guiding import (
    HOST,
    LONGEST_BYTES,
    MOST_GUIDES,
    NOT_ALLOWED,
    RequestQueue,
    guided_steps,
    serve_guides,
)
from cloner.behaviour.language import parse_scenario
from cloner.behaviour.trajectories import read_trajectories
from cloner.behaviour.walking import STEP_S
from cloner.behaviour.world import World, make_world
from cloner.behaviour.written import guide_file
from cloner.errors import ClonerError

TEXT = """floor 0, 0 to 20, 12
point east at 18, 6 region 3 x 6
point west at 2, 6 region 3 x 6
group school: 4 people, starts at east
"""


@pytest.fixture
def world() -> World:
    return make_world(parse_scenario(TEXT, "hall"), 3)


def asked(guest: ClientConnection, **message: object) -> dict:
    guest.send(json.dumps(message))
    return json.loads(guest.recv(timeout=60))


@contextmanager
def entered(desk: RequestQueue, port: int) -> Iterator[ClientConnection]:
    with connect(f"ws://{HOST}:{port}", compression=None) as guest:
        assert asked(guest, token=desk.token) == {"welcome": True}
        yield guest


@pytest.fixture
def running(world):
    """A world that runs a hundred times faster than the clock until a guide ends it: desk, port, the loop's thread."""
    desk = RequestQueue()

    def walk() -> None:
        for _ in guided_steps(world, desk, 1e4, pace=lambda _: time.sleep(STEP_S / 100.0)):
            pass

    with serve_guides(desk) as port:
        loop = threading.Thread(target=walk, daemon=True)
        loop.start()
        yield desk, port, loop
        if loop.is_alive():
            with entered(desk, port) as guest:
                asked(guest, do="end")
        loop.join(10.0)


def test_an_order_is_obeyed_within_two_steps_and_turns_people_round(running, world) -> None:
    desk, port, loop = running
    with entered(desk, port) as guest:
        before = asked(guest, do="look")
        assert {one["group"] for one in before["people"]} == {"school"}
        answer = asked(guest, do="order", text="school goes to west")
        assert answer["obeyed_from_s"] - answer["at_s"] <= 2.0 * STEP_S + 1e-9
        while (shown := asked(guest, do="look"))["at_s"] < answer["at_s"] + 25.0:
            time.sleep(0.02)
        assert np.mean([one["place_m"][0] for one in shown["people"]]) < 6.0
        assert asked(guest, do="end")["ended"]
    loop.join(10.0)
    assert not loop.is_alive()


def test_what_is_wrong_is_said_in_a_line_and_the_scenario_goes_on(running) -> None:
    desk, port, loop = running
    with entered(desk, port) as guest:
        assert "nobody" in asked(guest, do="order", text="nobody goes to west")["error"]
        assert "order, look or end" in asked(guest, do="delete")["error"]
        guest.send("{not json")
        assert "no message" in json.loads(guest.recv(timeout=60))["error"]
        guest.send(json.dumps([1]))
        assert "no message" in json.loads(guest.recv(timeout=60))["error"]
        first = asked(guest, do="look")["at_s"]
        guest.send("x" * (LONGEST_BYTES + 1))
        with pytest.raises(ConnectionClosed):
            guest.recv(timeout=60)
    with entered(desk, port) as guest:
        assert asked(guest, do="look")["at_s"] > first
    assert loop.is_alive()


@pytest.mark.parametrize(
    "first", ['{"token": "guess"}', '{"token": null}', "hello", "[]", '{"token": "\\ud800"}', "[" * LONGEST_BYTES]
)
def test_nobody_gets_in_without_the_token(running, first: str) -> None:
    _, port, loop = running
    with connect(f"ws://{HOST}:{port}", compression=None) as guest:
        guest.send(first)
        with pytest.raises(ConnectionClosed) as refused:
            guest.recv(timeout=60)
    assert refused.value.rcvd is not None
    assert refused.value.rcvd.code == NOT_ALLOWED
    assert "token" in refused.value.rcvd.reason
    assert loop.is_alive()


def test_more_guides_than_places_are_sent_away_and_places_come_back(running) -> None:
    desk, port, _ = running
    with ExitStack() as guests:
        for _ in range(MOST_GUIDES):
            guests.enter_context(entered(desk, port))
        with connect(f"ws://{HOST}:{port}", compression=None) as late, pytest.raises(ConnectionClosed):
            late.recv(timeout=60)
    threading.Event().wait(1.5)
    with entered(desk, port) as guest:
        assert asked(guest, do="look")["people"]


def test_a_port_that_is_taken_is_said(world) -> None:
    with socket.socket() as taken:
        taken.bind((HOST, 0))
        taken.listen()
        with pytest.raises(ClonerError, match="cannot be had"), serve_guides(RequestQueue(), taken.getsockname()[1]):
            pass
    with pytest.raises(ClonerError, match="cannot be had"), serve_guides(RequestQueue(), 99999):
        pass


def test_the_walk_is_written_at_the_end(tmp_path: Path) -> None:
    plan, out, told = tmp_path / "hall.crowd", tmp_path / "hall.walk", []
    plan.write_text(TEXT, encoding="utf-8")
    lines: list[str] = []
    done = threading.Thread(
        daemon=True, target=lambda: lines.extend(guide_file(plan, out, seconds=600.0, report=told.append))
    )
    done.start()
    while len(told) < 2:
        threading.Event().wait(0.01)
    assert told[0].startswith(f"ws://{HOST}:")
    with connect(told[0], compression=None) as guest:
        assert asked(guest, token=told[1].removeprefix("token "))["welcome"]
        assert asked(guest, do="order", text="school goes to west")["obeyed_from_s"] < 5.0
        threading.Event().wait(0.5)
        asked(guest, do="end")
    done.join(10.0)
    assert lines[-1] == str(out)
    walk = read_trajectories(out)
    assert walk.groups == ("school",) * 4


def test_who_ends_it_hears_so_however_late_the_answer_leaves(world, monkeypatch: pytest.MonkeyPatch) -> None:
    asked_at_once = guiding._forward

    def late(desk: RequestQueue, said: str | bytes) -> dict:
        answer = asked_at_once(desk, said)
        threading.Event().wait(0.5)
        return answer

    monkeypatch.setattr(guiding, "_forward", late)
    desk, answers = RequestQueue(), []

    def end(port: int) -> None:
        with entered(desk, port) as guest:
            answers.append(asked(guest, do="end"))

    with serve_guides(desk) as port:
        guide = threading.Thread(target=end, args=(port,), daemon=True)
        guide.start()
        for _ in guided_steps(world, desk, 1e4, pace=lambda _: time.sleep(STEP_S / 100.0)):
            pass
    guide.join(10.0)
    assert answers
    assert answers[0]["ended"]


def test_what_cannot_be_run_is_refused_before_anybody_is_let_in(tmp_path: Path) -> None:
    plan = tmp_path / "hall.crowd"
    plan.write_text(TEXT, encoding="utf-8")
    told: list[str] = []
    with pytest.raises(ClonerError, match="seconds"):
        guide_file(plan, tmp_path / "a.walk", seconds=-1.0, report=told.append)
    assert not told
    assert not (tmp_path / "a.walk").exists()
