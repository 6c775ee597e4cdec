"""Borders beside an axis, gaps between limbs and extremes of profiles, on drawn shapes."""

import numpy as np
import pytest

from cloner.vision.segmentation.outline_walk import extreme, gap_apex, gap_between, gap_top, soft_mask, walk_strip


def drawn(height=200, width=120):
    return np.zeros((height, width), np.float64)


def as_mask(coverage):
    return np.round(255 * np.clip(coverage, 0.0, 1.0)).astype(np.uint8)


def post(left, right, top=20, bottom=180):
    """Return the mask of an upright post with borders between pixels: (0, 0) is the first pixel's centre."""
    columns = np.arange(120.0)
    row = np.clip(columns + 0.5 - left, 0, 1) * np.clip(right - columns + 0.5, 0, 1)
    picture = drawn()
    picture[top:bottom] = row
    return as_mask(picture)


@pytest.mark.parametrize(("left", "right"), [(40.0, 80.0), (40.25, 80.7), (39.6, 81.5)])
def test_borders_are_found_between_pixels(left, right):
    figure = soft_mask(post(left, right))
    rows = np.arange(40.0, 160.0)
    centres = np.stack([np.full(len(rows), 55.0), rows], axis=1)
    strip = walk_strip(figure, centres, np.tile([1.0, 0.0], (len(rows), 1)), 60.0)
    assert 55.0 + strip.near == pytest.approx(np.full(len(rows), left), abs=0.3)
    assert 55.0 + strip.far == pytest.approx(np.full(len(rows), right), abs=0.3)


def test_an_axis_beside_the_person_finds_no_border():
    figure = soft_mask(post(40.0, 80.0))
    strip = walk_strip(
        figure, np.array([[20.0, 100.0], [38.0, 100.0]]), np.tile([1.0, 0.0], (2, 1)), 70.0, slack_px=5.0
    )
    assert np.isnan(strip.far[0])
    assert strip.far[1] == pytest.approx(42.0, abs=0.6)


def test_borders_that_cut_the_person_are_named():
    assert soft_mask(post(40.0, 80.0)).cut == ()
    assert soft_mask(post(40.0, 80.0, bottom=200)).cut == ("bottom",)
    assert soft_mask(post(-5.0, 80.0, top=0)).cut == ("top", "left")


def test_nobody_has_no_figure():
    assert soft_mask(np.zeros((50, 50), np.uint8)) is None


def test_the_gap_between_two_legs_opens_at_its_apex():
    picture = drawn()
    picture[20:180, 30:91] = 1.0
    for row in range(90, 180):
        half = (row - 89.5) / 6.0
        columns = np.arange(120.0)
        picture[row] *= 1.0 - np.clip(half + 0.5 - np.abs(columns - 60.0), 0.0, 1.0)
    figure = soft_mask(as_mask(picture))
    rows = np.arange(30.0, 170.0)
    left, right = (np.stack([np.full(len(rows), column), rows], axis=1) for column in (40.0, 80.0))
    gap = gap_between(figure, left, right)
    top = gap_top(gap, 5.0)
    assert rows[top] == pytest.approx(92.0, abs=3.0)
    assert (gap[:50] == 0.0).all()
    assert gap[-1] == pytest.approx(2 * (rows[-1] - 89.5) / 6.0, abs=1.5)
    assert gap_apex(figure, left[top], right[top]) == pytest.approx([60.0, 92.0], abs=3.0)


def test_a_gap_that_closes_again_is_none():
    gap = np.zeros(100)
    gap[30:33] = 4.0
    assert gap_top(gap, 5.0) is None
    gap[60:] = 2.0
    assert gap_top(gap, 5.0) == 60


def test_extremes_lie_inside_the_window_or_are_none():
    profile = (np.arange(100.0) - 41.3) ** 2
    assert extreme(profile, 10, 90, largest=False) == pytest.approx(41.3, abs=0.01)
    assert extreme(profile, 50, 90, largest=False) is None, "it only rises there"
    assert extreme(-profile, 10, 90, largest=True) == pytest.approx(41.3, abs=0.01)
    profile[20:80] = np.nan
    assert extreme(profile, 10, 90, largest=False) is None
