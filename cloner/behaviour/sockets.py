"""WebSockets of the two live services: a server in a thread of its own, and messages that are JSON objects."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Final

from cloner.errors import ClonerError

#: Only this machine can reach it.
HOST: Final = "127.0.0.1"
#: Who says nothing at first, or does not take what was asked for, is let go, seconds.
PATIENCE_S: Final = 5.0
#: Closing code (RFC 6455) for who comes when all places are taken.
TOO_MANY: Final = 1013


@contextmanager
def listening_at(host: str, port: int, receive: Callable[[Any], None], **options: Any) -> Iterator[int]:
    """Serve every connection by ``receive`` in a thread of its own while the block lasts; give the port.

    Parameters
    ----------
    host : str
        An address of this machine.
    port : int
        0 takes any free one.
    receive : callable
        Gets a connection of the library.
    **options
        What the library's server takes besides.

    Raises
    ------
    ClonerError
        If the library is missing or the address cannot be had.
    """
    try:
        from websockets.sync.server import serve
    except ImportError as error:
        hint = 'Install it with: pip install "cloner[guide]"'
        raise ClonerError("this needs a library that is not here", hint, "websockets") from error
    try:
        server = serve(
            receive, host, port,
            open_timeout=PATIENCE_S, close_timeout=1.0, compression=None, server_header=None, **options,
        )  # fmt: skip
    except (OSError, OverflowError) as error:
        hint = "Leave --port out, or give one that is free, 1024 to 65535; --host is an address of this machine"
        raise ClonerError(f"{host}, port {port} cannot be had", hint, "--port") from error
    thread = threading.Thread(target=server.serve_forever, name="sockets", daemon=True)
    thread.start()
    try:
        yield int(server.socket.getsockname()[1])
    finally:
        server.shutdown()
        thread.join(PATIENCE_S)


def read_message(said: str | bytes) -> dict[str, Any]:
    """Return what the other side says.

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
