"""The dark line below soles is found, soles are not; every true pixel is known."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from cloner.vision.retouching.matting import prepare_matted_photo
from cloner.vision.retouching.soles import contact_shadow, shaded_floor

HIGH, WIDE = 1000, 400
FLOOR, SHADOW, TROUSERS = 150, 12, 90


def standing(shoe: int, *, thick: int) -> tuple[np.ndarray, np.ndarray]:
    """Return a photo of two legs on a floor, and the true person; below each shoe lies a shadow ``thick`` px high."""
    grey = np.full((HIGH, WIDE), FLOOR, np.float32)
    person = np.zeros((HIGH, WIDE), bool)
    for left in (80, 240):
        person[60:880, left : left + 70] = True
        grey[60:820, left : left + 70] = TROUSERS
        grey[820:880, left : left + 70] = shoe
        grey[880 : 880 + thick, left - 2 : left + 72] = SHADOW
    noise = np.random.default_rng(0).normal(0, 3, grey.shape)
    soft = cv2.GaussianBlur(grey, (0, 0), 1.0) + noise
    return np.repeat(np.clip(soft, 0, 255).astype(np.uint8)[..., None], 3, axis=2), person


@pytest.mark.parametrize("thick", [5, 7])
def test_the_shadow_in_a_mask_is_found_and_the_shoe_is_not(thick: int) -> None:
    rgb, person = standing(60, thick=thick)
    mask = person.copy()
    mask[880 : 880 + thick] = person[879]
    found = contact_shadow(rgb, mask)
    assert found[mask & ~person].sum() >= (thick - 2) * 140  # all but the rows that are mixed; two shoes of 70 px
    assert (found & person).sum() <= 140


@pytest.mark.parametrize("shoe", [60, 230])
def test_a_mask_that_ends_at_the_sole_loses_nothing(shoe: int) -> None:
    rgb, person = standing(shoe, thick=0)
    assert not contact_shadow(rgb, person).any()


def test_a_person_cut_by_the_lower_edge_has_no_soles() -> None:
    rgb, person = standing(60, thick=9)
    assert not contact_shadow(rgb[:870], person[:870]).any()
    assert not contact_shadow(rgb, np.zeros_like(person)).any()


def test_a_plate_shows_the_shoe_where_its_mask_had_the_shadow() -> None:
    rgb, person = standing(60, thick=6)
    mask = person.copy()
    mask[880:886] = person[879]
    matted = prepare_matted_photo(rgb, mask, np.zeros(mask.shape, np.uint8), None, None, None)
    below = matted.rgb[880:892, 90:140].mean()
    assert 42 < below < 70, below  # the shoe has 60, its shadow 12


@pytest.mark.parametrize(("floor", "found"), [((150, 70, 70), True), ((110, 112, 110), False)])
def test_shaded_floor_between_shoes_is_told_by_its_hue(floor: tuple[int, int, int], found: bool) -> None:
    rgb = np.full((HIGH, WIDE, 3), floor, np.float32)
    person = np.zeros((HIGH, WIDE), bool)
    person[60:930, 100:200] = person[840:885, 100:280] = person[885:897, 100:240] = person[897:930, 100:300] = True
    rgb[person] = 50
    gap = np.zeros_like(person)
    gap[885:897, 240:280] = True
    rgb[gap] *= 0.6
    noise = np.random.default_rng(0).normal(0, 3, rgb.shape)
    photo = np.clip(cv2.GaussianBlur(rgb, (0, 0), 0.7) + noise, 0, 255).astype(np.uint8)
    told = shaded_floor(photo, person | gap)
    assert (told[gap].mean() > 0.5) == found  # all but its mixed rim; a grey floor has the grey shoes' hue
    assert told[person].sum() < 0.1 * gap.sum()
