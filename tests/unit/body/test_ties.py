"""Unknowns that usually agree pull at each other, mirrored ones with the other sign."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.body.solve import _Normal


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_tie_brings_the_unseen_side_to_the_seen_one(sign: float) -> None:
    seen, unseen = np.array([0]), np.array([1])
    normal = _Normal(2)
    normal.pull(seen, np.array([-0.4]), 0.01)
    normal.pull(unseen, np.array([0.0]), 1.0)
    normal.tie(seen, unseen, np.array([0.0]), 0.05, sign)
    assert np.linalg.solve(normal.matrix, normal.right) == pytest.approx([0.4, sign * 0.4], abs=0.002)
