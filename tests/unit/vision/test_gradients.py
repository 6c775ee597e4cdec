"""Lengths of gradients are the same wherever in memory a picture lies."""

import numpy as np

from cloner.vision.photographs.gradients import magnitudes


def test_lengths_do_not_depend_on_the_place_in_memory() -> None:
    rng = np.random.default_rng(0)
    across, down = rng.normal(0.0, 40.0, (2, 37, 53)).astype(np.float32)
    found = []
    for shift in range(17):  # of four bytes each: every place within a line of the cache
        room = np.empty((2, across.size + 32), np.float32)
        moved = [row[shift : shift + across.size].reshape(across.shape) for row in room]
        np.copyto(moved[0], across)
        np.copyto(moved[1], down)
        found.append(magnitudes(*moved).tobytes())
    assert len(set(found)) == 1
    exact = np.hypot(across.astype(np.float64), down)
    np.testing.assert_allclose(magnitudes(across, down), exact, rtol=2e-7)
