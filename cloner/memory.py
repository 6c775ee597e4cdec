"""The process's memory: how much it was at most, and giving back what is free."""

from __future__ import annotations

import ctypes
import functools
import sys
from collections.abc import Callable
from typing import cast

if sys.platform == "win32":
    import psutil
else:
    import resource


def peak_mib() -> float:
    """Return the process's peak resident memory in MiB."""
    if sys.platform == "win32":
        return float(psutil.Process().memory_info().peak_wset) / (1024.0 * 1024.0)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1024.0 * 1024.0 if sys.platform == "darwin" else 1024.0)


def give_back() -> None:
    """Let the system have the memory that is free: the C library keeps what threads and large arrays left (300 MiB)."""
    trim = _trim()
    if trim is not None:
        trim(0)


@functools.cache
def _trim() -> Callable[[int], int] | None:
    """Return glibc's ``malloc_trim``; other C libraries have none and need none."""
    try:
        return cast(Callable[[int], int], ctypes.CDLL(None).malloc_trim)
    except (AttributeError, OSError, TypeError):
        return None
