"""Laws of the goodness functions: what must raise and what must lower them."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from cloner.vision.contours.linking import bridge, link_goodness
from cloner.vision.contours.paths import path_goodness

angle = st.floats(0.0, np.pi / 2 - 0.01)
length = st.floats(0.0, 50.0)
strength = st.floats(1.0, 40.0)
more = st.floats(0.0, 20.0)
SLACK = 1e-9


@given(angle, angle, length, length, strength, more)
def test_link_goodness_grows_with_magnitude(a1: float, a2: float, d1: float, d2: float, m: float, extra: float) -> None:
    assert link_goodness(a1, a2, d1, d2, m + extra) >= link_goodness(a1, a2, d1, d2, m) - SLACK


@given(angle, angle, angle, length, length, strength)
def test_link_goodness_falls_with_either_angle(
    a1: float, a2: float, other: float, d1: float, d2: float, m: float
) -> None:
    small, large = sorted((a1, other))
    assert link_goodness(large, a2, d1, d2, m) <= link_goodness(small, a2, d1, d2, m) + SLACK
    assert link_goodness(a2, large, d1, d2, m) <= link_goodness(a2, small, d1, d2, m) + SLACK


@given(angle, angle, length, length, strength, more)
def test_link_goodness_falls_with_either_distance(
    a1: float, a2: float, d1: float, d2: float, m: float, extra: float
) -> None:
    here = link_goodness(a1, a2, d1, d2, m)
    assert link_goodness(a1, a2, d1 + extra, d2, m) <= here + SLACK
    assert link_goodness(a1, a2, d1, d2 + extra, m) <= here + SLACK


joints = st.lists(st.tuples(length, angle, angle), min_size=1, max_size=8)


@given(joints, length, length, st.data())
def test_path_goodness_never_rises_when_a_kink_is_added(
    rows: list[tuple[float, float, float]], dt1: float, dt2: float, data: st.DataObject
) -> None:
    d, a1, a2 = (np.array(column) for column in zip(*rows, strict=True))
    magnitudes = np.full(len(rows) + 1, 2.0)
    before = path_goodness(magnitudes, dt1, dt2, d, a1, a2)
    at = data.draw(st.integers(0, len(rows) - 1))
    kink = data.draw(st.floats(0.0, np.pi))
    bent = a1.copy()
    bent[at] = min(bent[at] + kink, np.pi)
    assert path_goodness(magnitudes, dt1, dt2, d, bent, a2) <= before + SLACK
    assert path_goodness(magnitudes, dt1, dt2, d, a2, bent) <= (path_goodness(magnitudes, dt1, dt2, d, a2, a1) + SLACK)


@given(joints, length, length, more)
def test_path_goodness_grows_with_strength_and_falls_with_distance(
    rows: list[tuple[float, float, float]], dt1: float, dt2: float, extra: float
) -> None:
    d, a1, a2 = (np.array(column) for column in zip(*rows, strict=True))
    magnitudes = np.full(len(rows) + 1, 2.0)
    here = path_goodness(magnitudes, dt1, dt2, d, a1, a2)
    assert path_goodness(magnitudes + extra, dt1, dt2, d, a1, a2) >= here - SLACK
    assert path_goodness(magnitudes, dt1 + extra, dt2, d, a1, a2) <= here + SLACK
    assert path_goodness(magnitudes, dt1, dt2 + extra, d, a1, a2) <= here + SLACK
    assert path_goodness(magnitudes, dt1, dt2, d + extra, a1, a2) <= here + SLACK


vector = st.tuples(st.floats(-20, 20), st.floats(-20, 20)).filter(lambda v: np.hypot(*v) > 0.5)


@given(vector, vector, vector, st.floats(-np.pi, np.pi))
def test_bridge_angles_do_not_depend_on_the_photo_s_rotation(
    s1: tuple[float, float], s2: tuple[float, float], c: tuple[float, float], turn: float
) -> None:
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    vectors = [np.array(v) for v in (s1, s2, c)]
    here = bridge(*vectors)
    there = bridge(*(rotation @ v for v in vectors))
    # arccos near 0 and pi turns a rounding error of 1e-16 into 1e-8; the bisector of opposite
    # segments has no direction at all, which only a bridge shorter than 2 px consults.
    if np.hypot(*c) >= 2.0:
        np.testing.assert_allclose(there, here, atol=1e-6)
