"""Photos that tell hair's height differently are brought to their median, and only above the ears."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.hair.volumes.crowns import align_crowns

Array = NDArray[np.float64]

EARS_M = 0.0
SCALP_M = np.array([[-0.07, 0.0, 0.0], [0.07, 0.0, 0.0], [0.0, 0.0, 0.0]])


@dataclass
class Seen:
    """A photo without perspective, a millimetre a pixel, whose hair ends ``top_mm`` over the ears."""

    view: ViewId
    top_mm: float
    flip_m: float | None = None
    above_m: float = np.inf
    taller: float = 1.0

    @property
    def posed(self) -> SimpleNamespace:
        return SimpleNamespace(view=self.view, camera=self)

    @property
    def hair(self) -> NDArray[np.bool_]:
        flags = np.zeros((300, 200), np.bool_)
        if np.isfinite(self.top_mm):
            flags[200 - round(self.top_mm) : 220, 40:160] = True
            flags[200 - round(self.top_mm) - 9 : 220, 99:102] = True  # a lock on end is no crown
        return flags

    def to_view(self, points_m: Array) -> Array:
        return points_m

    to_rest = to_view

    def pixel_mm(self, _: Array) -> float:
        return 1.0

    def back_project(self, pixel: Array, at: Array) -> Array:
        return np.column_stack([(pixel[:, 0] - 100.0) / 1e3, (200.0 - pixel[:, 1]) / 1e3, at[:, 2]])


def test_every_photo_is_brought_to_the_median_crown() -> None:
    views = [Seen(ViewId.BODY_FRONT, 120.0), Seen(ViewId.BODY_SIDE, 150.0), Seen(ViewId.BODY_BACK, 180.0)]
    found = align_crowns(views, SCALP_M, EARS_M)  # type: ignore[arg-type]
    assert [view.taller for view in found] == pytest.approx([0.8, 1.0, 1.2])
    assert all(view.above_m == EARS_M for view in found)


def test_a_photo_without_hair_or_cut_at_the_top_tells_nothing() -> None:
    views = [Seen(ViewId.BODY_FRONT, -np.inf), Seen(ViewId.FACE_FRONT, 200.0), Seen(ViewId.BODY_SIDE, 150.0)]
    bare, cut, side = align_crowns(views, SCALP_M, EARS_M)  # type: ignore[arg-type]
    assert (bare.taller, cut.taller, side.taller) == (1.0, 1.0, 1.0)
