"""Crops of a plane of brightness show it where they say, and values come back to where they were cut."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.vision.photographs.crops import Crop, cut, paste, photo_px_from_crop

HEIGHT, WIDTH = 403, 307


@pytest.fixture(scope="module")
def ramp():
    """Brightness grows by two fifths of a level a column and a fifth a row: means of blocks lie on the same plane."""
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    return np.repeat((20.0 + 0.4 * columns + 0.2 * rows)[..., None], 3, axis=2).round().astype(np.uint8)


@pytest.mark.parametrize(
    "crop", [Crop(160.3, 210.7, 90.0, 110.0, 0.2), Crop(150.2, 190.0, 290.0, 290.0, -0.1), Crop(40.0, 60.0, 30.0, 30.0)]
)
@pytest.mark.parametrize("side", [20, 48])
def test_a_crop_shows_the_plane_where_it_lies(ramp, crop, side):
    found = cut(ramp, crop, width=side, height=side)
    rows, columns = np.mgrid[:side, :side].astype(float)
    linear = photo_px_from_crop(crop, width=side, height=side)
    x, y = linear @ np.stack([columns.ravel(), rows.ravel(), np.ones(side * side)])
    inside = (x > 20) & (x < WIDTH - 21) & (y > 20) & (y < HEIGHT - 21)
    expected = 20.0 + 0.4 * x + 0.2 * y
    assert inside.any()
    assert np.abs(found[..., 0].ravel() - expected)[inside].max() < 1.3  # photo, mean and warp are rounded to levels


def test_the_last_columns_and_rows_are_not_lost(ramp):
    """403 rows are no multiple of the 8 that one of 50 shows: the last one still shows the photo, not the fill."""
    found = cut(ramp, Crop((WIDTH - 1) / 2, (HEIGHT - 1) / 2, WIDTH, HEIGHT), width=36, height=50)
    assert found[-1].min() > 60
    assert found[:, -1].min() > 60


def test_what_lies_beyond_the_photo_is_fill(ramp):
    found = cut(ramp, Crop(-500.0, -500.0, 200.0, 200.0), width=20, height=20, fill=7)
    assert (found == 7).all()


def test_values_come_back_to_their_place_and_nowhere_else():
    crop = Crop(120.0, 200.0, 64.0, 96.0)
    found = paste(np.ones((32, 32), np.float32), crop, shape=(HEIGHT, WIDTH))
    rows, columns = np.nonzero(found > 0.5)
    assert found.shape == (HEIGHT, WIDTH)
    assert (columns.min(), columns.max()) == pytest.approx((88.5, 151.5), abs=1.0)
    assert (rows.min(), rows.max()) == pytest.approx((152.5, 247.5), abs=1.0)
    assert found.sum() == pytest.approx(64 * 96, rel=0.02)
