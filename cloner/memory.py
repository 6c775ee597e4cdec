"""Memory of the process: its peak, limits, and the return of free memory to the system."""

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
#: (the most that glibc takes), and that much of it may lie free between two calls of ``release_free_memory``.
_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8
_LARGEST_KEPT: Final = 32 * 1024 * 1024
_MOST_KEPT: Final = 2**31 - 1


def check_address_limit() -> None:
    """Check that a limit on this process's address space (``ulimit -v``) is large enough for a clone.

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


def use_one_heap() -> None:
    """Let all threads of this process allocate from one heap, and keep large freed arrays there.

    An arena a thread keeps what only that thread will ask for again: 180 MiB of a clone's peak. Large arrays fetched
    from the system and handed back one by one cost a fault for every page: a quarter of a clone's.
    ``release_free_memory`` still empties the heap.
    """
    option = _of_libc("mallopt")
    if option is not None:
        for parameter, value in ((_ARENA_MAX, 1), (_MMAP_THRESHOLD, _LARGEST_KEPT), (_TRIM_THRESHOLD, _MOST_KEPT)):
            option(parameter, value)


def release_free_memory() -> None:
    """Return free memory to the system: the C library keeps what threads and large arrays freed (300 MiB)."""
    trim = _of_libc("malloc_trim")
    if trim is not None:
        trim(0)


@functools.cache
def _of_libc(name: str) -> Callable[..., int] | None:
    """Return a function of the C library, None where it does not exist: these two are glibc's."""
    try:
        return cast(Callable[..., int], getattr(ctypes.CDLL(None), name))
    except (AttributeError, OSError, TypeError):
        return None
