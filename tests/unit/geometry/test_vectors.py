"""Directions of length 1, and places along polylines, against lengths known beforehand."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.geometry.meshes.vectors import arc_lengths, places_along, unit

CORNER = np.array([[0.0, 0.0], [3.0, 0.0], [3.0, 4.0]])


def test_directions_are_one_long_and_nothing_stays_nothing() -> None:
    assert unit(np.array([[3.0, 4.0], [0.0, 0.0]])).tolist() == [[0.6, 0.8], [0.0, 0.0]]
    assert unit(np.float32([[[0.0, 0.0, 2.0]]])).tolist() == [[[0.0, 0.0, 1.0]]]
    assert unit(np.array([[1e-10, 0.0]]))[0, 0] == pytest.approx(0.1)


def test_places_lie_their_length_along() -> None:
    lengths = arc_lengths(CORNER)
    assert lengths.tolist() == [0.0, 3.0, 7.0]
    assert places_along(CORNER, lengths, np.array([1.5, 3.0, 5.0])).tolist() == [[1.5, 0.0], [3.0, 0.0], [3.0, 2.0]]
