"""Hair that ends a little above a shoulder reaches it; wide gaps, and those in which a photo shows cloth, stay."""

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.hair.volumes.gaps import DEEP_MM, REACH, close_gaps
from cloner.hair.volumes.grid import VOXEL_M
from cloner.hair.volumes.views import HairSkinning

SHAPE = (24, 40, 24)
POINTS = VOXEL_M * np.indices(SHAPE).reshape(3, -1).T
ROWS = np.arange(len(POINTS))
LEVEL = np.indices(SHAPE)[1].ravel()
FREE = np.zeros(len(POINTS), bool)
SKIN_MM = (4.0 * (LEVEL - 8)).astype(np.float32)  # a shoulder's top at level 8


def seen(inside_mm=10.0, judged=True, name=ViewId.BODY_BACK):
    """Return a photo that shows hair so deep everywhere, or cannot judge."""
    return SimpleNamespace(
        posed=SimpleNamespace(view=name),
        evidence=lambda points: (np.full(len(points), inside_mm, np.float32), np.full(len(points), judged)),
    )


def hair(first):
    """Return the field of hair from a level upwards."""
    return (4.0 * (LEVEL - first) + 2.0).astype(np.float32)


@pytest.mark.parametrize(("wide", "closes"), [(2, True), (2 * REACH - 1, True), (2 * REACH + 3, False)])
def test_a_gap_closes_when_it_is_narrow(wide, closes):
    field = hair(9 + wide)
    found = close_gaps([seen()], field, SKIN_MM.reshape(SHAPE), POINTS, ROWS, FREE)
    between = (LEVEL > 8) & (LEVEL < 9 + wide)
    assert (found[between] > 0.0).all() == closes
    if closes:
        assert (found[between] == DEEP_MM).all()
    np.testing.assert_array_equal(found[~between], field[~between])


@pytest.mark.parametrize(
    "views",
    [[seen(-20.0)], [seen(), seen(-20.0)], [seen(judged=False)], [seen(name=ViewId.BODY_SIDE)]],
    ids=["cloth", "one denies", "nobody sees", "a side alone"],
)
def test_it_stays_where_a_photo_shows_something_else_or_none_shows_hair(views):
    field = hair(12)
    np.testing.assert_array_equal(close_gaps(views, field, SKIN_MM.reshape(SHAPE), POINTS, ROWS, FREE), field)


def test_gaps_of_the_body_alone_stay():
    arm = np.abs(np.indices(SHAPE)[0].ravel() - 12)
    skin = (4.0 * (arm - 2)).astype(np.float32)  # two walls of skin, four voxels apart
    bald = np.full(len(POINTS), -15.0, np.float32)
    np.testing.assert_array_equal(close_gaps([seen()], bald, -skin.reshape(SHAPE), POINTS, ROWS, FREE), bald)


def test_a_tail_lies_on_nothing():
    field = hair(12)
    found = close_gaps([seen()], field, SKIN_MM.reshape(SHAPE), POINTS, ROWS, np.ones(len(POINTS), bool))
    np.testing.assert_array_equal(found, field)


def test_hair_hangs_from_the_head_and_lies_on_the_back():
    hanger = HairSkinning(np.arange(4, dtype=np.int32), np.array([1.6, 1.55, 1.4]))
    heights = np.array([1.7, 1.6, 1.4, 1.34, 1.28, 1.0])
    points = np.column_stack([np.zeros(6), heights, np.zeros(6)])
    skull, neck, chest = hanger.shares(points)
    np.testing.assert_allclose(skull + neck + chest, 1.0)
    np.testing.assert_allclose(skull, [1.0, 1.0, 0.5, 0.25, 0.0, 0.0], atol=1e-9)
    np.testing.assert_allclose(chest, [0.0, 0.0, 0.5, 0.75, 1.0, 1.0], atol=1e-9)
