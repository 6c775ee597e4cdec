"""Light told from the person's own symmetry, burnt-out skin, and skin told from collars."""

import numpy as np

from cloner.vision.evening import beyond_light, log_levels, one_sided_light, unclipped
from cloner.vision.skin_colour import skin_colour
from cloner.vision.vetting import before_wall, hair_colours, shown_bare, vet_hair

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


def test_shade_is_light_and_another_hue_or_white_on_black_is_another_thing():
    suit, shaded, shirt, blue = (
        log_levels(np.array(c, float)) for c in ((60, 60, 58), (30, 30, 28), (235,) * 3, (40, 60, 110))
    )
    assert beyond_light(suit - shaded) < 1.0
    assert beyond_light(suit - shirt) > 1.5
    assert beyond_light(suit - blue) > 1.0
    assert beyond_light(log_levels(SKIN) - log_levels(0.6 * SKIN)) < 1.0
    assert beyond_light(log_levels(SKIN) - shirt) > 1.0


def test_burnt_out_skin_gets_its_hue_back_and_cloth_does_not():
    shares = (SKIN[0] / SKIN[1], SKIN[2] / SKIN[1])
    burnt = np.array([[255.0, 215.0, 180.0], [255.0, 255.0, 250.0], [255.0, 255.0, 250.0], [200.0, 150.0, 120.0]])
    mended = unclipped(burnt, shares, np.array([1.0, 1.0, 0.0, 1.0]))
    assert mended[0, 0] > 285.0
    assert mended[0, 2] == 180.0
    assert mended[1, 2] < 220.0
    assert np.allclose(mended[2:], burnt[2:])


def test_collars_labelled_skin_are_not_skin_and_unlabelled_arms_are():
    rng = np.random.default_rng(5)
    rgb = np.full((200, 120, 3), (40, 70, 150), np.uint8)
    rgb[20:100, 40:80] = SKIN  # face and neck
    rgb[100:120, 40:80] = (225, 225, 225)  # a white collar
    rgb[130:190, 5:30] = SKIN * 0.8  # an arm in the shade
    rgb = np.clip(rgb + rng.normal(0, 3, rgb.shape), 0, 255).astype(np.uint8)
    bare = np.zeros(rgb.shape[:2], bool)
    bare[20:120, 40:80] = True
    hair = np.zeros_like(bare)
    hair[10:20, 40:80] = True
    shown = shown_bare(rgb, np.ones_like(bare), hair, bare, skin_colour(rgb[20:100, 40:80].reshape(-1, 3)))
    assert shown[30:90, 45:75].min() > 200
    assert shown[104:116, 45:75].max() < 50
    assert shown[140:180, 10:25].min() > 200
    assert shown[130:190, 90:115].max() < 50
    assert shown[12:18, 45:75].min() > 200  # hair is the person's own too


def _strands(shape, base, rng):
    return np.clip(np.array(base) + rng.normal(0, 6, (*shape, 3)), 0, 255).astype(np.uint8)


def test_a_collar_and_a_gap_labelled_hair_are_denied():
    rng = np.random.default_rng(6)
    hair, skin = _strands((60, 60), (90, 60, 40), rng), _strands((60, 60), SKIN, rng)
    colours = hair_colours([hair.reshape(-1, 3)], [skin.reshape(-1, 3)])
    photo = np.full((160, 120, 3), (90, 160, 130), np.uint8)  # a green wall
    photo[20:120, 20:100] = _strands((100, 80), (90, 60, 40), rng)
    photo[30:60, 70:90] = _strands((30, 20), (110, 80, 60), rng)  # shine
    photo[60:80, 30:50] = (90, 160, 130)  # the wall between tail and neck
    photo[120:140, 20:100] = (230, 230, 230)  # a collar
    label = np.zeros(photo.shape[:2], bool)
    label[20:140, 20:100] = True
    before = before_wall(photo, label, label, colours)
    assert not before[64:76, 34:46].any()
    assert before[30:60, 70:90].mean() > 0.95
    kept = vet_hair(photo, before, colours)
    assert not kept[125:135, 30:90].any()
    assert kept[90:115, 25:95].mean() > 0.95


def test_before_a_wall_of_the_hairs_colour_nothing_is_denied():
    rng = np.random.default_rng(7)
    photo = _strands((120, 120), (90, 60, 40), rng)
    label = np.zeros(photo.shape[:2], bool)
    label[30:90, 30:90] = True
    colours = hair_colours([photo[label]], [])
    assert np.array_equal(before_wall(photo, label, label, colours), label)


def test_a_nape_in_the_shade_is_no_hair_though_hair_shines_in_its_colour():
    rng = np.random.default_rng(8)
    dark, shine = _strands((60, 60), (90, 60, 40), rng), _strands((20, 60), (150, 110, 85), rng)
    shade, lit = _strands((40, 60), (150, 110, 85), rng), _strands((60, 60), SKIN, rng)
    colours = hair_colours([np.vstack([dark, shine]).reshape(-1, 3)], [np.vstack([lit, shade]).reshape(-1, 3)])
    photo = np.full((200, 120, 3), (60, 90, 180), np.uint8)
    photo[20:110, 20:100] = _strands((90, 80), (90, 60, 40), rng)
    photo[20:40, 40:80] = _strands((20, 40), (150, 110, 85), rng)  # shine on the crown
    photo[110:160, 35:85] = _strands((50, 50), (150, 110, 85), rng)  # the neck below
    label = np.zeros(photo.shape[:2], bool)
    label[20:110, 20:100] = label[110:160, 35:85] = True
    kept = vet_hair(photo, label, colours)
    assert kept[20:100, 25:95].mean() > 0.97
    assert kept[118:155, 40:80].mean() < 0.02
