"""A neck that a net took for hair is given back; hair that looks like hair stays."""

import numpy as np

from cloner.vision.vetting import without_neck

HAIR, SKIN = (45, 30, 25), (214, 166, 140)


def side_photo(rng, neck):
    """Return a photo with hair over a cheek, above a neck or a tail, the true hair, and a label that takes both."""
    rgb = np.full((400, 300, 3), 120, np.uint8)
    hair, cheek, below = (np.zeros((400, 300), bool) for _ in range(3))
    hair[40:200, 60:220] = True
    cheek[120:260, 220:280] = True
    below[200:340, 80:150] = True
    rgb[hair], rgb[cheek], rgb[below] = HAIR, SKIN, neck
    rgb = np.clip(rgb + rng.normal(0.0, 4.0, rgb.shape), 0, 255).astype(np.uint8)
    return rgb, hair, hair | below, cheek


def test_a_neck_taken_for_hair_is_given_back():
    shaded = tuple(int(0.8 * level) for level in SKIN)
    rgb, hair, label, cheek = side_photo(np.random.default_rng(0), shaded)
    kept = without_neck(rgb, label, cheek)
    assert (kept & ~hair).sum() < 0.1 * (label & ~hair).sum()
    assert (kept & hair).sum() > 0.98 * hair.sum()


def test_hair_that_hangs_down_stays():
    rgb, _, label, cheek = side_photo(np.random.default_rng(0), HAIR)
    assert np.array_equal(without_neck(rgb, label, cheek), label)


def test_without_skin_to_compare_nothing_is_denied():
    rgb, _, label, _ = side_photo(np.random.default_rng(0), SKIN)
    assert np.array_equal(without_neck(rgb, label, np.zeros_like(label)), label)
