"""What stages leave behind is given back to the system."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from cloner.memory import release_free_memory


def resident_mib():
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 2**20


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc and speaks of glibc")
def test_freed_memory_goes_back():
    small = [np.ones(8000) for _ in range(2000)]  # 122 MiB in pieces that the C library keeps
    kept = small[1999]
    full = resident_mib()
    del small
    release_free_memory()
    assert resident_mib() < full - 80.0
    assert kept.sum() == 8000


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc and speaks of glibc")
def test_threads_take_from_one_heap():
    """A new arena is 64 MiB of addresses a thread (glibc's HEAP_MAX_SIZE)."""
    assert addresses_of_threads("") > 200.0
    assert addresses_of_threads("use_one_heap()") < 100.0


def addresses_of_threads(first):
    """Return by how many MiB a process's addresses grow with what four threads hold at once, stacks beside."""
    told = subprocess.run(
        [sys.executable, "-c", f"{THREADS}\n{first}\n{COUNT}"], check=True, capture_output=True, text=True
    )
    return float(told.stdout)


THREADS = """
import sys, threading
from pathlib import Path
from cloner.memory import use_one_heap
threading.stack_size(256 * 1024)
def addresses():
    return int(Path("/proc/self/statm").read_text().split()[0]) * 4096 / 2**20
"""
COUNT = """
all_here = threading.Barrier(5)
def work():
    kept = [bytearray(10000) for _ in range(10)]
    all_here.wait()
    all_here.wait()
before = addresses()
threads = [threading.Thread(target=work) for _ in range(4)]
for thread in threads:
    thread.start()
all_here.wait()
print(addresses() - before)
all_here.wait()
"""
