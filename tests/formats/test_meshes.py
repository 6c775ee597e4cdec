"""OBJ and PLY through trimesh, and the table of formats."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from cloner.exporters.table import EXPORTERS
from kit.clones import RED_LEFT_HAND, toy_clone
from kit.compare_clones import snapshot


@pytest.mark.parametrize("name", ["obj", "ply"])
def test_a_foreign_reader_sees_the_person(name, tmp_path):
    clone = toy_clone(1.64)
    before = snapshot(clone)
    path = EXPORTERS.get(name)(clone, tmp_path)[0]
    assert snapshot(clone) == before
    read = trimesh.load(path, process=False)
    points = read.vertices if name == "ply" else np.concatenate([mesh.vertices for mesh in read.geometry.values()])
    assert points[:, 1].min() == pytest.approx(0.0, abs=0.002)
    assert points[:, 1].max() == pytest.approx(clone.shells[0].vertices_m[:, 1].max(), abs=1e-4)
    assert np.linalg.norm(points - clone.features_m["nose_tip"], axis=1).min() < 1e-4
    if name == "ply":
        hand = np.linalg.norm(points - clone.features_m["fingertip_left"], axis=1).argmin()
        assert np.abs(read.visual.vertex_colors[hand, :3].astype(int) - RED_LEFT_HAND).max() < 10


def test_the_table_lists_the_formats_and_refuses_others():
    assert set(EXPORTERS) >= {"glb", "wrl", "obj", "ply"}
    assert all(callable(EXPORTERS.get(name)) for name in EXPORTERS)
    with pytest.raises(KeyError, match="glb"):
        EXPORTERS.get("fbx")
