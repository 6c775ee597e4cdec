"""Hems in masks: arched, level seen from above, and slanting, with legs that come out below them."""

import numpy as np
import pytest

from cloner.records.loose import HEM_PLACES
from cloner.vision.segmentation.loose_outline import hem_rows

HEIGHT, WIDTH, FIGURE_PX = 700, 400, 1300.0
LOW, HIGH = 80, 320


def shown(hem, legs=((130, 180), (220, 270))):
    """Return the mask of cloth that ends at rows ``hem`` (W,), with tapering legs below it, and the cloth's edges."""
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    mask = (columns >= LOW) & (columns <= HIGH) & (rows <= hem)
    for first, last in legs:
        taper = np.clip(rows - 500, 0, None) // 20
        mask |= (columns >= first + taper) & (columns <= last - taper)
    return mask, np.tile([float(LOW), float(HIGH)], (HEIGHT, 1))


def curve(kind):
    across = np.clip((np.arange(WIDTH) - 200.0) / 120.0, -1.0, 1.0)
    return {
        "arched": 500.0 - 35.0 * (1.0 - across**2),
        "level from above": 500.0 + 30.0 * np.sqrt(1.0 - across**2),
        "slanting": 500.0 + 25.0 * across,
    }[kind]


@pytest.mark.parametrize("kind", ["arched", "level from above", "slanting"])
def test_a_hem_is_found_between_and_beside_the_legs(kind):
    hem = curve(kind)
    mask, edges = shown(hem)
    found = hem_rows(mask, edges, hem[[LOW, HIGH]], FIGURE_PX)
    true = np.interp(HEM_PLACES, np.linspace(-1.0, 1.0, HIGH - LOW + 1), hem[LOW : HIGH + 1])
    assert np.abs(found - true).max() < 4.0


def test_legs_that_hide_the_hem_leave_it_straight_between_its_ends():
    mask, edges = shown(curve("slanting"), legs=((LOW, HIGH),))
    found = hem_rows(mask, edges, np.array([475.0, 525.0]), FIGURE_PX)
    np.testing.assert_allclose(found, np.interp(HEM_PLACES, [-1.0, 1.0], [475.0, 525.0]))
