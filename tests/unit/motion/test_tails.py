"""Where hair swings: tails of known shape, and hair that is none."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.motion.limbs.tails import FREE_M, tails
from kit.clones import toy_clone
from kit.tails import BACK_M, DOWN_M, RADIUS_M, with_tail


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.70)


def test_a_tail_s_bones_lie_in_its_middle_from_the_head_to_its_end(clone) -> None:
    hung = with_tail(clone)
    (tail,) = tails(hung)
    points = hung.shells[0].vertices_m
    lowest = points[:, 1].min()
    assert tail.points_m[-1, 1] == pytest.approx(lowest, abs=0.015)
    assert np.abs(tail.points_m[:, 0] - points[:, 0].mean()).max() < 0.003
    length = np.linalg.norm(np.diff(tail.points_m, axis=0), axis=1)
    assert length.sum() == pytest.approx(BACK_M + DOWN_M - FREE_M, abs=0.04)
    assert np.ptp(length) < 0.25 * length.mean(), "bones of one length"
    assert tail.radius_m[1:] == pytest.approx(RADIUS_M, abs=0.004)
    hanging = tail.points_m[tail.points_m[:, 1] < points[:, 1].max() - 0.06]
    assert np.abs(hanging[:-1, 2] - points[:, 2].min() - RADIUS_M).max() < 0.002
    assert abs(hanging[-1, 2] - points[:, 2].min() - RADIUS_M) < 0.5 * RADIUS_M, "its end is still inside"


def test_shares_begin_with_nothing_at_the_head_and_end_with_the_last_bone(clone) -> None:
    hung = with_tail(clone)
    (tail,) = tails(hung)
    points, total = hung.shells[0].vertices_m, tail.share.sum(axis=1)
    assert (tail.share >= 0.0).all()
    assert total.max() <= 1.0 + 1e-9
    assert total[points[:, 2] > points[:, 2].max() - 0.005].max() == 0.0
    lowest = points[:, 1] < points[:, 1].min() + 0.01
    assert (tail.share[lowest, -1] == 1.0).all()
    assert total[points[:, 1] < points[:, 1].max() - 0.1] == pytest.approx(1.0)


@pytest.mark.parametrize("hair", [True, False])
def test_a_cap_of_hair_or_none_has_no_tail(hair: bool) -> None:
    assert tails(toy_clone(1.70, hair=hair)) == ()


def test_hair_as_broad_as_the_neck_hangs_loose(clone) -> None:
    assert tails(with_tail(clone, breadth=4.0)) == ()
