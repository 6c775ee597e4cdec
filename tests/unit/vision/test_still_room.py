"""Two photos of one camera that stood still tell what is behind the person."""

from __future__ import annotations

import numpy as np

from cloner.vision.outlines import extract_outline
from cloner.vision.still_room import still_room, without_room
from kit.drawn import HEIGHT, SKIN, WALL, WIDTH, draw, ellipse, rough_mask, with_noise

BOX = np.array([[270.0, 260.0], [350.0, 260.0], [350.0, 340.0], [270.0, 340.0]])


def room_with_box() -> np.ndarray:
    rng = np.random.default_rng(2)
    wall = np.full((HEIGHT, WIDTH, 3), WALL, np.uint8)
    for x, y in rng.integers(0, (390, 590), (300, 2)):
        wall[y : y + 14, x : x + 14] = rng.integers(0, 255, 3)
    # a box in the skin's colour beside the person
    return draw(wall, BOX, (SKIN[0] - 4, SKIN[1] + 3, SKIN[2] + 2))


def photo_of(middle_px: float, seed: int) -> tuple[np.ndarray, np.ndarray]:
    shift = np.array([middle_px, 0.0])
    mask = np.roll(rough_mask(shift=0.0, blur=1.0), int(middle_px), axis=1)
    return with_noise(draw(room_with_box(), ellipse() + shift, SKIN), 2.0, seed), mask.astype(np.float32)


def boxed(mask: np.ndarray) -> np.ndarray:
    return draw(np.repeat(mask[..., None] * 255, 3, axis=2).astype(np.uint8), BOX, (255, 255, 255))[
        ..., 0
    ] / np.float32(255)


def test_what_another_photo_shows_without_the_person_is_the_room() -> None:
    (first, mask), (second, other) = photo_of(0.0, 1), photo_of(-80.0, 2)
    odds = still_room(first, boxed(mask).astype(np.float32), [(second, other)])
    assert odds is not None
    assert odds[280:320, 320:345].max() < -3.0, "the box stands in the other photo, and nobody before it"
    assert odds[120:240, 240:270].min() > -1.0, "the person differs from it"
    assert np.abs(odds[250:350, 120:160]).max() < 1e-6, "both photos show the person"


def test_a_box_in_the_skin_s_colour_leaves_the_outline() -> None:
    (first, mask), (second, other) = photo_of(0.0, 1), photo_of(-80.0, 2)
    fooled = boxed(mask).astype(np.float32)
    room = still_room(first, fooled, [(second, other)])
    truth = mask > 0.5
    wrong = [(extract_outline(first, fooled, room=each).filled ^ truth).sum() for each in (None, room)]
    assert wrong[0] > 1500
    assert wrong[1] < 0.25 * wrong[0]


def test_a_camera_that_moved_tells_nothing() -> None:
    (first, mask), (second, other) = photo_of(0.0, 1), photo_of(-80.0, 2)
    assert still_room(first, mask, [(np.roll(second, 9, axis=1), other)]) is None
    assert still_room(first, mask, [(second[:-20], other[:-20])]) is None
    assert without_room(mask, None) is mask


def test_a_darker_exposure_of_the_same_room_compares() -> None:
    (first, mask), (second, other) = photo_of(0.0, 1), photo_of(-80.0, 2)
    odds = still_room(first, mask, [((second * 0.8).astype(np.uint8), other)])
    assert odds is not None
    assert np.median(odds[20:200, 340:390]) < -3.0
