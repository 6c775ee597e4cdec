"""Hair is round in plan, and ends as low as the photos show it: a bob's lower edge is no bowl's."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.hair.volumes.rows import across_px, agreed_mm
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.repair import signed_distance

Array = NDArray[np.float64]

PIXEL_MM = 2.0
HAIR = np.zeros((140, 140), np.bool_)
HAIR[30:111, 30:111] = True  # 162 mm wide and high, its middle at pixel 70


@dataclass
class Seen:
    """A photo without perspective, from before or from aside, that shows a square of hair; y is up."""

    view: ViewId
    axis: int
    hair: NDArray[np.bool_]
    flip_m: float | None = None

    @property
    def posed(self) -> SimpleNamespace:
        return SimpleNamespace(view=self.view, camera=self)

    def to_view(self, points_m: Array) -> Array:
        return points_m

    def seen_at(self, points_m: Array) -> tuple[Array, Array]:
        return points_m, self.project(points_m)

    def pixel_mm(self, _: Array) -> float:
        return PIXEL_MM

    def project(self, points_m: Array) -> Array:
        return 70.0 + 1000.0 / PIXEL_MM * points_m[:, [self.axis, 1]] * (1.0, -1.0)

    def evidence(self, points_m: Array, seen_at: tuple[Array, Array]) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
        depth = PIXEL_MM * sample(signed_distance(self.hair), seen_at[1])[:, 0]
        return depth, np.ones(len(points_m), np.bool_)


CURTAIN = np.zeros_like(HAIR)
CURTAIN[30:111, 66:75] = True  # 18 mm thick seen from aside


def inside(*points_mm: tuple[float, float, float], side: NDArray[np.bool_] = HAIR) -> NDArray[np.float32]:
    """Return how deep points lie in what both photos agree on, mm."""
    views = [Seen(ViewId.BODY_FRONT, 0, HAIR), Seen(ViewId.BODY_SIDE, 2, side)]
    return agreed_mm(views, np.array(points_mm) / 1000.0, (-0.5, 0.5))[0]  # type: ignore[arg-type]


def test_hair_reaches_down_to_where_both_photos_end_it() -> None:
    middle, side = inside((0.0, -76.0, 0.0), (60.0, -76.0, 0.0))
    assert middle == pytest.approx(5.0, abs=2.0)
    assert side == pytest.approx(5.0, abs=2.0), "the whole lower edge is even"
    assert inside((0.0, -90.0, 0.0))[0] < 0.0


def test_hair_is_round_seen_from_above() -> None:
    corner, edge = inside((70.0, 0.0, 70.0), (70.0, 0.0, 0.0))
    assert corner < 0.0 < edge


def test_a_curtain_is_as_wide_as_photos_show_it() -> None:
    """Rounded by half a head's width a thin sheet lost its sides: what remained down a back was a ragged strip."""
    middle, side, beyond = inside((0.0, 0.0, 0.0), (70.0, 0.0, 0.0), (85.0, 0.0, 0.0), side=CURTAIN)
    assert middle == pytest.approx(side, abs=1.0)
    assert side > 5.0
    assert beyond < 0.0


def test_rows_are_measured_to_their_own_ends_and_reach_as_far_as_all_of_their_hair() -> None:
    hair = np.zeros((3, 9), np.bool_)
    hair[1, 2:7] = True
    hair[2, [0, 8]] = True
    near, half = np.moveaxis(across_px(hair), 2, 0)
    assert near[1].tolist() == [0, 0, 0.5, 1.5, 2.5, 1.5, 0.5, 0, 0]
    assert half[1].tolist() == [0, 0, 2.5, 2.5, 2.5, 2.5, 2.5, 0, 0]
    assert (near[2, 0], half[2, 0]) == (0.5, 4.5)
    assert not across_px(np.zeros((2, 2), np.bool_)).any()
