"""What stages leave behind is given back to the system."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from cloner.memory import give_back


def resident_mib():
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 2**20


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc and speaks of glibc")
def test_freed_memory_goes_back():
    small = [np.ones(8000) for _ in range(2000)]  # 122 MiB in pieces that the C library keeps
    kept = small[1999]
    full = resident_mib()
    del small
    give_back()
    assert resident_mib() < full - 80.0
    assert kept.sum() == 8000
