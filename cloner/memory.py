"""The process's memory: how much it was at most, whether it may be enough, and giving back what is free."""

from __future__ import annotations

import ctypes
import functools
import sys
from collections.abc import Callable
from typing import Final, cast

from cloner.errors import ClonerError

if sys.platform == "win32":
    import psutil
else:
    import resource

#: What a clone takes of a process's addresses: 2.41 GB at most on two cores (VmPeak, samples), and room for a few more
#: threads. With less some library ends the process itself, without a word that anybody could catch.
CLONE_ADDRESSES_BYTES: Final = 2_500_000_000


def check_room() -> None:
    """Check that a limit on this process's addresses (``ulimit -v``) leaves enough for a clone.

    Raises
    ------
    ClonerError
        If it does not.
    """
    if sys.platform == "win32":
        return
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if limit != resource.RLIM_INFINITY and limit < CLONE_ADDRESSES_BYTES:
        may, needs = limit / 1e9, CLONE_ADDRESSES_BYTES / 1e9
        hint = f"Raise it: ulimit -v {-(-CLONE_ADDRESSES_BYTES // 1024)}"
        raise ClonerError(
            f"there is not enough memory: a limit allows {may:.1f} GB, a clone needs {needs:.1f}", hint, "Memory"
        )


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
