"""Rods are closed surfaces of the thickness that was asked for, seen from outside."""

import numpy as np
import pytest
import trimesh

from cloner.geometry.meshes.sweeps import sweep_profile


def _joined(vertices, triangles):
    """Return the mesh with the seam's doubled points welded."""
    mesh = trimesh.Trimesh(vertices, triangles, process=True, merge_norm=True, merge_tex=True)
    mesh.merge_vertices(digits_vertex=9)
    mesh.update_faces(mesh.nondegenerate_faces())
    return mesh


def test_a_straight_rod_has_its_size():
    path = np.column_stack([np.zeros(5), np.zeros(5), np.linspace(0.0, 0.1, 5)])
    across = np.tile([0.0, 1.0, 0.0], (5, 1))
    vertices, uv, triangles = sweep_profile(path, across, np.array([0.004, 0.002]), closed=False)
    assert np.ptp(vertices, axis=0) == pytest.approx([0.004, 0.008, 0.1])
    mesh = _joined(vertices, triangles)
    assert mesh.is_watertight
    box = 0.004 * 0.008 * 0.1
    assert 0.75 * box < mesh.volume < box  # positive: it is seen from outside
    assert uv.min() == 0.0
    assert uv.max() == 1.0


def test_a_ring_closes():
    turn = np.linspace(0.0, 2.0 * np.pi, 40, endpoint=False)
    path = 0.03 * np.column_stack([np.cos(turn), np.sin(turn), np.zeros(40)])
    vertices, _, triangles = sweep_profile(path, path, np.array([0.002, 0.001]), closed=True)
    mesh = _joined(vertices, triangles)
    assert mesh.is_watertight
    whole = 2.0 * np.pi * 0.03 * 0.004 * 0.002
    assert 0.75 * whole < mesh.volume < whole
