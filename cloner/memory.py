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
#: Parameters of glibc's ``mallopt`` (malloc.h), and what they are set to: arrays up to this size come from the heap
#: (the most that glibc takes), and that much of it may lie free between two calls of ``give_back``.
_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8
_LARGEST_KEPT: Final = 32 * 1024 * 1024
_MOST_KEPT: Final = 2**31 - 1


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


def keep_one_heap() -> None:
    """Let all threads of this process take memory from one heap, and leave large freed arrays there for the next ones.

    An arena a thread keeps what only that thread will ask for again: 180 MiB of a clone's peak. Large arrays fetched
    from the system and handed back one by one cost a fault for every page: a quarter of a clone's. ``give_back`` still
    empties the heap.
    """
    option = _of_libc("mallopt")
    if option is not None:
        for parameter, value in ((_ARENA_MAX, 1), (_MMAP_THRESHOLD, _LARGEST_KEPT), (_TRIM_THRESHOLD, _MOST_KEPT)):
            option(parameter, value)


def give_back() -> None:
    """Let the system have the memory that is free: the C library keeps what threads and large arrays left (300 MiB)."""
    trim = _of_libc("malloc_trim")
    if trim is not None:
        trim(0)


@functools.cache
def _of_libc(name: str) -> Callable[..., int] | None:
    """Return a function of the C library, or None where it has none such: these two are glibc's own."""
    try:
        return cast(Callable[..., int], getattr(ctypes.CDLL(None), name))
    except (AttributeError, OSError, TypeError):
        return None
