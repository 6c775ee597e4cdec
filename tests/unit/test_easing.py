"""The smooth step against its formula, its ends, its slope and its type."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.easing import half_wave, smoothstep


def test_it_is_the_cubic_of_its_ends() -> None:
    assert smoothstep(np.array([-1.0, 2.0, 3.0, 4.0, 9.0]), 2.0, 4.0).tolist() == [0.0, 0.0, 0.5, 1.0, 1.0]
    assert float(smoothstep(0.25)) == pytest.approx(0.15625)  # 3/16 - 2/64
    assert smoothstep(np.float32([0.25])).dtype == np.float32


def test_its_ends_are_flat() -> None:
    step = 1e-4
    for end, inward in ((0.0, step), (1.0, -step)):
        assert abs(float(smoothstep(end + inward)) - float(smoothstep(end))) < 4.0 * step**2


def test_half_a_wave_goes_from_nothing_to_all() -> None:
    assert half_wave(np.array([0.0, 0.5, 1.0])).tolist() == pytest.approx([0.0, 0.5, 1.0])
    assert float(half_wave(1.0 / 3.0)) == pytest.approx(0.25)  # cos 60 degrees is a half
