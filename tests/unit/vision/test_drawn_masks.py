"""Masks of drawn figures: gaps, lost shoes, lookalike walls. Every true pixel is known."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from cloner.vision.segmentation.limbs import add_feet, distance_to, finger_zone
from cloner.vision.segmentation.masks import outline_step, refine_mask

HIGH, WIDE = 1000, 600
Mask = NDArray[np.bool_]


def figure() -> Mask:
    """Return a trunk and a limb beside it, 14 px apart, and a shoe below."""
    drawn = np.zeros((HIGH, WIDE), np.uint8)
    cv2.rectangle(drawn, (220, 200), (330, 800), 1, -1)
    cv2.rectangle(drawn, (345, 320), (385, 600), 1, -1)
    cv2.rectangle(drawn, (325, 320), (350, 360), 1, -1)
    cv2.rectangle(drawn, (220, 790), (420, 830), 1, -1)
    return drawn > 0


def photograph(person: Mask, shirt: tuple[int, int, int], wall: tuple[int, int, int], *, noise: float = 3.0) -> NDArray:
    rgb = np.where(person[..., None], shirt, wall) + np.random.default_rng(1).normal(0, noise, (HIGH, WIDE, 3))
    return np.clip(cv2.GaussianBlur(rgb, (0, 0), 0.7), 0, 255).astype(np.uint8)


def net(person: Mask, sigma: float = 9.0) -> NDArray[np.float32]:
    """Return a mask as a small net sees it: no finer than its cells."""
    soft = cv2.GaussianBlur(person.astype(np.float32), (0, 0), sigma)
    return np.asarray(1 / (1 + np.exp(-12 * (soft - 0.5))), np.float32)


def overlap(first: Mask, second: Mask) -> float:
    return float((first & second).sum() / (first | second).sum())


@pytest.mark.parametrize(
    ("shirt", "wall"),
    [((60, 80, 150), (200, 195, 190)), ((120, 118, 115), (135, 133, 128)), ((30, 30, 30), (60, 60, 58))],
)
def test_gap_between_limb_and_trunk_opens(shirt: tuple[int, int, int], wall: tuple[int, int, int]) -> None:
    person = figure()
    gap = np.s_[380:580, 333:343]
    closed = cv2.morphologyEx(person.astype(np.uint8), cv2.MORPH_CLOSE, np.ones((25, 25), np.uint8)) > 0
    coarse = (net(person) + net(closed)) / 2
    assert (coarse[gap] > 0.5).all(), "the net must have filled it, or the test proves nothing"
    found = refine_mask(photograph(person, shirt, wall), coarse) > 0.5
    assert found[gap].mean() < 0.1
    assert overlap(found, person) > 0.985 > overlap(coarse > 0.5, person)


def test_lost_shoe_comes_back_where_pose_points_show_a_foot() -> None:
    person = figure()
    coarse = net(person)
    coarse[800:] = 0.01
    rgb = photograph(person, (60, 80, 150), (200, 195, 190))
    rgb[790:831][person[790:831]] = (240, 60, 60)  # no other part has the shoe's colour
    pose = np.full((33, 2), (270.0, 500.0))
    pose[[0, 27, 29, 31]] = (270, 220), (270, 780), (235, 815), (405, 815)
    pose[[28, 30, 32]] = pose[[27, 29, 31]]
    shoe = np.s_[803:826, 225:415]
    before = rgb.copy(), coarse.copy(), pose.copy()
    without, found = refine_mask(rgb, coarse) > 0.5, refine_mask(rgb, coarse, pose) > 0.5
    assert without[shoe].mean() < 0.5
    assert found[shoe].mean() > 0.97
    assert overlap(found, person) > 0.97
    for array, kept in zip((rgb, coarse, pose), before, strict=True):
        np.testing.assert_array_equal(array, kept)


def test_foot_far_from_the_person_is_not_believed() -> None:
    coarse = net(figure())
    pose = np.full((33, 2), (500.0, 60.0))
    pose[[29, 30]] += (-30, 20)
    pose[[31, 32]] += (30, 20)
    raised, around = add_feet(coarse, pose)
    np.testing.assert_array_equal(raised, coarse)
    assert not around.any()


def test_shirt_of_the_wall_s_colour_is_left_to_the_net() -> None:
    person = figure()
    coarse = net(person, sigma=3.0)
    found = refine_mask(photograph(person, (180, 178, 175), (180, 178, 175)), coarse) > 0.5
    assert overlap(found, person) > overlap(coarse > 0.5, person) - 0.01


def test_step_of_colour_is_the_photo_s_own() -> None:
    person = figure()
    low, high = (
        outline_step(photograph(person, (120, 120, 120), (120 + step, 120, 120), noise=1.0), net(person))
        for step in (14, 30)
    )
    assert low == pytest.approx(1.4, rel=0.4)
    assert high == pytest.approx(3.0, rel=0.4)


def test_distance_to_strokes_and_areas() -> None:
    away = distance_to((50, 80), [np.array([[10.0, 10.0], [30.0, 10.0]]), np.array([[60.0, 30], [70, 30], [65, 40]])])
    assert away[10, 20] == 0.0
    assert away[15, 20] == pytest.approx(5.0, abs=0.2)
    assert away[33, 65] == 0.0
    assert (distance_to((50, 80), []) >= 50).all()


def test_fingers_are_looked_for_round_the_knuckles_only() -> None:
    pose = np.full((33, 2), (270.0, 300.0))
    pose[[0, 27, 28]] = (270, 100), (270, 850), (270, 850)
    pose[[16, 18, 20, 22]] = (450, 500), (455, 520), (450, 525), (440, 515)
    pose[[15, 17, 19, 21]] = pose[[16, 18, 20, 22]]
    zone = finger_zone((HIGH, WIDE), pose)
    assert zone[548, 450] > 0.9
    assert zone[510, 450] < 0.1  # the palm
    assert zone[300, 270] < 0.01
    assert zone[700, 450] < 0.01
