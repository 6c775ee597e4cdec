"""Open mouths: where their borders lie, what they show is not the lips', and lips are looked up beside it."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.generic.face_grids import mouth_grid
from cloner.generic.lip_steps import SHARE, drop_from_borders
from cloner.generic.load import load_generic
from cloner.records.labels import Label
from cloner.vision.retouching.matting import prepare_matted_photo
from cloner.vision.retouching.open_mouth import INNER_LIPS, lip_colour_edges, open_lip_borders


def mouth(apart_px: float) -> np.ndarray:
    """Return face points (468, 2) whose lips are 60 px wide and so far apart in the middle, eyes somewhere above."""
    out = np.full((468, 2), 40.0)
    across = np.linspace(70.0, 130.0, 11)
    bow = apart_px / 2.0 * np.sin(np.linspace(0.0, np.pi, 11))
    for border, side in zip(INNER_LIPS, (-1.0, 1.0), strict=True):
        out[list(border)] = np.column_stack([across, 100.0 + side * bow])
    return out


def test_a_shut_mouth_has_no_opening() -> None:
    assert open_lip_borders(mouth(6.0)) is None
    borders = open_lip_borders(mouth(20.0))
    assert borders is not None
    assert borders[:, 5, 1] == pytest.approx([90.0, 110.0])
    assert lip_colour_edges(borders)[:, 5, 1] == pytest.approx([88.2, 111.8])


def test_what_shows_between_open_lips_paints_no_skin() -> None:
    labels = np.full((200, 200), Label.FACE_SKIN, np.uint8)
    labels[112:114, 95:105] = Label.MOUTH
    rgb, mask = np.full((200, 200, 3), 128, np.uint8), np.ones((200, 200), bool)
    opened = prepare_matted_photo(rgb, mask, labels, mouth(20.0), None, None).openings
    assert opened[100, 100], "by the net"
    assert opened[113, 100], "by the labels"
    assert not opened[120, 100]
    shut = prepare_matted_photo(rgb, mask, labels, mouth(2.0), None, None)
    assert shut.lips_px is None
    assert not shut.openings[90:, :].any(), "the dark line between closed lips is theirs"


def test_lips_step_to_the_borders_that_a_photo_shows() -> None:
    grid = mouth_grid()
    seen = load_generic().vertices_m[grid.rings].astype(np.float64)[..., :2] * [1000.0, -1000.0] + [100.0, 1621.0]
    borders = np.array(mouth(20.0)[np.array(INNER_LIPS)])
    moved = seen.copy()
    moved[..., 1] += SHARE[:, None] * drop_from_borders(grid, seen, borders)
    middle = np.abs(seen[grid.margin, :, 0] - 100.0) < 5.0
    for lip, border_px in ((grid.upper & middle, 90.0), (grid.lower & middle, 110.0)):
        rings = moved[grid.margin - 1 : grid.margin + 2, lip, 1]
        inner = rings.max(axis=0) if border_px < 100.0 else rings.min(axis=0)
        assert inner == pytest.approx(border_px, abs=1.2)
    np.testing.assert_array_equal(moved[-1], seen[-1])
