"""What a mask took of the room: told by the person's own colours at that height, and by the body fitted to it."""

from __future__ import annotations

import cv2
import numpy as np

from cloner.vision.retouching.background_colours import colours_by_height
from cloner.vision.retouching.repair import remove_outside_body

WALL, CLOTH, SHIRT = (20, 130, 130), (70, 90, 80), (150, 140, 160)


def _figure():
    """Return a photo of a person in front of a teal wall and the true mask."""
    mask = np.zeros((900, 400), bool)
    mask[40:860, 140:260] = True
    photo = np.full((900, 400, 3), WALL, np.uint8)
    photo[mask] = CLOTH
    photo[40:450, 140:260] = SHIRT
    noise = np.random.default_rng(0).normal(0.0, 4.0, photo.shape)
    return np.clip(photo + noise, 0, 255).astype(np.uint8), mask


def test_a_piece_of_wall_beside_the_hip_leaves_the_mask_and_a_stripe_of_the_persons_stays():
    photo, true = _figure()
    photo[300:420, 250:260] = CLOTH  # a stripe down the shirt: the trousers' colour, but not at that height
    taken = true.copy()
    cv2.ellipse(wrong := taken.astype(np.uint8), (262, 600), (10, 40), 0, 0, 360, 1, -1)
    taken = wrong > 0
    found = colours_by_height([(photo, taken)]).without_room(photo, taken)
    assert (found & ~true).sum() < 0.25 * (taken & ~true).sum()
    assert (true & ~found).sum() < 0.002 * true.sum()
    assert found[300:420, 252:258].all()


def test_a_mask_without_any_wall_stays_as_it_is():
    photo, true = _figure()
    own = colours_by_height([(photo, true)])
    assert (own.without_room(photo, true) == true).mean() > 0.9999
    assert np.array_equal(own.without_room(photo, np.zeros_like(true)), np.zeros_like(true))


def test_a_box_beside_an_arm_goes_down_to_the_arm_and_what_a_fit_errs_by_stays():
    body = np.zeros((450, 200), bool)
    body[20:430, 70:130] = True
    mask = np.zeros((900, 400), bool)
    mask[40:860, 134:266] = True  # three of the body's pixels wider than it
    box = mask.copy()
    box[400:500, 260:330] = True
    found = remove_outside_body(box, body, 5.0)
    assert not found[405:495, 262:].any()
    assert found[:360].sum() == mask[:360].sum()
    assert np.array_equal(remove_outside_body(mask, body, 5.0), mask)
