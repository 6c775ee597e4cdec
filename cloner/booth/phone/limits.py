"""Rate limits per phone: enough for a page with its pictures, too little for guessing links."""

from __future__ import annotations

import threading
import time
from collections import OrderedDict
from typing import Final

#: Requests that may come at once, and how many come back a second: a page is some thirty.
BURST: Final = 120.0
EACH_SECOND: Final = 4.0
#: Wrong links that are answered, and how many come back a second.
WRONG_BURST: Final = 10.0
WRONG_EACH_SECOND: Final = 0.05
REMEMBERED: Final = 5000  # addresses; the one that was quiet longest is forgotten first


class RateLimit:
    """A token bucket for each address.

    Parameters
    ----------
    burst, each_second : float
    clock : callable
        Seconds that only rise.
    """

    def __init__(self, burst: float, each_second: float, clock: object = time.monotonic) -> None:
        self._burst, self._each = burst, each_second
        self._clock = clock
        self._left: OrderedDict[str, tuple[float, float]] = OrderedDict()
        self._turn = threading.Lock()

    def left(self, address: str) -> float:
        """Return the tokens left for an address."""
        with self._turn:
            return self._now(address)[0]

    def spend(self, address: str) -> bool:
        """Take one token of an address; return False if there is none."""
        with self._turn:
            left, now = self._now(address)
            self._left[address] = (left - 1.0 if left >= 1.0 else left, now)
            self._left.move_to_end(address)
            while len(self._left) > REMEMBERED:
                self._left.popitem(last=False)
            return left >= 1.0

    def _now(self, address: str) -> tuple[float, float]:
        now = float(self._clock())  # type: ignore[operator]
        left, then = self._left.get(address, (self._burst, now))
        return min(left + (now - then) * self._each, self._burst), now
