"""Colours counted by hand: what is likelier on the person, in the whole photo and nearby."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.vision.segmentation.colours import BELIEF_EVEN, BELIEF_WIDE, LIMIT, colour_ratio, quantise_colours

SHAPE = (60, 90)
RED, GREEN, GREY = (110, 190, 170), (140, 70, 170), (128, 128, 128)


def test_palette_parts_colours_and_joins_a_colour_with_its_noise() -> None:
    lab = np.full((*SHAPE, 3), GREY, np.uint8)
    lab[:30] = RED
    lab[0, 0] = np.array(RED) + [1, 0, 1]
    palette = quantise_colours(lab, np.ones(SHAPE, dtype=bool))
    red, grey = palette.of_pixel[10, 10], palette.of_pixel[50, 10]
    assert red != grey
    assert palette.spread[red, grey] < 1e-6
    assert palette.spread[red, palette.of_pixel[0, 0]] > 0.1
    np.testing.assert_allclose(palette.spread.sum(axis=1), 1.0, rtol=1e-5)


def test_whole_photo_ratio_counted_by_hand() -> None:
    lab = np.full((*SHAPE, 3), GREEN, np.uint8)
    lab[:, :30] = RED
    lab[40:50, :30] = GREEN  # 300 of the person's 1800 pixels are green
    person, behind = np.zeros(SHAPE, dtype=bool), np.zeros(SHAPE, dtype=bool)
    person[:, :30], behind[:, 30:] = True, True
    wide, _ = colour_ratio(quantise_colours(lab, person | behind), person, behind, person | behind, window_px=9.0)
    even = BELIEF_EVEN / 2
    on_person = (300 + even) / (1800 + BELIEF_EVEN)
    on_behind = (3600 + even) / (3600 + BELIEF_EVEN)
    assert wide.reshape(SHAPE)[5, 60] == pytest.approx(np.log(on_person / on_behind), abs=0.01)
    assert wide.reshape(SHAPE)[5, 5] == pytest.approx(LIMIT, abs=1e-5)


def test_window_knows_the_neighbourhood_and_leans_on_the_photo_where_it_has_seen_nothing() -> None:
    # Red is the person's above and the background's below: only a window can tell.
    lab = np.full((*SHAPE, 3), GREEN, np.uint8)
    lab[:30, :45], lab[30:, 45:] = RED, RED
    person, behind = np.zeros(SHAPE, dtype=bool), np.zeros(SHAPE, dtype=bool)
    person[:, :44], behind[:, 46:] = True, True
    everywhere = np.ones(SHAPE, dtype=bool)
    palette = quantise_colours(lab, everywhere)
    wide, near = (part.reshape(SHAPE) for part in colour_ratio(palette, person, behind, everywhere, window_px=6.0))
    assert np.abs(wide).max() < 0.2
    assert near[5, 44] > 1.5
    assert near[55, 45] < -1.5
    nobody = np.zeros(SHAPE, dtype=bool)
    wide, near = colour_ratio(palette, nobody, nobody, everywhere, window_px=6.0)
    assert np.abs(wide).max() < 1e-5
    assert np.abs(near).max() < 1e-5
    assert BELIEF_WIDE > 0


def test_two_colours_of_one_side_are_both_known() -> None:
    # A striped shirt: one Gaussian would take the grey between for the person's.
    lab = np.full((*SHAPE, 3), (100, 128, 128), np.uint8)
    lab[:, :45] = np.where((np.arange(60) // 4 % 2)[:, None, None], (40, 128, 128), (160, 128, 128))
    person, behind = np.zeros(SHAPE, dtype=bool), np.zeros(SHAPE, dtype=bool)
    person[:, :40], behind[:, 50:] = True, True
    everywhere = np.ones(SHAPE, dtype=bool)
    _, near = colour_ratio(quantise_colours(lab, everywhere), person, behind, everywhere, window_px=8.0)
    assert (near.reshape(SHAPE)[:, 40:45] > 1.0).all()
    assert (near.reshape(SHAPE)[:, 45:50] < -1.0).all()
