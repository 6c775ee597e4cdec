"""Which outline of a side photo is the face's own."""

from __future__ import annotations

import numpy as np

from cloner.head.evidence import _of_the_face
from cloner.records.labels import Label

HEIGHT, WIDTH = 200, 120


def upright_front() -> np.ndarray:
    """Return a straight front, looking to the right at column 80: places and outward normals (200, 4)."""
    rows = np.arange(HEIGHT, dtype=np.float64)
    return np.column_stack([np.full(HEIGHT, 80.0), rows, np.ones(HEIGHT), np.zeros(HEIGHT)])


def labels(**spans: tuple[int, int]) -> np.ndarray:
    """Return face skin with other classes between rows."""
    found = np.full((HEIGHT, WIDTH), Label.FACE_SKIN, np.uint8)
    for name, (top, bottom) in spans.items():
        found[top:bottom] = Label[name.upper()]
    return found


def rows_kept(shown: np.ndarray) -> np.ndarray:
    return _of_the_face(upright_front(), shown, tip_row=100.0)[:, 1]


def test_all_of_a_bare_face_is_its_own() -> None:
    assert len(rows_kept(labels())) == HEIGHT
    assert len(rows_kept(np.zeros((HEIGHT, WIDTH), np.uint8))) == HEIGHT, "nobody labelled the photo"


def test_a_beards_outline_is_not_the_chins() -> None:
    kept = rows_kept(labels(beard=(140, 180)))
    assert not ((kept >= 140) & (kept < 180)).any()
    assert {139, 180} <= set(kept)


def test_under_a_cap_or_a_fringe_the_face_begins_below() -> None:
    assert rows_kept(labels(hair=(30, 60))).min() > 60.0, "what lies above hair is hidden by it"
    assert not np.isin(np.arange(0, 50), rows_kept(labels(accessory=(0, 50)))).any()
