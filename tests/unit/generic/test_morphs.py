"""Targets over the wedges of a surface."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cloner.generic.morphs import wedge_offsets
from kit.clones import toy_clone


def test_wedges_of_a_moved_vertex_move_alike_in_rising_order() -> None:
    clone = replace(
        toy_clone(hair=False),
        morph_names=("smile", "blink"),
        morph_index=np.array([7, 3, 5, 3], np.int32),
        morph_delta_m=np.array([[1, 0, 0], [0, 2, 0], [0, 0, 1e-4], [0, 0, -3]], np.float32),
        morph_start=np.array([0, 3, 4], np.int32),
    )
    found = list(wedge_offsets(clone, np.array([3, -1, 7, 3, 5, 0]), 1e-3))
    assert [name for name, _, _ in found] == ["smile", "blink"]
    assert found[0][1].tolist() == [0, 2, 3], "5 moves by less than the least, -1 never"
    assert found[0][2].tolist() == [[0, 2, 0], [1, 0, 0], [0, 2, 0]]
    assert found[1][1].tolist() == [0, 3]
    assert found[1][2].tolist() == [[0, 0, -3], [0, 0, -3]]


def test_a_surface_that_no_target_moves_has_no_wedges() -> None:
    clone = toy_clone(hair=False)
    assert {len(rows) for _, rows, _ in wedge_offsets(clone, np.array([-1, -1]), 0.0)} == {0}
