"""Tiles of an atlas cover it once, and a window holds what the whole atlas holds there."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.paint.composing.baked import AtlasInProgress
from cloner.paint.composing.grain import coarse_tiles
from cloner.paint.composing.tiles import MARGIN, TILE, cut_tiles


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


def test_a_halved_tile_shows_the_same_part_of_the_smaller_atlas():
    for tile in cut_tiles(2048):
        half = tile.halved()
        assert [part.start * 2 for part in half.place] == [part.start for part in tile.place]
        assert [part.stop * 2 for part in half.place] == [part.stop for part in tile.place]
        assert half.outer.top + half.inner[0].start == half.place[0].start
        assert half.outer.left + half.inner[1].start == half.place[1].start


def test_tiles_are_coarse_only_where_no_photo_holds_more():
    generic, tiles = load_generic(), cut_tiles(2048)
    rough = SimpleNamespace(lookup_px=generic.vertices_m[:, :2].astype(np.float64) * 100.0)  # a pixel a centimetre
    sharp = SimpleNamespace(lookup_px=rough.lookup_px * 40.0)
    body, none = np.ones(len(generic.vertices_m)), np.zeros(len(generic.vertices_m))
    assert all(coarse_tiles(generic, 2048, tiles, [rough], np.stack([body])))
    fine = coarse_tiles(generic, 2048, tiles, [rough, sharp], np.stack([body, body]))
    assert sum(fine) < len(tiles) / 4
    assert all(coarse_tiles(generic, 2048, tiles, [rough, sharp], np.stack([body, none])))  # it paints nothing


def test_doubling_keeps_colours_in_their_place():
    ramp = np.repeat(np.arange(0, 200, 10, dtype=np.uint8)[None, :, None], 12, axis=0).repeat(3, axis=2)
    flags = ramp[..., 0] > 90
    twice = AtlasInProgress(ramp, flags, ~flags).doubled()
    assert np.array_equal(twice.covered[::2, ::2], flags)
    assert np.array_equal(twice.seen[1::2, 1::2], ~flags)
    pairs = twice.rgb.reshape(12, 2, 20, 2, 3).astype(float).mean(axis=(1, 3))
    assert np.abs(pairs - ramp)[:, 1:-1].max() <= 1.0
