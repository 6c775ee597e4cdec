"""Laws of Sibson coordinates and of the deformation made from them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cloner.geometry.deformation.dffd import deform, enclosing_points, sibson_weights

SEEDS = st.integers(0, 10_000)


def scene(seed: int, *, symmetric: bool):
    """Return controls (first 40 or 80 movable, then 26 fixed) and 120 queries around a head-sized cloud, metres."""
    rng = np.random.default_rng(seed)
    movable = rng.normal(size=(40, 3)) * [0.07, 0.1, 0.09]
    if symmetric:  # faces are: mirrored pairs are cospherical, the hard case for a Delaunay tessellation
        movable = np.vstack([movable, movable * [-1.0, 1.0, 1.0]])
    queries = rng.normal(size=(120, 3)) * [0.06, 0.09, 0.08]
    hull = enclosing_points(np.vstack([movable, queries]))
    return np.vstack([movable, hull]), len(movable), queries


@pytest.mark.parametrize("symmetric", [False, True])
@given(seed=SEEDS)
@settings(max_examples=15, deadline=None)
def test_weights_are_convex_and_reproduce_their_own_position(seed, symmetric):
    controls, _, queries = scene(seed, symmetric=symmetric)
    weights = sibson_weights(queries, controls)
    assert weights.data.min() >= 0.0
    assert np.abs(np.asarray(weights.sum(axis=1)) - 1.0).max() < 1e-9
    assert np.abs(weights @ controls - queries).max() < 1e-6  # metres


@given(seed=SEEDS)
@settings(max_examples=15, deadline=None)
def test_a_control_point_is_interpolated(seed):
    controls, count, _ = scene(seed, symmetric=True)
    weights = sibson_weights(controls[:count], controls)
    assert np.abs(weights.toarray() - np.eye(count, len(controls))).max() == 0.0


@given(seed=SEEDS, shift=st.tuples(*[st.floats(-0.05, 0.05)] * 3))
@settings(max_examples=15, deadline=None)
def test_moving_all_controls_moves_all_queries_likewise(seed, shift):
    controls, _, queries = scene(seed, symmetric=False)
    weights = sibson_weights(queries, controls)
    moved = deform(weights, np.tile(shift, (len(controls), 1)))
    assert np.abs(moved - np.array(shift)).max() < 1e-9


@given(seed=SEEDS)
@settings(max_examples=10, deadline=None)
def test_any_affine_map_of_the_controls_is_followed(seed):
    controls, _, queries = scene(seed, symmetric=False)
    rng = np.random.default_rng(seed)
    linear = rng.normal(scale=0.3, size=(3, 3))
    weights = sibson_weights(queries, controls)
    assert np.abs(deform(weights, controls @ linear) - queries @ linear).max() < 1e-6
