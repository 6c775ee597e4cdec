"""Control of a running scenario by another program: JSON over a local WebSocket with a token.

The loop alone touches the world. Each guide has a thread of its own, which hands orders to the loop and waits for what
it says; an order is obeyed in the next step, above reactions and script.
"""

from __future__ import annotations

import hmac
import json
import logging
import queue
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Any, Final

from cloner.behaviour.loop import guide, run
from cloner.behaviour.walking import STEP_S
from cloner.behaviour.world import World
from cloner.errors import ClonerError, printable

log = logging.getLogger(__name__)

#: Only this machine can reach it; nobody else is let in.
HOST: Final = "127.0.0.1"
#: A message is a line, not a file; a guide that says nothing at first, or does not take what it asked for, is let go.
LONGEST_BYTES: Final = 4096
PATIENCE_S: Final = 5.0
#: Guides at a time, and what a wrong token costs each, seconds.
MOST_GUIDES: Final = 16
WRONG_TOKEN_S: Final = 0.5
#: Closing codes (RFC 6455): who is not allowed, and who comes when all places are taken.
NOT_ALLOWED, TOO_MANY = 1008, 1013


@dataclass(slots=True)
class _Request:
    """A guide's request, with the queue on which its answer is awaited."""

    message: dict[str, Any]
    answer: queue.SimpleQueue[dict[str, Any]] = field(default_factory=queue.SimpleQueue)


@dataclass(slots=True)
class RequestQueue:
    """Requests of guides for the simulation loop."""

    token: str = field(default_factory=lambda: secrets.token_urlsafe(24))
    wishes: queue.SimpleQueue[_Request] = field(default_factory=queue.SimpleQueue)
    over: threading.Event = field(default_factory=threading.Event)
    places: threading.BoundedSemaphore = field(default_factory=lambda: threading.BoundedSemaphore(MOST_GUIDES))


@contextmanager
def serve_guides(desk: RequestQueue, port: int = 0) -> Iterator[int]:
    """Accept guides while the block lasts; yield the port.

    Parameters
    ----------
    desk : RequestQueue
    port : int
        0 takes any free one.

    Raises
    ------
    ClonerError
        If the library is missing or the port cannot be had.
    """
    try:
        from websockets.sync.server import serve
    except ImportError as error:
        hint = 'Install it with: pip install "cloner[guide]"'
        raise ClonerError("guiding needs a library that is not here", hint, "websockets") from error
    try:
        server = serve(
            lambda guest: _receive(desk, guest), HOST, port,
            max_size=LONGEST_BYTES, open_timeout=PATIENCE_S, close_timeout=1.0, compression=None, server_header=None,
        )  # fmt: skip
    except (OSError, OverflowError) as error:
        hint = "Leave --port out, or give one that is free, 1024 to 65535"
        raise ClonerError(f"port {port} cannot be had", hint, "--port") from error
    thread = threading.Thread(target=server.serve_forever, name="guides", daemon=True)
    thread.start()
    try:
        yield int(server.socket.getsockname()[1])
    finally:
        desk.over.set()
        _wait_for_answers(desk)
        server.shutdown()
        thread.join(PATIENCE_S)


def _wait_for_answers(desk: RequestQueue) -> None:
    """Wait until every guide has its last answer and has disconnected, as shutting down would cut it off."""
    until = time.monotonic() + PATIENCE_S
    for _ in range(MOST_GUIDES):
        desk.places.acquire(timeout=max(until - time.monotonic(), 0.0))


def guided_steps(
    world: World, desk: RequestQueue, seconds: float, pace: Callable[[float], None] | None = None
) -> Iterator[World]:
    """Yield the world after each step, obeying guides, until the time is over or a guide ends it.

    Parameters
    ----------
    world : World
    desk : RequestQueue
    seconds : float
    pace : callable, optional
        Called with the scenario's time, seconds, before each step; waits. None keeps to the clock.
    """
    pace = pace or real_time_pace()
    for now in run(world, seconds):
        yield now
        pace(now.time_s)
        with suppress(queue.Empty):
            while True:
                wish = desk.wishes.get_nowait()
                wish.answer.put(_answer(now, wish.message))
                if wish.message.get("do") == "end":
                    return


def real_time_pace() -> Callable[[float], None]:
    """Return a function that waits for a time of the clock; a late step delays all later ones."""
    begun = time.monotonic()

    def wait(at_s: float) -> None:
        nonlocal begun
        ahead = begun + at_s - time.monotonic()
        if ahead > 0.0:
            time.sleep(ahead)
        else:
            begun -= ahead

    return wait


def _answer(world: World, message: dict[str, Any]) -> dict[str, Any]:
    """Execute a guide's request between two steps, and return the answer."""
    at = {"at_s": round(world.time_s, 3)}
    if message.get("do") == "order":
        try:
            guide(world, str(message.get("text", "")))
        except ClonerError as error:
            return at | {"error": str(error)}
        return at | {"obeyed_from_s": round(world.time_s + STEP_S, 3)}
    if message.get("do") == "look":
        return at | _describe_people(world)
    if message.get("do") == "end":
        return at | {"ended": True}
    return at | {"error": f"{printable(str(message.get('do')))} is nothing that can be done. Say order, look or end"}


def _describe_people(world: World) -> dict[str, Any]:
    """Return everybody's number, group, position (x, y) in metres, heading, posture and emotion, and the messages."""
    people, scenario = world.people, world.scenario
    shown = []
    for k in world.bodies.present.nonzero()[0]:
        x, y = (round(float(one), 3) for one in world.bodies.place[k])
        dx, dy = (round(float(one), 3) for one in world.bodies.facing[k])
        shown.append(
            {
                "number": int(k),
                "group": str(scenario.groups[int(people.home[k])].name),
                "place_m": [x, y],
                "facing": [dx, dy],
                "posture": str(world.acts[int(people.posture[k])]),
                "emotion": str(scenario.emotions[int(people.emotion[k])].name),
            }
        )
    return {"people": shown, "told": [[round(when, 3), text] for when, text in world.told]}


def _receive(desk: RequestQueue, guest: Any) -> None:
    """Serve one guide until it or the scenario ends, whatever it sends."""
    from websockets.exceptions import ConnectionClosed

    if not desk.places.acquire(blocking=False):
        guest.close(TOO_MANY, "as many guides as there may be are here already")
        return
    try:
        if not _knows_token(desk, guest):
            time.sleep(WRONG_TOKEN_S)
            guest.close(NOT_ALLOWED, "the first message tells the token that cloner crowd guide printed")
            return
        guest.send(json.dumps({"welcome": True}))
        while not desk.over.is_set():
            with suppress(TimeoutError):
                guest.send(json.dumps(_forward(desk, guest.recv(timeout=1.0))))
    except ConnectionClosed:
        log.info("a guide has gone")
    finally:
        desk.places.release()


def _knows_token(desk: RequestQueue, guest: Any) -> bool:
    try:
        first = read_message(guest.recv(timeout=PATIENCE_S))
        return hmac.compare_digest(str(first.get("token", "")).encode(), desk.token.encode())
    except (TimeoutError, ValueError):  # also half a letter, which has no bytes
        return False


def _forward(desk: RequestQueue, said: str | bytes) -> dict[str, Any]:
    """Pass one message to the loop and return its answer."""
    try:
        wish = _Request(read_message(said))
    except ValueError:
        return {"error": 'that is no message. Say for example {"do": "order", "text": "school goes to door"}'}
    desk.wishes.put(wish)
    ended = False
    while not ended:
        ended = desk.over.is_set()
        with suppress(queue.Empty):
            return wish.answer.get(timeout=0.2)
    return {"error": "the scenario has ended"}


def read_message(said: str | bytes) -> dict[str, Any]:
    """Return the content of a guide's message.

    Raises
    ------
    ValueError
        If it is no JSON object.
    """
    try:
        found = json.loads(said)
    except RecursionError as error:
        raise ValueError("too deep") from error
    if not isinstance(found, dict):
        raise ValueError("no object")
    return found
