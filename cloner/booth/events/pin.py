"""The operator's PIN, stored as a salted hash, with a limit on attempts."""

from __future__ import annotations

import hashlib
import hmac
import secrets
import time
from collections.abc import Callable
from typing import Final

_ROUNDS: Final = 200_000  # a tenth of a second for who knows it; a number has few digits, so the tries are what counts
#: Wrong numbers in a row before it has to rest, and for how long, seconds.
TRIES: Final = 5
REST_S: Final = 30.0


def hash_pin(number: str) -> str:
    """Return salt and digest of a PIN; "" for none."""
    if not number:
        return ""
    salt = secrets.token_hex(16)
    return f"{salt}${_digest(number, salt)}"


def matches_pin(number: str, kept: str) -> bool:
    """Return whether a number is the PIN that was hashed."""
    salt, dollar, digest = kept.partition("$")
    return bool(dollar) and hmac.compare_digest(_digest(number, salt), digest)


def _digest(number: str, salt: str) -> str:
    return hashlib.pbkdf2_hmac("sha256", number.encode(), salt.encode(), _ROUNDS).hex()


class PinLock:
    """Accepts the right PIN; after `TRIES` wrong ones it accepts none for `REST_S` seconds.

    Parameters
    ----------
    clock : callable
        Seconds that only rise.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock, self._wrong, self._since = clock, 0, 0.0

    def is_locked(self) -> bool:
        """Return whether all PINs are refused just now."""
        return self._wrong >= TRIES and self._clock() - self._since < REST_S

    def accepts(self, number: str, kept: str) -> bool:
        """Return whether a PIN is right."""
        if self.is_locked():
            return False
        if matches_pin(number, kept):
            self._wrong = 0
            return True
        self._wrong, self._since = (self._wrong if self._wrong < TRIES else 0) + 1, self._clock()
        return False
