"""Photos made ready: no background in the edge, outlines that meet, light that agrees."""

import numpy as np
import pytest

from cloner.vision.retouching.aligning import outline_shift, shift_points
from cloner.vision.retouching.normalising import LEVEL_OFFSET, apply_light, common_balance, even_light, light_basis
from cloner.vision.retouching.repair import remove_background_coloured, repair_bleeding, signed_distance


def _disc(centre, radius, size=200):
    row, column = np.mgrid[:size, :size]
    return np.hypot(column - centre[0], row - centre[1]) < radius


def test_no_background_colour_is_left_in_the_repaired_photo():
    true = _disc((100, 100), 60)
    photo = np.where(true[..., None], (200, 60, 40), (0, 255, 0)).astype(np.uint8)
    generous = _disc((100, 100), 63)  # a mask 3 px too large lets green in
    repaired, inside = repair_bleeding(photo, generous, 5.0)
    assert np.abs(repaired.astype(int) - (200, 60, 40)).max() <= 1
    assert abs(inside[100, 100] - 63) < 1.5
    assert inside[100, 190] < -20


def test_a_finger_thinner_than_the_band_keeps_its_colour():
    mask = np.zeros((100, 100), bool)
    mask[:60] = True
    mask[60:95, 48:53] = True
    photo = np.where(mask[..., None], (30, 30, 200), (0, 255, 0)).astype(np.uint8)
    photo[60:95, 48:53] = (220, 180, 160)
    repaired, _ = repair_bleeding(photo, mask, 6.0)
    assert np.abs(repaired[90, 50].astype(int) - (220, 180, 160)).max() <= 10


def test_outlines_a_few_pixels_apart_are_brought_together():
    photo = signed_distance(_disc((104, 97), 60))
    everywhere = np.ones(photo.shape, bool)
    field, gap = outline_shift(_disc((100, 100), 60), photo, everywhere, 12.0)
    rim = np.array([100, 100]) + 58 * np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])
    moved = shift_points(rim.astype(float), field)
    assert 2.0 < gap < 5.0
    assert np.abs(np.hypot(*(moved - (104, 97)).T) - 58).max() < 1.0


def test_what_lies_right_stays_while_an_outline_elsewhere_is_moved():
    shoulders, lifted = np.zeros((2, 240, 200), bool)
    shoulders[160:220, 20:180], lifted[148:208, 20:180] = True, True
    photo, everywhere = signed_distance(lifted), np.ones((240, 200), bool)
    face = np.stack(np.meshgrid(np.arange(80.0, 121.0, 4.0), np.arange(30.0, 91.0, 4.0)), axis=-1).reshape(-1, 2)
    free, _ = outline_shift(shoulders, photo, everywhere, 15.0)
    held, _ = outline_shift(shoulders, photo, everywhere, 15.0, face)
    assert np.abs(shift_points(face, free) - face).max() > 5.0
    assert np.abs(shift_points(face, held) - face).max() < 2.0
    upper = np.array([[100.0, 162.0]])
    assert shift_points(upper, held)[0, 1] == pytest.approx(150.0, abs=2.5)


def test_outlines_too_far_apart_are_left_alone():
    photo = signed_distance(_disc((140, 100), 40))
    field, _ = outline_shift(_disc((60, 100), 30), photo, np.ones(photo.shape, bool), 5.0)
    assert np.abs(field).max() < 5.0


def test_light_that_differs_by_exposure_and_side_is_evened():
    rng = np.random.default_rng(7)
    normals = rng.normal(size=(900, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    truth = rng.uniform(60, 190, (900, 3))
    light = light_basis(normals) @ np.array([[-0.12] * 3, [0.06] * 3, [0.0] * 3, [0.0] * 3])
    photos = np.stack([truth, apply_light(truth, light)])
    gains = even_light(photos, np.ones((2, 900)), normals, np.array([30.0, 1.0]))
    evened = np.stack([apply_light(photos[k], light_basis(normals) @ gains[k]) for k in range(2)])
    assert np.abs(photos[0] - photos[1]).mean() > 10
    assert np.abs(evened[0] - evened[1]).mean() < 3
    assert np.abs(evened[0] - truth).mean() < 8  # the reference gives way least


def test_photos_that_share_nothing_are_left_alone():
    weights = np.zeros((2, 50))
    weights[0, :25] = weights[1, 25:] = 1.0
    gains = even_light(np.full((2, 50, 3), 90.0), weights, np.tile([0.0, 0.0, 1.0], (50, 1)), np.ones(2))
    assert not gains.any()


def test_a_wall_shining_through_strands_is_not_hair():
    wall, brown = np.array([210, 215, 205]), np.array([90, 60, 40])
    photo = np.tile(wall, (120, 120, 1)).astype(np.uint8)
    photo[10:110, 30:90] = brown
    photo[20:100, 84:86] = wall  # a gap between strands that the labels bridge
    mask = np.zeros((120, 120), bool)
    mask[10:110, 30:90] = True
    mask[40:60, 90:93] = True  # labels a little too far out
    own = remove_background_coloured(photo, mask, 6.0)
    assert not own[25:95, 84:86].any()
    assert not own[42:58, 90:93].any()
    assert own[15:105, 34:80].all()


def test_exposure_and_white_balance_are_those_of_all_photos():
    rng = np.random.default_rng(3)
    truth = rng.uniform(80, 160, (500, 3))
    casts = np.array([[0.12, 0.0, -0.12], [-0.06, 0.0, 0.06], [-0.06, 0.0, 0.06]])  # they are 0 in the mean
    casts += np.array([[-0.4], [0.3], [0.1]])  # so are exposures: the reference is the darkest photo
    photos = (truth + LEVEL_OFFSET) * np.exp(casts)[:, None] - LEVEL_OFFSET
    light = np.broadcast_to((casts[0] - casts)[:, None], photos.shape)  # all like the first
    weights = np.ones((3, 500))
    gain = common_balance(photos, light, weights, np.ones(3, bool))
    assert np.abs(apply_light(photos[0], gain) / truth - 1.0).max() < 0.05
    alone = common_balance(photos, light, weights, np.array([True, False, False]))
    assert np.abs(alone).max() < 1e-9
    assert np.abs(common_balance(photos, light, 0.0 * weights, np.ones(3, bool))).max() == 0.0


def test_a_mask_without_an_outline_is_far_and_not_infinite():
    everything = np.ones((20, 30), bool)
    assert np.array_equal(signed_distance(everything), -signed_distance(~everything))
    assert 1e3 < signed_distance(everything).max() < 1e5
