"""Free hair hangs: what stands above the head is a dome, and what lies on it all the way down is thick hair."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.hair.volumes.tail import free_hair, hangs_clear, is_knot

SIZE = (300, 300)
ROWS, COLUMNS = np.mgrid[: SIZE[0], : SIZE[1]]
#: A head and the neck below it.
HEAD = (np.hypot(ROWS - 150, COLUMNS - 150) < 60) | ((np.abs(COLUMNS - 150) < 25) & (ROWS > 150))


def side_photo(hair):
    """Return what a side photo with this hair (H, W) tells, a millimetre a pixel."""
    return SimpleNamespace(hair=hair, pixel_mm=lambda points: 1.0, to_view=lambda points: points)


def found(hair):
    return free_hair(side_photo(hair), HEAD, np.zeros((1, 3)))


@pytest.fixture
def tail():
    """A strand that hangs behind the neck."""
    return (np.abs(COLUMNS - 245) < 12) & (ROWS > 130) & (ROWS < 280)


def test_the_dome_of_a_cap_is_no_tail(tail):
    dome = (np.hypot(ROWS - 110, COLUMNS - 150) < 70) & (ROWS < 110)
    assert found(tail)[tail].mean() > 0.9
    assert not found(dome)[:90].any()
    assert np.array_equal(found(dome | tail)[150:], found(tail)[150:]), "the tail below stays what it is"


def test_a_tail_with_its_root_and_the_nape_s_hair_in_one_piece_hangs(tail):
    root = (np.abs(ROWS - 130) < 15) & (COLUMNS > 205) & (COLUMNS < 257) & ~HEAD
    nape = (ROWS > 130) & (ROWS < 240) & (COLUMNS > 175) & (COLUMNS < 215) & ~HEAD
    view = side_photo(tail | root | nape)
    free = view.hair
    assert hangs_clear(view, free, HEAD, np.zeros((1, 3)))[tail].all()


def test_thick_hair_lies_on_the_head_all_the_way_down_and_a_tail_does_not(tail):
    thick = (np.hypot(ROWS - 150, COLUMNS - 170) < 85) & ~HEAD & (COLUMNS > 150) & (ROWS > 100)
    for hair, hangs in ((tail, True), (thick, False)):
        view = side_photo(hair)
        assert hair.any()
        assert hangs_clear(view, hair, HEAD, np.zeros((1, 3)))[hair].all() == hangs


def test_a_bun_goes_on_above_the_head_and_is_told_from_a_strand(tail):
    bun = np.hypot(ROWS - 100, COLUMNS - 228) < 45
    seen = found(bun)
    assert seen[bun & ~HEAD].mean() > 0.95
    assert is_knot(seen)
    assert not is_knot(found(tail))
    assert not is_knot(bun & (np.hypot(ROWS - 110, COLUMNS - 210) > 45)), "a crescent of thick hair"
