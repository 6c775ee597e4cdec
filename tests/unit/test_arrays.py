"""Arrays in frozen records: nobody's changes reach them, and large ones are not copied from record to record."""

from dataclasses import replace

import numpy as np
import pytest

from cloner.records.clones import TextureAtlas


def test_a_record_keeps_its_own_copy_of_what_may_still_change():
    rgb = np.zeros((4, 4, 3), np.uint8)
    atlas = TextureAtlas(rgb, np.zeros((4, 4), np.uint8))
    rgb[:] = 255
    assert not atlas.rgb.any()
    with pytest.raises(ValueError, match="read-only"):
        atlas.rgb[:] = 1


def test_what_one_record_has_frozen_the_next_one_shares():
    atlas = TextureAtlas(np.zeros((4, 4, 3), np.uint8), np.zeros((4, 4), np.uint8))
    assert replace(atlas, coverage=np.ones((4, 4), np.uint8)).rgb is atlas.rgb


def test_a_read_only_window_of_a_picture_that_may_change_is_copied():
    whole = np.zeros((8, 4, 3), np.uint8)
    window = whole[:4]
    window.setflags(write=False)
    atlas = TextureAtlas(window, np.zeros((4, 4), np.uint8))
    whole[:] = 255
    assert not atlas.rgb.any()
