"""One visitor, one worker: a lock file that dies with the process that holds it."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def claimed(out: Path, identifier: str) -> Iterator[bool]:
    """Give whether this process may clone a visitor; others that ask meanwhile get False.

    The lock is the system's (flock), so a killed process leaves none behind.
    """
    out.mkdir(parents=True, exist_ok=True)
    path = out / f".{identifier}.claim"
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o600)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(descriptor)
        yield False
        return
    try:
        yield True
    finally:
        path.unlink(missing_ok=True)
        os.close(descriptor)
