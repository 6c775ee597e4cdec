"""The window's thread listens again and again in spite of its own work: pages, photos, a day of two hundred.

Work is counted in calls, which are as many on every machine; what it costs in milliseconds is measured by
``benchmarks/gui_flow.py``.
"""

import logging

import pytest

from kit.busy_day import crowd, walk
from kit.silence import Calls, LargeFiles, Silence

from .test_flow import event  # noqa: F401  (a fixture)

pytestmark = [pytest.mark.gui, pytest.mark.slow]
VISITORS = 200
#: Some 0.3 µs each on a free core: of the 100 ms that the window may be silent. A deletion on this thread has millions.
MOST_CALLS = 200_000
OWN = {"face_errors.npz"}  # the program's own table, 30 kB, read once
log = logging.getLogger(__name__)


def test_the_window_is_never_silent_for_long_by_its_own_work(event, jobs):  # noqa: F811
    silence, root = Silence(Calls()), event.booth.root
    crowd(root, VISITORS)
    with LargeFiles() as large:
        walk(event, jobs, root, silence)
    log.info("\n%s", silence.told("calls"))
    assert set(large.opened) <= OWN, "pictures and clones are read beside the window's thread"
    late = {name: round(count) for name, count in silence.longest.items() if count > MOST_CALLS}
    assert not late, late
