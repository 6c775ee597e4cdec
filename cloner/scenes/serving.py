"""The command ``cloner scene serve``: a built scene's page on this machine, which finished clones come into.

It listens on loopback only; the address holds a token that nobody can guess. Everything else gets an empty 404.
"""

from __future__ import annotations

import hmac
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.scenes.living import EVERY_S, MOST_PAGES, Living, finished_in, line

HOST: Final = "127.0.0.1"
#: What a wrong address costs, and a pause of the stream until a sign of life is sent, seconds.
WRONG_S: Final = 0.5
ALIVE_S: Final = 2.0
#: Pages have so long to hear that it is over, seconds.
TOLD_S: Final = 0.3
#: A page that takes nothing for so long is let go, seconds.
SLOWEST_S: Final = 20.0
LONGEST_NUMBER: Final = 64
_KINDS: Final = {".webp": "image/webp", ".bin": "application/octet-stream", ".json": "application/json"}


def serve_folder(
    pack: Path, clones: Path | Callable[[], tuple[Path, ...]], opens: Callable[[str], bool] | None = None, *,
    port: int = 0, said: Callable[[str], None],
) -> None:  # fmt: skip
    """Show a built scene into which finished clones come, until it is interrupted.

    Parameters
    ----------
    pack : Path
        What ``cloner scene build`` wrote.
    clones : Path or callable
        A folder of results, or what returns the folders of clones that may be shown, the newest first.
    opens : callable, optional
        Whether a number is the operator's; a number is made up and told where none is given.
    port : int
        0 takes any free one.
    said : callable
        Gets lines while it goes on: first the page's address.

    Raises
    ------
    ClonerError
        If the pack cannot be shown or is taken away, the folder is missing, or the port cannot be had.
    """
    if isinstance(clones, Path):
        if not clones.is_dir():
            raise ClonerError("there is no such folder", "Give the folder of results, or the event's", clones.name)
        clones = partial(finished_in, clones)
    living = Living(pack, clones, said)
    number = f"{secrets.randbelow(1_000_000):06}" if opens is None else ""
    with served(living, opens or (lambda told: hmac.compare_digest(told.encode(), number.encode())), port) as address:
        said(address)
        said(f"staff: Ctrl+Shift+K and the number {number or 'of the event'}")
        while True:
            living.look()
            time.sleep(EVERY_S)


@contextmanager
def served(living: Living, opens: Callable[[str], bool], port: int = 0) -> Iterator[str]:
    """Serve a scene's page while the block lasts; give its address.

    Raises
    ------
    ClonerError
        If the port cannot be had.
    """
    token = secrets.token_urlsafe(24)
    state = _State(living, token, opens)
    try:
        server = ThreadingHTTPServer((HOST, port), partial(_Handler, state))
    except (OSError, OverflowError) as error:
        hint = "Leave --port out, or give one that is free, 1024 to 65535"
        raise ClonerError(f"port {port} cannot be had", hint, "--port") from error
    server.daemon_threads = True
    thread = threading.Thread(target=server.serve_forever, name="scene", daemon=True)
    thread.start()
    try:
        yield f"http://{HOST}:{server.server_address[1]}/{token}/"
    finally:
        if not living.over:
            living.stop()
        time.sleep(TOLD_S)
        server.shutdown()
        server.server_close()
        thread.join(ALIVE_S)


class _State:
    """What all requests share."""

    def __init__(self, living: Living, token: str, opens: Callable[[str], bool]) -> None:
        self.living, self.token, self.opens = living, token, opens
        self.places = threading.BoundedSemaphore(MOST_PAGES)


class _Handler(BaseHTTPRequestHandler):
    """One request."""

    server_version, sys_version = "scene", ""
    protocol_version = "HTTP/1.0"
    timeout = SLOWEST_S

    def __init__(self, state: _State, *arguments: Any) -> None:
        self._state = state
        super().__init__(*arguments)

    def do_GET(self) -> None:
        """Send the page, a newcomer's file, or what happens."""
        path = self._path()
        if path == "":
            self._send(200, "text/html; charset=utf-8", self._state.living.page())
        elif path == "events":
            self._stream()
        elif path is not None and path.startswith("newcomers/") and path.count("/") == 2:
            _, key, name = path.split("/")
            data = self._state.living.file(key, name)
            if data is None:
                self._send(404, "text/plain", b"")
            else:
                self._send(200, _KINDS.get(Path(name).suffix, "text/plain"), data)
        else:
            self._refuse()

    def do_POST(self) -> None:
        """Say whether a number is the operator's."""
        if self._path() != "staff":
            self._refuse()
            return
        told = self.headers.get("Content-Length", "")
        if not (told.isascii() and told.isdigit() and int(told) <= LONGEST_NUMBER):
            self._refuse()
            return
        number = self.rfile.read(int(told)).decode("utf-8", "replace")
        if self._state.opens(number):
            self._send(200, "text/plain", b"")
        else:
            self._refuse(403)

    def _path(self) -> str | None:
        """Return what is asked for behind the token, None where the token or the host is another."""
        token, slash, rest = self.path.removeprefix("/").partition("/")
        host = f"{HOST}:{self.server.server_address[1]}"  # type: ignore[index]
        if not slash or self.headers.get("Host") != host:  # a page elsewhere has given this machine its own name
            return None
        return rest if hmac.compare_digest(token.encode(), self._state.token.encode()) else None

    def _refuse(self, code: int = 404) -> None:
        time.sleep(WRONG_S)
        self._send(code, "text/plain", b"")

    def _stream(self) -> None:
        """Send what happens as it happens, until the page or the scene ends."""
        if not self._state.places.acquire(blocking=False):
            self._refuse(503)
            return
        try:
            self._head(200, "text/event-stream")
            for event in self._state.living.told(ALIVE_S):
                self.wfile.write(line(event))
                self.wfile.flush()
        finally:
            self._state.places.release()

    def _head(self, code: int, kind: str) -> None:
        self.send_response(code)
        for name, value in (
            ("Content-Type", kind), ("Cache-Control", "no-store"), ("Referrer-Policy", "no-referrer"),
            ("X-Content-Type-Options", "nosniff"), ("X-Frame-Options", "DENY"),
        ):  # fmt: skip
            self.send_header(name, value)
        self.end_headers()

    def _send(self, code: int, kind: str, content: bytes) -> None:
        with suppress(OSError):  # who asked has gone
            self._head(code, kind)
            self.wfile.write(content)

    def handle(self) -> None:
        """Answer; who closes the connection half-way is not worth a line."""
        with suppress(OSError):
            super().handle()

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002
        """Log nothing: who looks at a clone is nobody's business."""
