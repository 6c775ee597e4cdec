"""Sibson coordinates against answers known without our code."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from cloner.geometry.deformation.dffd import circumcentres, deform, enclosing_points, sibson_weights
from kit.silence import Calls


def test_circumcentre_of_a_corner_tetrahedron():
    corner = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]], dtype=np.float64)
    assert circumcentres(corner)[0] == pytest.approx([0.5, 0.5, 0.5], abs=1e-12)


def test_weights_are_the_volumes_stolen_in_the_voronoi_diagram():
    rng = np.random.default_rng(4)
    controls = rng.uniform(-1, 1, (60, 3))
    controls = np.vstack([controls, enclosing_points(controls)])
    query = np.array([[0.1, -0.05, 0.2]])
    samples = query + rng.uniform(-1.2, 1.2, (2_000_000, 3))
    distance, owner = cKDTree(controls).query(samples)
    stolen = np.linalg.norm(samples - query, axis=1) < distance
    counted = np.bincount(owner[stolen], minlength=len(controls)) / stolen.sum()
    spread = np.sqrt(counted.max() / stolen.sum())  # standard error of a counted share
    weights = sibson_weights(query, controls).toarray()[0]
    assert np.abs(weights - counted).max() < 5 * spread < 0.03


def test_the_middle_of_a_cube_belongs_to_all_corners_alike():
    cube = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T.astype(np.float64)
    controls = np.vstack([cube, enclosing_points(cube)])
    weights = sibson_weights(np.array([[0.0, 0.0, 0.0]]), controls).toarray()[0]
    # All eight by symmetry, up to the shift into general position; the box's face middles take the six tips.
    assert weights[:8] == pytest.approx(np.full(8, weights[:8].mean()), abs=1e-3)
    assert 0.9 < weights[:8].sum() < 1.0


def test_a_far_point_does_not_move_with_a_near_control():
    rng = np.random.default_rng(2)
    controls = rng.uniform(-1, 1, (200, 3))
    queries = np.array([[0.6, 0.6, 0.6], [-0.6, -0.6, -0.6]])
    weights = sibson_weights(queries, np.vstack([controls, enclosing_points(controls)]))
    near = np.linalg.norm(controls - 0.6, axis=1).argmin()
    displacement = np.zeros((200, 3))
    displacement[near] = [0.0, 0.1, 0.0]
    moved = deform(weights, displacement)
    assert moved[0, 1] > 0.005
    assert np.abs(moved[1]).max() == 0.0


def test_a_query_outside_the_hull_is_refused():
    controls = enclosing_points(np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]))
    with pytest.raises(ValueError, match="outside"):
        sibson_weights(np.array([[9.0, 0.0, 0.0]]), controls)


def test_coinciding_controls_are_refused():
    controls = np.vstack([enclosing_points(np.eye(3)), enclosing_points(np.eye(3))[:1]])
    with pytest.raises(ValueError, match="coincide"):
        sibson_weights(np.zeros((1, 3)), controls)


def test_a_head_is_worked_out_at_once_and_not_point_by_point():
    rng = np.random.default_rng(0)
    controls = rng.normal(size=(250, 3)) * [0.07, 0.1, 0.09]
    queries = rng.normal(size=(5000, 3)) * [0.06, 0.09, 0.08]
    controls = np.vstack([controls, enclosing_points(np.vstack([controls, queries]))])
    calls, counted = Calls(), []
    for some in (queries[:500], queries):
        calls.begin()
        sibson_weights(some, controls)
        counted.append(calls.end())
    assert counted[1] < 4.0 * counted[0], "ten times the points"
