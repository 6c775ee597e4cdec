"""Pyramids: laws that hold for any image."""

import numpy as np

from cloner.vision.photographs.blending import Layer, blend_pyramids, push_pull


def _noise(seed, shape=(128, 64, 3)):
    return np.random.default_rng(seed).uniform(0, 255, shape).astype(np.float32)


def test_an_image_blended_with_itself_is_itself():
    image = _noise(1)
    share = _noise(2)[..., 0] / 255.0
    mixed = blend_pyramids([Layer(image, share), Layer(image, 1.0 - share)], image.shape, 4)
    assert np.abs(mixed - image).max() < 0.01


def test_each_half_keeps_its_own_image_far_from_the_border():
    first, second = _noise(3), _noise(4)
    left = np.zeros((128, 64), np.float32)
    left[:, :32] = 1.0
    mixed = blend_pyramids([Layer(first, left), Layer(second, 1.0 - left)], first.shape, 2)
    assert np.abs(mixed[:, :16] - first[:, :16]).max() < 0.01
    assert np.abs(mixed[:, 48:] - second[:, 48:]).max() < 0.01


def test_a_step_of_light_becomes_a_ramp_as_wide_as_the_coarsest_level():
    dark, light = np.full((64, 128, 3), 100, np.float32), np.full((64, 128, 3), 140, np.float32)
    left = np.zeros((64, 128), np.float32)
    left[:, :64] = 1.0
    row = blend_pyramids([Layer(dark, left), Layer(light, 1.0 - left)], dark.shape, 4)[32, :, 0]
    assert np.abs(np.diff(row)).max() < 4.0  # the step was 40
    assert abs(row[4] - 100) < 1
    assert abs(row[-5] - 140) < 1


def test_a_crop_blends_like_the_whole():
    ground, patch = np.full((128, 128, 3), 60, np.float32), _noise(5, (128, 128, 3))
    weight = np.zeros((128, 128), np.float32)
    weight[56:72, 56:72] = 1.0
    rest = Layer(ground, np.full((128, 128), 1e-6, np.float32))
    whole = blend_pyramids([rest, Layer(patch, weight)], ground.shape, 3)
    crop = Layer(patch[24:104, 32:104], weight[24:104, 32:104], (24, 32))
    assert np.abs(blend_pyramids([rest, crop], ground.shape, 3) - whole).max() < 0.01


def test_push_pull_keeps_what_is_known_and_stays_between_its_values():
    image = _noise(6, (96, 80, 3))
    known = np.zeros((96, 80), np.float32)
    known[10:20, 10:20] = known[60:70, 50:60] = 1.0
    filled = push_pull(image, known)
    assert np.array_equal(filled[known > 0], image[known > 0])
    assert filled.min() >= image[known > 0].min() - 0.01
    assert filled.max() <= image[known > 0].max() + 0.01
    assert np.allclose(push_pull(np.full_like(image, 77.0), known), 77.0, atol=0.01)
