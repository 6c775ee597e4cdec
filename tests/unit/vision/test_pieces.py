"""Pieces of a mask are the same in its box as in the whole picture."""

from __future__ import annotations

import cv2
import numpy as np

from cloner.vision.segmentation.pieces import connected_pieces


def test_two_squares_in_a_corner_of_a_large_picture() -> None:
    mask = np.zeros((400, 300), np.bool_)
    mask[310:320, 200:204] = True
    mask[330:333, 210:216] = True
    box, pieces, figures = connected_pieces(mask)
    assert box == np.s_[310:333, 200:216]
    assert sorted(figures[1:, cv2.CC_STAT_AREA]) == [18, 40]
    assert sorted(figures[1:, cv2.CC_STAT_TOP]) == [310, 330]
    assert sorted(figures[1:, cv2.CC_STAT_LEFT]) == [200, 210]
    assert np.array_equal(pieces > 0, mask[box])
    assert pieces[0, 0] != pieces[-1, -1]


def test_an_empty_mask_has_no_piece() -> None:
    box, pieces, figures = connected_pieces(np.zeros((40, 30), np.bool_))
    assert np.zeros((40, 30))[box].size == 0
    assert pieces.size == 0
    assert figures.shape == (1, 5)


def test_a_mask_that_fills_its_picture_is_one_piece() -> None:
    box, pieces, figures = connected_pieces(np.ones((6, 9), np.uint8))
    assert (pieces == 1).all()
    assert figures[1, cv2.CC_STAT_AREA] == 54
    assert box == np.s_[0:6, 0:9]
