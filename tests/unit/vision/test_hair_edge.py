"""Coarse labels of hair are drawn anew along the photo's own colours."""

from __future__ import annotations

import cv2
import numpy as np

from cloner.vision.segmentation.hair_edge import draw_edge, fill_slivers, sharpen_hair

SIZE, HEAD_PX = (300, 260), 230.0


def drawn() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return picture, person and true hair: a cap over a face with two thin sideburns."""
    person, hair = np.zeros(SIZE, np.uint8), np.zeros(SIZE, np.uint8)
    cv2.ellipse(person, (130, 150), (80, 115), 0, 0, 360, 1, -1)
    cv2.ellipse(hair, (130, 150), (80, 115), 0, 180, 360, 1, -1)
    hair[95:, 62:198] = 0
    hair[150:175] = (person[150:175] > 0) & (np.abs(np.arange(SIZE[1]) - 130) > 70)  # 9 px wide: 9 mm
    light = np.interp(np.arange(SIZE[1]), [40, 220], [1.0, 0.7])[None, :, None]
    picture = np.where(hair[..., None] > 0, (70, 50, 40), (200, 155, 130)) * light
    picture = np.where(person[..., None] > 0, picture, (150, 165, 150)) + np.random.default_rng(0).normal(
        0, 4, (*SIZE, 1)
    )
    return np.clip(picture, 0, 255).astype(np.uint8), person > 0, (hair > 0) & (person > 0)


def test_a_hairline_ten_millimetres_off_and_lost_sideburns_are_found():
    rgb, person, true = drawn()
    coarse = true.copy()
    coarse[148:] = False  # the sideburns are cut off
    coarse[:105, 62:198] |= person[:105, 62:198]  # and the fringe reaches too low
    found = sharpen_hair(rgb, cv2.GaussianBlur(coarse.astype(np.float32), (0, 0), 3.0), person, ~person, HEAD_PX) > 0.5
    assert (coarse & true).sum() / (coarse | true).sum() < 0.85
    assert (found & true).sum() / (found | true).sum() > 0.95
    assert found[165][true[165]].mean() > 0.8


def test_what_is_never_hair_stays_so_and_nobody_gets_hair_from_nothing():
    rgb, person, true = drawn()
    brows = np.zeros(SIZE, bool)
    brows[100:106, 90:120] = True
    rgb = rgb.copy()
    rgb[brows] = (70, 50, 40)
    found = sharpen_hair(rgb, true.astype(np.float32), person, brows, HEAD_PX) > 0.5
    assert not found[brows].any()
    assert not sharpen_hair(rgb, np.zeros(SIZE, np.float32), person, brows, HEAD_PX).any()


def test_shine_at_the_outline_is_hair_and_a_forehead_is_not():
    _, person, true = drawn()
    shine = true.copy()
    shine[:60] &= cv2.erode(person.astype(np.uint8), np.ones((7, 7), np.uint8))[:60] > 0
    assert (shine & true)[:60].sum() < true[:60].sum()
    filled = fill_slivers(shine, person, HEAD_PX)
    assert (filled & true)[:58].sum() > 0.98 * true[:58].sum()
    assert not filled[100:140, 70:190].any()


def test_a_head_whose_ears_are_the_first_row_has_no_rows_above_them():
    nothing = np.zeros((0, 40), bool)
    assert fill_slivers(nothing, nothing, HEAD_PX).shape == (0, 40)
    rgb, person, true = drawn()
    assert draw_edge(rgb, true.astype(np.float32), person, None, HEAD_PX, ear_px=0.0).any()
