"""Points over triangles of a picture, against weights known beforehand."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.geometry.meshes.surface import overlaps_triangles
from cloner.geometry.outlines.contour_search import is_covered

TRIANGLE = np.array([[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]])


def test_weights_are_those_of_the_corners() -> None:
    inside, u, v = overlaps_triangles(np.array([[1.0, 2.0], [3.0, 3.0]]), TRIANGLE)
    assert inside.tolist() == [[True], [False]]
    assert (u[0, 0], v[0, 0]) == pytest.approx((0.25, 0.5))


def test_nothing_lies_over_a_triangle_without_area() -> None:
    flat = np.array([[[0.0, 0.0], [2.0, 2.0], [4.0, 4.0]], [[5.0, 5.0]] * 3])
    assert not overlaps_triangles(np.array([[9.0, 1.0], [1.0, 1.0]]), flat)[0].any()
    # of three points in a line a triangle is seen edge on: a point beside it is not covered
    assert not is_covered(
        np.array([[2.0, 1.0]]), np.array([[2.0, 0.0], [2.0, 2.0], [2.0, 4.0]]), np.array([[0, 1, 2]])
    )[0]
