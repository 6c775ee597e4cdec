"""Tiles of an atlas cover it once, and a window holds what the whole atlas holds there."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.baking.tiles import MARGIN, TILE, cut_tiles
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic


@pytest.mark.parametrize("size", [512, 2048])
def test_tiles_cover_the_atlas_once_and_keep_their_margins(size):
    count = np.zeros((size, size), int)
    number = np.arange(size * size).reshape(size, size)
    for tile in cut_tiles(size):
        count[tile.place] += 1
        window = tile.outer
        outer = number[window.top : window.top + window.height, window.left : window.left + window.width]
        assert outer.shape == (window.height, window.width)
        assert np.array_equal(outer[tile.inner], number[tile.place])
        assert max(outer.shape) <= TILE + 2 * MARGIN
    assert (count == 1).all()


def test_a_window_shows_what_the_whole_atlas_shows():
    generic = load_generic()
    whole = generic_atlas(generic, 1024)
    heights = np.full((1024, 1024), np.nan)
    heights.reshape(-1)[whole.texel] = whole.interpolate(generic.vertices_m[:, 1])
    for tile in cut_tiles(1024)[:2]:
        window = tile.outer
        part = generic_atlas(generic, 1024, window=window)
        seen = np.full((window.height, window.width), np.nan)
        seen.reshape(-1)[part.texel] = part.interpolate(generic.vertices_m[:, 1])
        expected = heights[window.top : window.top + window.height, window.left : window.left + window.width]
        assert np.array_equal(np.isnan(seen), np.isnan(expected))
        assert np.nanmax(np.abs(seen - expected)) < 1e-5
