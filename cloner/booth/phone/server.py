"""The server of the page: listens on one address of the booth's own network while it is switched on.

It answers GET and HEAD of the files of `cloner.booth.phone.parcel` below a visitor's link. Everything else, and every
link that is nobody's, gets the same empty 404; nothing is listed, logged or cached.
"""

from __future__ import annotations

import socket
import ssl
import threading
from collections.abc import Callable
from datetime import UTC, datetime
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, Final

from cloner.booth.phone import limits
from cloner.booth.phone.page import page, policy
from cloner.booth.phone.parcel import FILES, FOLDER
from cloner.booth.phone.tickets import read_ticket, visitor_of
from cloner.errors import ClonerError
from cloner.untrusted import read_untrusted

#: Usual second port of web servers, and the largest file that is handed out, bytes (taste).
PORT: Final = 8080
ABREAST: Final = 32  # requests at a time; others wait or are refused by their telephone
SLOWEST_S: Final = 20.0  # a telephone that says nothing for so long is let go
LARGEST_BYTES: Final = 100_000_000


class PhoneServer:
    """Serves visitors' parcels until it is stopped.

    Parameters
    ----------
    visitors : callable
        Gives the folders of everybody whose page may be seen now.
    language : str
    address : str
        Of this computer, on the network that the telephones are on.
    port : int
        0 takes a free one.
    certificate : (Path, Path) or None
        Certificate and key for an encrypted page.

    Raises
    ------
    ClonerError
        If nothing can be served there.
    """

    def __init__(
        self,
        visitors: Callable[[], tuple[Path, ...]],
        language: str,
        address: str,
        port: int = PORT,
        certificate: tuple[Path, Path] | None = None,
    ) -> None:
        state = _State(visitors, language)
        try:
            self._server = _Server((address, port), partial(_Handler, state))
            if certificate is not None:
                context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
                context.load_cert_chain(*certificate)
                self._server.tls = context
        except OSError as error:
            hint = "Is the booth's network up, and is nothing else served here?"
            raise ClonerError("the page for telephones cannot be served", hint, f"{address}:{port}") from error
        self._secure = certificate is not None
        self._thread = threading.Thread(target=self._server.serve_forever, name="phone page", daemon=True)
        self._thread.start()

    @property
    def base(self) -> str:
        """The base address of all links."""
        host, port = self._server.server_address[:2]
        return f"{'https' if self._secure else 'http'}://{host!s}:{port}/"

    def link(self, token: str) -> str:
        """Return the address of a visitor's page."""
        return f"{self.base}{token}/"

    def stop(self) -> None:
        """Stop serving: the port is closed when this returns."""
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()


def local_addresses() -> tuple[str, ...]:
    """Return this computer's addresses in its networks, the likeliest to be reachable first, the loopback last.

    Nothing is sent: a datagram socket that is only connected names the address it would send from.
    """
    found: list[str] = []
    for far in ("10.255.255.255", "192.168.255.255", "172.31.255.255"):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            try:
                probe.connect((far, 9))
                found.append(str(probe.getsockname()[0]))
            except OSError:
                continue
    return tuple(dict.fromkeys(one for one in found if not one.startswith("0."))) or ("127.0.0.1",)


class _State:
    """State shared by all requests."""

    def __init__(self, visitors: Callable[[], tuple[Path, ...]], language: str) -> None:
        self.visitors, self.language = visitors, language
        self.asked = limits.RateLimit(limits.BURST, limits.EACH_SECOND)
        self.wrong = limits.RateLimit(limits.WRONG_BURST, limits.WRONG_EACH_SECOND)


class _Server(ThreadingHTTPServer):
    """Answers each request in its own thread, up to a limit."""

    daemon_threads = True
    allow_reuse_address = True
    tls: ssl.SSLContext | None = None

    def __init__(self, address: tuple[str, int], handler: Callable[..., BaseHTTPRequestHandler]) -> None:
        self._free = threading.BoundedSemaphore(ABREAST)
        super().__init__(address, handler)

    def process_request(self, request: Any, client_address: Any) -> None:
        """Begin to answer unless too many requests are being answered."""
        if not self._free.acquire(timeout=1.0):
            self.shutdown_request(request)
            return
        super().process_request(request, client_address)

    def process_request_thread(self, request: Any, client_address: Any) -> None:
        """Answer; the TLS handshake takes place here, so that a slow phone delays nobody else."""
        try:
            request.settimeout(SLOWEST_S)
            if self.tls is not None:
                request = self.tls.wrap_socket(request, server_side=True)
            super().process_request_thread(request, client_address)
        except OSError:
            self.shutdown_request(request)
        finally:
            self._free.release()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Ignore phones that closed the connection."""


class _Handler(BaseHTTPRequestHandler):
    """One request."""

    server_version, sys_version = "booth", ""
    protocol_version = "HTTP/1.0"

    def __init__(self, state: _State, *arguments: Any) -> None:
        self._state = state
        super().__init__(*arguments)

    def do_GET(self) -> None:
        """Send a file."""
        self._answer(with_body=True)

    def do_HEAD(self) -> None:
        """Send a file's headers."""
        self._answer(with_body=False)

    def _answer(self, *, with_body: bool) -> None:
        address = str(self.client_address[0])
        if not self._state.asked.spend(address) or self._state.wrong.left(address) < 1.0:
            self._send(429, "text/plain", b"", with_body)
            return
        found = self._found(self.path)
        if found is None:
            self._state.wrong.spend(address)
            self._send(404, "text/plain", b"", with_body)
            return
        self._send(200, *found, with_body)

    def _found(self, path: str) -> tuple[str, bytes] | None:
        """Return type and content of a path."""
        token, slash, file = path.removeprefix("/").partition("/")
        if not slash or not token.isascii() or len(path) > 200 or (file and file not in FILES):
            return None
        visitor = visitor_of(token, self._state.visitors(), datetime.now(UTC))
        ticket = None if visitor is None else read_ticket(visitor)
        if visitor is None or ticket is None:
            return None
        if not file:
            return "text/html; charset=utf-8", page(self._state.language, f"{ticket.expires.astimezone():%d.%m. %H:%M}")
        try:
            return FILES[file], read_untrusted(visitor / FOLDER / file, LARGEST_BYTES)
        except OSError:
            return None

    def _send(self, code: int, kind: str, content: bytes, with_body: bool) -> None:
        self.send_response(code)
        for name, value in (
            ("Content-Type", kind),
            ("Content-Length", str(len(content))),
            ("Cache-Control", "no-store"),
            ("Referrer-Policy", "no-referrer"),
            ("X-Content-Type-Options", "nosniff"),
            ("X-Robots-Tag", "noindex"),
            ("Content-Security-Policy", policy()),
        ):
            self.send_header(name, value)
        self.end_headers()
        if with_body:
            self.wfile.write(content)

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002
        """Log nothing: who looks at a clone stays private."""
