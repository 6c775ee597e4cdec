"""Where visitors of the page may walk."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.scenes.building.reading import parse_plan
from cloner.scenes.building.solids import build_room
from cloner.scenes.building.walkable import BODY_M, CELL_M, make_walkable

PLAN = """
[[floor]]
from = [0, 0]
to = [6, 4]
look = "flags"
[[floor]]
from = [6, 1]
to = [10, 3]
look = "flags"
[[wall]]
from = [6, 0]
to = [6.2, 4]
high = 3
look = "stone"
openings = [{ at = 2, wide = 1.2, low = 0, high = 2.2 }, { at = 3.4, wide = 0.6, low = 1, high = 2 }]
[[block]]
name = "bench"
at = [2, 2]
size = [1, 1]
high = 0.5
look = "stone"
[[block]]
name = "beam"
at = [4, 2]
size = [1, 1]
low = 2.2
high = 2.5
look = "timber"
"""


def test_walls_and_things_stop_doors_and_beams_do_not() -> None:
    raster, low, step = make_walkable(build_room(parse_plan(PLAN, "a plan")))
    assert (low, step) == ((0.0, -4.0), CELL_M)

    def free(x: float, y: float) -> bool:
        return bool(raster[int((-y - low[1]) / step), int((x - low[0]) / step)])

    assert free(1.0, 1.0)
    assert free(4.0, 2.0), "below the beam"
    assert free(6.1, 2.0), "through the door"
    assert not free(6.1, 3.4), "no way through a window"
    assert not free(2.0, 2.0), "a bench"
    assert not free(2.0 + 0.5 + BODY_M - 0.06, 2.0)
    assert free(2.0 + 0.5 + BODY_M + 0.11, 2.0)
    assert not free(0.1, 1.0), "shoulders at the border"
    assert np.count_nonzero(raster) * step * step == pytest.approx(
        17.05 + 4.95 + 0.49, abs=2.0
    )  # by hand; half a cell a side
