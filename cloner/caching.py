"""Caches of what is computed from a frozen record or a read-only array, for as long as that object lives.

A clone leaves in many formats; they share its walk, its T-pose, its packed pictures.
"""

from __future__ import annotations

import functools
import threading
import weakref
from collections.abc import Callable
from typing import TypeVar

Thing = TypeVar("Thing")
Made = TypeVar("Made")


def cached_per_object(make: Callable[[Thing], Made]) -> Callable[[Thing], Made]:
    """Return ``make`` with its results cached per argument object, for as long as somebody else holds that object.

    ``make`` is pure; nobody changes its value, which does not hold the object that it was made of. Of two threads that
    ask for the same, the second waits for the first.
    """
    kept: dict[int, tuple[weakref.ref[Thing], Made]] = {}
    making = threading.RLock()

    @functools.wraps(make)
    def made(thing: Thing) -> Made:
        key = id(thing)  # another object takes it only after this one's end has emptied its place
        with making:
            if key not in kept:
                kept[key] = (weakref.ref(thing, lambda _: kept.pop(key, None)), make(thing))
            return kept[key][1]

    return made
