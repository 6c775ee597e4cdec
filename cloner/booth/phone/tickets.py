"""One unguessable link per visitor, which expires after some hours.

It lies in the visitor's folder. Whoever is forgotten takes the link along: nothing of it is kept anywhere else.
"""

from __future__ import annotations

import hmac
import json
import secrets
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path
from typing import Final

from cloner.project.atomic import write_text
from cloner.project.texts import LARGEST_BYTES
from cloner.untrusted import read_untrusted

TICKET_FILE: Final = "phone.json"
#: Bytes of chance in a link: 2**128 tries at a hundred a second outlast the sun.
TOKEN_BYTES: Final = 16


@dataclass(frozen=True, slots=True)
class Ticket:
    """The secret of a visitor's page.

    Attributes
    ----------
    token : str
    expires : datetime
        UTC.
    """

    token: str
    expires: datetime


def read_ticket(folder: Path) -> Ticket | None:
    """Return a visitor's ticket, None if there is none or it cannot be read."""
    try:
        data = json.loads(read_untrusted(folder / TICKET_FILE, LARGEST_BYTES))
        ticket = Ticket(str(data["token"]), datetime.fromisoformat(data["expires"]))
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None
    return ticket if len(ticket.token) >= TOKEN_BYTES and ticket.expires.tzinfo is not None else None


def issue_ticket(folder: Path, now: datetime, hours: int) -> Ticket:
    """Return a visitor's ticket, a new one if there is none or it has expired.

    Raises
    ------
    ClonerError
        If the folder cannot be written.
    """
    known = read_ticket(folder)
    if known is not None and now < known.expires:
        return known
    made = Ticket(secrets.token_urlsafe(TOKEN_BYTES), now + timedelta(hours=hours))
    data = {"token": made.token, "expires": made.expires.isoformat(timespec="seconds")}
    write_text(folder / TICKET_FILE, json.dumps(data) + "\n")
    return made


def visitor_of(token: str, folders: Iterable[Path], now: datetime) -> Path | None:
    """Return the visitor of a token, None if it is unknown or has expired.

    Every ticket is compared to its end, so that the time of the answer tells nothing of how near a guess came.
    """
    found = None
    for folder in folders:
        ticket = read_ticket(folder)
        if ticket is not None and hmac.compare_digest(ticket.token.encode(), token.encode()) and now < ticket.expires:
            found = folder
    return found
