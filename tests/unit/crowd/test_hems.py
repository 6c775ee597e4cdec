"""Garments end where their colours end; where colours say nothing, between the teeth of triangles."""

from __future__ import annotations

import numpy as np

from cloner.crowd.clones.groups import GROUPS, STEP
from cloner.crowd.clones.hems import refine_hems

SIZE, MIDDLE, TOOTH = 512, 256, 5
SHIRT, TROUSERS, SKIN = (60, 90, 160), (40, 40, 45), (214, 168, 142)


def code(name: str) -> int:
    return STEP * (GROUPS.index(name) + 1)


def sawn(above: str, below: str) -> np.ndarray:
    """Codes of one chart whose two groups meet in a saw of ``TOOTH`` texels up and down."""
    row, column = np.mgrid[:SIZE, :SIZE]
    saw = MIDDLE + np.abs(column % (4 * TOOTH) - 2 * TOOTH) - TOOTH
    codes = np.where(row < saw, code(above), code(below)).astype(np.uint8)
    codes[:20] = codes[-20:] = 0
    return codes


def painted(above: tuple[int, ...], below: tuple[int, ...]) -> np.ndarray:
    """Colours that change in a straight line, with some noise."""
    rgb = np.where(np.arange(SIZE)[:, None, None] < MIDDLE, above, below) + np.zeros((SIZE, SIZE, 3))
    return np.clip(rgb + np.random.default_rng(4).normal(0, 4, rgb.shape), 0, 255).astype(np.uint8)


def wrong(codes: np.ndarray, above: str) -> int:
    inside = codes > 0
    return int(((codes == code(above)) != (np.arange(SIZE)[:, None] < MIDDLE))[inside].sum())


def test_a_saw_of_triangles_becomes_the_hem_that_was_painted() -> None:
    for above, below, colours in (("top", "bottom", (SHIRT, TROUSERS)), ("head", "top", (SKIN, SHIRT))):
        codes = sawn(above, below)
        found = refine_hems(painted(*colours), codes)
        assert wrong(codes, above) > 2 * SIZE  # 2.5 texels a column
        assert wrong(found, above) < SIZE / 20


def test_cloth_of_one_colour_ends_between_the_teeth() -> None:
    found = refine_hems(painted(SHIRT, SHIRT), sawn("top", "bottom"))
    assert wrong(found, "top") < SIZE  # less than one texel a column


def test_what_is_never_dyed_keeps_its_borders() -> None:
    for above, below in (("head", "arms"), ("hair", "head"), ("mouth", "head")):
        codes = sawn(above, below)
        assert np.array_equal(refine_hems(painted(SHIRT, SKIN), codes), codes)


def test_colours_of_another_chart_do_not_reach_over() -> None:
    codes = np.zeros((SIZE, SIZE), np.uint8)
    codes[40:250, 40:470], codes[253:460, 40:470] = code("top"), code("head")
    assert np.array_equal(refine_hems(painted(SKIN, SKIN), codes), codes)
