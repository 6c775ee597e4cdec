"""Light told from the person's own symmetry, burnt-out skin, and skin told from collars."""

import numpy as np
import pytest

from cloner.vision.retouching.matting import skin_shares
from cloner.vision.retouching.normalising import (
    apply_light,
    beyond_light,
    even_light,
    light_basis,
    log_levels,
    one_sided_light,
    restore_clipped_hue,
)
from cloner.vision.retouching.skin_colour import SkinColour

SKIN = np.array([190, 140, 115])


def _ball(count=800):
    """Return unit normals whose second half mirrors the first, and each one's twin."""
    half = np.random.default_rng(3).normal(size=(count // 2, 3))
    half /= np.linalg.norm(half, axis=1, keepdims=True)
    twin = np.concatenate([np.arange(count // 2, count), np.arange(count // 2)])
    return np.concatenate([half, half * (-1, 1, 1)]), twin


def test_a_lamp_from_one_side_is_told_from_the_two_halves():
    normals, twin = _ball()
    paint = np.random.default_rng(4).uniform(3.5, 5.0, (len(normals) // 2, 3))
    logs = np.concatenate([paint, paint]) + 0.4 * normals[:, :1]
    badge = np.arange(len(normals) // 2)[:40]
    logs[badge] = 5.5  # what one half alone wears is no light
    slope = one_sided_light(logs, np.ones(len(logs)), normals, twin)
    assert np.abs(slope - 0.4).max() < 0.03


def test_one_half_alone_tells_no_light():
    normals, twin = _ball()
    weight = np.where(np.arange(len(normals)) < len(normals) // 2, 1.0, 0.0)
    assert not one_sided_light(np.asarray(log_levels(normals + 2.0)), weight, normals, twin).any()


def test_a_photo_much_darker_is_evened_whole():
    normals, _ = _ball()
    cloth = np.tile([120.0, 110.0, 100.0], (len(normals), 1))
    photos = np.stack([cloth, cloth * 0.62])  # as dark as a back photo is beside a front one, .45 in log levels
    gains = even_light(photos, np.ones((2, len(normals))), normals, np.array([1e4, 1.0]))
    assert np.abs(apply_light(photos[1], light_basis(normals) @ gains[1]) - cloth).max() < 4.0


def test_no_photo_is_evened_beyond_what_light_does():
    normals, _ = _ball()
    black = np.full((len(normals), 3), 4.0)
    photos = np.stack([np.full((len(normals), 3), 200.0), black])
    gains = even_light(photos, np.ones((2, len(normals))), normals, np.array([1e4, 1.0]))
    assert apply_light(black, light_basis(normals) @ gains[1]).max() < 24.0


def test_shade_is_light_and_another_hue_or_white_on_black_is_another_thing():
    suit, shaded, shirt, blue = (
        log_levels(np.array(c, float)) for c in ((60, 60, 58), (30, 30, 28), (235,) * 3, (40, 60, 110))
    )
    assert beyond_light(suit - shaded) < 1.0
    assert beyond_light(suit - shirt) > 1.5
    assert beyond_light(suit - blue) > 1.0
    assert beyond_light(log_levels(SKIN) - log_levels(0.6 * SKIN)) < 1.0
    assert beyond_light(log_levels(SKIN) - shirt) > 1.0


def test_burnt_out_skin_is_as_pale_as_the_skin_beside_it():
    skin = SkinColour((0.6, -0.4), (0.05, 0.05))
    usual, pale = np.tile([180, 140, 110], (100, 1)), np.tile([255, 215, 204], (50, 1))
    red, blue = skin_shares(skin, np.vstack([usual, pale]).astype(np.uint8))
    assert red == pytest.approx(skin.shares()[0])
    assert blue == pytest.approx(204 / 215)
    assert skin_shares(skin, usual.astype(np.uint8)) == pytest.approx(skin.shares())


def test_burnt_out_skin_gets_its_hue_back_and_cloth_does_not():
    shares = (SKIN[0] / SKIN[1], SKIN[2] / SKIN[1])
    burnt = np.array([[255.0, 215.0, 180.0], [255.0, 255.0, 250.0], [255.0, 255.0, 250.0], [200.0, 150.0, 120.0]])
    mended = restore_clipped_hue(burnt, shares, np.array([1.0, 1.0, 0.0, 1.0]))
    assert mended[0, 0] > 285.0
    assert mended[0, 2] == 180.0
    assert mended[1, 2] < 220.0
    assert np.allclose(mended[2:], burnt[2:])
