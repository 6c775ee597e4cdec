"""A lock file that is released when its process dies, on every system."""

from __future__ import annotations

import contextlib
import errno
import os
import sys
from pathlib import Path

_TAKEN = {errno.EWOULDBLOCK, errno.EAGAIN, errno.EACCES, errno.EDEADLK}
_TRIES = 5  # taste: files that others hold for a moment

if sys.platform == "win32":
    import msvcrt

    def _take(descriptor: int) -> None:
        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _take(descriptor: int) -> None:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)


def lock(path: Path) -> int | None:
    """Return a descriptor that holds a lock file's lock while it is open; None where another process holds it.

    Raises
    ------
    OSError
        If the file cannot be made, or this file system knows no locks.
    """
    for _ in range(_TRIES):
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o600)
        try:
            _take(descriptor)
            if sys.platform == "win32" or _is_same_file(descriptor, path):
                return descriptor
        except OSError as error:
            os.close(descriptor)
            if error.errno not in _TAKEN:
                raise
            return None
        os.close(descriptor)  # its holder removed it between the two lines above: make another
    return None


def release(descriptor: int, path: Path) -> None:
    """Remove a lock file that this process holds, and release the lock."""
    if sys.platform == "win32":  # an open file cannot be removed there; whoever opened it meanwhile keeps it
        os.close(descriptor)
        with contextlib.suppress(OSError):
            path.unlink(missing_ok=True)
        return
    path.unlink(missing_ok=True)  # first: whoever gets the lock afterwards sees that the file is gone
    os.close(descriptor)


def _is_same_file(descriptor: int, path: Path) -> bool:
    """Return whether a locked file is the one under its name: a holder may have removed it before we had the lock."""
    try:
        mine, named = os.fstat(descriptor), path.stat()
    except FileNotFoundError:
        return False
    return (mine.st_dev, mine.st_ino) == (named.st_dev, named.st_ino)
