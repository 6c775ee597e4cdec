"""The nose's hollows are dark, and nothing else of the face is."""

import numpy as np
import pytest

from cloner.paint.details.nostrils import DARK, darken_nostrils, nostril_texels


@pytest.mark.parametrize("size", [512, 1024])
def test_only_the_hollows_of_the_nose_become_dark(size):
    rgb = np.full((size, size, 3), 180, np.uint8)
    found = darken_nostrils(rgb)
    texel, share = nostril_texels(size)
    changed = np.flatnonzero((found != rgb).any(axis=2))
    assert set(changed) <= set(texel[share > 0.0])
    assert found.min() == round(DARK * 180)
    assert 0 < len(changed) < 0.001 * size**2


def test_a_hollow_that_is_dark_already_stays():
    rgb = np.full((512, 512, 3), 180, np.uint8)
    texel, share = nostril_texels(512)
    rgb.reshape(-1, 3)[texel[share > 0.5]] = 30
    assert (darken_nostrils(rgb).reshape(-1, 3)[texel[share > 0.5]] == 30).all()
