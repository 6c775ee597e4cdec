"""Points under clothes: read off maps worked by hand, in the pixels of a photo."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.seen_points import NAMES, kind_and_aspect
from cloner.labels.points import locate_points
from cloner.vision.photographs.crops import Crop

#: A crop of 512 px around (300, 400): one cell of a map is 8 px of the photo.
CROP = Crop(300.0, 400.0, 512.0, 512.0)
LEFT, RIGHT = NAMES.index("l_hip"), NAMES.index("r_hip")


def maps(**cells: tuple[float, float]) -> np.ndarray:
    """Return maps whose points lie at (column, row) of 64 cells, shared among four; others in the middle."""
    scores = np.full((len(NAMES), 64, 64), -12.0, np.float32)
    for number, name in enumerate(NAMES):
        column, row = cells.get(name, (31.5, 31.5))
        for down in (0, 1):
            for across in (0, 1):
                share = (1.0 - abs(int(column) + across - column)) * (1.0 - abs(int(row) + down - row))
                scores[number, int(row) + down, int(column) + across] = np.log(max(share, 1e-5))
    return scores


def px(column: float, row: float) -> tuple[float, float]:
    """Return the photo's pixel of a place in the map."""
    return 300.0 + 8.0 * (column - 31.5), 400.0 + 8.0 * (row - 31.5)


@pytest.mark.parametrize("view", [ViewId.BODY_FRONT, ViewId.BODY_SIDE])
def test_points_lie_between_cells(view: ViewId) -> None:
    found = locate_points(maps(l_hip=(36.25, 30.5), r_hip=(27.0, 30.75)), CROP, view)
    assert found.shape == (len(NAMES), 2)
    np.testing.assert_allclose(found[LEFT], px(36.25, 30.5), atol=0.3)
    np.testing.assert_allclose(found[RIGHT], px(27.0, 30.75), atol=0.3)
    np.testing.assert_allclose(found[NAMES.index("crotch")], (300.0, 400.0), atol=0.3)


@pytest.mark.parametrize(("view", "left"), [(ViewId.BODY_FRONT, 36.25), (ViewId.BODY_BACK, 27.0)])
def test_what_lies_on_the_left_is_left_whatever_the_net_says(view: ViewId, left: float) -> None:
    right = 36.25 + 27.0 - left
    exchanged = maps(l_hip=(right, 30.5), r_hip=(left, 30.5))
    found = locate_points(exchanged, CROP, view)
    np.testing.assert_allclose(found[LEFT], px(left, 30.5), atol=0.3)
    np.testing.assert_allclose(found[RIGHT], px(right, 30.5), atol=0.3)


def test_a_side_photo_leaves_left_and_right_to_the_net() -> None:
    found = locate_points(maps(l_hip=(27.0, 30.5), r_hip=(36.25, 30.5)), CROP, ViewId.BODY_SIDE)
    np.testing.assert_allclose(found[LEFT], px(27.0, 30.5), atol=0.3)


def test_maps_that_hold_both_sides_give_one_point_each() -> None:
    both = maps(l_hip=(36.25, 30.5), r_hip=(27.0, 30.5))
    torn = both.copy()
    torn[LEFT] = np.logaddexp(both[LEFT] + np.log(0.4), both[RIGHT] + np.log(0.6))
    found = locate_points(torn, CROP, ViewId.BODY_FRONT)
    np.testing.assert_allclose(found[LEFT], px(36.25, 30.5), atol=0.3)
    np.testing.assert_allclose(found[RIGHT], px(27.0, 30.5), atol=0.3)


@pytest.mark.parametrize(
    ("name", "shown", "kind", "side"),
    [
        ("l_knee", "front", "knee", "front"),
        ("l_knee", "left", "knee", "near"),
        ("r_knee", "left", "knee", "far"),
        ("neck_base_L", "right", "neck_base", "far"),
        ("crotch", "right", "crotch", "near"),
    ],
)
def test_what_a_photo_shows_of_a_point(name: str, shown: str, kind: str, side: str) -> None:
    assert kind_and_aspect(name, shown) == (kind, side)
