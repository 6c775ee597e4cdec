"""The command ``cloner scene serve``: a built scene in browsers of this machine, or of one network on request.

One server, one port: the page and newcomers' files over HTTP, what happens over a WebSocket. Everything lies behind a
token that nobody can guess; other addresses, other hosts' names and other pages' sockets get an empty refusal. Pages
say one thing at a time, small, and only who has told the operator's number is obeyed.
"""

from __future__ import annotations

import hmac
import ipaddress
import json
import logging
import secrets
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.scenes.served.living import EVERY_S, RunningScene
from cloner.scenes.served.newcomers import result_finder

HOST: Final = "127.0.0.1"
#: What is wrong costs so long, seconds, and what a page may say at most, bytes.
WRONG_S: Final = 0.5
LONGEST_BYTES: Final = 1024
#: Pages that may be connected at once, and how long one may take for its first line, seconds.
MOST_PAGES: Final = 8
PATIENCE_S: Final = 5.0
#: A page that has not answered for so long is let go, seconds.
ALIVE_S: Final = 10.0
#: How sockets are served, pages' and other booths'.
OPTIONS: Final[Mapping[str, Any]] = MappingProxyType({
    "compression": None, "max_queue": 2, "open_timeout": PATIENCE_S, "close_timeout": 1.0, "server_header": None,
    "ping_interval": ALIVE_S / 2.0, "ping_timeout": ALIVE_S / 2.0,
})  # fmt: skip
#: A page is listened to at least so often, and has so long to hear that it is over, seconds.
TURN_S: Final = 0.25
TOLD_S: Final = 0.3
#: Nobody walks farther away, metres.
FARTHEST_M: Final = 1e4
#: Closing codes (RFC 6455): who comes when all places are taken, and who says what is no message.
TOO_MANY, NO_MESSAGE = 1013, 1003
_KINDS: Final = {".webp": "image/webp", ".bin": "application/octet-stream"}


def serve_folder(
    pack: Path, clones: Path | Callable[[], tuple[Path, ...]], opens: Callable[[str], bool] | None = None, *,
    host: str = HOST, port: int = 0, lent: Callable[[RunningScene, str], AbstractContextManager[str]] | None = None,
    said: Callable[[str], None],
) -> None:  # fmt: skip
    """Serve a built, running scene that finished clones can join, until it is interrupted.

    Parameters
    ----------
    pack : Path
        What ``cloner scene build`` made of a scenario.
    clones : Path or callable
        A folder of results, or what returns the folders of clones that may be shown, the newest first.
    opens : callable, optional
        Whether a number is the operator's; a number is made up and told where none is given.
    host : str
        This machine's own address in a network whose machines may show the scene too; loopback lets nobody else in.
    port : int
        0 takes any free one.
    lent : callable, optional
        Lets other booths lend clones (:func:`cloner.scenes.served.lending.accept_lent_clones`).
    said : callable
        Gets lines while it goes on: first the page's address.

    Raises
    ------
    ClonerError
        If the pack cannot be shown or is taken away, the folder is missing, or the address cannot be had.
    """
    living = RunningScene(pack, result_finder(clones), said)
    number = f"{secrets.randbelow(1_000_000):06}" if opens is None else ""
    with served(
        living, opens or (lambda entered: hmac.compare_digest(entered.encode(), number.encode())), host, port
    ) as url:
        said(url)
        said(f"staff: Ctrl+Shift+K and the number {number or 'of the event'}")
        with advancing(living), lent(living, host) if lent else nullcontext("") as address:
            if address:
                said(f"other booths: cloner scene lend {address} --clones EVENT")
            while True:
                living.look()
                time.sleep(EVERY_S)


@contextmanager
def advancing(living: RunningScene) -> Iterator[None]:
    """Advance a scene in a thread of its own while the block lasts, as preparing a newcomer takes seconds."""
    over = threading.Event()

    def walk() -> None:
        while not over.wait(EVERY_S) and not living.over:
            living.go_on()

    thread = threading.Thread(target=walk, name="minds", daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join(PATIENCE_S)


@contextmanager
def served(living: RunningScene, opens: Callable[[str], bool], host: str = HOST, port: int = 0) -> Iterator[str]:
    """Serve a scene's page while the block lasts; yield its address.

    Raises
    ------
    ClonerError
        If the library is missing, the address is none of a network of one's own, or it cannot be had.
    """
    try:
        from websockets.sync.server import serve
    except ImportError as error:
        hint = 'Install it with: pip install "cloner[guide]"'
        raise ClonerError("serving a scene needs a library that is not here", hint, "websockets") from error
    if not is_private_address(host):
        hint = "Give this machine's own address in your network, as 192.168.1.20"
        raise ClonerError("the scene is shown in a network of one's own only", hint, "--host")
    state = _State(living, opens)
    try:
        server = serve(
            partial(_receive, state), host, port, process_request=partial(_answer, state), max_size=LONGEST_BYTES,
            logger=null_logger(), **OPTIONS,
        )  # fmt: skip
    except (OSError, OverflowError) as error:
        hint = "Give an address of this machine, and leave --port out or give one that is free, 1024 to 65535"
        raise ClonerError(f"{host}, port {port} cannot be had", hint, "--port") from error
    state.host = f"{host}:{server.socket.getsockname()[1]}"
    thread = threading.Thread(target=server.serve_forever, name="scene", daemon=True)
    thread.start()
    try:
        yield f"http://{state.host}/{state.token}/"
    finally:
        if not living.over:
            living.stop()
        time.sleep(TOLD_S)
        server.shutdown()
        thread.join(PATIENCE_S)


class _State:
    """What all requests share."""

    def __init__(self, living: RunningScene, opens: Callable[[str], bool]) -> None:
        self.living, self.accepts = living, opens
        self.token, self.host = secrets.token_urlsafe(24), ""
        self.places = threading.BoundedSemaphore(MOST_PAGES)


def is_private_address(host: str) -> bool:
    """Return whether an address is the loopback or in a private network; a name may resolve to anything."""
    try:
        own = ipaddress.IPv4Address(host)
    except ValueError:
        return False
    return (own.is_private or own.is_link_local) and not own.is_unspecified


def null_logger() -> logging.Logger:
    """Return a logger that discards everything: who looks at a clone stays private."""
    logger = logging.getLogger("cloner.scenes.pages")
    logger.disabled = True
    return logger


def _answer(state: _State, connection: Any, request: Any) -> Any:
    """Answer an HTTP request; None accepts a page's own socket."""
    token, slash, path = request.path.removeprefix("/").partition("/")
    headers = request.headers
    here = headers.get_all("Host") == [state.host]  # else a page elsewhere has given this machine its own name
    reads = getattr(request, "method", "GET") == "GET"  # older libraries know no other
    if not (reads and slash and here and hmac.compare_digest(token.encode(), state.token.encode())):
        time.sleep(WRONG_S)
        return _response(404, "text/plain", b"")
    if path == "live" and headers.get_all("Origin") == [f"http://{state.host}"]:
        return None
    if path == "":
        return _response(200, "text/html; charset=utf-8", state.living.page())
    folder, _, file = path.partition("/")
    key, _, name = file.partition("/")
    data = state.living.file(key, name) if folder == "newcomers" else None
    if data is None:
        return _response(404, "text/plain", b"")
    return _response(200, _KINDS.get(Path(name).suffix, "text/plain"), data)


def _response(code: int, kind: str, content: bytes) -> Any:
    from websockets.datastructures import Headers
    from websockets.http11 import Response

    headers = Headers(
        [
            ("Content-Type", kind), ("Content-Length", str(len(content))), ("Connection", "close"),
            ("Cache-Control", "no-store"), ("Referrer-Policy", "no-referrer"), ("X-Content-Type-Options", "nosniff"),
            ("X-Frame-Options", "DENY"),
        ]
    )  # fmt: skip
    return Response(code, "OK" if code == 200 else "Not Found", headers, content)


def _receive(state: _State, page: Any) -> None:
    """Exchange messages with one page until it or the scene ends."""
    from websockets.exceptions import ConnectionClosed

    if not state.places.acquire(blocking=False):
        page.close(TOO_MANY, "as many pages as there may be are here already")
        return
    staff = False
    try:
        for event in state.living.told(TURN_S):
            if event is not None:
                page.send(json.dumps({"kind": event[0], **event[1]}))
            with suppress(TimeoutError):
                said = _message(page.recv(timeout=0))
                if said is None:
                    page.close(NO_MESSAGE, "that is no message")
                    return
                staff, answer = _handle_request(state, page, staff, said)
                page.send(json.dumps({"kind": "answer", **answer}))
    except ConnectionClosed:
        pass
    finally:
        state.living.walks(page, None)
        state.places.release()


def _message(said: str | bytes) -> tuple[str, str] | None:
    """Return a page's request and its text; None for an invalid message."""
    try:
        found = json.loads(said)
    except (ValueError, RecursionError):
        return None
    if not isinstance(found, dict) or len(found) != 1:
        return None
    [(kind, text)] = found.items()
    said_plainly = isinstance(text, str) and text.isprintable()  # halves of letters cannot be written
    if kind == "walk" and said_plainly and text:
        said_plainly = _place(text) is not None
    return (kind, text) if kind in ("number", "order", "walk") and said_plainly else None


def _place(text: str) -> tuple[float, float, float] | None:
    """Return the position and heading in a text, None if there are none."""
    try:
        x, z, heading = (float(one) for one in text.split())
    except ValueError:
        return None
    return (x, z, heading) if all(abs(one) < FARTHEST_M for one in (x, z, heading)) else None  # not for nan


def _handle_request(state: _State, page: Any, staff: bool, said: tuple[str, str]) -> tuple[bool, dict[str, Any]]:
    """Return whether a page belongs to the staff after this message, and the answer."""
    kind, text = said
    if kind == "walk":
        return staff, {"who": state.living.walks(page, _place(text))}
    if kind == "number":
        staff = state.accepts(text)
        if not staff:
            time.sleep(WRONG_S)
        return staff, {"staff": staff}
    if not staff:
        return False, {"error": "Tell the operator's number first"}
    try:
        state.living.order(text)
    except ClonerError as error:
        return True, {"error": str(error)}
    return True, {"obeyed": text}
