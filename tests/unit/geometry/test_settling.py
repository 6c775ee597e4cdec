"""A sphere settles on a larger circle, smoothly, and stays where nothing pulls."""

import numpy as np
import pytest
import trimesh

from cloner.geometry.settling import bending_matrix, settle


@pytest.fixture(scope="module")
def sphere():
    mesh = trimesh.creation.icosphere(subdivisions=3, radius=1.0)
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


def settled(sphere, gap, *, anchor=1e-4, slope=1.0, weight=1.0):
    """Return heights after a front photo wants its rim (near z = 0) moved by ``gap``."""
    vertices, triangles = sphere
    rows = np.flatnonzero(np.abs(vertices[:, 2]) < 0.05)
    ones = np.ones(len(rows))
    heights = settle(
        rows, slope * ones, gap * ones, weight * ones, bending_matrix(triangles, len(vertices)),
        stiffness=1.0, anchor=np.full(len(vertices), anchor),
    )  # fmt: skip
    return heights, rows


def test_the_rim_reaches_the_larger_circle(sphere):
    vertices, _ = sphere
    heights, rows = settled(sphere, 0.1)
    grown = (1.0 + heights[:, None]) * vertices
    assert np.linalg.norm(grown[rows, :2], axis=1) == pytest.approx(np.full(len(rows), 1.1), abs=0.006)


def test_the_field_between_is_smooth_and_falls_off(sphere):
    vertices, _ = sphere
    heights, _ = settled(sphere, 0.1, anchor=0.01)
    z = np.abs(vertices[:, 2])
    bands = [heights[(z >= low) & (z < low + 0.2)].mean() for low in (0.0, 0.2, 0.4, 0.6, 0.8)]
    assert np.all(np.diff(bands) < 0), "farther from the rim, less motion"
    # a plate that bends swings a little through zero before it rests
    assert abs(bands[-1]) < 0.03


def test_nothing_wanted_nothing_moved(sphere):
    heights, _ = settled(sphere, 0.0)
    assert not heights.any()


def test_a_slope_of_half_needs_twice_the_height(sphere):
    heights, rows = settled(sphere, 0.05, slope=0.5, weight=10.0)
    assert heights[rows].mean() == pytest.approx(0.1, abs=0.005)


def test_a_strong_anchor_holds(sphere):
    heights, _ = settled(sphere, 0.1, anchor=1e4)
    assert np.abs(heights).max() < 1e-4


def test_bending_is_blind_to_a_constant_and_sees_a_bump(sphere):
    vertices, triangles = sphere
    bending = bending_matrix(triangles, len(vertices))
    constant, bump = np.ones(len(vertices)), np.zeros(len(vertices))
    bump[0] = 1.0
    assert constant @ bending @ constant == pytest.approx(0.0, abs=1e-9)
    assert bump @ bending @ bump > 1.0
