"""Blocks of what stands in the way: as high as what they are, closed outwards, and whole however bent."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.acting.blocks import COUNTER_M, PILLAR_M, PLINTH_M, THING_M, obstacle_blocks

SQUARE = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
BENT = ((0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0))


def heights(blocks: np.ndarray) -> float:
    return float(blocks[:, 1].max())


def test_heights_tell_plinths_pillars_and_counters() -> None:
    assert heights(obstacle_blocks([SQUARE], [])) == PILLAR_M
    assert heights(obstacle_blocks([BENT], [])) == COUNTER_M
    assert heights(obstacle_blocks([SQUARE], [(0.5, 0.5)])) == pytest.approx(PLINTH_M + THING_M)
    assert heights(obstacle_blocks([], [(0.5, 0.5)])) == pytest.approx(THING_M)
    assert obstacle_blocks([], []).shape == (0, 6)


@pytest.mark.parametrize("corners", [SQUARE, BENT, BENT[::-1], tuple(reversed(SQUARE))])
def test_a_block_is_closed_and_looks_outwards(corners: tuple[tuple[float, float], ...]) -> None:
    """The volume under its triangles, by the divergence of x, is the plan's area times its height."""
    blocks = obstacle_blocks([corners], []).astype(float)
    high = heights(blocks)
    triangles = blocks[:, :3].reshape(-1, 3, 3)
    facing = blocks[:, 3:].reshape(-1, 3, 3)[:, 0]
    wound = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) / 2.0
    assert (np.einsum("ta,ta->t", wound, facing) > 0.0).all(), "wound as the normals look"
    area = 1.0 if len(corners) == 4 else 6.0
    assert wound[facing[:, 1] > 0.5, 1].sum() == pytest.approx(area)
    assert (triangles.mean(axis=1)[:, 0] * wound[:, 0]).sum() == pytest.approx(area * high)
