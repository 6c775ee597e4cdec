"""Edges under clothes: read off maps worked by hand, in the pixels of a photo."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.labels.naked_edges import IN_HEAD, IN_PERSON, LEFT_THIGH, NECK, RIGHT_THIGH, TRUNK, body_edges
from cloner.vision.photographs.crops import Crop

#: A crop of 512 px around (300, 400): one cell of a map is 4 px of the photo.
CROP = Crop(300.0, 400.0, 512.0, 512.0)
ARM = 3


def maps(**parts: tuple[int, slice, slice]) -> np.ndarray:
    """Return log-odds of parts, each a plane with the rows and columns that it fills; elsewhere there is none."""
    scores = np.full((15, 128, 128), -9.0, np.float32)
    scores[0] = 0.0
    for plane, rows, columns in parts.values():
        scores[plane, rows, columns] = 9.0
    return scores


def x_px(column: float) -> float:
    """Return the photo's pixel of a column of the map."""
    return 300.0 + 4.0 * (column - 63.5)


def test_edges_lie_between_the_last_cell_and_the_next() -> None:
    found = body_edges(maps(trunk=(2, slice(40, 42), slice(50, 71))), CROP, IN_PERSON)
    assert found[:, 0].tolist() == [TRUNK, TRUNK]
    np.testing.assert_allclose(found[:, 1], [400.0 + 4.0 * (row - 63.5) for row in (40, 41)])
    np.testing.assert_allclose(found[:, 2:], [(x_px(49.5), x_px(70.5))] * 2, atol=0.1)


def test_a_doubtful_cell_moves_the_edge() -> None:
    scores = maps(trunk=(2, slice(40, 41), slice(50, 71)))
    scores[2, 40, 71] = np.log(0.25 / 0.75)
    found = body_edges(scores, CROP, IN_PERSON)
    assert found[0, 3] == pytest.approx(x_px(70.0 + 0.5 / 0.75), abs=0.1)


def test_thighs_are_told_apart_and_belong_to_the_trunk_as_well() -> None:
    both = maps(left=(9, slice(80, 81), slice(66, 76)), right=(10, slice(80, 81), slice(52, 62)))
    found = {int(row[0]): row[2:] for row in body_edges(both, CROP, IN_PERSON)}
    np.testing.assert_allclose(found[LEFT_THIGH], (x_px(65.5), x_px(75.5)), atol=0.1)
    np.testing.assert_allclose(found[RIGHT_THIGH], (x_px(51.5), x_px(61.5)), atol=0.1)
    np.testing.assert_allclose(found[TRUNK], (x_px(51.5), x_px(75.5)), atol=0.1)


def test_a_row_whose_edge_an_arm_hides_tells_nothing() -> None:
    trunk = (2, slice(40, 44), slice(50, 71))
    found = body_edges(maps(trunk=trunk, arm=(ARM, slice(42, 44), slice(71, 76))), CROP, IN_PERSON)
    assert len(found) == 2
    across = body_edges(maps(trunk=trunk, arm=(ARM, slice(42, 44), slice(58, 62))), CROP, IN_PERSON)
    assert len(across) == 4, "an arm before the middle hides no edge"


def test_in_a_crop_of_the_head_the_trunk_begins_with_the_neck() -> None:
    neck = body_edges(
        maps(neck=(2, slice(80, 81), slice(50, 71)), head=(1, slice(40, 80), slice(45, 80))), CROP, IN_HEAD
    )
    assert neck[:, 0].tolist() == [NECK]
    np.testing.assert_allclose(neck[0, 2:], (x_px(49.5), x_px(70.5)), atol=0.1)


def test_no_body_has_no_edges() -> None:
    assert body_edges(maps(), CROP, IN_PERSON).shape == (0, 4)
