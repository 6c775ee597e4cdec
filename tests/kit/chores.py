"""Small tasks for worker processes."""

from __future__ import annotations

import os
import threading
import time
from pathlib import Path


def doubled(number: int) -> int:
    return 2 * number


def refuse(text: str) -> None:
    raise ValueError(text)


def refuse_to_serve(pipe: object, modules: tuple[str, ...]) -> None:
    """Die at once, as a worker that cannot start does."""
    os._exit(3)


def give_a_lock() -> object:
    return threading.Lock()


def die_once(mark: Path, after_s: float) -> str:
    """End this process the first time; say how often it was tried the second."""
    time.sleep(after_s)
    if mark.exists():
        return "second"
    mark.touch()
    os._exit(9)


def ignore_an_end(mark: Path) -> None:
    """Say that it has begun, and go on for a minute; tidy up when asked to end."""
    mark.touch()
    try:
        time.sleep(60)
    finally:
        mark.unlink()
