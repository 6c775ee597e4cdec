"""Booths that share one scene: each lends its visitors' clones to the serving booth and can withdraw them at once.

The serving booth opens a second port where that is asked, behind a token of its own: what pages may say is small, a
clone has megabytes. The other booth makes clones ready, sends them, and says who is gone; when the link ends, by
whatever, all its clones leave the scene. A lost link is tried again, and its clones come anew.
"""

from __future__ import annotations

import hmac
import json
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, Final
from urllib.parse import urlsplit

from cloner.crowd.clones.levels import body_levels
from cloner.crowd.clones.people import Found
from cloner.errors import ClonerError, printable
from cloner.project.folder import safe_identifier
from cloner.scenes.served.lent import FILES, offer_facts, parse_clone
from cloner.scenes.served.living import EVERY_S, RunningScene
from cloner.scenes.served.newcomers import Mark, Newcomer, creation_time, latest_clones, make_newcomer, result_finder
from cloner.scenes.served.serving import (
    NO_MESSAGE,
    OPTIONS,
    PATIENCE_S,
    TOO_MANY,
    TURN_S,
    WRONG_S,
    is_private_address,
    null_logger,
)

#: A clone has 2 MB; more than this is none.
LARGEST_BYTES: Final = 16_000_000
#: What is said in words, bytes: a clone's row has 1,500.
LONGEST_BYTES: Final = 20_000
#: Booths that may lend at a time, and clones of each.
MOST_BOOTHS, MOST_LENT = 4, 6
#: A lost link is tried again after this time, seconds.
AGAIN_S: Final = 1.0
_HINT: Final = "Give the address that the other booth's cloner scene serve --lent printed"


@contextmanager
def accept_lent_clones(living: RunningScene, host: str) -> Iterator[str]:
    """Accept clones that other booths lend to a scene while the block lasts; yield the address to tell them.

    Raises
    ------
    ClonerError
        If the address cannot be had.
    """
    from websockets.sync.server import serve

    token, places = secrets.token_urlsafe(24), threading.BoundedSemaphore(MOST_BOOTHS)
    try:
        server = serve(
            partial(_serve_booth, living, places), host, 0, process_request=partial(_admit, token),
            max_size=LARGEST_BYTES, logger=null_logger(), **OPTIONS,
        )  # fmt: skip
    except OSError as error:
        raise ClonerError(f"{host} cannot be had", "Give an address of this machine", "--host") from error
    thread = threading.Thread(target=server.serve_forever, name="lent", daemon=True)
    thread.start()
    try:
        yield f"ws://{host}:{server.socket.getsockname()[1]}/{token}"
    finally:
        server.shutdown()
        thread.join(PATIENCE_S)


def _admit(token: str, connection: Any, request: Any) -> Any:
    """Return an error response for clients without the token and for pages; None admits."""
    token_part = request.path.removeprefix("/")
    if hmac.compare_digest(token_part.encode(), token.encode()) and "Origin" not in request.headers:
        return None
    time.sleep(WRONG_S)
    return connection.respond(404, "")


def _serve_booth(living: RunningScene, places: threading.BoundedSemaphore, link: Any) -> None:
    """Show one booth's clones in the scene until its connection, or the scene, ends."""
    from websockets.exceptions import ConnectionClosed

    if not places.acquire(blocking=False):
        link.close(TOO_MANY, "as many booths as may be lend already")
        return
    keys: dict[int, str] = {}
    try:
        link.send(json.dumps({"wanted": offer_facts(living.facts)}))
        while not living.over:
            try:
                said = _parse_offer(link.recv(timeout=TURN_S))
            except TimeoutError:
                continue
            if said is None:
                link.close(NO_MESSAGE, "that is no message")
                return
            number, row, _ = said
            if row is None:
                living.leave(keys.pop(number, ""))
                continue
            link.send(
                json.dumps(
                    {"number": number, "error": _receive_clone(living, keys, said, link.recv(timeout=PATIENCE_S))}
                )
            )
        link.send(json.dumps({"over": living.over}))
    except (ConnectionClosed, TimeoutError):
        pass
    finally:
        for key in keys.values():
            living.leave(key)
        places.release()


def _receive_clone(
    living: RunningScene, keys: dict[int, str], said: tuple[int, Any, list[int]], data: str | bytes
) -> str:
    """Add a received clone to the scene; return the reason of a refusal, "" if it was added."""
    number, row, sizes = said
    if number in keys or len(keys) >= MOST_LENT:
        return f"a booth may lend {MOST_LENT} clones at a time"
    if not isinstance(data, bytes) or len(data) != sum(sizes):
        return "the files are not as long as they were said to be"
    files, at = {}, 0
    for name, size in zip(FILES, sizes, strict=True):
        files[name], at = data[at : at + size], at + size
    try:
        keys[number] = living.enter(parse_clone(row, files, living.facts, living.body), fresh=True)
    except ClonerError as error:
        return str(error)
    living.said("a clone of another booth is in the scene")
    return ""


def _parse_offer(said: str | bytes) -> tuple[int, Any, list[int]] | None:
    """Return a clone's number, its row and its files' sizes; no row if it is withdrawn; None for an invalid message."""
    if not isinstance(said, str) or len(said) > LONGEST_BYTES:
        return None
    try:
        found = json.loads(said)
    except (ValueError, RecursionError):
        return None
    if not isinstance(found, dict) or type(found.get("number")) is not int:
        return None
    if set(found) == {"number", "gone"}:
        return found["number"], None, []
    sizes = found.get("sizes")
    if set(found) != {"number", "row", "sizes"} or not isinstance(sizes, list) or len(sizes) != len(FILES):
        return None
    return (found["number"], found["row"], sizes) if all(type(one) is int and one >= 0 for one in sizes) else None


def lend_folder(
    address: str,
    clones: Path | Callable[[], tuple[Path, ...]],
    said: Callable[[str], None],
    ends: Callable[[], bool] = lambda: False,
) -> None:
    """Lend finished clones to another booth's scene until it is over, or this is interrupted.

    Parameters
    ----------
    address : str
        What ``cloner scene serve --lent`` printed there.
    clones : Path or callable
        A folder of results, or what returns the folders of clones that may be shown, the newest first.
    said : callable
        Gets lines while it goes on.
    ends : callable
        Says whether to end; asked twice a second.

    Raises
    ------
    ClonerError
        If the address is none, nobody lets us in there, the folder is missing, or the scene is over.
    """
    try:
        from websockets.exceptions import InvalidHandshake, InvalidURI, WebSocketException
        from websockets.sync.client import connect
    except ImportError as error:
        hint = 'Install it with: pip install "cloner[guide]"'
        raise ClonerError("lending clones needs a library that is not here", hint, "websockets") from error
    _check_near(address)
    lender = _Lender(result_finder(clones), said)
    linked = lost = False
    while not ends():
        try:
            with connect(
                address, compression=None, max_size=LONGEST_BYTES, open_timeout=PATIENCE_S, proxy=None
            ) as link:
                linked, lost = True, False
                said("linked")
                lender.lend(link, ends)
        except (InvalidHandshake, InvalidURI) as error:
            raise ClonerError("nobody lets us in there", _HINT, "ADDRESS") from error
        except (OSError, WebSocketException) as error:
            if not linked:
                raise ClonerError("nobody answers there", _HINT, "ADDRESS") from error
            if not lost:
                said("the link is lost and tried again")
            lost = True
            time.sleep(AGAIN_S)


def _check_near(address: str) -> None:
    """Refuse addresses beyond this machine and private networks: visitors' clones are sent nowhere else."""
    parts = urlsplit(address)
    try:
        near = parts.scheme == "ws" and bool(parts.port) and is_private_address(parts.hostname or "")
    except ValueError:
        near = False
    if not near:
        raise ClonerError("clones are lent within a network of one's own only", _HINT, "ADDRESS")


@dataclass(slots=True)
class _Lender:
    """One booth's clones by number; prepared ones are kept in memory in case the connection is lost."""

    clones: Callable[[], tuple[Path, ...]]
    said: Callable[[str], None]
    ready: dict[Mark, Newcomer] = field(default_factory=dict)
    count: int = 0

    def lend(self, link: Any, ends: Callable[[], bool]) -> None:
        """Send finished clones, and withdrawals, as long as the connection lasts."""
        wanted = self._told(link, PATIENCE_S).get("wanted")
        if not isinstance(wanted, dict):
            raise ClonerError("that is no scene", _HINT, "ADDRESS")
        body = body_levels(mouth="faces" in wanted)
        numbers: dict[Mark, int] = {}
        while not ends():
            there = latest_clones(self.clones, MOST_LENT)
            for mark in [one for one in numbers if one not in there]:
                self.ready.pop(mark, None)
                link.send(json.dumps({"number": numbers.pop(mark), "gone": True}))
                self.said("somebody has left the scene")
            for mark in [one for one in there if one not in numbers][:1]:
                self.count += 1
                numbers[mark] = self.count
                self._send(link, mark, self.count, wanted, body)
            message = self._told(link, EVERY_S)
            if "over" in message:
                raise ClonerError("the scene is over", "Lend again when it is served again", "ADDRESS")

    def _send(self, link: Any, mark: Mark, number: int, wanted: dict[str, Any], body: Any) -> None:
        name = safe_identifier(mark[0].resolve().name)
        try:
            if mark not in self.ready:
                self.ready[mark] = make_newcomer(Found(name, mark[0]), wanted, body)
        except (ClonerError, LookupError, TypeError, ValueError, AttributeError) as error:
            self.said(
                f"not lent: {error if isinstance(error, ClonerError) else 'that scene asks for what is no clone'}"
            )
            return
        if creation_time(mark[0]) != mark[1]:  # forgotten, or made anew, in the meantime
            self.ready.pop(mark)
            return
        own = self.ready[mark]
        link.send(json.dumps({"number": number, "row": own.row, "sizes": [len(own.files[name]) for name in FILES]}))
        link.send(b"".join(own.files[name] for name in FILES))
        wrong = self._told(link, 2.0 * PATIENCE_S).get("error", "no answer")
        self.said(f"not lent: {printable(str(wrong))}" if wrong else f"{name} is in the scene")

    def _told(self, link: Any, wait_s: float) -> dict[str, Any]:
        """Return the other booth's next message, None on timeout."""
        try:
            found = json.loads(link.recv(timeout=wait_s))
        except (TimeoutError, ValueError, RecursionError):
            return {}
        return found if isinstance(found, dict) else {}
